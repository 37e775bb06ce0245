"""The layout: a lattice as striped bit planes.

Sand and walls are kept apart, and each is split in four by the parity of row and column. Plane row r holds lattice
rows 2r and 2r + 1. A plane row is striped over `words` words: bit k of word j is column k·words + j of the plane, so a
word's right-hand neighbours are the next word, same bits. Each row ends in one spare word, the seam: in the planes of
even columns it holds the neighbours of the last word (word 0 shifted down by a bit) while an iteration with odd x runs;
in those of odd columns it is wall. Everything outside the lattice is wall.

Planes are one (PLANES, length) uint64 array. Sand comes first, at 2·(row parity) + (column parity); walls follow in the
same order; last come two copies of the walls of even columns, for iterations with odd x: their seams hold the
neighbours for good and their first word is all wall, which keeps the seam's own block still.
"""

from typing import NamedTuple

import numpy as np

from game.core.jit import kernel

SAND = 0  # first plane of sand
WALLS = 4  # first plane of walls
SHIFTED_WALLS = 8  # walls of even columns for odd x: even rows, then odd rows
PLANES = 10
BITS = 64

# Planes start this many words apart, modulo a 4096-byte page: were all starts alike, as a width of 2**n makes them, a
# store to one plane would stall loads from the others (4096 x 4096 ran at half the speed of 3840 x 2160).
STAGGER = 56
PAGE = 512  # words
LINE = 8  # words in a cache line: loads and stores that straddle two cost a third of the speed

_ONE = np.uint64(1)
_TOP = np.uint64(BITS - 1)
_FULL = np.uint64(2**64 - 1)


class Layout(NamedTuple):
    """Where the cells of a lattice are in its planes."""

    height: int  # cells
    width: int  # cells
    rows: int  # plane rows
    words: int  # words in a plane row, without the seam
    stride: int  # words from one plane row to the next
    length: int  # words in a plane, with padding


def layout(height, width):
    """Return the layout of a lattice of height x width cells."""
    rows = -(-height // 2)
    words = -(-width // (2 * BITS))
    stride = words + 1
    used = (rows + 1) * stride + 1  # one row and a word past the end are read, and are wall
    return Layout(height, width, rows, words, stride, -(-used // PAGE) * PAGE + STAGGER)


def pack(sand, walls):
    """Return the planes of two (H, W) bool arrays."""
    where = layout(*sand.shape)
    planes = empty(where)
    planes[:WALLS] = 0
    planes[WALLS:] = _FULL
    _pack_cells(sand.view(np.uint8), walls.view(np.uint8), planes, where.words)
    shift_walls(planes, where.rows, where.words)
    return planes


def empty(where, number=PLANES):
    """Return room for a number of planes of a layout, not filled, starting at a cache line as every plane then does."""
    room = np.empty(number * where.length + LINE, np.uint64)
    start = -room.ctypes.data // room.itemsize % LINE
    return room[start : start + number * where.length].reshape(number, where.length)


def unpack(planes, where, first=SAND):
    """Return the cells of the four planes from `first` as an (H, W) bool array."""
    cells = np.empty((where.height, where.width), np.uint8)
    _unpack_cells(planes[first : first + 4], where.words, cells)
    return cells.view(np.bool_)


def count(planes, where, first=SAND):
    """Return how many cells of the four planes from `first` are set."""
    rows = planes[first : first + 4, : where.rows * where.stride].reshape(4, where.rows, where.stride)
    return sum(int(np.bitwise_count(plane[:, : where.words]).sum()) for plane in rows)


def count_above(planes, where, row, first=SAND):
    """Return how many cells above lattice row `row` are set in the four planes from `first`."""
    whole = count(planes, where._replace(rows=row // 2), first)
    start = row // 2 * where.stride
    return whole + (
        int(np.bitwise_count(planes[first : first + 2, start : start + where.words]).sum()) if row % 2 else 0
    )


def bands(planes, where, first=SAND, height=64):
    """Yield the cells of the four planes from `first` as (height or less, W) bool arrays, from the top down."""
    for top in range(0, where.height, height):
        start = top // 2 * where.stride
        band = where._replace(height=min(height, where.height - top))
        yield unpack(planes[:, start:], band, first)


def turn(planes, where):
    """Turn the lattice by 180 degrees, in place."""
    sand, walls = unpack(planes, where, SAND), unpack(planes, where, WALLS)
    planes[:] = pack(np.ascontiguousarray(sand[::-1, ::-1]), np.ascontiguousarray(walls[::-1, ::-1]))


@kernel
def _pack_cells(sand, walls, planes, words):
    height, width = sand.shape
    for y in range(height):
        for x in range(width):
            plane = 2 * (y & 1) + (x & 1)
            lane = (x >> 1) // words
            word = (x >> 1) - lane * words
            at = (y >> 1) * (words + 1) + word
            bit = _ONE << np.uint64(lane)
            if sand[y, x]:
                planes[SAND + plane, at] |= bit
            if not walls[y, x]:
                planes[WALLS + plane, at] &= ~bit


@kernel
def _unpack_cells(planes, words, cells):
    height, width = cells.shape
    for y in range(height):
        for x in range(width):
            lane = (x >> 1) // words
            word = (x >> 1) - lane * words
            bits = planes[2 * (y & 1) + (x & 1), (y >> 1) * (words + 1) + word]
            cells[y, x] = (bits >> np.uint64(lane)) & _ONE


@kernel
def shift_walls(planes, rows, words):
    """Make the walls of even columns for odd x anew, in place."""
    for parity in range(2):
        plane, copy = WALLS + 2 * parity, SHIFTED_WALLS + parity
        for i in range(planes.shape[1]):
            planes[copy, i] = planes[plane, i]
        for start in range(0, rows * (words + 1), words + 1):
            planes[copy, start + words] = (planes[plane, start] >> _ONE) | (_ONE << _TOP)
            planes[copy, start] = _FULL
