"""The loop that most toys would write, compiled: a byte for each cell, block after block."""

import numba
import numpy as np

from game.study.peers import Peer
from game.study.peers.lattice import EMPTY, SAND


@numba.njit
def _advance(cells, offsets, start, iterations, threshold_left, threshold_right):
    """Run the iterations in place. Thresholds: topple probabilities in units of 2**-32."""
    height, width = cells.shape[0] - 1, cells.shape[1] - 1
    random = np.uint64(start) + np.uint64(88172645463325252)
    for t in range(start, start + iterations):
        left, top = offsets[t % len(offsets)]
        for y in range(1 - top, height, 2):
            for x in range(1 - left, width, 2):
                a, b = cells[y, x], cells[y, x + 1]
                if a != SAND and b != SAND:
                    continue
                c, d = cells[y + 1, x], cells[y + 1, x + 1]
                a_falls, b_falls = a == SAND and c == EMPTY, b == SAND and d == EMPTY
                if a_falls:
                    cells[y, x], cells[y + 1, x] = EMPTY, SAND
                if b_falls:
                    cells[y, x + 1], cells[y + 1, x + 1] = EMPTY, SAND
                if a_falls or b_falls:
                    continue
                right = a == SAND and b == EMPTY and d == EMPTY
                if right or (b == SAND and a == EMPTY and c == EMPTY):
                    random ^= random << np.uint64(13)  # xorshift64, Marsaglia 2003
                    random ^= random >> np.uint64(7)
                    random ^= random << np.uint64(17)
                    if right and (random >> np.uint64(32)) < threshold_right:
                        cells[y, x], cells[y + 1, x + 1] = EMPTY, SAND
                    elif not right and (random >> np.uint64(32)) < threshold_left:
                        cells[y, x + 1], cells[y + 1, x] = EMPTY, SAND


def advance(cells, rule, start, iterations):
    """Run `iterations` iterations on a lattice, the first of them numbered `start`, in place."""
    thresholds = (np.uint64(round(p * 2**32)) for p in (rule.topple_left, rule.topple_right))
    _advance(cells, np.array(rule.offsets, np.int64), start, iterations, *thresholds)


BYTE_LOOP = Peer("byte_loop", "numba, byte-per-cell loop", advance)
