"""Effects: what an outcome does to the corners of a block, found again from the blocks before and after."""

from itertools import permutations
from typing import NamedTuple

import numpy as np

from game.core.rule_table import corners

EMPTY = 0
_STAY = (0, 1, 2, 3)
_FAR = ((0, 3, 1, 2), (3, 0, 2, 1), (1, 2, 0, 3), (2, 1, 3, 0))  # down or up 1, across 2, aside 3


class Invert(NamedTuple):
    """Some bits of a corner's code are inverted."""

    corner: int
    bits: int


class Copy(NamedTuple):
    """A corner takes the code that another had."""

    corner: int
    source: int


class Become(NamedTuple):
    """A corner takes a code."""

    corner: int
    code: int


class Effect(NamedTuple):
    """What one outcome does."""

    parts: tuple  # of Invert, Copy and Become; a corner without one stays
    sources: tuple  # for each corner the one whose content it takes, itself where nothing is known to have moved
    odd: tuple  # corners for which none of the parts will do


def effect_of(states, after, bits):
    """Return the Effect that turns each block state of an array into the one `after`."""
    before, after = corners(states, bits), corners(after, bits)
    sources = _sources(before, after)
    parts, odd = [], []
    for corner in range(4):
        if (before[corner] == after[corner]).all():
            continue
        part = _part(before, after, corner, sources)
        if part is None:
            odd.append(corner)
        else:
            parts.append(part)
    return Effect(tuple(parts), sources, tuple(odd))


def _part(before, after, corner, sources):
    """Return what turns a corner's codes before into those after, or None."""
    old, new = before[corner], after[corner]
    is_new_one = (new == new[0]).all()
    if (old ^ new == old[0] ^ new[0]).all():
        return Invert(corner, int(old[0] ^ new[0]))
    if (before[sources[corner]] == new).all():
        return Copy(corner, sources[corner])
    if is_new_one:
        return Become(corner, int(new[0]))
    return next((Copy(corner, source) for source in range(4) if (before[source] == new).all()), None)


def _sources(before, after):
    """Return where each corner's content comes from if the block's cells only changed places, else `_STAY`."""
    same = [[(after[corner] == before[source]).all() for source in range(4)] for corner in range(4)]
    ways = [way for way in permutations(range(4)) if all(same[corner][source] for corner, source in enumerate(way))]
    return min(ways, key=lambda way: sum(_FAR[corner][source] for corner, source in enumerate(way)), default=_STAY)


def moves_of(states, after, effect, bits):
    """Return the (corner, source) by which what is not empty came to another corner."""
    new = corners(after, bits)
    return [
        (corner, source)
        for corner, source in enumerate(effect.sources)
        if corner != source and (new[corner] != EMPTY).any()
    ]


def flipped(states, after, bits, corner, number):
    """Return at which of the states a bit of a corner changes."""
    return np.asarray(states ^ after) >> (corner * bits + number) & 1 == 1
