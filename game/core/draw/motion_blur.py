"""Streams: cells through which sand passes, drawn as the mean of what they held in the last few iterations.

Grains fall in whole cells, so that a thin stream shows the phases of the cycle as stripes; over a whole cycle they even
out. The cells of each sample are kept as planes, and how many samples hold sand is counted for 64 cells at a time.
"""

import numpy as np

from game.core.jit import gate, kernel
from game.core.planes import COLOURS, DEPTH, WALLS

SAMPLES = 4  # a cycle of any schedule: what repeats with it is the same in every mean
PLANES = 4  # of a sample: sand alone

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
# A bit's place is found with a sequence in which every six bits are different (Leiserson, Prokop & Randall 1998).
_SEQUENCE = 0x03F79D71B4CB0A89
_PLACES = np.zeros(64, np.uint8)
_PLACES[[(_SEQUENCE << bit) % 2**64 >> 58 for bit in range(64)]] = range(64)


@gate
def _counted(a, b, c, d):
    """Return the two bits of how many of four are set, for cells that are not in all: the lower and the upper one."""
    return a ^ b ^ c ^ d, (a & b) | (c & d) | ((a | b) & (c | d))


@gate
def _bit(word, place):
    return (word >> np.uint64(place)) & _ONE


@gate
def _colour_at(planes, dyed, plane, at, place):
    """Return the colour of the grain that is in a cell or was the last one there."""
    if dyed is None:
        return _ZERO
    colour = _ZERO
    for k in range(DEPTH):
        colour |= _bit(planes[COLOURS + 4 * k + plane, at], place) << np.uint64(k)
    return colour


@gate
def blend_row(planes, decor, dyed, samples, stride, words, y, shades, blends, cells):
    """Put the mean of the samples into `cells`, the colours of lattice row y, wherever not all samples are the same.

    samples: (SAMPLES, PLANES, length) uint64. shades: the row's shades, those of two neighbours a uint16, as
    `pixels.shades_of` gives them. blends: (colours, SAMPLES - 1, 4, SHADES) uint32, what holds sand of each colour in
    1 … samples looks like before each kind of place of `decor`, in each shade. dyed: as for `pixels.draw_cells`.
    """
    start = (y >> 1) * stride
    for parity in range(2):
        plane = 2 * (y & 1) + parity
        for word in range(words):
            at = start + word
            a, b, c, d = samples[0, plane, at], samples[1, plane, at], samples[2, plane, at], samples[3, plane, at]
            moving = (a | b | c | d) & ~(a & b & c & d) & ~planes[WALLS + plane, at]
            if moving == _ZERO:
                continue
            low, high = _counted(a, b, c, d)
            while moving != _ZERO:
                lowest = moving & (~moving + _ONE)
                moving ^= lowest
                place = _PLACES[(lowest * np.uint64(_SEQUENCE)) >> np.uint64(58)]
                count, ground = _bit(low, place) | (_bit(high, place) << _ONE), _ZERO
                if decor is not None:
                    ground = _bit(decor[plane, at], place) | (_bit(decor[4 + plane, at], place) << _ONE)
                pair = np.uint64(place) * np.uint64(words) + np.uint64(word)
                shade = (shades[pair] >> np.uint16(8 + 2 * parity)) & np.uint16(3)
                cells[2 * pair + np.uint64(parity)] = blends[
                    _colour_at(planes, dyed, plane, at, place), count - _ONE, ground, shade
                ]


@kernel
def take_sample(planes, sample, left, stamps, stamp, band_words, stride, length):
    """Copy the sand of bands that moved within a cycle to `sample`, (PLANES, length) uint64, in place.

    left: uint8, in how many samples more each band is to be copied, counted down here. stamps: when each band changed;
    one that did after `stamp` is copied SAMPLES times. A band's blocks reach a row into the next.
    """
    for band in range(len(left)):
        if stamps[band] > stamp:
            left[band] = SAMPLES
        if left[band] == 0:
            continue
        left[band] -= 1
        start = band * band_words
        end = min(start + band_words + stride, length)
        for plane in range(PLANES):
            for i in range(start, end):
                sample[plane, i] = planes[plane, i]
