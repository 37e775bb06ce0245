"""Planes to colours: one pass from bits to a window's pixels.

A cell's *look* is a number of four bits, worked out from bit planes, 64 cells at a time: what it is, and what lies
around it. With the *shade* of its place, two bits, it makes a code, and the codes of two neighbours together find the
colours of both in one table. Where sand has colours, a look has two bits more, which leaves room for those of a colour
in the looks of sand, and the table is a larger one.
"""

from typing import NamedTuple

import numpy as np

from game.core.draw.motion_blur import blend_row
from game.core.jit import gate, kernel
from game.core.planes import BITS, COLOURS, DEPTH, SAND, WALLS

TEXTURE = 64  # side of the texture of shades, in cells; a power of two
SHADES = 4
LOOKS = 16
# What a cell looks like. The two upper bits tell air, sand, walls and wooden walls apart, but for the last of both.
AIR, AIR_BY_WALL, INSIDE, INSIDE_BY_WALL = range(4)  # inside of a glass
GRAIN, SURFACE, UNDER, GRAIN_BY_WALL = range(4, 8)  # a surface has nothing on it, and lies on what is under it
WALL, RIM, EDGE, GLEAM = range(8, 12)  # a rim has no wall above or at its left, an edge below or at its right
WOOD, WOOD_RIM, WOOD_EDGE, POST = range(12, 16)
DYED_LOOKS = 64  # looks in a world with colours: those above unless it is sand …
DYED_SAND = 32  # … whose looks start here: GRAIN in each colour, then SURFACE in each, and so on

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_LAST = np.uint64(BITS - 1)
_BYTE = np.uint64(255)
_UPPER_BITS, _ONE_BIT = np.uint32(0xFEFEFEFE), np.uint32(1)  # all of each channel but the lowest bit
_POINT_BITS = 20  # positions in a turned picture are fixed-point numbers with this many binary places
_POINT = 1 << _POINT_BITS


@gate
def _left_of(planes, plane, start, word, words):
    """Return the cells to the left of a word of a row of walls: of its own bits there, and wall before column 0."""
    if plane & 1:
        return planes[plane - 1, start + word]
    if word > 0:
        return planes[plane + 1, start + word - 1]
    return (planes[plane + 1, start + words - 1] << _ONE) | _ONE


@gate
def _right_of(planes, plane, start, word, words):
    """Return the cells to the right of a word of a row of walls; wall after the last column."""
    if not plane & 1:
        return planes[plane + 1, start + word]
    if word < words - 1:
        return planes[plane - 1, start + word + 1]
    return (planes[plane - 1, start] >> _ONE) | (_ONE << _LAST)


@gate
def _bits_of_row(planes, decor, stride, words, y, parity, bits):
    """Write the four bits of the looks of the columns of one parity of lattice row y to `bits`, (4, words) uint64."""
    row, plane = y >> 1, 2 * (y & 1) + parity
    start, other = row * stride, plane ^ 2
    above, below = start - stride * (1 - (y & 1)), start + stride * (y & 1)
    for word in range(words):
        sand, walls = planes[SAND + plane, start + word], planes[WALLS + plane, start + word]
        walls_above = sand_above = covered_above = _ZERO
        if y > 0:
            sand_above, walls_above = planes[SAND + other, above + word], planes[WALLS + other, above + word]
        if y > 1:
            above_that = start - stride + word
            covered_above = planes[SAND + plane, above_that] | planes[WALLS + plane, above_that]
        beside = _left_of(planes, WALLS + plane, start, word, words)
        right = _right_of(planes, WALLS + plane, start, word, words)
        under = planes[WALLS + other, below + word]
        near = beside | right | walls_above | under
        air = ~(sand | walls)
        lit = sand & ~(sand_above | walls_above)
        by_wall = sand & (beside | right | walls_above) & ~lit
        beneath = sand & sand_above & ~covered_above & ~by_wall
        rim = walls & ~(beside & walls_above)
        edge = walls & ~rim & ~(right & under)
        low, high = lit | by_wall | rim | (air & near), beneath | by_wall | edge
        wall, sand_or_wood = walls, sand
        if decor is not None:
            first, second = decor[plane, start + word], decor[4 + plane, start + word]
            behind = air & second
            wall |= behind
            sand_or_wood |= (walls | behind) & first
            low |= behind
            high |= behind | (air & first)
        bits[0, word], bits[1, word], bits[2, word], bits[3, word] = low, high, sand_or_wood, wall


