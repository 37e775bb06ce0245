"""Heat: how often many runs had sand in each cell, as levels, and levels as colours over a picture of the sand."""

import numpy as np

from game.core.jit import gate, kernel

LEVELS = 256
NEVER, ALWAYS, SOLID = 0, 254, 255  # no run has sand there; every run; a wall, which is left as it is

_LOW, _HIGH = np.uint32(0x00FF00FF), np.uint32(0xFF00FF00)  # two bytes of a pixel, and the other two
_BYTE, _HALF = np.uint32(8), np.uint64(32)


@kernel
def heat_levels(counts, runs, walls, levels):
    """Write the level of each cell to `levels`, (H, W) uint8: from NEVER to ALWAYS as `counts` goes from 0 to `runs`.

    counts: (H, W) int64. walls: (H, W) bool. What happens at all is above NEVER, what may fail below ALWAYS.
    """
    height, width = counts.shape
    half, whole = np.float64(runs // 2), np.float64(runs)  # exact, and a quotient of them is rounded too little to err
    for y in range(height):
        for x in range(width):
            count = counts[y, x]
            level = np.int64((np.float64(count) * ALWAYS + half) / whole)
            if count > 0 and level <= NEVER:
                level = NEVER + 1
            if count < runs and level >= ALWAYS:
                level = ALWAYS - 1
            levels[y, x] = SOLID if walls[y, x] else level


@gate
def _add_row(row, totals, cells):
    """Add the levels of a row to those of its columns, and count the cells that are no walls."""
    for x in range(len(row)):
        free = row[x] != SOLID
        totals[x] += np.int32(row[x]) if free else np.int32(0)
        cells[x] += np.int32(free)


@gate
def _mean_between(first, last, totals, cells):
    """Return the mean level of the columns from `first` to before `last`."""
    total, number = 0, 0
    for x in range(first, last):
        total += totals[x]
        number += cells[x]
    if number == 0:
        return SOLID
    mean = np.int64(np.float64(total + number // 2) / np.float64(number))  # exact, as in `heat_levels`
    return max(mean, min(total, NEVER + 1))


@kernel
def mean_levels(levels, columns, rows, means):
    """Write the mean level of the cells of each pixel to `means`, (len(rows) - 1, len(columns) - 1) uint8.

    columns, rows: int32, the cells between which the pixels lie. Walls count only where a pixel holds nothing else; a
    pixel is NEVER only if all its cells are.
    """
    width = levels.shape[1]
    totals, cells = np.empty(width, np.int32), np.empty(width, np.int32)  # of each column in a row of pixels
    for i in range(len(rows) - 1):
        totals[:] = 0
        cells[:] = 0
        for y in range(rows[i], rows[i + 1]):
            _add_row(levels[y], totals, cells)
        for j in range(len(columns) - 1):
            means[i, j] = _mean_between(columns[j], columns[j + 1], totals, cells)


def covers_of(kept, laid):
    """Return (LEVELS,) uint64 for `lay_heat`, two of (LEVELS,) uint32 in one, so that a level is looked up once.

    kept: how much of the pixel below stays, in parts of 256. laid: the pixel value that is added to that.
    """
    return kept.astype(np.uint64) | laid.astype(np.uint64) << _HALF


@gate
def _look_up(levels, columns, unscaled, covers, shown):
    """Write what lies over each pixel of a row to `shown`: one load for each level that is shown as it lies there."""
    if unscaled:
        row = levels[columns[0] : columns[0] + len(columns)]
        for j in range(len(columns)):
            shown[j] = covers[row[j]]
    else:
        for j in range(len(columns)):
            shown[j] = covers[levels[columns[j]]]


@gate
def _blend(line, shown):
    """Mix a row's pixels with what lies over them."""
    for j in range(len(shown)):
        pixel, keep = line[j], np.uint32(shown[j])
        low = (((pixel & _LOW) * keep) >> _BYTE) & _LOW
        high = (((pixel >> _BYTE) & _LOW) * keep) & _HIGH
        line[j] = (low | high) + np.uint32(shown[j] >> _HALF)


@kernel
def lay_heat(levels, covers, columns, rows, pixels, top, left):
    """Lay levels over pixel rows from `top` and columns from `left` of `pixels`, an (h, w) uint32 array, in place.

    columns, rows: the level's column and row for each pixel column and row, rising. covers: what `covers_of` gives.
    """
    width = len(columns)
    shown = np.empty(width, np.uint64)
    unscaled = width > 0 and columns[width - 1] - columns[0] == width - 1
    for i in range(len(rows)):
        if i == 0 or rows[i] != rows[i - 1]:
            _look_up(levels[rows[i]], columns, unscaled, covers, shown)
        _blend(pixels[top + i, left : left + width], shown)
