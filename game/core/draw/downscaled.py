"""Planes to colours where a pixel holds many cells: they are counted, 64 columns at a time, and their light is mixed.

It is done sort by sort, see `looks.counted`. Seven rows at a time are added up bit by bit: each word of a row has a
stack of words, whose d-th holds the d-th digits of its columns' counts. Where pixels are wide, neighbouring columns are
added up in that way. Then the stacks are transposed, so that each count is a byte, and summed along each lane, the
neighbouring columns that are one bit of all words of a row: so the cells between any two edges of pixels are the
difference of two sums. All but the last is done by passes over words.
"""

from functools import lru_cache

import numpy as np

from game.core.compiler.word_pass import transposed, word_pass
from game.core.draw.looks import counted
from game.core.draw.rows import RowStreams, addresses, find_row
from game.core.jit import gate, kernel
from game.core.loops.calls import call_words
from game.core.planes import BITS, LINE, aligned

LIGHTS = 4096  # levels of linear light that are told apart
DIGITS = 8  # of a count, which is taken out of the words as a byte
TOGETHER = 7  # rows added up at a time

_PAIRED, _FOURFOLD = 8, 16  # cells to a pixel from which its edges may move by an eighth of it, to even columns or more
_MOST = 2**DIGITS - 1  # cells in one count
_SUMS = np.uint64(16)  # words that hold the sums of all lanes, in 16 bits each
_NONE = np.float32(-1e9)  # no amount of light
_GREEN, _BLUE = np.uint64(16400), np.uint64(2 * 16400)  # where the green and the blue light of a row starts: more than
# the widest lattice has columns
_ZERO, _ONE, _EIGHT = np.uint64(0), np.uint64(1), np.uint64(8)
_HALVES = np.uint64(0x00FF00FF00FF00FF)