@gate
def _dye_bits(planes, stride, words, y, parity, bits, more):
    """Make the looks of a row in `bits` those of a world with colours; more: (2, words) uint64, the two upper bits."""
    start, plane = (y >> 1) * stride, COLOURS + 2 * (y & 1) + parity
    for word in range(words):
        at = start + word
        low, high, sand_or_wood, wall = bits[0, word], bits[1, word], bits[2, word], bits[3, word]
        sand = sand_or_wood & ~wall
        bits[0, word] = (sand & planes[plane, at]) | (low & ~sand)
        bits[1, word] = (sand & planes[plane + 4, at]) | (high & ~sand)
        bits[2, word] = (sand & planes[plane + 8, at]) | (sand_or_wood & ~sand)
        bits[3, word] = wall | (sand & low)
        more[0, word], more[1, word] = sand & high, sand


@gate
def _transposed(x):
    """Return a matrix of 8×8 bits with its rows and columns changed over (Warren, Hacker's Delight, 7-3)."""
    t = (x ^ (x >> np.uint64(7))) & np.uint64(0x00AA00AA00AA00AA)
    x ^= t ^ (t << np.uint64(7))
    t = (x ^ (x >> np.uint64(14))) & np.uint64(0x0000CCCC0000CCCC)
    x ^= t ^ (t << np.uint64(14))
    t = (x ^ (x >> np.uint64(28))) & np.uint64(0x00000000F0F0F0F0)
    return x ^ t ^ (t << np.uint64(28))


