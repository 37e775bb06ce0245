"""Reactions counted: how often each event makes some materials of others, by name."""

from collections import Counter
from functools import lru_cache

import numpy as np

from game.core.changed_blocks import changed_blocks
from game.world.sand.advance import advance
from game.world.sand.block_events import offset, told_events

PARTS = 4  # of the lattice, from the top down, which are watched in turn
MOST_BLOCKS = 2**16  # that react in one iteration; more are taken to react as these do
STATES = 2**16  # of a block, at most


class ReactionMeter:
    """Counts the reactions of the coming iteration in one part of a lattice; the next look is at the next part.

    The iteration is run on a copy, without taps and drains, and blocks of bands that stir are compared. What several
    events may have made of a block counts for "one or another".
    """

    def __init__(self, parts=PARTS):
        self._parts, self._turn = parts, 0
        self._after = None  # the copy, of which only the part watched and what is beside it are up to date
        self._found = np.empty((MOST_BLOCKS, 2), np.int64)

    def look(self, world, rule):
        """Return a Counter {name of an event: how often it will make other materials, about, in the whole lattice}."""
        where, activity = world.layout, world.activity
        bands = len(activity.quiet)
        parts = min(self._parts, bands)
        first, end = (bands * (self._turn % parts + side) // parts for side in (0, 1))
        self._turn += 1
        after = self._copied(world, (first - 1) * activity.band_rows, (end + 1) * activity.band_rows)
        watched = (np.arange(bands) >= first) & (np.arange(bands) < end)
        after.activity.follow(activity, rule.schedule, world.iteration, watched)
        watched &= activity.awake(rule.schedule, world.iteration)
        advance(after, rule, 1)
        lattice = (where.words, where.bits, where.outside), where.height, offset(world, rule)
        number = changed_blocks(world.planes, after.planes, *lattice, watched, activity.band_rows, self._found)
        blocks, times = np.unique(self._found[:number] @ (STATES, 1), return_counts=True)
        counted, share = Counter(), parts * max(1.0, number / len(self._found))
        for block, n in zip(blocks.tolist(), times.tolist(), strict=True):
            counted[_name(rule, *divmod(block, STATES))] += n * share
        return counted

    def _copied(self, world, first, end):
        """Return the copy, with the plane rows from `first` to before `end` as they are now."""
        if self._after is None or (self._after.layout, self._after.codes) != (world.layout, world.codes):
            self._after = world.copy()
            self._after.fixtures = ()
        stride = world.layout.stride
        words = slice(max(0, first) * stride, end * stride)
        self._after.planes[:, words] = world.planes[:, words]
        self._after.iteration, self._after.seed = world.iteration, world.seed
        return self._after


@lru_cache(maxsize=2**12)
def _name(rule, before, after):
    """Return the names of the events that make one block of another."""
    return " or ".join(event.name for event, _ in told_events(rule, before, after))
