"""Peers: the same automaton as others would write it, to be timed beside ours on the same machine in the same run.

A peer moves a lattice of bytes, made by `lattice`, in place, and draws random numbers of its own. Those that know sand
alone honour the schedule and the two topple probabilities; their cells are known beforehand where every probability is
0 or 1. Those that look block states up in a table (`block_table`) move any rule, and their numbers are known, too.
"""

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Peer:
    """Another implementation of the block rule, or of any rule."""

    key: str
    name: str
    advance: Callable  # (lattice, rule, start, iterations): run iterations, the first of them numbered `start`
