"""Reactions counted: how often each event makes some materials of others, by name."""

from collections import Counter
from functools import lru_cache

import numpy as np

from game.core.changed_blocks import changed_blocks
from game.world.sand.advance import advance
from game.world.sand.block_events import offset, told_events

MOST_BLOCKS = 2**16  # that react in one iteration; more are taken to react as these do
STATES = 2**16  # of a block, at most


def coming_reactions(world, rule):
    """Return a Counter {name of an event: how often it makes other materials in the coming iteration}.

    The iteration is run on a copy of the world, without its taps and drains, and the blocks of bands that stir are
    compared. What several events may have made of a block counts for "one or another".
    """
    after, where, activity = world.copy(), world.layout, world.activity
    after.fixtures = ()
    after.activity.follow(activity)
    advance(after, rule, 1)
    found = np.empty((MOST_BLOCKS, 2), np.int64)
    lattice = (where.words, where.bits, where.outside), where.height, offset(world, rule)
    awake = activity.awake(rule.schedule, world.iteration)
    number = changed_blocks(world.planes, after.planes, *lattice, awake, activity.band_rows, found)
    blocks, times = np.unique(found[:number] @ (STATES, 1), return_counts=True)
    counted, share = Counter(), max(1.0, number / MOST_BLOCKS)
    for block, n in zip(blocks.tolist(), times.tolist(), strict=True):
        counted[_name(rule, *divmod(block, STATES))] += n * share
    return counted


@lru_cache(maxsize=2**12)
def _name(rule, before, after):
    """Return the names of the events that make one block of another."""
    return " or ".join(event.name for event, _ in told_events(rule, before, after))