def shift_edges(columns, words):
    """Return the edges between pixels, int32 lattice columns, moved a little so that columns can be counted together.

    Where pixels are wide enough, an edge has an even number of columns before it in its lane, or a multiple of four.
    """
    narrowest = int(np.diff(columns).min())
    group = 4 if narrowest >= _FOURFOLD else 2 if narrowest >= _PAIRED else 1
    lane = 2 * words
    first = columns // lane * lane
    moved = first + np.minimum((columns - first + group // 2) // group * group, lane)
    return np.where(moved > columns[-1], moved - group, moved).astype(np.int32)


def _columns_together(edges, words):
    """Return how many columns, 4, 2 or 1, never lie on both sides of an edge."""
    return next(group for group in (4, 2, 1) if not (edges % (2 * words) % group).any())


def _full_sum(x, y, z):
    """Return the digit and the carry of the sum of three bits."""
    return x ^ y ^ z, (x & y) | (z & (x ^ y))


def _sum(ones, others):
    """Return the digits of the sums of two stacks."""
    digits, carry = [], 0
    for one, other in zip(ones, others, strict=True):
        digit, carry = _full_sum(one, other, carry)
        digits.append(digit)
    return digits


def _add_rows(streams):
    """Return the digits of a stack, which follows TOGETHER rows of bits, with the bits added."""
    one, two = _full_sum(*(streams[each] for each in range(3)))
    other, other_two = _full_sum(*(streams[each] for each in range(3, 6)))
    one, last_two = _full_sum(one, other, streams[6])
    two, four = _full_sum(two, other_two, last_two)
    stack = [streams[TOGETHER + digit] for digit in range(DIGITS)]
    return _sum(stack, [one, two, four] + [0] * (DIGITS - 3))


def _each_column(streams):
    """Return the counts of a stack as bytes: that of lane 8b + r becomes byte b of word r."""
    return transposed(streams[digit] for digit in range(DIGITS))


def _both_columns(streams):
    """Return the sums of the counts of even and of odd columns as bytes."""
    return transposed(_sum(*([streams[first + digit] for digit in range(DIGITS)] for first in (0, DIGITS))))


def _four_columns(streams):
    """Return the sums of the counts of every four columns as bytes; streams are read word pair by word pair."""
    columns = [[streams[first + digit][word] for digit in range(DIGITS)] for first in (0, DIGITS) for word in (0, 1)]
    return transposed(_sum(_sum(*columns[:2]), _sum(*columns[2:])))


@lru_cache(maxsize=32)
def _compiled(substances, decorated, depth):
    """Return (pass, RowStreams, number of sorts): what finds the cells of each sort in the columns of each parity."""
    reader = RowStreams(substances.bits, decorated, depth)

    def find(streams):
        parities = [counted(substances, *each) for each in reader.parities(streams)]
        return [each for sort in zip(*parities, strict=True) for each in sort]

    code, writes = word_pass(find, reader.reads)
    return code, reader, writes // 2


@lru_cache(maxsize=1)
def _sums():
    """Return the passes that add rows up, and that make bytes of counts of each, of both and of every four columns."""
    shapes = (_add_rows, TOGETHER + DIGITS), (_each_column, DIGITS), (_both_columns, 2 * DIGITS)
    return [word_pass(*each)[0] for each in shapes] + [word_pass(_four_columns, 2 * DIGITS, pairs=True)[0]]


class CountPass:
    """Draws the mean light of cells of some Substances in rows of `words` words, in memory of its own."""

    def __init__(self, substances, words, decorated, depth):
        code, self._reader, sorts = _compiled(substances, decorated, depth)
        self._passes = code, *_sums()  # kept: the caches may forget them, and two threads may have made them twice
        self._codes = np.array([each.address for each in self._passes], np.int64)
        side = -(-words // LINE) * LINE + LINE  # words from even to odd columns: no vector goes on into others' words
        rows = (TOGETHER + DIGITS) * sorts + DIGITS + 1
        self._scratch = aligned(rows * 2 * side).reshape(rows, 2 * side)
        self._scratch[:] = 0
        places = addresses(self._scratch)
        stacks, last = places[TOGETHER * sorts : -DIGITS - 1].reshape(sorts, DIGITS), places[-DIGITS - 1 : -1]
        bits = places[: TOGETHER * sorts].reshape(TOGETHER, sorts).T
        odd, last = stacks + 8 * side, np.tile(last, (sorts, 1))
        self._at_sums = np.hstack([bits, stacks, stacks, stacks, last, stacks, odd, last])
        self._at_find = np.zeros(self._reader.reads + 2 * sorts, np.int64)
        self._nothing = places[-1]

    def draw(self, planes, where, decor, columns, *how):
        """Draw rows of planes as `draw_density` does; decor: as many planes as the pass was made for, may be none."""
        places = self._reader.places(planes, where, decor)
        looked = places, self._at_find, self._nothing, self._reader.bits
        group, width = _columns_together(columns, where.words), len(columns) - 1
        found = (
            *_find_edges(columns, where.words, group),
            np.empty(width + 1, np.int32),  # cells before each edge
            np.empty((len(self._at_sums), width), np.int32),  # cells of each sort in each pixel
            np.empty(width, np.float32),  # the share of a cell in each pixel
            np.empty(3 * int(_GREEN), np.float32),
            np.zeros((2 * where.words + 1) * int(_SUMS), np.uint64),
        )
        counting = self._codes, looked, self._at_sums, self._scratch, found, group
        draw_density(*counting, where.stride, where.words, columns, *how)


@gate
def _find_rows(code, looked, at_sums, scratch, sorts, stride, words, top, bottom):
    """Write where there are cells of each sort in TOGETHER lattice rows from `top`, none from `bottom` on."""
    places, at, nothing, bits = looked
    side = scratch.shape[1] >> 1
    for row in range(TOGETHER):
        first = row * sorts
        if top + row < bottom:
            find_row(places, top + row, stride, bits, nothing, at)
            for sort in range(sorts):
                to = len(at) - 2 * (sorts - sort)
                at[to] = at_sums[sort, row]
                at[to + 1] = at_sums[sort, row] + 8 * side
            call_words(code, at, 0, words)
            for sort in range(sorts):  # an odd one out has nothing beside it
                scratch[first + sort, words] = scratch[first + sort, side + words] = _ZERO
        else:
            for sort in range(sorts):
                _clear(scratch[first + sort])


@gate
def _clear(row):
    for i in range(len(row)):
        row[i] = _ZERO


@gate
def _stack_rows(codes, looked, at, scratch, stride, words, top, bottom, seen):
    """Count the cells of each sort of the lattice rows from `top` in every column; note which there are any of."""
    sorts, side = len(seen), scratch.shape[1] >> 1
    stacks = TOGETHER * sorts
    for row in range(stacks, stacks + DIGITS * sorts):
        _clear(scratch[row])
    for first in range(top, bottom, TOGETHER):
        _find_rows(codes[0], looked, at, scratch, sorts, stride, words, first, bottom)
        for sort in range(sorts):
            call_words(codes[1], at, sort * at.shape[1], side + words)
    for sort in range(sorts):
        some = _ZERO
        for row in range(stacks + DIGITS * sort, stacks + DIGITS * (sort + 1)):
            for word in range(words):
                some |= scratch[row, word] | scratch[row, side + word]
        seen[sort] = some != _ZERO


@gate
def _add_to_sums(scratch, word, sums, at):
    """Write the sums at a place, from those before it and the bytes of one word."""
    for r in range(_EIGHT):
        counts = scratch[len(scratch) - 9 + r, word]
        sums[at + r] = sums[at - _SUMS + r] + (counts & _HALVES)
        sums[at + _EIGHT + r] = sums[at - _EIGHT + r] + ((counts >> _EIGHT) & _HALVES)


def _find_edges(edges, words, group):
    """Return the first edge of each lane, and the place of each edge's sum in the sums as a flat uint16 array."""
    lanes = np.minimum(edges // (2 * words), BITS - 1)
    places = _place_of_sum(lanes, (edges - lanes * 2 * words + group - 1) // group)
    return np.searchsorted(lanes, np.arange(BITS + 1)).astype(np.uint64), places.astype(np.uint32)


@gate
def _place_of_sum(lane, before):
    """Return where the sum is of what `before` places have counted in a lane."""
    return (before * 16 + 8 * ((lane >> 3) & 1) + (lane & 7)) * 4 + (lane >> 4)


@gate
def _count_spans(sums, size, starts, places, before, counts):
    """Add to `counts` what was counted between every two edges; a lane has `size` sums."""
    base = np.int32(0)
    for lane in range(BITS):
        for i in range(starts[lane], starts[lane + 1]):
            before[i] = base + np.int32(sums[places[i]])
        base += np.int32(sums[_place_of_sum(lane, size)])
    for pixel in range(len(counts)):
        counts[pixel] += before[pixel + 1] - before[pixel]


@gate
def _count_sort(codes, at, scratch, words, sort, group, starts, places, sums, flat, before, counts):
    """Add to `counts` the cells of a sort that has been stacked in each pixel."""
    side, first = scratch.shape[1] >> 1, sort * at.shape[1] + TOGETHER + 2 * DIGITS
    if group == 1:
        size = 2 * words
        call_words(codes[2], at, first, side + words)
        for word in range(words):
            _add_to_sums(scratch, word, sums, np.uint64(2 * word + 1) * _SUMS)
            _add_to_sums(scratch, side + word, sums, np.uint64(2 * word + 2) * _SUMS)
    else:
        size = words if group == 2 else (words + 1) >> 1
        call_words(codes[3 if group == 2 else 4], at, first + 2 * DIGITS, size)
        for word in range(size):
            _add_to_sums(scratch, word, sums, np.uint64(word + 1) * _SUMS)
    _count_spans(flat, size, starts, places, before, counts)


@gate
def _level(light):
    return np.uint32(min(max(light, np.float32(0.0)), np.float32(LIGHTS - 1)))


@gate
def _mix_row(counts, seen, cells, lights, channels, light, line, left):
    """Write the colours of a row of pixels, from the counts of the sorts seen and the share of a cell in each pixel."""
    width = np.uint64(counts.shape[1])
    for i in range(width):
        light[i] = lights[0, 0] + 0.5
        light[_GREEN + i] = lights[0, 1] + 0.5
        light[_BLUE + i] = lights[0, 2] + 0.5
    for sort in range(counts.shape[0]):
        if seen[sort]:
            of_sort, more = counts[sort], lights[1 + sort]
            red, green, blue = np.float32(more[0]), np.float32(more[1]), np.float32(more[2])
            for i in range(width):
                share = np.float32(of_sort[i]) * cells[i]
                light[i] += share * red
                light[_GREEN + i] += share * green
                light[_BLUE + i] += share * blue
    first, last_red, last_green, last_blue, colour = np.uint64(left), _NONE, _NONE, _NONE, np.uint32(0)
    for i in range(width):
        red, green, blue = light[i], light[_GREEN + i], light[_BLUE + i]
        if red != last_red or green != last_green or blue != last_blue:  # most pixels are like the one before
            last_red, last_green, last_blue = red, green, blue
            colour = channels[0, _level(red)] | channels[1, _level(green)] | channels[2, _level(blue)]
        line[first + i] = colour


@kernel
def draw_density(
    codes, looked, at, scratch, found, group, stride, words, columns, rows, lights, channels, pixels, top, left
):
    """Draw the mean light of the cells of each pixel into `pixels`, an (h, w) uint32 array, in place.

    codes, looked, at, scratch, found, group: how a `CountPass` counts cells, and where. columns: int32, the lattice
    columns between which the pixels from `left` lie, one more than they are, all different; those that `shift_edges`
    gives are drawn sooner. rows: int32, the same for the rows from `top`. lights: (1 + sorts, 3) float64, the light of
    air in levels of 0 … LIGHTS - 1, then what a cell of each sort adds to it. channels: (3, LIGHTS) uint32, a level as
    part of a colour.
    """
    starts, places, before, counts, cells, light, sums = found
    width, sorts = len(columns) - 1, len(lights) - 1
    flat = sums.view(np.uint16)
    seen, ever_seen = np.empty(sorts, np.bool_), np.empty(sorts, np.bool_)
    most = _MOST // group
    for i in range(len(rows) - 1):
        for sort in range(sorts):
            ever_seen[sort] = False
            for j in range(width):
                counts[sort, j] = 0
        for first in range(rows[i], rows[i + 1], most):
            after = min(first + most, rows[i + 1])
            _stack_rows(codes, looked, at, scratch, stride, words, first, after, seen)
            for sort in range(sorts):
                if seen[sort]:
                    ever_seen[sort], here = True, counts[sort]
                    _count_sort(codes, at, scratch, words, sort, group, starts, places, sums, flat, before, here)
        for j in range(width):
            cells[j] = np.float32(1.0) / np.float32((columns[j + 1] - columns[j]) * (rows[i + 1] - rows[i]))
        _mix_row(counts, ever_seen, cells, lights, channels, light, pixels[top + i], left)
