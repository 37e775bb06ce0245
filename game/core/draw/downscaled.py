"""Planes to colours where a pixel holds many cells: they are counted, 64 columns at a time, and their light is mixed.

It is done kind by kind. Seven rows at a time are added up bit by bit: each word of a row has a stack of words, whose
d-th holds the d-th digits of its columns' counts. Where pixels are wide, neighbouring columns are added up in that way.
Then the stacks are transposed, so that each count is a byte, and summed along each lane, the neighbouring columns that
are one bit of all words of a row: so the cells between any two edges of pixels are the difference of two sums.

All working memory is one flat array of rows, since the compiler has to check separate arrays for overlap, and indices
are unsigned, since signed ones may count from the end: either keeps it from working on whole vectors. The large parts
are kernels of their own, so that most of them is compiled once for lattices with and without decor or colours.
"""

import numpy as np

from game.core.jit import gate, kernel
from game.core.planes import BITS, COLOURS, DEPTH, SAND, WALLS

KINDS = 3  # what is counted: sand, that part of it that has nothing on it, walls
DECOR_KINDS = 4  # and in decorated lattices: wooden walls, the inside of a glass, its reflections, posts
DYES = 2**DEPTH - 1  # and where sand has colours: sand of each but the first
LIGHTS = 4096  # levels of linear light that are told apart

_GRAINS, _LIT, _WALL, _WOOD, _INSIDE, _GLEAM, _POST, _DYED = range(8)
_PAIRED, _FOURFOLD = 8, 16  # cells to a pixel from which its edges may move by an eighth of it, to even columns or more
_MOST = 255  # cells in one count, which is taken out of the words as a byte
_DIGITS = np.uint64(8)
_ROW = np.uint64(
    272
)  # words from one row of working memory to the next: even columns, 128 words at most, then odd ones
_ODD = np.uint64(136)
_BITS, _STACKS, _OTHERS = np.uint64(0), np.uint64(7) * _ROW, np.uint64(15) * _ROW  # where bits and stacks start
_SCRATCH = 23 * 272
_SUMS = np.uint64(16)  # words that hold the sums of all lanes, in 16 bits each

_NONE = np.float32(-1e9)  # no amount of light
_GREEN, _BLUE = np.uint64(16400), np.uint64(2 * 16400)  # where the green and the blue light of a row starts: more than
# the widest lattice has columns
_ZERO = np.uint64(0)
_ONE, _TWO, _THREE, _FOUR, _EIGHT = np.uint64(1), np.uint64(2), np.uint64(3), np.uint64(4), np.uint64(8)
_NIBBLES, _PAIRS, _SINGLES = np.uint64(0x0F0F0F0F0F0F0F0F), np.uint64(0x3333333333333333), np.uint64(0x5555555555555555)
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


@gate
def _columns_together(edges, words):
    """Return how many columns, 4, 2 or 1, never lie on both sides of an edge."""
    group = 4
    for i in range(edges.size):
        inside = edges[i] % (2 * words)
        while inside % group:
            group >>= 1
    return group


@gate
def _full_sum(x, y, z):
    """Return the digit and the carry of the sum of three bits."""
    return x ^ y ^ z, (x & y) | (z & (x ^ y))


@gate
def _lit(planes, plane, other, start, above, first, word):
    """Return where the sand of a word has nothing on it; first: it is that of the uppermost row."""
    covered = planes[SAND + other, above + word] | planes[WALLS + other, above + word]
    return planes[SAND + plane, start + word] & (~covered | first)


@gate
def _of_colour(planes, plane, at, colour):
    """Return where the cells of a word have sand of a colour."""
    low = planes[COLOURS + plane, at] ^ (_ZERO - np.uint64(~colour & 1))
    middle = planes[COLOURS + 4 + plane, at] ^ (_ZERO - np.uint64(~(colour >> 1) & 1))
    high = planes[COLOURS + 8 + plane, at] ^ (_ZERO - np.uint64(~(colour >> 2) & 1))
    return planes[SAND + plane, at] & low & middle & high


