"""The one verb that moves sand."""

from functools import lru_cache

import numpy as np

from game.core.compiler.rule_pass import pass_of
from game.core.planes import DEPTH
from game.core.step import advance_planes
from game.world.sand import fixtures, parameters
from game.world.sand.fixtures import Traffic
from game.world.sand.grain_account import NO_GRAINS, added
from game.world.sand.material_codes import check_held

NO_TRAFFIC = Traffic(NO_GRAINS, NO_GRAINS)

_MASK = 2**64 - 1


def advance(world, rule, iterations):
    """Run `iterations` iterations of `rule` on `world`, in place; return the Traffic through the world's fixtures.

    The result does not depend on how the iterations are split into calls. Raises ValueError unless `iterations` is a
    whole number in [0, 2**62] and the rule is of the materials that the world holds.
    """
    check_held(rule, world)
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
    moving = pass_of(rule.table, rule.values, DEPTH if world.coloured else 0)
    where, activity = world.layout, world.activity
    activity.expect(rule.schedule, world.iteration)
    advance_planes(
        world.planes.reshape(-1),
        (where.length, where.rows, where.stride, activity.band_rows),
        moving.run,
        moving.edges,
        (activity.quiet, activity.changed),
        activity.stamp,
        offsets_from(rule.offsets, world.iteration % len(rule.offsets)),
        np.uint64(world.seed),
        np.uint64(world.iteration & _MASK),
        iterations,
    )
    world.iteration += iterations
    activity.iteration = world.iteration


@lru_cache(maxsize=64)
def offsets_from(offsets, phase):
    """Return a schedule's offsets (x, y) as an array that starts with number `phase`; only to be read."""
    return np.array(offsets[phase:] + offsets[:phase], np.int64)