@gate
def _spread(bits, words, room, looks):
    """Write the looks of a row to `looks`, those of two neighbours in eight bits of a uint16, padded to whole words.

    bits: (8, words) uint64, the bits of the looks of the even and of the odd columns. room: (words,) uint64.
    """
    for part in range(BITS // 8):
        shift = np.uint64(8 * part)
        for word in range(words):
            eight = _ZERO
            for k in range(8):
                eight |= ((bits[k, word] >> shift) & _BYTE) << np.uint64(8 * k)
            room[word] = _transposed(eight)
        for bit in range(8):
            first, place = (8 * part + bit) * words, np.uint64(8 * bit)
            for word in range(words):
                looks[first + word] = np.uint16((room[word] >> place) & _BYTE)


@gate
def _spread_more(more, words, room, looks):
    """Add the two upper bits of the looks in a world with colours: those of two neighbours are the uppermost four.

    more: (4, words) uint64, the bits of the even and of the odd columns.
    """
    for part in range(BITS // 8):
        shift = np.uint64(8 * part)
        for word in range(words):
            four = _ZERO
            for k in range(4):
                four |= ((more[k, word] >> shift) & _BYTE) << np.uint64(8 * k)
            room[word] = _transposed(four)
        for bit in range(8):
            first, place = (8 * part + bit) * words, np.uint64(8 * bit)
            for word in range(words):
                looks[first + word] |= np.uint16(((room[word] >> place) & _BYTE) << np.uint64(12))


@gate
def _colours_of_row(looks, shades, pairs, colours):
    """Look up the colours of every two neighbours of a row at once."""
    for k in range(looks.size):
        colours[k] = pairs[np.uint64(looks[k] | shades[k])]


@gate
def _copy(source, first, target, start, size):
    """Copy by unsigned indices, which may not count from the end: the compiler then moves whole vectors."""
    of, to = np.uint64(first), np.uint64(start)
    for j in range(np.uint64(size)):
        target[to + j] = source[of + j]


class Row(NamedTuple):
    """Working memory for one lattice row."""

    bits: np.ndarray  # (8, words) uint64: the bits of the looks of the even and of the odd columns
    more: np.ndarray  # (4, words) uint64: the upper ones in a world with colours
    room: np.ndarray  # (words,) uint64
    looks: np.ndarray  # (64·words,) uint16: those of two neighbours


@gate
def _cells_of_row(planes, decor, dyed, stride, words, y, shades, pairs, samples, blends, row, colours):
    """Write the colours of lattice row y, those of two neighbours a word, to (64·words,) uint64."""
    _bits_of_row(planes, decor, stride, words, y, 0, row.bits[:4])
    _bits_of_row(planes, decor, stride, words, y, 1, row.bits[4:])
    if dyed is not None:
        _dye_bits(planes, stride, words, y, 0, row.bits[:4], row.more[:2])
        _dye_bits(planes, stride, words, y, 1, row.bits[4:], row.more[2:])
    _spread(row.bits, words, row.room, row.looks)
    if dyed is not None:
        _spread_more(row.more, words, row.room, row.looks)
    _colours_of_row(row.looks, shades[y % TEXTURE], pairs, colours)
    if samples.shape[0]:
        cells = colours.view(np.uint32)
        blend_row(planes, decor, dyed, samples, stride, words, y, shades[y % TEXTURE], blends, cells)


@gate
def _mean(one, other):
    """Return the mean of two colours, each channel rounded down."""
    return (one & other) + (((one ^ other) & _UPPER_BITS) >> _ONE_BIT)


@gate
def _mix(cells, others):
    """Mix the cells of a row with those of another, in place."""
    for k in range(cells.size):
        cells[k] = _mean(cells[k], others[k])


@gate
def _mix_neighbours(cells, mixed):
    """Write the mean of each cell of a row and the next one."""
    for k in range(cells.size - 1):
        mixed[k] = _mean(cells[k], cells[k + 1])


@kernel
def draw_cells(
    planes, decor, dyed, stride, words, columns, rows, ends, shades, pairs, samples, blends, pixels, top, left
):
    """Draw lattice rows into `pixels`, an (h, w) uint32 array, in place.

    decor: None, or what stands still behind or in the cells, see core.decor. dyed: None, or True where sand has
    colours. columns: uint32, the lattice column of each pixel column from `left`. rows: int32, the lattice row of each
    pixel row from `top`. shades: (TEXTURE, 64·words) uint16, what `shades_of` gives. pairs: what `pairs_of` gives.
    samples, blends: those of `core.streams.blend_row`, or no samples.

    ends: int32, the last lattice row of each pixel row, where a pixel may hold two by two cells, which it then mixes;
    elsewhere none. Then columns of those that hold two are 128·words more than the first of them.
    """
    row = Row(
        np.empty((8, words), np.uint64),
        np.empty((4, words), np.uint64),
        np.empty(words, np.uint64),
        np.empty(BITS * words, np.uint16),
    )
    colours = np.empty((3, BITS * words), np.uint64)  # of a row; of each two neighbours mixed; of the next row
    cells = colours[:2].reshape(-1).view(np.uint32)
    own, mixed, others = colours[0].view(np.uint32), colours[1].view(np.uint32), colours[2].view(np.uint32)
    width = len(columns)
    unscaled = columns[width - 1] - columns[0] == width - 1
    for i in range(len(rows)):
        y = rows[i]
        line = pixels[top + i]
        if i > 0 and y == rows[i - 1]:
            _copy(pixels[top + i - 1], left, line, left, width)
            continue
        two = len(ends) > 0 and ends[i] > y
        for k in range(2 if two else 1):  # a loop, since to compile the row's work twice takes seconds
            here = y if k == 0 else ends[i]
            _cells_of_row(planes, decor, dyed, stride, words, here, shades, pairs, samples, blends, row, colours[2 * k])
        if two:
            _mix(own, others)
        if len(ends):
            _mix_neighbours(own, mixed)
        if unscaled:
            _copy(cells, columns[0], line, left, width)
        else:
            for j in range(width):
                line[left + j] = cells[columns[j]]


def mixed_columns(edges, words):
    """Return the `columns` of `draw_cells` for pixel columns between lattice columns `edges`, where they may mix."""
    first, last = edges[:-1], edges[1:] - 1
    return (first + np.where(last > first, 2 * BITS * words, 0)).astype(np.uint32)


def dyed(look):
    """Return the looks in a world with colours of what would look so without: eight for sand, by colour, else one."""
    if GRAIN <= look <= GRAIN_BY_WALL:
        return np.arange(2**DEPTH) + DYED_SAND + 2**DEPTH * (look - GRAIN)
    return np.array([look])


def pairs_of(palette):
    """Return the uint64 colours of two neighbours, the left one in the lower half.

    palette: (LOOKS or DYED_LOOKS, SHADES) uint32. A pair's place, from the lowest bit: four bits of the left one's
    look, four of the right one's, the left one's shade, the right one's; then the upper bits of the looks, if any.
    """
    place = np.arange(len(palette) ** 2 * SHADES**2)
    left, right = place & 15 | place >> 8 & 0b110000, place >> 4 & 15 | place >> 10 & 0b110000
    codes = palette.astype(np.uint64)
    return codes[left, place >> 8 & 3] | codes[right, place >> 10 & 3] << np.uint64(32)


def shades_of(texture, words):
    """Return the shades of (TEXTURE, TEXTURE) uint8 for rows of `words` words: (TEXTURE, 64·words) uint16."""
    row = np.tile(texture, 2 * BITS * words // TEXTURE).astype(np.uint16)
    return (row[:, ::2] << 8) | (row[:, 1::2] << 10)


@kernel
def draw_turned(picture, ground, cosine, sine, zoom, pixels, top, left, height, width):
    """Draw `picture`, turned about its middle, into the middle of a frame of `pixels`; `ground` elsewhere, in place.

    zoom: pixels of the picture to one of the frame; more where that is needed to keep all of it inside the frame.
    """
    tall, wide = picture.shape
    zoom = max(
        zoom,
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
