"""The one verb that moves sand."""

from functools import lru_cache

import numpy as np

from game.core.chance import bit_masks
from game.core.step import advance_planes
from game.world import knob

_MASK = 2**64 - 1


def advance(world, rule, iterations):
    """Run `iterations` iterations of `rule` on `world`, in place.

    The result does not depend on how the iterations are split into calls. Raises ValueError unless `iterations` is a
    whole number in [0, 2**62].
    """
    iterations = knob.ITERATIONS.check(iterations)
    offsets = np.array(rule.offsets, np.int64)
    phase = world.iteration % len(offsets)
    topples, all_seven = chances(rule)
    where = world.layout
    advance_planes(
        world.planes,
        where.rows,
        where.stride,
        np.roll(offsets, -phase, axis=0),
        np.uint64(world.seed),
        np.uint64(world.iteration & _MASK),
        iterations,
        topples,
        all_seven,
    )
    world.iteration += iterations


@lru_cache(maxsize=64)
def chances(rule):
    """Return the rule's (topples, all_seven) for `advance_planes`: None where nothing is left to chance."""
    if all(p == 1.0 for p in rule.probabilities):
        return None, None
    if all(p == 1.0 for p in rule.probabilities[2:]):
        return bit_masks(rule.probabilities[:2]), None
    return None, bit_masks(rule.probabilities)
