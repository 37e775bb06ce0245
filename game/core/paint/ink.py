"""Ink on planes: the code that an act leaves in a cell that it reaches, and which cells take it."""

from typing import NamedTuple

import numpy as np

from game.core.chance import mix
from game.core.jit import gate
from game.core.planes import DEPTH

ANY = 2**16 - 1  # a set of codes has bit k for code k
RAINBOW = 2**DEPTH  # a colour that is none: stripes of them all; so many more begin so many colours later
STRIPE = 12  # cells, along a row: the width of the rainbow's stripes
SPRAYED = np.uint64(2**64 // 40)  # of 2**64: the chance that a cell takes the ink of one spray

_ONE = np.uint64(1)
_ROW = np.uint64(2**32)


class Ink(NamedTuple):
    """What an act leaves in the cells that it reaches."""

    code: int
    taken: int = ANY  # the codes of the cells that take it, as bits
    spray: int = 0  # 0: all of them take it; else a number that picks a few of them, others for each number
    colour: int = 0  # of a grain of sand, or RAINBOW


class Tally(NamedTuple):
    """An ink as kernels need it for a world, and the account of what it does there."""

    ink: Ink
    bits: int  # of a code
    change: np.ndarray  # (2**n,) int64: what became of the cells of each content, n bits: code + 2**bits · colour


@gate
def _sprayed(spray, x, y):
    """Return whether the cell is one of those that spray number `spray` picks."""
    return mix(mix(np.uint64(spray)) + np.uint64(y) * _ROW + np.uint64(x)) < SPRAYED


@gate
def put(planes, words, x, y, tally):
    """Let the cell in column x and row y take the ink of a Tally, if it is one that does, and count it."""
    ink, bits, change = tally
    plane = 2 * (y & 1) + (x & 1)
    lane = (x >> 1) // words
    at = (y >> 1) * (words + 1) + (x >> 1) - lane * words
    mask = _ONE << np.uint64(lane)
    before = 0
    for bit in range(len(planes) >> 2):
        before |= int((planes[4 * bit + plane, at] & mask) != 0) << bit
    if not (ink.taken >> (before & ((1 << bits) - 1))) & 1 or (ink.spray and not _sprayed(ink.spray, x, y)):
        return
    colour = ink.colour if ink.colour < RAINBOW else (ink.colour + (x + y) // STRIPE) % RAINBOW
    after = (ink.code | colour << bits) & (len(change) - 1)
    change[before] -= 1
    change[after] += 1
    for bit in range(len(planes) >> 2):
        old = planes[4 * bit + plane, at]
        planes[4 * bit + plane, at] = old | mask if (after >> bit) & 1 else old & ~mask
