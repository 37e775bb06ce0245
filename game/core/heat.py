"""Heat: how often many runs had sand in each cell, as levels, and levels as colours over a picture of the sand."""

import numpy as np

from game.core.jit import gate, kernel

LEVELS = 256
NEVER, ALWAYS, SOLID = 0, 254, 255  # no run has sand there; every run; a wall, which is left as it is

_LOW, _HIGH = np.uint32(0x00FF00FF), np.uint32(0xFF00FF00)  # two bytes of a pixel, and the other two
_BYTE = np.uint32(8)


@kernel
def heat_levels(counts, runs, walls, levels):
    """Write the level of each cell to `levels`, (H, W) uint8: from NEVER to ALWAYS as `counts` goes from 0 to `runs`.

    counts: (H, W) int64. walls: (H, W) bool. What happens at all is above NEVER, what may fail below ALWAYS.
    """
    height, width = counts.shape
    for y in range(height):
        for x in range(width):
            count = counts[y, x]
            level = (count * ALWAYS + runs // 2) // runs
            if 0 < count < runs:
                level = min(max(level, NEVER + 1), ALWAYS - 1)
            levels[y, x] = SOLID if walls[y, x] else level


@kernel
def mean_levels(levels, columns, rows, means):
    """Write the mean level of the cells of each pixel to `means`, (len(rows) - 1, len(columns) - 1) uint8.

    columns, rows: int32, the cells between which the pixels lie. Walls count only where a pixel holds nothing else; a
    pixel is NEVER only if all its cells are.
    """
    for i in range(len(rows) - 1):
        for j in range(len(columns) - 1):
            total, cells = 0, 0
            for y in range(rows[i], rows[i + 1]):
                for x in range(columns[j], columns[j + 1]):
                    level = levels[y, x]
                    if level != SOLID:
                        total += level
                        cells += 1
            mean = SOLID
            if cells:
                mean = max((total + cells // 2) // cells, min(total, NEVER + 1))
            means[i, j] = mean


@gate
def _spread(levels, columns, kept, laid, keeps, lays):
    """Look up what each pixel of a row keeps of the picture, and what is laid over it."""
    for j in range(len(columns)):
        level = levels[columns[j]]
        keeps[j] = kept[level]
        lays[j] = laid[level]


@gate
def _blend(line, keeps, lays):
    """Mix a row's pixels with what is laid over them."""
    for j in range(len(keeps)):
        pixel, keep = line[j], keeps[j]
        low = (((pixel & _LOW) * keep) >> _BYTE) & _LOW
        high = (((pixel >> _BYTE) & _LOW) * keep) & _HIGH
        line[j] = (low | high) + lays[j]


@kernel
def lay_heat(levels, kept, laid, columns, rows, pixels, top, left):
    """Lay levels over pixel rows from `top` and columns from `left` of `pixels`, an (h, w) uint32 array, in place.

    columns, rows: the level's column and row for each pixel column and row. kept: (LEVELS,) uint32, how much of the
    pixel below stays, in parts of 256. laid: (LEVELS,) uint32, the pixel value that is added to that.
    """
    keeps, lays = np.empty(len(columns), np.uint32), np.empty(len(columns), np.uint32)
    for i in range(len(rows)):
        if i == 0 or rows[i] != rows[i - 1]:
            _spread(levels[rows[i]], columns, kept, laid, keeps, lays)
        _blend(pixels[top + i, left : left + len(columns)], keeps, lays)
