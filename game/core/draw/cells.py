"""Planes to colours: one pass from bits to a window's pixels.

A cell's *look* is a number of four bits, or of six where a world has many looks, worked out from bit planes by a pass
made for the world's substances, see `looks`. With the *shade* of its place, two bits, it makes a code, and the codes of
two neighbours together find the colours of both in one table.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.core.compiler.machine_code import MachineCode
from game.core.compiler.word_pass import transposed, word_pass
from game.core.draw.looks import falling, look_bits
from game.core.draw.motion_blur import blend_row
from game.core.draw.rows import RowStreams, addresses, find_row, find_sides, room_for
from game.core.jit import gate, kernel
from game.core.loops.calls import call_words, copy
from game.core.planes import BITS, aligned

TEXTURE = 64  # side of the texture of shades, in cells; a power of two
SHADES = 4

_LOW = 4  # bits of a look that come first
_BYTE = np.uint64(255)
_UPPER = np.uint64(12)  # where the upper bits of the looks of two neighbours lie in their code
_UPPER_BITS = 0xFEFEFEFEFEFEFEFE  # all of each channel but the lowest bit
_POINT_BITS = 20  # positions in a turned picture are fixed-point numbers with this many binary places
_POINT = 1 << _POINT_BITS


class _Compiled(NamedTuple):
    code: MachineCode
    reader: RowStreams
    writes: int


@lru_cache(maxsize=32)
def _compiled(substances, decorated, depth):
    """Return the pass that works out a row's looks: those of two neighbours as bytes, then where things could fall."""
    reader = RowStreams(substances.bits, decorated, depth)

    def work_out(streams):
        bits, spaces = [], []
        for around, decor, colours in reader.parities(streams):
            bits.append([*look_bits(substances, around, decor, colours), 0, 0, 0][:6])
            spaces.append(falling(substances, around.own)[1])
        halves = [bits[0][:_LOW] + bits[1][:_LOW], bits[0][_LOW:] + bits[1][_LOW:] + [0] * 4]
        return [word for half in halves if any(half) for word in transposed(half)] + spaces

    code, writes = word_pass(work_out, reader.reads)
    return _Compiled(code, reader, writes)


@lru_cache(maxsize=1)
def _mean_pass():
    """Return the pass that gives the means of colours, two in a word, each channel rounded down."""
    return word_pass(lambda two: [(two[0] & two[1]) + (((two[0] ^ two[1]) & _UPPER_BITS) >> 1)], 2)[0]


class CellPass:
    """Draws cells of some Substances in rows of `words` words, in memory of its own."""

    def __init__(self, substances, words, decorated, depth):
        # kept: the caches may forget them, and two threads may have made them twice
        self._made, self._mean = _compiled(substances, decorated, depth), _mean_pass()
        reader = self._made.reader
        self._room, self._sides = room_for(words, self._made.writes + 1), room_for(words, 2 * reader.bits)
        places = addresses(self._room)
        self._nothing = places[-1]
        self._at = np.concatenate([np.zeros(reader.moving, np.int64), addresses(self._sides), places[:-1]])
        self._outside = substances.outside
        # colours of a row, of every two neighbours mixed, of the next row
        self._colours = aligned(3 * BITS * words).reshape(3, BITS * words)
        own, mixed, others = addresses(self._colours)
        self._at_means = np.array([own, others, own, own, own + 4, mixed])

    def draw(self, planes, where, decor, *how):
        """Draw rows of planes as `draw_cells` does; decor: as many planes as the pass was made for, may be none."""
        places = self._made.reader.places(planes, where, decor)
        looked = self._made.code.address, places, self._at, self._nothing, self._outside, self._sides, self._room
        mixing = self._mean.address, self._at_means, self._colours
        draw_cells(planes, looked, mixing, decor, where.stride, where.words, *how)


