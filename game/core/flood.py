"""Floods: the cells that one cell is connected with, side by side, through cells of its own kind."""

import numpy as np

from game.core import planes as bit_planes
from game.core.ink import EMPTY, GRAIN, WALL, put
from game.core.jit import gate, kernel

DRY, OPEN, WET = np.uint8(0), np.uint8(1), np.uint8(2)  # of another kind; of the kind, not reached yet; reached


def kind_of(planes, where, x, y):
    """Return the kind of the cell in column x and row y."""
    plane, at = 2 * (y & 1) + (x & 1), (y >> 1) * where.stride + (x >> 1) % where.words
    lane = np.uint64((x >> 1) // where.words)
    for kind, first in ((GRAIN, bit_planes.SAND), (WALL, bit_planes.WALLS)):
        if int(planes[first + plane, at] >> lane) & 1:
            return kind
    return EMPTY


def flood(planes, where, x, y, ink):
    """Let the cells take `ink` that are connected with the one in column x and row y, in place.

    Return (change in grains, first row, row after the last).
    """
    cells = _cells_of_kind(planes, where, kind_of(planes, where, x, y))
    top, bottom = _spread(cells, x, y)
    return _take(planes, where.words, cells, top, bottom, ink), top, bottom


def _cells_of_kind(planes, where, kind):
    """Return where cells of a kind are, (H, W) uint8 of DRY and OPEN."""
    if kind == GRAIN:
        return bit_planes.unpack(planes, where, bit_planes.SAND).view(np.uint8)
    walls = bit_planes.unpack(planes, where, bit_planes.WALLS)
    if kind == EMPTY:
        walls |= bit_planes.unpack(planes, where, bit_planes.SAND)
        np.logical_not(walls, out=walls)
    return walls.view(np.uint8)


@gate
def _note_spans(cells, y, left, right, waiting, size):
    """Note the first cell of each open stretch of row y within `left` … `right`; return `waiting` and its new size."""
    was_open = False
    for x in range(left, right + 1):
        is_open = cells[y, x] == OPEN
        if is_open and not was_open:
            if size == len(waiting):
                waiting = np.concatenate((waiting, np.empty_like(waiting)))
            waiting[size, 0], waiting[size, 1] = x, y
            size += 1
        was_open = is_open
    return waiting, size


@kernel
def _spread(cells, x, y):
    """Wet the open cells connected with the one at (x, y), in place; return (first row, row after the last)."""
    height, width = cells.shape
    waiting, size = np.empty((1024, 2), np.int32), 1
    waiting[0, 0], waiting[0, 1] = x, y
    top, bottom = y, y + 1
    while size:
        size -= 1
        x, y = waiting[size, 0], waiting[size, 1]
        if cells[y, x] != OPEN:
            continue
        left = right = x
        while left > 0 and cells[y, left - 1] == OPEN:
            left -= 1
        while right < width - 1 and cells[y, right + 1] == OPEN:
            right += 1
        cells[y, left : right + 1] = WET
        top, bottom = min(top, y), max(bottom, y + 1)
        if y > 0:
            waiting, size = _note_spans(cells, y - 1, left, right, waiting, size)
        if y < height - 1:
            waiting, size = _note_spans(cells, y + 1, left, right, waiting, size)
    return top, bottom


@kernel
def _take(planes, words, cells, top, bottom, ink):
    """Let the wet cells take `ink`, in place; return the change in grains."""
    change = 0
    for y in range(top, bottom):
        for x in range(cells.shape[1]):
            if cells[y, x] == WET:
                change += put(planes, words, x, y, ink)
    return change
