"""Firelight: how much of what glows lies in each tile of a lattice, the light between tiles, and lit pixels."""

import numpy as np

from game.core.jit import gate, kernel
from game.core.packing import BITS

TILE = 8  # cells: the side of a tile
FULL = TILE * TILE  # cells in a tile
LEVELS = 256  # of light
DIGITS = 5  # of the number of bits in two columns of a tile

_ONE, _ZERO = np.uint64(1), np.uint64(0)
_MIDDLE, _SIDE = np.float32(0.5), np.float32(TILE)
_BYTE = np.uint32(255)
_CHANNELS = np.uint32(0), np.uint32(8), np.uint32(16), np.uint32(24)  # where the bytes of a pixel are


@kernel
def count_glowing(four, rows, words, counts):
    """Write how many of the bits are set in four planes of `rows` plane rows to `counts`, (h, w) int32, by tile.

    w: the tiles that the words of a row reach over.
    """
    stride, digits = words + 1, np.empty(DIGITS, np.uint64)
    counts[:] = 0
    for first in range(0, rows, TILE // 2):
        tile_row = counts[first // (TILE // 2)]
        for word in range(words):
            digits[:] = _ZERO  # of the number of bits set in every two columns, as binary digits of 64 numbers at once
            some = _ZERO
            for row in range(first, min(first + TILE // 2, rows)):
                for plane in range(4):
                    carry = four[plane, row * stride + word]
                    some |= carry
                    for digit in range(DIGITS):
                        digits[digit], carry = digits[digit] ^ carry, digits[digit] & carry
            if some == _ZERO:
                continue
            for lane in range(BITS):
                number = _ZERO
                for digit in range(DIGITS):
                    number |= ((digits[digit] >> np.uint64(lane)) & _ONE) << np.uint64(digit)
                tile_row[2 * (lane * words + word) // TILE] += np.int32(number)


@kernel
def spread_light(counts, reach, gain, across, tiles):
    """Write the light of tiles to `tiles`, (h, w) float32, whole numbers up to LEVELS - 1.

    counts: int32, (h, w) or more. Light goes to tiles nearer than `reach`, evenly less in both directions. gain: the
    light of a tile amid nothing but what glows, before it is cut off. across: (h, w) float32, room.
    """
    height, width = tiles.shape
    some = np.zeros(height, np.bool_)
    for row in range(height):
        across[row] = np.float32(0)
        for column in range(counts.shape[1]):
            some[row] |= counts[row, column] != 0
        for column in range(width if some[row] else 0):
            total = 0
            for other in range(max(column - reach + 1, 0), min(column + reach, width)):
                total += (reach - abs(column - other)) * counts[row, other]
            across[row, column] = np.float32(total)
    scale = np.float32(gain / (FULL * reach**4))
    for row in range(height):
        tiles[row] = np.float32(0)
        for other in range(max(row - reach + 1, 0), min(row + reach, height)):
            if not some[other]:
                continue
            weight = np.float32(reach - abs(row - other)) * scale
            for column in range(width):
                tiles[row, column] += weight * across[other, column]
        for column in range(width):
            tiles[row, column] = np.floor(min(tiles[row, column], np.float32(LEVELS - 1)))


@gate
def _light_of_row(tiles, y, first, last, line, levels):
    """Write the light of lattice row y in the columns of the tiles from `first` to before `last` to `levels`.

    tiles: (h, w) float32, 0 … 255, the light in the middle of each tile; between them it goes over evenly, both ways.
    """
    height, width = tiles.shape
    place = (np.float32(y) + _MIDDLE) / _SIDE - _MIDDLE
    above = min(max(np.int64(np.floor(place)), 0), height - 1)
    below, part = min(above + 1, height - 1), max(place - np.float32(above), np.float32(0))
    low, high = max(first - 1, 0), min(last + 1, width)
    for column in range(low, high):
        line[column] = tiles[above, column] + part * (tiles[below, column] - tiles[above, column])
    for column in range(first, last):
        here = line[column]
        left, right = line[max(column - 1, 0)], line[min(column + 1, width - 1)]
        for k in range(TILE // 2):
            share = (np.float32(k) + _MIDDLE) / _SIDE
            levels[column * TILE + k] = np.uint8(left + (share + _MIDDLE) * (here - left))
            levels[column * TILE + TILE // 2 + k] = np.uint8(here + share * (right - here))


@gate
def _lit(pixel, light):
    """Return a pixel with light on it: each byte p under l becomes p + l - p·l / 255, which is brighter and fits."""
    result = np.uint32(0)
    for shift in _CHANNELS:
        under, on = (pixel >> shift) & _BYTE, (light >> shift) & _BYTE
        result |= (under + on - (under * on + _BYTE) // np.uint32(256)) << shift
    return result


@kernel
def lay_light(tiles, lights, lit, columns, rows, pixels, top, left):
    """Light pixel rows from `top` and columns from `left` of `pixels`, an (h, w) uint32 array, in place.

    tiles: see `_light_of_row`. lights: (LEVELS,) uint32, the pixel value that each level adds to black. lit: (h, 4)
    int64, for each row of tiles the first and the last + 1 of its tiles with light, and of the pixel columns of those.
    columns, rows: int32, the lattice column and row of each pixel column and row.
    """
    line, levels = np.empty(tiles.shape[1], np.float32), np.empty(tiles.shape[1] * TILE, np.uint8)
    shown = np.empty(len(columns), np.uint32)
    for i in range(len(rows)):
        first, last, start, end = lit[rows[i] // TILE]
        if i == 0 or rows[i] != rows[i - 1]:
            _light_of_row(tiles, rows[i], first, last, line, levels)
            for j in range(start, end):
                shown[j] = lights[levels[columns[j]]]
        pixel_row = pixels[top + i]
        for j in range(start, end):
            pixel_row[left + j] = _lit(pixel_row[left + j], shown[j])


@gate
def _columns_before(columns, end):
    """Return how many of the columns, which rise, come before one."""
    low, high = 0, len(columns)
    while low < high:
        middle = (low + high) // 2
        if columns[middle] < end:
            low = middle + 1
        else:
            high = middle
    return low


@kernel
def find_lit(tiles, columns, lit):
    """Write to `lit` what `lay_light` needs of which tiles have light, or one beside them: it goes half a tile further.

    columns: int32, the lattice column of each pixel column.
    """
    height, width = tiles.shape
    for row in range(height):
        first, last = width, 0
        for near in range(max(row - 1, 0), min(row + 2, height)):
            for column in range(width):
                if tiles[near, column] > 0:
                    first, last = min(first, max(column - 1, 0)), max(last, min(column + 2, width))
        first = min(first, last)
        lit[row, 0], lit[row, 1] = first, last
        lit[row, 2], lit[row, 3] = _columns_before(columns, first * TILE), _columns_before(columns, last * TILE)


def tiles_of(height, width):
    """Return how many tiles there are in each direction: (rows, columns)."""
    return -(-height // TILE), -(-width // TILE)


def padded(width):
    """Return how many columns of tiles the words of a row reach over: what is beyond the lattice is never set."""
    return -(-width // (2 * BITS)) * 2 * BITS // TILE