@gate
def _bits_of_row(planes, decor, dyed, kind, stride, words, y, scratch, row):
    """Write where in lattice row y there are cells of a kind: first the even, then the odd columns."""
    start = np.uint64((y >> 1) * stride)
    above = np.uint64(max(0, (y >> 1) - (1 - (y & 1))) * stride)
    first = _ZERO - np.uint64(y == 0)
    for parity in range(2):
        plane, to = 2 * (y & 1) + parity, row + np.uint64(parity) * _ODD
        other = plane ^ 2
        if kind in (_GRAINS, _WALL):
            what = plane + (SAND if kind == _GRAINS else WALLS)
            for word in range(words):
                scratch[to + word] = planes[what, start + word]
        elif kind == _LIT:
            for word in range(words):
                scratch[to + word] = _lit(planes, plane, other, start, above, first, word)
        elif kind >= _DYED:
            if dyed:
                for word in range(words):
                    scratch[to + word] = _of_colour(planes, plane, start + word, kind - _DYED + 1)
        elif decor is not None:
            _bits_of_decor(planes, decor, kind, plane, start, words, scratch, to)


@gate
def _bits_of_decor(planes, decor, kind, plane, start, words, scratch, to):
    not_first, not_second = _ZERO - np.uint64(kind == _GLEAM), _ZERO - np.uint64(kind == _INSIDE)
    for word in range(words):
        walls = planes[WALLS + plane, start + word]
        first, second = decor[plane, start + word], decor[4 + plane, start + word]
        if kind == _WOOD:
            scratch[to + word] = walls & first
        else:
            air = ~(planes[SAND + plane, start + word] | walls)
            scratch[to + word] = air & (first ^ not_first) & (second ^ not_second)


@gate
def _add_rows(scratch, first, words):
    """Add seven rows of bits to the stacks, from their word `first`."""
    for i in range(first, first + words):
        at = _BITS + i
        one, two = _full_sum(scratch[at], scratch[at + _ROW], scratch[at + _TWO * _ROW])
        at += _THREE * _ROW
        other, other_two = _full_sum(scratch[at], scratch[at + _ROW], scratch[at + _TWO * _ROW])
        one, last_two = _full_sum(one, other, scratch[at + _THREE * _ROW])
        two, four = _full_sum(two, other_two, last_two)
        at = _STACKS + i
        scratch[at], carry = _full_sum(scratch[at], one, _ZERO)
        scratch[at + _ROW], carry = _full_sum(scratch[at + _ROW], two, carry)
        scratch[at + _TWO * _ROW], carry = _full_sum(scratch[at + _TWO * _ROW], four, carry)
        for digit in range(_THREE, _DIGITS):
            count = scratch[at + digit * _ROW]
            scratch[at + digit * _ROW] = count ^ carry
            carry &= count


@gate
def _clear(scratch, first, size):
    for i in range(size):
        scratch[first + i] = _ZERO


@kernel
def _stack_rows(planes, decor, dyed, kind, stride, words, top, bottom, scratch):
    """Count the cells of a kind of the lattice rows from `top` in every column; return whether there are any."""
    some = _ZERO
    for digit in range(_DIGITS):
        _clear(scratch, _STACKS + digit * _ROW, _ODD + words)
    for first in range(top, bottom, 7):
        for k in range(7):
            row = _BITS + np.uint64(k) * _ROW
            if first + k < bottom:
                _bits_of_row(planes, decor, dyed, kind, stride, words, first + k, scratch, row)
                for word in range(words):
                    some |= scratch[row + word] | scratch[row + _ODD + word]
            else:
                _clear(scratch, row, _ODD + words)
        _add_rows(scratch, _ZERO, words)
        _add_rows(scratch, _ODD, words)
    return some != _ZERO


@gate
def _add_parities(scratch, words):
    """Write the sums of the counts of even and of odd columns to the other stacks."""
    for i in range(words):
        carry = _ZERO
        for digit in range(_DIGITS):
            at = digit * _ROW + i
            one, other = scratch[_STACKS + at], scratch[_STACKS + at + _ODD]
            scratch[_OTHERS + at], carry = _full_sum(one, other, carry)


