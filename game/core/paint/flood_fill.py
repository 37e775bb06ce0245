"""Floods: the cells that one cell is connected with, side by side, through cells of its own code."""

import numpy as np

from game.core import planes as bit_planes
from game.core.jit import gate, kernel
from game.core.paint.ink import put

_ONE = np.uint64(1)
_LAST = np.uint64(63)
_DOUBLINGS = tuple(np.uint64(2**k) for k in range(6))


def content_of(planes, where, x, y):
    """Return the content of the cell in column x and row y: code + 2**bits · colour."""
    lane = np.uint64((x >> 1) // where.words)
    plane, at = 2 * (y & 1) + (x & 1), (y >> 1) * where.stride + (x >> 1) % where.words
    return sum((int(four[at] >> lane) & 1) << bit for bit, four in enumerate(planes[plane::4]))


def flood(planes, where, x, y, tally):
    """Let the cells take the ink of a Tally that are connected with the one in column x and row y, in place.

    Return (first row, row after the last).
    """
    code = content_of(planes, where, x, y) % 2**where.bits
    wet = connected(bit_planes.unpack_where(planes, where, {code}), x, y)
    rows = np.flatnonzero(wet.any(axis=1))
    top, bottom = int(rows[0]), int(rows[-1]) + 1
    if bit_planes.has_colours(planes, where) or tally.ink.spray:
        _take_singly(planes, where.words, wet, top, bottom, tally)
    elif (tally.ink.taken >> code) & 1:
        _take_together(planes, where, wet, code, tally)
    return top, bottom


def _take_together(planes, where, wet, code, tally):
    """Let all wet cells, of one code, take an ink without colours, in place."""
    for bit, first in enumerate(range(0, len(planes), 4)):
        if (code ^ tally.ink.code) >> bit & 1:
            four = planes[first : first + 4]
            cells = bit_planes.unpack(four, where)
            np.copyto(cells, np.uint8(tally.ink.code >> bit & 1), where=wet)
            bit_planes.set_bit(cells, 0, four, where)
    number = int(np.count_nonzero(wet))
    tally.change[code] -= number
    tally.change[tally.ink.code] += number


@kernel
def _take_singly(planes, words, wet, top, bottom, tally):
    """Let each wet cell take the ink of a Tally, in place."""
    for y in range(top, bottom):
        for x in range(wet.shape[1]):
            if wet[y, x]:
                put(planes, words, x, y, tally)


def connected(cells, x, y):
    """Return the cells that are connected side by side with the one in column x and row y: (H, W) bool, as `cells`."""
    height, width = cells.shape
    free = np.zeros((height + 2, -(-width // 64) * 8), np.uint8)  # a row that is not free above and below
    free[1:-1, : -(-width // 8)] = np.packbits(cells, axis=1, bitorder="little")
    free = free.view("<u8").astype(np.uint64, copy=False)
    reached, start = np.zeros_like(free), np.zeros_like(free[0])
    start[x // 64] = _ONE << np.uint64(x % 64)
    _spread(free, reached, y + 1, start)
    reached = reached[1:-1].astype("<u8", copy=False).view(np.uint8)
    return np.unpackbits(reached, axis=1, count=width, bitorder="little").view(np.bool_)


@kernel
def _spread(free, reached, row, start):
    """Reach all free cells that are connected with those of one row in `start`, in place; 64 cells a word."""
    rows = len(free)
    waiting, fresh = np.zeros(rows, np.bool_), np.empty(free.shape[1], np.bool_)
    _spread_in_row(free[row], start, reached[row], start, fresh)
    waiting[row - 1] = waiting[row + 1] = True
    going_on, down = True, True
    while going_on:
        going_on = False
        for number in range(1, rows - 1):
            y = number if down else rows - 1 - number
            if waiting[y]:
                waiting[y] = False
                if _spread_in_row(free[y], reached[y - 1], reached[y], reached[y + 1], fresh):
                    waiting[y - 1] = waiting[y + 1] = going_on = True
        down = not down


@gate
def _spread_in_row(free, above, reached, below, fresh):
    """Reach what is free beside the cells reached in a row and in the rows next to it; return whether that is more.

    fresh: room for a bool for each word: it holds more than before, and may lead further.
    """
    more, carry = False, np.uint64(0)
    for word in range(len(free)):
        start = reached[word] | ((above[word] | below[word] | carry) & free[word])
        fresh[word] = start != reached[word]
        if fresh[word]:
            more = True
            reached[word] = start | (free[word] & ~(free[word] + start))  # the sum clears runs of ones from there up
        carry = reached[word] >> _LAST
    if more:
        carry = np.uint64(0)
        for word in range(len(free) - 1, -1, -1):
            filled, way = reached[word] | ((carry << _LAST) & free[word]), free[word]
            if fresh[word] or filled != reached[word]:
                for step in _DOUBLINGS:
                    filled |= way & (filled >> step)
                    way &= way >> step
                reached[word] = filled
            carry = filled & _ONE
    return more
