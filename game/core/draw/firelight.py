"""Firelight: how much of what glows lies in each tile of a lattice, the light between tiles, and lit pixels."""

import numpy as np

from game.core.jit import gate, kernel
from game.core.packing import BITS

TILE = 8  # cells: the side of a tile
FULL = TILE * TILE  # cells in a tile
LEVELS = 256  # of light

_ONE, _ZERO = np.uint64(1), np.uint64(0)
_BYTE = np.uint32(255)
_CHANNELS = np.uint32(0), np.uint32(8), np.uint32(16), np.uint32(24)  # where the bytes of a pixel are


@kernel
def count_glowing(four, rows, words, tiles):
    """Add the cells whose bits are set in four planes of `rows` plane rows to `tiles`, (h, w) int32, in place."""
    stride = words + 1
    for plane in range(4):
        odd_row, odd_column = plane >> 1, plane & 1
        for row in range(rows):
            tile_row = (2 * row + odd_row) // TILE
            for word in range(words):
                left = four[plane, row * stride + word]
                lane = 0
                while left != _ZERO:
                    while left & _ONE == _ZERO:
                        left >>= _ONE
                        lane += 1
                    tiles[tile_row, (2 * (lane * words + word) + odd_column) // TILE] += 1
                    left &= ~_ONE


@kernel
def light_between(tiles, first, levels):
    """Write the light of lattice rows from `first` to `levels`, (rows, width) uint8.

    tiles: (h, w) float32, 0 … 255, the light in the middle of each tile; between them it is interpolated both ways.
    """
    height, width = tiles.shape
    line = np.empty(width, np.float32)
    for i in range(levels.shape[0]):
        place = (np.float32(first + i) + np.float32(0.5)) / np.float32(TILE) - np.float32(0.5)
        above = min(max(np.int64(np.floor(place)), 0), height - 1)
        below, part = min(above + 1, height - 1), min(max(place - np.float32(above), np.float32(0)), np.float32(1))
        for column in range(width):
            line[column] = tiles[above, column] + part * (tiles[below, column] - tiles[above, column])
        for x in range(levels.shape[1]):
            at = (np.float32(x) + np.float32(0.5)) / np.float32(TILE) - np.float32(0.5)
            left = min(max(np.int64(np.floor(at)), 0), width - 1)
            right, share = min(left + 1, width - 1), min(max(at - np.float32(left), np.float32(0)), np.float32(1))
            levels[i, x] = np.uint8(line[left] + share * (line[right] - line[left]))


@gate
def _lit(pixel, light):
    """Return a pixel with light on it: each byte p under l becomes p + l - p·l / 255, which is brighter and fits."""
    result = np.uint32(0)
    for shift in _CHANNELS:
        under, on = (pixel >> shift) & _BYTE, (light >> shift) & _BYTE
        result |= (under + on - (under * on + _BYTE) // np.uint32(256)) << shift
    return result


@kernel
def lay_light(levels, lights, columns, rows, pixels, top, left):
    """Light pixel rows from `top` and columns from `left` of `pixels`, an (h, w) uint32 array, in place.

    levels: (H, W) uint8. columns, rows: int32, the column and row in `levels` for each pixel column and row. lights:
    (LEVELS,) uint32, the pixel value that each level adds to black.
    """
    for i in range(len(rows)):
        line, row = pixels[top + i], levels[rows[i]]
        for j in range(len(columns)):
            line[left + j] = _lit(line[left + j], lights[row[columns[j]]])


def tiles_of(height, width):
    """Return how many tiles there are in each direction: (rows, columns)."""
    return -(-height // TILE), -(-width // TILE)


def padded(width):
    """Return how many columns of tiles the words of a row reach over: what is beyond the lattice is never set."""
    return -(-width // (2 * BITS)) * 2 * BITS // TILE
