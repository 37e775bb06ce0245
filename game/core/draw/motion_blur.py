"""Streams: cells through which sand passes, drawn as the mean of what they held in the last few iterations.

Grains fall in whole cells, so that a thin stream shows the phases of the cycle as stripes; over a whole cycle they even
out. The cells of each sample are kept as planes, and how many samples hold sand is counted for 64 cells at a time.
"""

from functools import lru_cache

import numpy as np

from game.core.compiler.word_pass import word_pass
from game.core.draw.looks import falling
from game.core.draw.rows import addresses
from game.core.jit import gate, kernel
from game.core.loops.calls import call_words
from game.core.planes import LINE

SAMPLES = 4  # a cycle of any schedule: what repeats with it is the same in every mean
PLANES = 4  # of a sample: where there is something that falls

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
def blend_row(spaces, decor, trail, samples, stride, words, y, shades, blends, cells):
    """Put the mean of the samples into `cells`, the colours of lattice row y, wherever not all samples are the same.

    spaces: (2, …) uint64, where things could fall in even and in odd columns. samples: (SAMPLES, PLANES, length)
    uint64. trail: four planes for each bit of the number of what fell last through a cell. shades: the row's shades,
    those of two neighbours a uint16, as `cells.shades_of` gives them. blends: (numbers, SAMPLES - 1, 4, SHADES) uint32,
    what holds that in 1 … samples looks like before each kind of place of `decor`, in each shade.
    """
    start = (y >> 1) * stride
    for parity in range(2):
        plane = 2 * (y & 1) + parity
        for word in range(words):
            at = start + word
            a, b, c, d = samples[0, plane, at], samples[1, plane, at], samples[2, plane, at], samples[3, plane, at]
            moving = (a | b | c | d) & ~(a & b & c & d) & spaces[parity, word]
            if moving == _ZERO:
                continue
            low, high = _counted(a, b, c, d)
            while moving != _ZERO:
                lowest = moving & (~moving + _ONE)
                moving ^= lowest
                place = _PLACES[(lowest * np.uint64(_SEQUENCE)) >> np.uint64(58)]
                count, ground, number = _bit(low, place) | (_bit(high, place) << _ONE), _ZERO, _ZERO
                if len(decor):
                    ground = _bit(decor[plane, at], place) | (_bit(decor[4 + plane, at], place) << _ONE)
                for bit in range(len(trail) >> 2):
                    number |= _bit(trail[4 * bit + plane, at], place) << np.uint64(bit)
                pair = np.uint64(place) * np.uint64(words) + np.uint64(word)
                shade = (shades[pair] >> np.uint16(8 + 2 * parity)) & np.uint16(3)
                cells[2 * pair + np.uint64(parity)] = blends[number, count - _ONE, ground, shade]


@lru_cache(maxsize=32)
def _compiled(substances, trailing):
    bits = substances.bits

    def take(streams):
        own = [streams[bit] for bit in range(bits)]
        falls = falling(substances, own)[0]
        trail = [(own[bit] & falls) | (streams[bits + bit] & ~falls) for bit in range(bits * trailing)]
        return [falls, *trail]

    return word_pass(take, bits + bits * trailing)[0]


def take_sample(substances, planes, sample, trail, *which):
    """Copy what falls in bands that moved within a cycle to `sample`, (PLANES, length) uint64, in place.

    trail: four planes for each bit of a code, or none: the codes of what falls are copied there. which: see `_take`.
    """
    bits, length = 4 * substances.bits, planes.shape[1]
    rows = [addresses(each).reshape(-1, PLANES) for each in (planes[:bits], trail, sample[:PLANES], trail)]
    code = _compiled(substances, len(trail) > 0)  # kept until it has run: two threads may have made it twice
    _take(code.address, np.ascontiguousarray(np.vstack(rows).T), length, *which)


@kernel
def _take(address, places, length, left, stamps, stamp, band_words, stride):
    """Take a sample of bands by a pass at an address.

    places: (PLANES, …) int64, the addresses of its streams. left: uint8, in how many samples more each band is to be
    copied, counted down here. stamps: when each band changed; one that did after `stamp` is copied SAMPLES times. A
    band's blocks reach a row into the next.
    """
    at = np.empty(places.shape[1], np.int64)
    for band in range(len(left)):
        if stamps[band] > stamp:
            left[band] = SAMPLES
        if left[band] == 0:
            continue
        left[band] -= 1
        start = band * band_words
        for plane in range(PLANES):
            for k in range(len(at)):
                at[k] = places[plane, k] + 8 * start
            call_words(address, at, 0, min(band_words + stride, length - LINE - start))
