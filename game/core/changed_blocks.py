"""Blocks that one iteration has made of other codes than they were of, found by comparing the planes before and after.

A block whose cells only changed places is none of them.
"""

import numpy as np

from game.core.jit import gate, kernel

_ZERO, _ONE, _TOP = np.uint64(0), np.uint64(1), np.uint64(63)
_FULL = np.uint64(2**64 - 1)


@gate
def _take(planes, where, row, word, x, blocks):
    """Write the bits of the corners of 64 blocks to `blocks`, at corner · bits + bit.

    row: that of the upper corners. where: (words in a plane row, bits, outside). Word number `words` is of the blocks
    half outside on the left, of which there is one.
    """
    words, bits, outside = where
    for bit in range(bits):
        beyond = _FULL if (outside >> bit) & 1 else _ZERO
        for corner in range(4):
            line, right = row + (corner >> 1), corner & 1
            plane, start = 4 * bit + 2 * (line & 1) + (x ^ right), (line >> 1) * (words + 1)
            if line < 0 or (word == words and right == 0):
                found = beyond
            elif word == words:
                found = planes[plane, start]
            elif x & right and word == words - 1:
                found = (planes[plane, start] >> _ONE) | (beyond << _TOP)
            else:
                found = planes[plane, start + word + (x & right)]
            blocks[corner * bits + bit] = found


@gate
def _block(blocks, bits, lane):
    """Return (the state of a block, as in `core.rule_table`; how many cells of each code it has, four bits each)."""
    state, cells = _ZERO, _ZERO
    for corner in range(4):
        code = _ZERO
        for bit in range(bits):
            code |= ((blocks[corner * bits + bit] >> lane) & _ONE) << np.uint64(bit)
        state |= code << np.uint64(corner * bits)
        cells += _ONE << (code << np.uint64(2))
    return np.int64(state), cells


@kernel
def changed_blocks(before, after, where, height, offset, watched, band_rows, found):
    """Write the states before and after of blocks of other codes to `found`, (n, 2) int64; return their number.

    That may be more than n: the rest is left out. where: (words in a plane row, bits of a code, the one outside).
    height: of the lattice. offset: the (x, y) of the iteration's partition. watched: whether to look at the
    blocks that begin in each band of `band_rows` plane rows.
    """
    (words, bits, _), (x, y), number = where, offset, 0
    old, new = np.empty(4 * bits, np.uint64), np.empty(4 * bits, np.uint64)
    for row in range(-y, height, 2):
        if not watched[max(row, 0) // 2 // band_rows]:
            continue
        for word in range(words + x):
            _take(before, where, row, word, x, old)
            _take(after, where, row, word, x, new)
            left = _ZERO
            for each in range(4 * bits):
                left |= old[each] ^ new[each]
            if word == words:
                left &= _ONE
            lane = _ZERO
            while left:
                if left & _ONE:
                    one, cells = _block(old, bits, lane)
                    other, others = _block(new, bits, lane)
                    if cells != others:
                        if number < len(found):
                            found[number, 0], found[number, 1] = one, other
                        number += 1
                left >>= _ONE
                lane += _ONE
    return number
