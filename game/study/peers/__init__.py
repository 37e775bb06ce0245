"""Peers: the same automaton as others would write it, to be timed beside ours on the same machine in the same run.

A peer moves a lattice of bytes, made by `lattice`, in place. It honours the schedule and the two topple probabilities,
and draws from a generator of its own: its cells are known beforehand where every probability is 0 or 1.
"""

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Peer:
    """Another implementation of the block rule."""

    key: str
    name: str
    advance: Callable  # (lattice, rule, start, iterations): run iterations, the first of them numbered `start`
