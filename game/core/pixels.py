"""Planes to colours: one pass from bits to a window's pixels."""

import numpy as np

from game.core.jit import gate, kernel
from game.core.planes import BITS, SAND, WALLS

TEXTURE = 64  # side of the texture of shades, in cells; a power of two
SHADES = 8
EMPTY, GRAIN, WALL, SURFACE = range(4)  # what a cell looks like: a surface is a grain with nothing on it

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_BYTE = np.uint64(8)
_SHADE_BITS, _CODE_BITS, _HALF = np.uint16(3), np.uint16(5), np.uint16(8)  # a look and a shade make a code of five bits
_CODE = np.uint16(31)
_POINT_BITS = 20  # positions in a turned picture are fixed-point numbers with this many binary places
_POINT = 1 << _POINT_BITS


@gate
def _bits_of_row(planes, plane, start, above, words, low, high):
    """Write the two bits of the looks of a plane row: `low` for grains, `high` for walls, both for surfaces."""
    for word in range(words):
        sand, walls = planes[SAND + plane, start + word], planes[WALLS + plane, start + word]
        covered = _ZERO
        if above >= 0:
            covered = planes[SAND + (plane ^ 2), above + word] | planes[WALLS + (plane ^ 2), above + word]
        low[word] = sand
        high[word] = walls | (sand & ~covered)


@gate
def _looks_of_row(planes, stride, words, y, bits, looks):
    """Write what the cells of lattice row y look like to `looks`, two neighbours a uint16, padded to whole words.

    bits: (4, words) uint64, room for the two bits of the looks of the even and of the odd columns.
    """
    start, plane = (y >> 1) * stride, 2 * (y & 1)
    above = start - stride * (1 - (y & 1))
    _bits_of_row(planes, plane, start, above, words, bits[0], bits[1])
    _bits_of_row(planes, plane + 1, start, above, words, bits[2], bits[3])
    for bit in range(BITS):
        shift, first = np.uint64(bit), bit * words
        for word in range(words):
            even = ((bits[0, word] >> shift) & _ONE) | (((bits[1, word] >> shift) & _ONE) << _ONE)
            odd = ((bits[2, word] >> shift) & _ONE) | (((bits[3, word] >> shift) & _ONE) << _ONE)
            looks[first + word] = np.uint16(even | (odd << _BYTE))


@gate
def _colours_of_row(looks, shades, pairs, colours):
    """Look up the colours of every two neighbours of a row at once."""
    for k in range(looks.size):
        codes = (looks[k] << _SHADE_BITS) | shades[k]
        colours[k] = pairs[np.uint64((codes & _CODE) | ((codes >> _HALF) << _CODE_BITS))]


@gate
def _copy(source, first, target, start, size):
    for j in range(size):
        target[start + j] = source[first + j]


@kernel
def draw_cells(planes, stride, words, columns, rows, shades, pairs, pixels, top, left):
    """Draw lattice rows into `pixels`, an (h, w) uint32 array, in place.

    columns: uint32, the lattice column of each pixel column from `left`. rows: int32, the lattice row of each pixel row
    from `top`. shades: (TEXTURE, 64·words) uint16, those of two neighbours a value. pairs: what `pairs_of` gives.
    """
    bits = np.empty((4, words), np.uint64)
    looks = np.empty(BITS * words, np.uint16)
    colours = np.empty(BITS * words, np.uint64)
    cells = colours.view(np.uint32)
    width = len(columns)
    unscaled = columns[width - 1] - columns[0] == width - 1
    for i in range(len(rows)):
        y = rows[i]
        line = pixels[top + i]
        if i > 0 and y == rows[i - 1]:
            _copy(pixels[top + i - 1], left, line, left, width)
            continue
        _looks_of_row(planes, stride, words, y, bits, looks)
        _colours_of_row(looks, shades[y % TEXTURE], pairs, colours)
        if unscaled:
            _copy(cells, columns[0], line, left, width)
        else:
            for j in range(width):
                line[left + j] = cells[columns[j]]


def pairs_of(palette):
    """Return the (1024,) uint64 colours of two neighbours, the left one lower, from (4 looks, SHADES) uint32."""
    codes = palette.ravel().astype(np.uint64)
    return (codes[None, :] | (codes[:, None] << np.uint64(32))).ravel()


def shades_of(texture, words):
    """Return the shades of (TEXTURE, TEXTURE) uint8 for rows of `words` words, two neighbours a uint16."""
    return np.tile(texture, 2 * BITS * words // TEXTURE).view("<u2").astype(np.uint16)


@kernel
def draw_turned(picture, ground, cosine, sine, pixels, top, left, height, width):
    """Draw `picture`, turned about its middle, into the middle of a frame of `pixels`; `ground` elsewhere, in place.

    It is shrunk where that is needed to keep all of it inside the frame.
    """
    tall, wide = picture.shape
    zoom = max(
        1.0,
        (abs(wide * cosine) + abs(tall * sine)) / width,
        (abs(tall * cosine) + abs(wide * sine)) / height,
    )
    step_x, step_y = np.int64(zoom * cosine * _POINT), np.int64(-zoom * sine * _POINT)
    for i in range(height):
        u, v = (0.5 - width / 2) * zoom, (i + 0.5 - height / 2) * zoom
        x_start = np.int64((u * cosine + v * sine + wide / 2) * _POINT)
        y_start = np.int64((v * cosine - u * sine + tall / 2) * _POINT)
        line = pixels[top + i, left : left + width]
        for j in range(width):
            x = (x_start + j * step_x) >> _POINT_BITS
            y = (y_start + j * step_y) >> _POINT_BITS
            line[j] = picture[y, x] if 0 <= x < wide and 0 <= y < tall else ground
