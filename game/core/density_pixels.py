"""Planes to colours where a pixel holds many cells: they are counted, 64 columns at a time, and their light is mixed.

Rows are added up bit by bit: each word of a row has a stack of words whose b-th holds the b-th digits of its columns'
counts. Counts are then taken out of the words, eight columns at a time, and summed along each lane, the neighbouring
columns that are one bit of all words of a row. So the cells of any span of columns are the difference of two sums.
"""

import numpy as np

from game.core.jit import gate, kernel
from game.core.planes import BITS, SAND, WALLS

KINDS = 3  # what is counted: sand, that part of it that has nothing on it, walls
DECOR_KINDS = 4  # and in decorated lattices: wooden walls, the inside of a glass, its reflections, posts
MOST_ROWS = 255  # of lattice rows in one stack: a column's count is taken out as a byte
LIGHTS = 4096  # levels of linear light that are told apart

_DIGITS = 8  # of a column's count
_AT_ONCE = 3  # rows that are added to a stack together
_SUMS = 16  # words that hold the sums of all lanes, in 16 bits each

_ZERO = np.uint64(0)
_BYTE = np.uint64(8)
_ONES = np.uint64(0x0101010101010101)
_HALVES = np.uint64(0x00FF00FF00FF00FF)


@gate
def _kinds_of_row(planes, decor, stride, words, y, bits):
    """Write where in lattice row y a cell of each kind is to `bits`: for each kind the even, then the odd columns."""
    start = (y >> 1) * stride
    above = start - stride * (1 - (y & 1))
    for parity in range(2):
        plane, sand_at = 2 * (y & 1) + parity, parity * words
        lit_at, wall_at = sand_at + 2 * words, sand_at + 4 * words
        for word in range(words):
            sand, walls = planes[SAND + plane, start + word], planes[WALLS + plane, start + word]
            covered = _ZERO
            if above >= 0:
                covered = planes[SAND + (plane ^ 2), above + word] | planes[WALLS + (plane ^ 2), above + word]
            bits[sand_at + word] = sand
            bits[lit_at + word] = sand & ~covered
            bits[wall_at + word] = walls
            if decor is not None:
                first, second = decor[plane, start + word], decor[4 + plane, start + word]
                air, at = ~(sand | walls), wall_at + 2 * words + word
                bits[at] = walls & first
                bits[at + 2 * words] = air & first & ~second
                bits[at + 4 * words] = air & second & ~first
                bits[at + 6 * words] = air & first & second


@gate
def _add_rows(bits, carries, digits, stacks):
    """Add three rows of bits to the stacks, whose counts have `digits` digits, two at least."""
    for i in range(carries.size):
        x, y, z = bits[0, i], bits[1, i], bits[2, i]
        low, high = x ^ y ^ z, (x & y) | (z & (x ^ y))
        ones, twos = stacks[0, i], stacks[1, i]
        carry = ones & low
        stacks[0, i] = ones ^ low
        stacks[1, i] = twos ^ high ^ carry
        carries[i] = (twos & high) | (carry & (twos ^ high))
    for digit in range(2, digits):
        for i in range(carries.size):
            count = stacks[digit, i]
            stacks[digit, i] = count ^ carries[i]
            carries[i] &= count


@gate
def _stack_rows(planes, decor, stride, words, top, bottom, bits, carries, stacks):
    """Count the cells of each kind of the lattice rows from `top` in every column; return the digits of the counts."""
    digits = 2
    while (bottom - top) >> digits:
        digits += 1
    stacks[:digits] = _ZERO
    for first in range(top, bottom, _AT_ONCE):
        for k in range(_AT_ONCE):
            if first + k < bottom:
                _kinds_of_row(planes, decor, stride, words, first + k, bits[k])
            else:
                bits[k] = _ZERO
        _add_rows(bits, carries, digits, stacks)
    return digits


@gate
def _sum_lanes(stacks, first, words, digits, counts, sums):
    """Write to sums[j] how many cells the words before the j-th of a stack's row have in each lane; say if any."""
    some = _ZERO
    for digit in range(digits):
        for word in range(words):
            some |= stacks[digit, first + word]
    if some == _ZERO:
        return False
    for word in range(words):
        for k in range(8):
            counts[k] = (stacks[0, first + word] >> np.uint64(k)) & _ONES
        for digit in range(1, digits):
            bits = stacks[digit, first + word]
            for k in range(8):
                counts[k] |= ((bits >> np.uint64(k)) & _ONES) << np.uint64(digit)
        for k in range(8):
            sums[word + 1, k] = sums[word, k] + (counts[k] & _HALVES)
            sums[word + 1, 8 + k] = sums[word, 8 + k] + ((counts[k] >> _BYTE) & _HALVES)
    return True