@gate
def _colours_of_row(room, words, shades, pairs, colours):
    """Look up the colours of every two neighbours of a row at once, by the bytes in `room` and by their shades."""
    for lane in range(BITS):
        place, row, first = np.uint64(8 * (lane >> 3)), lane & 7, lane * words
        if len(room) > 16:
            for word in range(words):
                looks = (room[row, word] >> place) & _BYTE | ((room[8 + row, word] >> place) & _BYTE) << _UPPER
                colours[first + word] = pairs[looks | np.uint64(shades[first + word])]
        else:
            for word in range(words):
                looks = (room[row, word] >> place) & _BYTE
                colours[first + word] = pairs[looks | np.uint64(shades[first + word])]


@gate
def _cells_of_row(planes, looked, decor, stride, words, y, shades, pairs, samples, trail, blends, colours):
    """Write the colours of lattice row y, those of two neighbours a word, to (64·words,) uint64."""
    address, places, at, nothing, outside, sides, room = looked
    find_row(places, y, stride, len(sides) >> 1, nothing, at)
    find_sides(planes, y, stride, words, outside, sides)
    call_words(address, at, 0, words)
    _colours_of_row(room, words, shades[y % TEXTURE], pairs, colours)
    if samples.shape[0]:
        spaces, cells = room[len(room) - 3 : len(room) - 1], colours.view(np.uint32)
        blend_row(spaces, decor, trail, samples, stride, words, y, shades[y % TEXTURE], blends, cells)


@kernel
def draw_cells(
    planes,
    looked,
    mixing,
    decor,
    stride,
    words,
    columns,
    rows,
    ends,
    shades,
    pairs,
    samples,
    trail,
    blends,
    pixels,
    top,
    left,
):
    """Draw lattice rows into `pixels`, an (h, w) uint32 array, in place.

    looked, mixing: how a `CellPass` works out looks, and means. decor: what stands still behind or in the cells, see
    core.decor, or no planes. columns: uint32, the lattice column of each pixel column from `left`. rows: int32, the
    lattice row of each pixel row from `top`. shades: (TEXTURE, 64·words) uint16, what `shades_of` gives. pairs: what
    `pairs_of` gives. The items of a row of `pixels` lie side by side.
    samples, trail, blends: those of `motion_blur.blend_row`, or no samples.

    ends: int32, the last lattice row of each pixel row, where a pixel may hold two by two cells, which it then mixes;
    elsewhere none. Then columns of those that hold two are 128·words more than the first of them.
    """
    mean, at_means, colours = mixing
    cells = colours.reshape(-1).view(np.uint32)
    width = len(columns)
    unscaled = columns[width - 1] - columns[0] == width - 1
    for i in range(len(rows)):
        y = rows[i]
        line = pixels[top + i]
        if i > 0 and y == rows[i - 1]:
            copy(pixels[top + i - 1], left, line, left, width)
            continue
        two = len(ends) > 0 and ends[i] > y
        for k in range(2 if two else 1):  # a loop, since to compile the row's work twice takes seconds
            here = y if k == 0 else ends[i]
            to = colours[2 * k]
            _cells_of_row(planes, looked, decor, stride, words, here, shades, pairs, samples, trail, blends, to)
        if two:
            call_words(mean, at_means, 0, BITS * words)
        if len(ends):
            call_words(mean, at_means, 3, BITS * words)
        if unscaled:
            copy(cells, columns[0], line, left, width)
        else:
            for j in range(width):
                line[left + j] = cells[columns[j]]


def mixed_columns(edges, words):
    """Return the `columns` of `draw_cells` for pixel columns between lattice columns `edges`, where they may mix."""
    first, last = edges[:-1], edges[1:] - 1
    return (first + np.where(last > first, 2 * BITS * words, 0)).astype(np.uint32)


def pairs_of(palette):
    """Return the uint64 colours of two neighbours, the left one in the lower half.

    palette: (MOST_LOOKS, SHADES) uint32. A pair's place, from the lowest bit: four bits of the left one's look, four of
    the right one's, the left one's shade, the right one's; then the upper bits of the looks.
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
            line[j] = picture[y, x] if 0 <= x < wide and 0 <= y < tall else np.uint32(ground)
