"""The one verb that moves sand."""

from functools import lru_cache

import numpy as np

from game.core.chance import chance_of
from game.core.grain_colours import ROW, Tracks
from game.core.planes import aligned
from game.core.step import advance_planes
from game.core.step_coloured import advance_together
from game.world.sand import fixtures, parameters
from game.world.sand.fixtures import Traffic
from game.world.sand.grain_account import NO_GRAINS, added

NO_TRAFFIC = Traffic(NO_GRAINS, NO_GRAINS)

_MASK = 2**64 - 1


def advance(world, rule, iterations):
    """Run `iterations` iterations of `rule` on `world`, in place; return the Traffic through the world's fixtures.

    The result does not depend on how the iterations are split into calls. Raises ValueError unless `iterations` is a
    whole number in [0, 2**62].
    """
    iterations = parameters.ITERATIONS.check(iterations)
    if not world.fixtures:
        _run(world, rule, iterations)
        return NO_TRAFFIC
    end, poured, swallowed = world.iteration + iterations, NO_GRAINS, NO_GRAINS
    while world.iteration < end:
        came, went = fixtures.act(world)
        poured, swallowed = added(poured, came), added(swallowed, went)
        _run(world, rule, min(fixtures.pause(world.fixtures, world.iteration), end - world.iteration))
    return Traffic(poured, swallowed)


def _run(world, rule, iterations):
    """Run iterations at once, in which no fixture acts."""
    certain, chance, seven = needs(rule)
    where, activity = world.layout, world.activity
    activity.expect(rule.schedule, world.iteration)
    planes = world.planes.reshape(-1)
    shape = where.length, where.rows, where.stride, activity.band_rows
    quiet, changed, stamp = activity.quiet, activity.changed, activity.stamp
    offsets = offsets_from(rule.offsets, world.iteration % len(rule.offsets))
    if certain and world.coloured:
        advance_together(planes, shape, quiet, activity.busy, changed, stamp, offsets, iterations)
    else:
        seed, iteration = np.uint64(world.seed), np.uint64(world.iteration & _MASK)
        tracks = Tracks(aligned(3 * ROW), np.empty(ROW, np.uint8)) if world.coloured else None
        advance_planes(
            planes, shape, quiet, changed, stamp, offsets, seed, iteration, iterations, certain, chance, seven, tracks
        )
    world.iteration += iterations
    activity.iteration = world.iteration


@lru_cache(maxsize=64)
def offsets_from(offsets, phase):
    """Return a schedule's offsets (x, y) as an array that starts with number `phase`; only to be read."""
    return np.array(offsets[phase:] + offsets[:phase], np.int64)


@lru_cache(maxsize=64)
def needs(rule):
    """Return the (certain, chance, seven) that `advance_planes` needs for the rule."""
    if all(p == 1.0 for p in rule.probabilities):
        return True, None, None
    only_topples = all(p == 1.0 for p in rule.probabilities[2:])
    return None, chance_of(rule.probabilities), None if only_topples else True
