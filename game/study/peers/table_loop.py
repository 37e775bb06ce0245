"""The loop that most toys would write for many materials, compiled: a byte for each cell, block states looked up."""

import numba
import numpy as np

from game.core import chance
from game.study.peers import Peer
from game.study.peers.block_table import block_table

_GOLDEN = np.uint64(0x9E3779B97F4A7C15)
_SHIFT = np.uint64(32)

_mix = numba.njit(chance.mix)


@numba.njit
def _advance(cells, offsets, start, iterations, bits, first, last, after):
    """Run the iterations in place."""
    height, width = cells.shape[0] - 1, cells.shape[1] - 1
    across, low = (width - 1) // 2 + 1, (1 << bits) - 1
    for t in range(start, start + iterations):
        key = _mix(np.uint64(t) * _GOLDEN)
        left, top = offsets[t % len(offsets)]
        for y in range(1 - top, height, 2):
            for x in range(1 - left, width, 2):
                a, b, c, d = cells[y, x], cells[y, x + 1], cells[y + 1, x], cells[y + 1, x + 1]
                state = np.int64(a) | np.int64(b) << bits | np.int64(c) << 2 * bits | np.int64(d) << 3 * bits
                at, end = first[state], first[state + 1]
                if at == end:
                    continue
                if last[at] != np.uint32(0xFFFFFFFF):
                    place = np.uint64(((y + 1) // 2) * across + (x + 1) // 2)
                    drawn = _mix(key + place * _GOLDEN) >> _SHIFT
                    while at < end and drawn > last[at]:
                        at += np.uint32(1)
                    if at == end:
                        continue
                new = np.int64(after[at])
                cells[y, x], cells[y, x + 1] = new & low, new >> bits & low
                cells[y + 1, x], cells[y + 1, x + 1] = new >> 2 * bits & low, new >> 3 * bits


def advance(cells, rule, start, iterations):
    """Run `iterations` iterations on a lattice, the first of them numbered `start`, in place."""
    _advance(cells, np.array(rule.offsets, np.int64), start, iterations, *block_table(rule))


def compile_anew():
    """Compile the loop once more, for the types that it was called with, and forget it."""
    type(_advance)(_advance.py_func, targetoptions=_advance.targetoptions).compile(_advance.signatures[0])


TABLE_LOOP = Peer("table_loop", "numba, bytes and a table of block states", advance)
