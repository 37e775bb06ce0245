"""The rule in a plain kernel whose topples draw from better or worse sources of random bits.

The toy draws afresh for each candidate. Here a candidate may have to share its draw with others, as in games that save
on random numbers. A cell is a byte and a run is a lattice; nothing is skipped, so times compare the sources alone.
"""

import numpy as np

from game.core.chance import iteration_key, mix, random_word, seed_stream, threshold
from game.core.jit import gate, kernel
from game.core.loops.calls import copy

FRESH, ROTATED, ROW, LATTICE, FROZEN = range(5)
SOURCES = {
    "fresh for each candidate": FRESH,
    "one word rotated by place": ROTATED,
    "one for a whole row": ROW,
    "one for a whole iteration": LATTICE,
    "fixed noise by place": FROZEN,
}

_EMPTY, _SAND, _WALL = np.uint8(0), np.uint8(1), np.uint8(2)
_ZERO, _WORD, _TOP = np.uint64(0), np.uint64(64), np.uint64(32)


def run_cheaply(sand, walls, p, offsets, iterations, runs, source, seed):
    """Run the rule in which grains topple with p and always fall; return (counts, surplus).

    counts: how many runs have sand in each cell, (H, W) int64. surplus: grains in the right half less grains in the
    left half of the lower half of the lattice, (runs,) int64; the middle column of an odd width counts for neither.
    """
    start = np.full((sand.shape[0] + 2, sand.shape[1] + 2), _WALL)
    start[1:-1, 1:-1] = np.where(walls, _WALL, np.where(sand, _SAND, _EMPTY))
    total, surplus = np.zeros(start.shape, np.int64), np.zeros(runs, np.int64)
    _run_all(start, np.array(offsets), iterations, np.uint64(threshold(p)), source, np.uint64(seed), total, surplus)
    return total[1:-1, 1:-1], surplus


@kernel
def _run_all(start, offsets, iterations, limit, source, seed, total, surplus):
    height, width = start.shape
    cells = np.empty((height, width), np.uint8)
    for run in range(len(surplus)):
        for y in range(height):
            copy(start[y], 0, cells[y], 0, width)
        stream = seed_stream(mix(seed) + np.uint64(run))
        for iteration in range(iterations):
            x0, y0 = offsets[iteration % len(offsets)]
            _iterate(cells, x0, y0, limit, source, stream, np.uint64(iteration))
        for y in range(height):
            for x in range(width):
                if cells[y, x] == _SAND:
                    total[y, x] += 1
                    if y > height // 2:
                        surplus[run] += (x >= width - width // 2) - (x < width // 2)


@gate
def _iterate(cells, x0, y0, limit, source, stream, iteration):
    """Run one iteration of the partition at (x0, y0) on (H + 2, W + 2) bytes with a border of walls, in place."""
    key = iteration_key(stream, iteration)
    height, width = cells.shape
    for y in range(1 - y0, height - 1, 2):
        for x in range(1 - x0, width - 1, 2):
            falls = False
            for column in (x, x + 1):
                if cells[y, column] == _SAND and cells[y + 1, column] == _EMPTY:
                    cells[y, column], cells[y + 1, column] = _EMPTY, _SAND
                    falls = True
            if falls:
                continue
            for column, other in ((x, x + 1), (x + 1, x)):
                beside_empty = cells[y, other] == _EMPTY and cells[y + 1, other] == _EMPTY
                if cells[y, column] == _SAND and cells[y + 1, column] != _EMPTY and beside_empty:
                    if _draw(source, stream, key, y, x, width) < limit:
                        cells[y, column], cells[y + 1, other] = _EMPTY, _SAND
                    break


@gate
def _draw(source, stream, key, y, x, width):
    """Return a number in [0, 2**32) for the block at (x, y), as a uint64."""
    place = np.uint64(y * width + x)
    if source == FRESH:
        word = random_word(key, place, _ZERO)
    elif source == ROTATED:
        turn = place % _WORD
        word = random_word(key, _ZERO, _ZERO)
        word = (word << turn) | (word >> ((_WORD - turn) % _WORD))
    elif source == ROW:
        word = random_word(key, np.uint64(y), _ZERO)
    elif source == LATTICE:
        word = random_word(key, _ZERO, _ZERO)
    else:
        word = random_word(stream, place, _ZERO)
    return word >> _TOP
