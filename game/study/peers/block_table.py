"""The table of block states that a plain writer would make of a rule: all layers folded into one draw a block.

A state's outcomes stand one after the other, each with the last random number, of 32 bits, with which it happens.
What leaves the block as it is has no entry.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.study.peers.numpy_blocks import GOLDEN, mix
from game.study.peers.table_blocks import DIGITS, Chances, Layer, layers_of


class BlockTable(NamedTuple):
    """A rule as byte loops take it."""

    bits: int  # of a cell
    first: np.ndarray  # (states + 1,) uint32: where the outcomes of a state begin; they end where the next state's do
    last: np.ndarray  # (n,) uint32: the last number with which the outcome, or an earlier one, happens
    after: np.ndarray  # (n,) uint16: the block after

    def as_layer(self):
        """Return the table as the one Layer of a twin."""
        counts = np.diff(self.first.astype(np.int64))
        most, states = int(counts.max()), np.repeat(np.arange(len(counts)), counts)
        place = np.arange(len(states)) - self.first[states]
        limits, after = (np.zeros((len(counts), most), dtype) for dtype in (np.uint64, np.uint16))
        limits[states, place], after[states, place] = self.last.astype(np.uint64) + np.uint64(1), self.after
        return Layer(np.maximum.accumulate(limits, axis=1)[None].repeat(2, 0), after[None].repeat(2, 0))


@lru_cache(maxsize=4)
def block_table(rule):
    """Return the BlockTable of a Rule."""
    layers = layers_of(rule)
    states, after, p = (np.concatenate(each) for each in zip(*_outcomes(layers), strict=True))
    key, place = np.unique(states << 16 | after, return_inverse=True)
    p = np.bincount(place, p, len(key))
    states, after = key >> 16, key & 0xFFFF
    order = np.lexsort((-p, states))  # the likeliest outcome of a state first
    states, after, p = states[order], after[order], p[order]
    first = np.searchsorted(states, np.arange(len(layers[0].limits[0]) + 1))
    sums = np.cumsum(p)
    before = np.concatenate([[0.0], sums])[first[states]]
    limits = np.minimum(2**DIGITS, np.rint((sums - before) * 2**DIGITS)).astype(np.uint64)
    last = (np.maximum(limits, 1) - 1).astype(np.uint32)
    return BlockTable(rule.table.bits, first.astype(np.uint32), last, after.astype(np.uint16))


def _outcomes(layers):
    """Yield (states, blocks after, probabilities) of all that changes a block, by layer, fair bit and outcome."""
    all_states = np.arange(len(layers[0].limits[0]), dtype=np.int64)
    for face in (0, 1):
        left = np.full(len(all_states), 0.5)
        for layer in layers:
            shares = np.diff(layer.limits[face].astype(np.float64), axis=1, prepend=0.0) / 2**DIGITS
            for share, after in zip(shares.T, layer.after[face].T.astype(np.int64), strict=True):
                changed = (share > 0) & (after != all_states) & (left > 0)
                yield all_states[changed], after[changed], (left * share)[changed]
            left = left * (1.0 - shares.sum(axis=1))


def loop_chances(width):
    """Return the Chances of the byte loops on a lattice `width` cells wide, its border left out."""
    across = np.int64(width // 2 + 1)

    def digit(iteration, rows, columns, layer, number):
        with np.errstate(over="ignore"):
            key = mix(np.uint64(iteration) * GOLDEN)
            drawn = mix(key + ((rows + 1) * across + columns + 1).astype(np.uint64) * GOLDEN) >> np.uint64(DIGITS)
        return drawn >> np.uint64(DIGITS - 1 - number) & np.uint64(1)

    return Chances(digit, lambda *_: 0)
