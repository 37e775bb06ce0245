"""Chance: random bits that are a function of seed, iteration, place and draw, and nothing else.

Place is the word of blocks, counted from the top of the lattice; draw counts the random words used there. So a result
depends neither on the order of the work nor on what was skipped.
"""

import numpy as np

from game.core.jit import gate

DRAWS = 32  # bits of a probability that are honoured; more would not be told apart in 10**9 trials
CERTAIN = 2**DRAWS  # probability 1 in units of 2**-32

_GOLDEN = np.uint64(0x9E3779B97F4A7C15)
_DRAWS = np.uint64(DRAWS)
_MULTIPLIERS = np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB)
_SHIFTS = np.uint64(30), np.uint64(27), np.uint64(31)


@gate
def mix(z):
    """Return splitmix64's finaliser of z (Steele, Lea & Flood 2014, with Stafford's variant 13)."""
    z = (z ^ (z >> _SHIFTS[0])) * _MULTIPLIERS[0]
    z = (z ^ (z >> _SHIFTS[1])) * _MULTIPLIERS[1]
    return z ^ (z >> _SHIFTS[2])


@gate
def seed_stream(seed):
    """Return what the keys of all iterations are drawn from, a uint64, from a uint64."""
    return mix(seed + _GOLDEN)


@gate
def iteration_key(stream, iteration):
    """Return the key of an iteration, a uint64, from two uint64."""
    return mix(stream + iteration * _GOLDEN)


@gate
def random_word(key, place, draw):
    """Return 64 random bits, one for each block of the word at `place` (all uint64)."""
    return mix(key + (place * _DRAWS + draw) * _GOLDEN)


def threshold(p):
    """Return probability p in units of 2**-32, rounded to nearest: an int in [0, 2**32]."""
    return round(p * CERTAIN)
