"""Ink on planes: what an act leaves in a cell that it reaches, and which cells take it."""

from typing import NamedTuple

import numpy as np

from game.core.chance import mix
from game.core.jit import gate
from game.core.planes import COLOURS, DEPTH, SAND, WALLS

EMPTY, GRAIN, WALL = range(3)  # the kinds of cells, and so the materials that make a cell one of them
ANY = 0b111  # a set of kinds has bit k for kind k
RAINBOW = 2**DEPTH  # a colour that is none: stripes of them all; so many more begin so many colours later
STRIPE = 12  # cells, along a row: the width of the rainbow's stripes
SPRAYED = np.uint64(2**64 // 40)  # of 2**64: the chance that a cell takes the ink of one spray

_ONE = np.uint64(1)
_ROW = np.uint64(2**32)


class Ink(NamedTuple):
    """What an act leaves in the cells that it reaches."""

    material: int  # EMPTY, GRAIN or WALL
    kinds: int = ANY  # the kinds of cells that take it, as bits
    spray: int = 0  # 0: all of them take it; else a number that picks a few of them, others for each number
    colour: int | None = 0  # of a grain, or RAINBOW; None where grains have no colours
    tally: np.ndarray | None = None  # (2**DEPTH,) int64: the change in the grains of each colour is added here


@gate
def _set(plane, at, bit, on):
    plane[at] = plane[at] | bit if on else plane[at] & ~bit


@gate
def _sprayed(spray, x, y):
    """Return whether the cell is one of those that spray number `spray` picks."""
    return mix(mix(np.uint64(spray)) + np.uint64(y) * _ROW + np.uint64(x)) < SPRAYED


@gate
def _colour_at(planes, plane, at, bit):
    """Return the colour of a grain."""
    colour = 0
    for k in range(DEPTH):
        colour |= int((planes[COLOURS + 4 * k + plane, at] & bit) != 0) << k
    return colour


@gate
def _dye(planes, plane, at, bit, was_sand, is_sand, number, colour, tally):
    """Give the grain that is in a cell now its colour and count it; number: of the stripe that the cell lies in."""
    if tally is not None:
        if was_sand:
            tally[_colour_at(planes, plane, at, bit)] -= 1
        if is_sand:
            taken = colour if colour < RAINBOW else (colour + number) % RAINBOW
            tally[taken] += 1
            for k in range(DEPTH):
                _set(planes[COLOURS + 4 * k + plane], at, bit, (taken >> k) & 1)


@gate
def put(planes, words, x, y, ink):
    """Let the cell in column x and row y take the ink, if it is one that does; return the change in grains."""
    plane = 2 * (y & 1) + (x & 1)
    lane = (x >> 1) // words
    word = (x >> 1) - lane * words
    at = (y >> 1) * (words + 1) + word
    bit = _ONE << np.uint64(lane)
    was_sand = (planes[SAND + plane, at] & bit) != 0
    kind = GRAIN if was_sand else WALL if (planes[WALLS + plane, at] & bit) != 0 else EMPTY
    if not (ink.kinds >> kind) & 1 or (ink.spray and not _sprayed(ink.spray, x, y)):
        return 0
    _set(planes[SAND + plane], at, bit, ink.material == GRAIN)
    _set(planes[WALLS + plane], at, bit, ink.material == WALL)
    _dye(planes, plane, at, bit, was_sand, ink.material == GRAIN, (x + y) // STRIPE, ink.colour, ink.tally)
    return int(ink.material == GRAIN) - int(was_sand)


def by_colour(change, ink):
    """Return the change in the grains of each colour, a tuple of eight, where acts with this ink changed so many."""
    return (change, *[0] * (RAINBOW - 1)) if ink.tally is None else tuple(ink.tally.tolist())