@gate
def _add_neighbours(scratch, words):
    """Write the sums of every two words' counts in the other stacks; an odd one out has nothing beside it."""
    for digit in range(_DIGITS):
        scratch[_OTHERS + digit * _ROW + words] = _ZERO
    for i in range((words + _ONE) >> _ONE):
        carry = _ZERO
        for digit in range(_DIGITS):
            at = digit * _ROW
            one, other = scratch[_OTHERS + at + _TWO * i], scratch[_OTHERS + at + _TWO * i + _ONE]
            scratch[_STACKS + at + i], carry = _full_sum(one, other, carry)


@gate
def _swapped(x, y, shift, mask):
    """Return two words that have changed the bits under `mask` of one for those `shift` higher of the other."""
    t = ((x >> shift) ^ y) & mask
    return x ^ (t << shift), y ^ t


@gate
def _transpose(scratch, stacks, size):
    """Make bytes of the counts, in place: that of lane 8b + r becomes byte b of word r of its stack."""
    for i in range(size):
        at = stacks + i
        lower = at + _FOUR * _ROW
        a, b, c, d = scratch[at], scratch[at + _ROW], scratch[at + _TWO * _ROW], scratch[at + _THREE * _ROW]
        e, f, g, h = scratch[lower], scratch[lower + _ROW], scratch[lower + _TWO * _ROW], scratch[lower + _THREE * _ROW]
        a, e = _swapped(a, e, _FOUR, _NIBBLES)
        b, f = _swapped(b, f, _FOUR, _NIBBLES)
        c, g = _swapped(c, g, _FOUR, _NIBBLES)
        d, h = _swapped(d, h, _FOUR, _NIBBLES)
        a, c = _swapped(a, c, _TWO, _PAIRS)
        b, d = _swapped(b, d, _TWO, _PAIRS)
        e, g = _swapped(e, g, _TWO, _PAIRS)
        f, h = _swapped(f, h, _TWO, _PAIRS)
        scratch[at], scratch[at + _ROW] = _swapped(a, b, _ONE, _SINGLES)
        scratch[at + _TWO * _ROW], scratch[at + _THREE * _ROW] = _swapped(c, d, _ONE, _SINGLES)
        scratch[lower], scratch[lower + _ROW] = _swapped(e, f, _ONE, _SINGLES)
        scratch[lower + _TWO * _ROW], scratch[lower + _THREE * _ROW] = _swapped(g, h, _ONE, _SINGLES)


@gate
def _add_to_sums(scratch, counted, sums, at):
    """Write the sums at a place, from those before it and the bytes of one word."""
    for r in range(_EIGHT):
        counts = scratch[counted + r * _ROW]
        sums[at + r] = sums[at - _SUMS + r] + (counts & _HALVES)
        sums[at + _EIGHT + r] = sums[at - _EIGHT + r] + ((counts >> _EIGHT) & _HALVES)


