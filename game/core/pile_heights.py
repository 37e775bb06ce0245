"""Heights: how many grains rest on the ground in each column and how high they reach, 64 columns at a time."""

import numpy as np

from game.core.jit import gate, kernel
from game.core.planes import BITS

DIGITS = 15  # binary places of a height: a lattice is at most 16384 cells high

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_FULL = np.uint64(2**64 - 1)


@gate
def _add(digits, ones):
    """Count one more where `ones` is set: bit i of digit k belongs to the k-th binary place of count i."""
    k = 0
    while ones:
        carry = digits[k] & ones
        digits[k] ^= ones
        ones = carry
        k += 1


@gate
def _set(digits, lanes, number):
    """Give the counts of some lanes a number."""
    for k in range(DIGITS):
        digits[k] = digits[k] | lanes if number >> k & 1 else digits[k] & ~lanes


@gate
def _stack(filled, solid, stride, word, parity, top, bottom, digits, tops):
    """Count the grains that rest in the rows from `bottom` - 1 up to `top`, in the columns of one word.

    Count in `tops` the rows from the bottom up to the uppermost of them.
    """
    standing, resting = _FULL, _ZERO
    for y in range(bottom - 1, top - 1, -1):
        plane, at = 2 * (y & 1) + parity, (y >> 1) * stride + word
        sand, walls = filled[plane, at], solid[plane, at]
        standing = (standing & (sand | walls)) | (walls & ~resting)
        resting |= standing & sand
        if standing & sand:
            _add(digits, standing & sand)
            _set(tops, standing & sand, bottom - y)


@gate
def _number(digits, lane):
    """Return one of the 64 counts."""
    number = _ZERO
    for k in range(DIGITS):
        number |= ((digits[k] >> lane) & _ONE) << np.uint64(k)
    return np.int64(number)


@kernel
def stack_heights(filled, solid, stride, words, top, bottom, heights, surface):
    """Write how many grains rest on the ground in each column, in rows `top` … `bottom` - 1, to (W,) int64 `heights`.

    Write to `surface`, alike, how many rows lie from the bottom up to the uppermost of them, 0 where there is none.

    filled, solid: four planes each, of the grains and of the walls. The ground is the row `bottom`, or the highest wall
    below the lowest sand on a wall; sand above a gap is left out.
    """
    width = len(heights)
    digits, tops = np.empty(DIGITS, np.uint64), np.empty(DIGITS, np.uint64)
    for word in range(words):
        for parity in range(2):
            digits[:] = _ZERO
            tops[:] = _ZERO
            _stack(filled, solid, stride, word, parity, top, bottom, digits, tops)
            for lane in range(BITS):
                x = 2 * (lane * words + word) + parity
                if x < width:
                    heights[x] = _number(digits, np.uint64(lane))
                    surface[x] = _number(tops, np.uint64(lane))
