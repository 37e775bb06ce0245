"""The layout: a lattice as striped bit planes.

Sand and walls are kept apart, and each is split in four by the parity of row and column. Plane row r holds lattice
rows 2r and 2r + 1. A plane row is striped over `words` words: bit k of word j is column k·words + j of the plane, so a
word's right-hand neighbours are the next word, same bits. Each row ends in one spare word, the seam: in the planes of
even columns it holds the neighbours of the last word (word 0 shifted down by a bit) while an iteration with odd x runs;
in those of odd columns it is wall. Everything outside the lattice is wall: the rest of the last word of a row, and the
end of each plane, a row and some words at least.

Planes are one (PLANES, length) uint64 array. Sand comes first, at 2·(row parity) + (column parity), and walls follow in
the same order: so a cell's code is 1 for sand, 2 for wall. A world with coloured grains has COLOURED_PLANES: four more
for each bit of a colour, in the order of sand, meaningless where there is none.
"""

from typing import NamedTuple

import numpy as np

from game.core.jit import gate, kernel
from game.core.packing import BITS, pack_cells, turned_cells, unpack_cells

SAND = 0  # first plane of sand
WALLS = 4  # first plane of walls
PLANES = 8
COLOURS = 8  # first plane of colours, where a world has any: four planes for each bit, the lowest bit first
DEPTH = 3  # bits of a colour
COLOURED_PLANES = COLOURS + 4 * DEPTH

# Planes start this many words apart, modulo a 4096-byte page: were all starts alike, as a width of 2**n makes them, a
# store to one plane would stall loads from the others (4096 x 4096 ran at half the speed of 3840 x 2160).
STAGGER = 56
PAGE = 512  # words
LINE = 8  # words in a cache line: loads and stores that straddle two cost a third of the speed

_ONE = np.uint64(1)
_FULL = np.uint64(2**64 - 1)
_PAIRS, _FOURS = np.uint64(0x5555555555555555), np.uint64(0x3333333333333333)
_BYTES, _EACH_BYTE = np.uint64(0x0F0F0F0F0F0F0F0F), np.uint64(0x0101010101010101)


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
    used = (rows + 1) * stride + LINE  # a row past the end, and the rest of a vector there
    return Layout(height, width, rows, words, stride, -(-used // PAGE) * PAGE + STAGGER)


def pack(sand, walls, colours=None):
    """Return the planes of two (H, W) bool arrays, and of the colours of the sand, (H, W) uint8, if there are any."""
    where = layout(*sand.shape)
    planes = empty(where, PLANES if colours is None else COLOURED_PLANES)
    planes[:] = 0
    planes[WALLS:COLOURS] = _FULL
    pack_cells(sand.view(np.uint8), planes[SAND : SAND + 4], where.words)
    pack_cells(walls.view(np.uint8), planes[WALLS : WALLS + 4], where.words)
    for bit, first in enumerate(colour_planes(planes)):
        pack_cells((colours >> bit) & 1, planes[first : first + 4], where.words)
    return planes


def empty(where, number=PLANES):
    """Return room for a number of planes of a layout, not filled, starting at a cache line as every plane then does."""
    return aligned(number * where.length).reshape(number, where.length)


def aligned(words):
    """Return room for words, not filled, that starts at a cache line."""
    room = np.empty(words + LINE, np.uint64)
    start = -room.ctypes.data // room.itemsize % LINE
    return room[start : start + words]


def unpack(planes, where, first=SAND):
    """Return the cells of the four planes from `first` as an (H, W) bool array."""
    cells = np.empty((where.height, where.width), np.uint8)
    unpack_cells(planes[first : first + 4], where.words, cells)
    return cells.view(np.bool_)


def colour_planes(planes):
    """Return the first of the four planes of each bit of the colours, the lowest bit first; none without colours."""
    return range(COLOURS, len(planes), 4)


def unpack_colours(planes, where):
    """Return the colours of the cells, 0 where there is no sand, as an (H, W) uint8 array."""
    colours = np.zeros((where.height, where.width), np.uint8)
    for bit, first in enumerate(colour_planes(planes)):
        colours |= unpack(planes, where, first).view(np.uint8) << bit
    return colours * unpack(planes, where)


def count_colours(planes, where):
    """Return how many cells have sand of each colour: a list of 2**DEPTH ints."""
    counts = np.zeros(2**DEPTH, np.int64)
    if len(planes) > PLANES:
        _count_colours(planes, where.rows, where.words, counts)
    else:
        counts[0] = count(planes, where)
    return counts.tolist()


def with_colours(planes, where):
    """Return the planes with room for colours, all of them 0."""
    more = empty(where, COLOURED_PLANES)
    more[:PLANES] = planes
    more[PLANES:] = 0
    return more


def without_colours(planes, where):
    """Return the planes of sand and walls alone, in memory of their own."""
    fewer = empty(where)
    fewer[:] = planes[:PLANES]
    return fewer


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


def turned(planes, where, quarters):
    """Return the planes of the lattice after so many quarter turns, clockwise."""
    sand, walls = (turned_cells(unpack(planes, where, first), quarters) for first in (SAND, WALLS))
    if len(planes) == PLANES:
        return pack(sand, walls)
    colours = np.zeros(sand.shape, np.uint8)
    for bit, first in enumerate(colour_planes(planes)):
        colours |= turned_cells(unpack(planes, where, first), quarters).view(np.uint8) << bit
    return pack(sand, walls, colours * sand)


@gate
def _ones(word):
    """Return how many bits of a word are set; the compiler knows this way to write it and takes one instruction."""
    word -= (word >> _ONE) & _PAIRS
    word = (word & _FOURS) + ((word >> np.uint64(2)) & _FOURS)
    return (((word + (word >> np.uint64(4))) & _BYTES) * _EACH_BYTE) >> np.uint64(56)


@gate
def _if_set(word, colour, bit):
    """Return a word where the bit of the colour is 1, else its opposite."""
    return word if (colour >> bit) & 1 else ~word


@kernel
def _count_colours(planes, rows, words, counts):
    """Add up the grains of each colour in `counts`, (2**DEPTH,) int64, in place."""
    for plane in range(4):
        low, middle, high = planes[COLOURS + plane], planes[COLOURS + 4 + plane], planes[COLOURS + 8 + plane]
        for colour in range(len(counts)):
            found = np.uint64(0)
            for start in range(0, rows * (words + 1), words + 1):
                for i in range(start, start + words):
                    same = _if_set(low[i], colour, 0) & _if_set(middle[i], colour, 1) & _if_set(high[i], colour, 2)
                    found += _ones(planes[SAND + plane, i] & same)
            counts[colour] += np.int64(found)