@gate
def _find_edges(edges, words, group, starts, places):
    """Write the first edge of each lane, and the place of each edge's sum in the sums as a flat uint16 array."""
    starts[:] = edges.size
    starts[0] = 0
    for i in range(edges.size):
        lane = min(edges[i] // (2 * words), BITS - 1)
        places[i] = _place_of_sum(lane, (edges[i] - lane * 2 * words + group - 1) // group)
        for each in range(lane, 0, -1):
            if starts[each] <= i:
                break
            starts[each] = i


@gate
def _place_of_sum(lane, before):
    """Return where the sum is of what `before` places have counted in a lane."""
    return np.uint32((before * 16 + 8 * ((lane >> 3) & 1) + (lane & 7)) * 4 + (lane >> 4))


@gate
def _count_spans(sums, size, starts, places, before, counts):
    """Add to `counts` what was counted between every two edges; a lane has `size` sums."""
    base = np.int32(0)
    for lane in range(BITS):
        for i in range(starts[lane], starts[lane + 1]):
            before[i] = base + np.int32(sums[places[i]])
        base += np.int32(sums[_place_of_sum(lane, size)])
    for i in range(counts.size):
        counts[i] += before[i + 1] - before[i]


@kernel
def _count_kind(scratch, words, group, starts, places, sums, flat, before, counts):
    """Add to `counts` the cells of the kind that has been stacked in each pixel."""
    size = words
    if group == 1:
        _transpose(scratch, _STACKS, words)
        _transpose(scratch, _STACKS + _ODD, words)
        for word in range(words):
            _add_to_sums(scratch, _STACKS + word, sums, (_TWO * word + _ONE) * _SUMS)
            _add_to_sums(scratch, _STACKS + _ODD + word, sums, (_TWO * word + _TWO) * _SUMS)
        size = _TWO * words
    else:
        _add_parities(scratch, words)
        stacks = _OTHERS
        if group == 4:
            _add_neighbours(scratch, words)
            stacks, size = _STACKS, (words + _ONE) >> _ONE
        _transpose(scratch, stacks, size)
        for word in range(size):
            _add_to_sums(scratch, stacks + word, sums, (word + _ONE) * _SUMS)
    _count_spans(flat, np.int64(size), starts, places, before, counts)


@gate
def _level(light):
    return np.uint32(min(max(light, np.float32(0.0)), np.float32(LIGHTS - 1)))


@kernel
def _mix_row(counts, seen, cells, lights, channels, light, line, left):
    """Write the colours of a row of pixels, from the counts of the kinds seen and the share of a cell in each pixel."""
    width = np.uint64(counts.shape[1])
    for i in range(width):
        light[i] = lights[0, 0] + 0.5
        light[_GREEN + i] = lights[0, 1] + 0.5
        light[_BLUE + i] = lights[0, 2] + 0.5
    for kind in range(counts.shape[0]):
        if seen[kind]:
            of_kind, more = counts[kind], lights[1 + kind]
            red, green, blue = np.float32(more[0]), np.float32(more[1]), np.float32(more[2])
            for i in range(width):
                share = np.float32(of_kind[i]) * cells[i]
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
def draw_density(planes, decor, dyed, stride, words, columns, rows, lights, channels, pixels, top, left):
    """Draw the mean light of the cells of each pixel into `pixels`, an (h, w) uint32 array, in place.

    decor: None, or what stands still behind or in the cells, see core.decor. dyed: whether sand has
    colours. columns: int32, the lattice columns between which the pixels from `left` lie, one more than they are, all
    different; those that `shift_edges` gives are drawn sooner. rows: int32, the same for the rows from `top`. lights:
    (1 + kinds, 3) float64, the light of air in levels of 0 … LIGHTS - 1, then what a cell of each kind adds to it: the
    KINDS, with decor the DECOR_KINDS, with colours the DYES. channels: (3, LIGHTS) uint32, a level as part of a colour.
    """
    width, group = len(columns) - 1, _columns_together(columns, words)
    kinds = KINDS + (0 if decor is None else DECOR_KINDS) + (DYES if dyed else 0)
    scratch = np.zeros(_SCRATCH, np.uint64)
    sums = np.zeros((2 * words + 1) * 16, np.uint64)
    flat = sums.view(np.uint16)
    starts, places = np.empty(BITS + 1, np.uint64), np.empty(width + 1, np.uint32)
    before, counts = np.empty(width + 1, np.int32), np.empty((kinds, width), np.int32)
    seen = np.empty(kinds, np.bool_)
    cells, light = np.empty(width, np.float32), np.empty(3 * _GREEN, np.float32)
    _find_edges(columns, words, group, starts, places)
    most = _MOST // group
    for i in range(len(rows) - 1):
        counts[:] = 0
        seen[:] = False
        for k in range(kinds):
            kind = k + DECOR_KINDS if decor is None and k >= KINDS else k
            for first in range(rows[i], rows[i + 1], most):
                after = min(first + most, rows[i + 1])
                if _stack_rows(planes, decor, dyed, kind, stride, np.uint64(words), first, after, scratch):
                    _count_kind(scratch, np.uint64(words), group, starts, places, sums, flat, before, counts[k])
                    seen[k] = True
        for j in range(width):
            cells[j] = np.float32(1.0) / np.float32((columns[j + 1] - columns[j]) * (rows[i + 1] - rows[i]))
        _mix_row(counts, seen, cells, lights, channels, light, pixels[top + i], left)
