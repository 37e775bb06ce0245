"""Cells to words and back: the striping of four planes, a row at a time.

For a fixed bit the words of a row hold neighbours in turn, so that the compiler moves many of them at once.
"""

import numpy as np

from game.core.jit import gate, kernel

BITS = 64

_ONE = np.uint64(1)
_BYTE, _LOW = np.uint64(8), np.uint64(255)
_SWAPS = (  # shifts and masks that exchange ever larger squares of a block of 8×8 bits
    (np.uint64(7), np.uint64(0x00AA00AA00AA00AA)),
    (np.uint64(14), np.uint64(0x0000CCCC0000CCCC)),
    (np.uint64(28), np.uint64(0x00000000F0F0F0F0)),
)
_LEFT, _HALF = np.uint16(1), np.uint16(8)


@gate
def _gather(pairs, even, odd, words):
    """Write the cells of a row, two neighbours a uint16, to the words of its even and its odd columns."""
    even[:] = 0
    odd[:] = 0
    for bit in range(BITS):
        shift, first = np.uint64(bit), bit * words
        for word in range(words):
            even[word] |= np.uint64(pairs[first + word] & _LEFT) << shift
        for word in range(words):
            odd[word] |= np.uint64(pairs[first + word] >> _HALF) << shift


@kernel
def pack_cells(cells, bit, planes, words):
    """Set the bits of four planes to one bit of `cells`, (H, W) uint8, in place; the rest stays."""
    height, width = cells.shape
    row = np.zeros(2 * BITS * words, np.uint8)
    pairs, used = row.view(np.uint16), np.zeros(2 * BITS * words, np.uint8)
    for x in range(width):
        used[x] = 1
    masks = np.zeros((2, words), np.uint64)
    bits, number = np.empty((2, words), np.uint64), np.uint8(bit)
    _gather(used.view(np.uint16), masks[0], masks[1], words)
    for y in range(height):
        for x in range(width):  # a loop: the message for slices that differ in length takes seconds to compile
            row[x] = (cells[y, x] >> number) & np.uint8(1)
        _gather(pairs, bits[0], bits[1], words)
        start = (y >> 1) * (words + 1)
        for parity in range(2):
            plane = planes[2 * (y & 1) + parity]
            for word in range(words):
                kept = plane[start + word] & ~masks[parity, word]
                plane[start + word] = kept | bits[parity, word]


@kernel
def unpack_cells(planes, words, bit, cells):
    """Set one bit of `cells`, (H, W) uint8, where that of four planes is set, in place; it was 0."""
    height, width, number = cells.shape[0], cells.shape[1], np.uint8(bit)
    pairs = np.empty(BITS * words, np.uint16)
    row = pairs.view(np.uint8)
    for y in range(height):
        start = (y >> 1) * (words + 1)
        even, odd = planes[2 * (y & 1)], planes[2 * (y & 1) + 1]
        for lane in range(BITS):
            shift, first = np.uint64(lane), lane * words
            for word in range(words):
                left = (even[start + word] >> shift) & _ONE
                right = (odd[start + word] >> shift) & _ONE
                pairs[first + word] = np.uint16(left | (right << _BYTE))
        for x in range(width):
            cells[y, x] |= row[x] << number


def turned_cells(cells, quarters):
    """Return (H, W) bool cells after so many quarter turns, clockwise, contiguous."""
    if quarters % 2:
        turned = _transposed(cells[::-1]) if quarters % 4 == 1 else _transposed(cells)[::-1]
    else:
        turned = cells[::-1, ::-1] if quarters % 4 else cells
    return np.ascontiguousarray(turned)


def _transposed(cells):
    """Return bool cells, (H, W), with rows and columns exchanged, by blocks of 8×8 bits."""
    height, width = cells.shape
    bits = np.zeros((-(-height // 8) * 8, -(-width // 8)), np.uint8)
    bits[:height] = np.packbits(cells, axis=1, bitorder="little")
    turned = np.empty((8 * bits.shape[1], bits.shape[0] // 8), np.uint8)
    transpose_bits(bits, turned)
    return np.unpackbits(turned[:width], axis=1, count=height, bitorder="little").view(np.bool_)


@kernel
def transpose_bits(bits, turned):
    """Write `bits`, (8·h, w) uint8, to `turned`, (8·w, h) uint8, with rows and columns of bits exchanged.

    A byte's lowest bit comes first. Source: Warren, Hacker's Delight, section 7-3.
    """
    rows, columns = turned.shape[1], bits.shape[1]
    for row in range(rows):
        for column in range(columns):
            block = np.uint64(0)
            for k in range(8):
                block |= np.uint64(bits[8 * row + k, column]) << np.uint64(8 * k)
            for shift, mask in _SWAPS:
                swapped = (block ^ (block >> shift)) & mask
                block ^= swapped ^ (swapped << shift)
            for k in range(8):
                turned[8 * column + k, row] = np.uint8((block >> np.uint64(8 * k)) & _LOW)
