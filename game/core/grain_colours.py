"""Colours of grains: bits that go where their grain goes and decide nothing.

Where events are left to chance, the sand of a band moves first and leaves tracks; then the colours follow them. What a
colour's planes hold where there is no sand means nothing: a grain that leaves need not wipe it away, one that comes
writes over it.
"""

from typing import NamedTuple

import numpy as np

from game.core.jit import gate
from game.core.planes import COLOURS
from game.core.seam import close_seam, close_seams, open_seam, open_seams

CROWD = 4  # where more than one word in so many has tracks, following in all words at once is cheaper
ROW = 1088  # words of a band at most, and some, so that rows of tracks do not start at the same place in a page

_ONE, _ZERO = np.uint64(1), np.uint64(0)
_LEFT_B, _CAME_C = np.uint64(ROW), np.uint64(2 * ROW)  # constants: so the compiler sees that rows do not overlap


class Tracks(NamedTuple):
    """Where grains went in the words of one band's blocks."""

    words: np.ndarray  # (3 · ROW,) uint64: the blocks where a grain left a, left b, came to c
    moved: np.ndarray  # (ROW,) uint8: the word has tracks


class Places(NamedTuple):
    """Where the words at the four corners of the blocks start in the flat planes."""

    a: np.uint64
    b: np.uint64
    c: np.uint64
    d: np.uint64


@gate
def leave_tracks(tracks, i, left_a, left_b, came_c):
    """Leave the tracks of word i, over those of the iteration before."""
    tracks.words[i] = left_a
    tracks.words[_LEFT_B + i] = left_b
    tracks.words[_CAME_C + i] = came_c
    tracks.moved[i] = (left_a | left_b) != _ZERO


@gate
def add_tracks(tracks, i, left_a, left_b, came_c):
    """Leave tracks of word i beside those of this iteration."""
    tracks.words[i] |= left_a
    tracks.words[_LEFT_B + i] |= left_b
    tracks.words[_CAME_C + i] |= came_c
    tracks.moved[i] |= (left_a | left_b) != _ZERO


@gate
def colour_places(at, length, bit):
    """Return the Places of one bit of the colours; at: those of sand."""
    start = np.uint64((COLOURS + 4 * bit) * length)
    return Places(at.a + start, at.b + start, at.c + start, at.d + start)


@gate
def moved_along(a, b, c, d, left_a, left_b, came_c, came_d):
    """Return a bit of the colours at c and d once it followed. Of two grains that leave a block both fall straight."""
    to_c, to_d = (a & left_a) | (b & ~left_a), (b & left_b) | (a & ~left_b)
    return (c & ~came_c) | (to_c & came_c), (d & ~came_d) | (to_d & came_d)


@gate
def follow(planes, at, i, left_a, left_b, came_c, came_d):
    """Let one bit of the colours of word i follow, in place."""
    a, b, c, d = planes[at.a + i], planes[at.b + i], planes[at.c + i], planes[at.d + i]
    planes[at.c + i], planes[at.d + i] = moved_along(a, b, c, d, left_a, left_b, came_c, came_d)


@gate
def follow_word(planes, bits, i, tracks):
    """Let the colours of word i follow its tracks, in place; bits: the Places of each bit."""
    left_a, left_b, came_c = tracks.words[i], tracks.words[_LEFT_B + i], tracks.words[_CAME_C + i]
    came_d = left_a ^ left_b ^ came_c
    follow(planes, bits[0], i, left_a, left_b, came_c, came_d)
    follow(planes, bits[1], i, left_a, left_b, came_c, came_d)
    follow(planes, bits[2], i, left_a, left_b, came_c, came_d)


@gate
def follow_all(planes, bits, x, rows, stride, tracks):
    """Let the colours of all words of a band follow, in place; its blocks start in column x."""
    if x:
        for at in bits:
            open_seams(planes, at.b - _ONE, rows, stride)
            open_seams(planes, at.d - _ONE, rows, stride)
    for i in range(np.uint64(rows * stride)):
        follow_word(planes, bits, i, tracks)
    if x:
        for at in bits:
            close_seams(planes, at.d - _ONE, rows, stride)


@gate
def follow_few(planes, bits, x, stride, listed, number, tracks):
    """Let the colours of the `number` words listed follow, in place; the band's blocks start in column x."""
    stride = np.uint64(stride)
    words = stride - _ONE
    for k in range(number):
        i = listed[k]
        at_seam = x and (i + _ONE) % stride == words
        if at_seam:
            for at in bits:
                open_seam(planes, at.b + i, words)
                open_seam(planes, at.d + i, words)
        follow_word(planes, bits, i, tracks)
        if at_seam:
            for at in bits:
                close_seam(planes, at.d + i, words)


@gate
def many_moved(tracks, size):
    """Return whether so many of `size` words have tracks that following in all words is cheaper."""
    moved = _ZERO
    for i in range(size):
        moved += np.uint64(tracks.moved[i])
    return moved * np.uint64(CROWD) > size


@gate
def bits_of_colours(at, length):
    """Return the Places of each bit of the colours; at: those of sand."""
    return colour_places(at, length, 0), colour_places(at, length, 1), colour_places(at, length, 2)
