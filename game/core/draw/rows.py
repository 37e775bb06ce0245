"""Rows: where a pass finds the words of a lattice row and of what lies around it.

Streams come in this order: for the row itself, the one above, the one above that and the one below, the bits of the
codes of the even columns, then of the odd ones; the two bits of decor and those of colours, likewise; what is at the
left of the even columns and at the right of the odd ones.
"""

from functools import lru_cache

import numpy as np

from game.core.draw.looks import Around
from game.core.jit import gate
from game.core.loops.calls import copy
from game.core.planes import BITS, LINE

_ONE, _LAST = np.uint64(1), np.uint64(BITS - 1)
_WORD = 8  # bytes


class RowStreams:
    """Reads the streams of rows by number, as a function for `word_pass` needs them."""

    def __init__(self, bits, decorated, depth):
        self.bits, self.depths = bits, (2 * decorated, depth)
        self.moving = 8 * bits + 2 * sum(self.depths)  # streams that lie in the planes
        self.reads = self.moving + 2 * bits

    def parities(self, streams):
        """Yield (Around, decor, colours) of the even, then of the odd columns."""
        bits = self.bits

        def some(first, number=bits):
            return [streams[first + each] for each in range(number)]

        for parity in range(2):
            rows = [some((2 * row + parity) * bits) for row in range(4)]
            even_or_odd = rows[0], some((1 - parity) * bits)
            sides = some(self.moving + parity * bits)
            left, right = (even_or_odd[1], sides) if parity else (sides, even_or_odd[1])
            start, extras = 8 * bits, []
            for depth in self.depths:
                extras.append(some(start + parity * depth, depth))
                start += 2 * depth
            yield Around(*rows, left, right), *extras

    def places(self, planes, where, decor):
        """Return the address of each stream in the planes for the rows 0 and 1, (2, moving) int64."""
        offsets, of_decor = _offsets(self.bits, self.depths, where.stride, planes.shape[1], decor.shape[1])
        return np.where(of_decor, decor.ctypes.data, planes.ctypes.data) + offsets


@lru_cache(maxsize=64)
def _offsets(bits, depths, stride, length, decor_length):
    """Return how far in bytes each stream of the rows 0 and 1 is from the start of its planes, and if those are decor.

    Both are (2, moving). length, decor_length: words in a plane.
    """
    found = []
    for odd in range(2):
        rows = (odd, 0), (1 - odd, odd - 1), (odd, -1), (1 - odd, odd)
        codes = [
            (4 * bit + 2 * row + parity) * length + further * stride
            for row, further in rows
            for parity in range(2)
            for bit in range(bits)
        ]
        decor = [(4 * bit + 2 * odd + parity) * decor_length for parity in range(2) for bit in range(depths[0])]
        colours = [(4 * (bits + bit) + 2 * odd + parity) * length for parity in range(2) for bit in range(depths[1])]
        found.append([*codes, *decor, *colours])
    of_decor = [False] * len(codes) + [True] * len(decor) + [False] * len(colours)
    return _WORD * np.array(found, np.int64), np.array([of_decor] * 2)


def room_for(words, number):
    """Return room for so many streams that a pass reads or writes, of zeros: (number, words + LINE) uint64."""
    return np.zeros((number, words + LINE), np.uint64)


def addresses(streams):
    """Return the address of each row of an array: int64."""
    return streams.ctypes.data + np.arange(len(streams), dtype=np.int64) * streams.strides[0]


@gate
def find_row(places, y, stride, bits, nothing, at):
    """Write the addresses of the streams of lattice row y to `at`; above the lattice there is air, at `nothing`."""
    further = (y >> 1) * stride * _WORD
    for k in range(places.shape[1]):
        at[k] = places[y & 1, k] + further
    for k in range(2 * bits if y == 0 else 4 * bits, 6 * bits if y < 2 else 0):
        at[k] = nothing


@gate
def find_sides(planes, y, stride, words, outside, sides):
    """Write what is at the left of the even columns of row y, then what is at the right of the odd ones, to `sides`.

    sides: (2·bits, words + LINE) uint64. outside: the code of what is outside.
    """
    start, bits = (y >> 1) * stride, len(sides) >> 1
    for bit in range(bits):
        even, beyond = 4 * bit + 2 * (y & 1), np.uint64((outside >> bit) & 1)
        sides[bit, 0] = (planes[even + 1, start + words - 1] << _ONE) | beyond
        copy(planes[even + 1], start, sides[bit], 1, words - 1)
        copy(planes[even], start + 1, sides[bits + bit], 0, words - 1)
        sides[bits + bit, words - 1] = (planes[even, start] >> _ONE) | (beyond << _LAST)
