"""The layout: a lattice as striped bit planes.

Each bit of a cell's code is kept apart, and split in four by the parity of row and column. Plane row r holds lattice
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

SAND = 0  # first plane of sand, in a world of sand
WALLS = 4  # first plane of walls there
PLANES = 8
WALL = 2  # the code of walls there
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
    codes: int  # how many codes there are
    outside: int  # the code of what is outside the lattice: that of walls

    @property
    def bits(self):
        """How many bits a cell's code has."""
        return max(2, (self.codes - 1).bit_length())


def layout(height, width, codes=3, outside=WALL):
    """Return the layout of a lattice of height x width cells that hold so many codes."""
    rows = -(-height // 2)
    words = -(-width // (2 * BITS))
    stride = words + 1
    used = (rows + 1) * stride + LINE  # a row past the end, and the rest of a vector there
    return Layout(height, width, rows, words, stride, -(-used // PAGE) * PAGE + STAGGER, codes, outside)


def pack(cells, where, colours=None):
    """Return the planes of (H, W) uint8 codes, and of the colours of the sand, (H, W) uint8, if there are any."""
    planes = empty(where, 4 * where.bits if colours is None else COLOURED_PLANES)
    for bit, first in enumerate(range(0, len(planes), 4)):
        of, number = (cells, bit) if bit < where.bits else (colours, bit - where.bits)
        _pack_bit(of, number, planes[first : first + 4], where, bit)
    return planes


def _pack_bit(cells, number, four, where, bit):
    """Set four planes, those of a bit of a cell, to bit `number` of (H, W) uint8 cells, and around them to the outside.

    Colours come after the codes, and are 0 outside.
    """
    four[:] = _FULL if bit < where.bits and where.outside >> bit & 1 else 0
    set_bit(cells, number, four, where)


def set_bit(cells, number, four, where):
    """Set the bits of four planes to bit `number` of (H, W) uint8 cells, in place; what is beside the cells stays."""
    fixed = cells.view()
    fixed.flags.writeable = False  # always: a kernel compiles anew for arrays that are not
    pack_cells(fixed, number, four, where.words)


def empty(where, number):
    """Return room for a number of planes of a layout, not filled, starting at a cache line as every plane then does."""
    return aligned(number * where.length).reshape(number, where.length)


def aligned(words):
    """Return room for words, not filled, that starts at a cache line."""
    room = np.empty(words + LINE, np.uint64)
    start = -room.ctypes.data // room.itemsize % LINE
    return room[start : start + words]


def unpack(planes, where):
    """Return the codes of the cells as an (H, W) uint8 array."""
    return _unpacked(planes[: 4 * where.bits], where)


def unpack_where(planes, where, codes):
    """Return which cells have one of a set of codes as an (H, W) bool array."""
    return _unpacked(planes_where(planes, where, codes), where).view(np.bool_)


def planes_where(planes, where, codes):
    """Return four planes of the cells that have one of a set of codes: a view of those given, or a new array."""
    for bit in range(where.bits):
        if set(codes) == {code for code in range(where.codes) if code >> bit & 1}:
            return planes[4 * bit : 4 * bit + 4]
    others = set(range(where.codes)) - set(codes)
    if len(others) < len(codes):
        return ~planes_where(planes, where, others)
    found = np.zeros((4, where.length), np.uint64)
    for code in codes:
        same = np.full((4, where.length), _FULL)
        for bit in range(where.bits):
            four = planes[4 * bit : 4 * bit + 4]
            same &= four if code >> bit & 1 else ~four
        found |= same
    return found


def unpack_colours(planes, where):
    """Return the colours of the cells, 0 where there is no sand, as an (H, W) uint8 array."""
    if not has_colours(planes, where):
        return np.zeros((where.height, where.width), np.uint8)
    return _unpacked(planes[COLOURS:], where) * _unpacked(planes[SAND:WALLS], where)


def _unpacked(planes, where):
    """Return the numbers whose bits are planes, four for each bit, as an (H, W) uint8 array."""
    cells = np.zeros((where.height, where.width), np.uint8)
    for bit, first in enumerate(range(0, len(planes), 4)):
        unpack_cells(planes[first : first + 4], where.words, bit, cells)
    return cells


def has_colours(planes, where):
    """Return whether there are planes of colours."""
    return len(planes) > 4 * where.bits


def count(planes, where, contents):
    """Return how many cells have each content, code + 2**bits · colour, as a tuple of ints."""
    counts = np.zeros(2 ** (len(planes) // 4), np.int64)
    _count(planes, where.rows, where.words, len(planes) // 4, counts)
    around = 4 * BITS * where.words * where.rows - where.height * where.width  # cells outside, in the same words
    return tuple(int(counts[each]) - around * (each == where.outside) for each in contents)


def with_colours(planes, where):
    """Return the planes with room for colours, all of them 0."""
    more = empty(where, COLOURED_PLANES)
    more[:PLANES] = planes
    more[PLANES:] = 0
    return more


def without_colours(planes, where):
    """Return the planes of codes alone, in memory of their own."""
    fewer = empty(where, 4 * where.bits)
    fewer[:] = planes[: len(fewer)]
    return fewer


def count_set(four, where, row=None):
    """Return how many cells of four planes are set, all of them or those above lattice row `row`."""
    rows = where.rows if row is None else row // 2
    lines = four[:, : where.rows * where.stride].reshape(4, where.rows, where.stride)[:, :, : where.words]
    whole = int(np.bitwise_count(lines[:, :rows]).sum())
    return whole + (int(np.bitwise_count(lines[:2, rows]).sum()) if row is not None and row % 2 else 0)


def bands(planes, where, height=64):
    """Yield the codes of the cells as (height or less, W) uint8 arrays, from the top down."""
    for top in range(0, where.height, height):
        start, end = top // 2 * where.stride, (top + height) // 2 * where.stride
        part = np.ascontiguousarray(planes[:, start:end])  # a kernel compiles anew for other strides
        yield unpack(part, where._replace(height=min(height, where.height - top)))


def turned(planes, where, quarters):
    """Return the planes of the lattice after so many quarter turns, clockwise."""
    height, width = (where.width, where.height) if quarters % 2 else (where.height, where.width)
    after = layout(height, width, where.codes, where.outside)
    new = empty(after, len(planes))
    for bit, first in enumerate(range(0, len(planes), 4)):
        cells = turned_cells(_unpacked(planes[first : first + 4], where).view(np.bool_), quarters)
        _pack_bit(cells.view(np.uint8), 0, new[first : first + 4], after, bit)
    return new


@gate
def _ones(word):
    """Return how many bits of a word are set; the compiler knows this way to write it and takes one instruction."""
    word -= (word >> _ONE) & _PAIRS
    word = (word & _FOURS) + ((word >> np.uint64(2)) & _FOURS)
    return (((word + (word >> np.uint64(4))) & _BYTES) * _EACH_BYTE) >> np.uint64(56)


@kernel
def _count(planes, rows, words, bits, counts):
    """Add up the cells of each content in `counts`, (2**bits,) int64, in place."""
    same = np.empty(len(counts), np.uint64)  # where the cells of a word have each content, by the bits looked at so far
    for plane in range(4):
        for start in range(0, rows * (words + 1), words + 1):
            for i in range(start, start + words):
                same[0] = _FULL
                for bit in range(bits):
                    word = planes[4 * bit + plane, i]
                    for content in range(1 << bit):
                        same[content + (1 << bit)] = same[content] & word
                        same[content] &= ~word
                for content in range(len(counts)):
                    if same[content]:
                        counts[content] += np.int64(_ones(same[content]))