@gate
def _place_of_sum(lane, word):
    """Return where the sum of a lane before a word is, in the sums as a flat uint16 array."""
    return (word * _SUMS + 8 * ((lane >> 3) & 1) + (lane & 7)) * 4 + (lane >> 4)


@gate
def _find_edges(edges, words, lanes, places):
    """Write the lane of each edge between pixels, and the place of its sum, for the even and the odd columns."""
    for i in range(edges.size):
        for parity in range(2):
            before = (edges[i] + 1 - parity) >> 1  # so many columns of this parity
            lane = min(before // words, BITS - 1)
            lanes[parity, i] = lane
            places[parity, i] = _place_of_sum(lane, before - lane * words)


@gate
def _count_spans(sums, words, lanes, places, before, counts):
    """Add to `counts` the cells between every two edges."""
    before[0] = 0
    for lane in range(BITS - 1):
        before[lane + 1] = before[lane] + np.int32(sums[_place_of_sum(lane, words)])
    last = before[lanes[0]] + np.int32(sums[places[0]])
    for i in range(counts.size):
        edge = before[lanes[i + 1]] + np.int32(sums[places[i + 1]])
        counts[i] += edge - last
        last = edge


@gate
def _mix_row(counts, columns, rows, lights, channels, levels, line, left):
    """Write the colours of a row of pixels, from the counts of each kind in it."""
    for channel in range(3):
        for i in range(counts.shape[1]):
            cells = np.float64(np.int32(columns[i + 1] - columns[i]) * rows)
            light = 0.0
            for kind in range(counts.shape[0]):
                light += counts[kind, i] * lights[1 + kind, channel]
            levels[channel, i] = np.int32(lights[0, channel] + light / cells + 0.5)
    for i in range(counts.shape[1]):
        line[left + i] = channels[0, levels[0, i]] | channels[1, levels[1, i]] | channels[2, levels[2, i]]


@kernel
def draw_density(planes, decor, stride, words, columns, rows, lights, channels, pixels, top, left):
    """Draw the mean light of the cells of each pixel into `pixels`, an (h, w) uint32 array, in place.

    decor: None, or what stands still behind or in the cells, see core.decor. columns: int32, the lattice columns
    between which the pixels from `left` lie, one more than they are, all different. rows: int32, the same for the rows
    from `top`. lights: (1 + KINDS + DECOR_KINDS, 3) float64, the light of air in levels of 0 … LIGHTS - 1, then what a
    cell of each kind adds to it. channels: (3, LIGHTS) uint32, each level as part of a colour.
    """
    kinds = KINDS if decor is None else KINDS + DECOR_KINDS
    width, size = len(columns) - 1, kinds * 2 * words
    bits, carries = np.empty((_AT_ONCE, size), np.uint64), np.empty(size, np.uint64)
    stacks, in_byte = np.empty((_DIGITS, size), np.uint64), np.empty(8, np.uint64)
    sums = np.zeros((words + 1, _SUMS), np.uint64)
    flat = sums.reshape(-1).view(np.uint16)
    lanes, places = np.empty((2, width + 1), np.int32), np.empty((2, width + 1), np.int32)
    before, counts = np.empty(BITS, np.int32), np.empty((kinds, width), np.int32)
    levels = np.empty((3, width), np.int32)
    _find_edges(columns, words, lanes, places)
    for i in range(len(rows) - 1):
        counts[:] = 0
        for first in range(rows[i], rows[i + 1], MOST_ROWS):
            after = min(first + MOST_ROWS, rows[i + 1])
            digits = _stack_rows(planes, decor, stride, words, first, after, bits, carries, stacks)
            for part in range(2 * kinds):
                if _sum_lanes(stacks, part * words, words, digits, in_byte, sums):
                    _count_spans(flat, words, lanes[part & 1], places[part & 1], before, counts[part >> 1])
        _mix_row(counts, columns, rows[i + 1] - rows[i], lights, channels, levels, pixels[top + i], left)
