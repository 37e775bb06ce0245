"""Bands of rows: which are quiet, so that they need not be computed or drawn."""

import numpy as np

from game.core.planes import LINE
from game.core.step import BAND, CYCLE


class ActiveBands:
    """What is known about each band of plane rows. It affects speed only, never the result."""

    def __init__(self, layout):
        band_rows = max(LINE, BAND // layout.stride // LINE * LINE)  # so bands start at a cache line
        self.band_rows = min(band_rows, layout.rows)  # plane rows in a band, two lattice rows each
        bands = -(-layout.rows // self.band_rows)
        self.quiet = np.zeros(bands, np.int64)  # iterations in which nothing moved or could have, up to CYCLE
        self.changed = np.zeros(bands, np.int64)  # the stamp of the latest change
        self.stamp = 1  # rises with every batch of iterations and every act
        self.woken = 1  # the stamp of the latest change from outside: without one, no wall has changed
        self.remade = 1  # the stamp of the latest change from outside to all of the lattice
        self.schedule, self.iteration = None, None  # what `quiet` counts for

    def expect(self, schedule, iteration):
        """Prepare for a batch of `schedule` that starts at `iteration`; forget what holds for another one."""
        if (schedule, iteration) != (self.schedule, self.iteration):
            self.quiet[:] = 0
            self.schedule, self.iteration = schedule, iteration
        self.stamp += 1

    def follow(self, other, schedule, iteration, watched):
        """Know for an iteration what the ActiveBands of an equal world know; bands that are not `watched` are still."""
        known = other.quiet if (schedule, iteration) == (other.schedule, other.iteration) else 0
        self.quiet[:] = np.where(watched, known, CYCLE)
        self.schedule, self.iteration = schedule, iteration

    def awake(self, schedule, iteration):
        """Return which bands may change in one iteration of a schedule: a bool array."""
        if (schedule, iteration) != (self.schedule, self.iteration):
            return np.ones(len(self.quiet), bool)
        quiet = np.pad(self.quiet >= CYCLE, 1, mode="edge")
        return ~(quiet[:-2] & quiet[1:-1] & quiet[2:])

    def wake(self, top=0, bottom=None):
        """Note a change from outside in the lattice rows from `top` to before `bottom` (default: all)."""
        bands = slice(
            max(0, top // 2 // self.band_rows), None if bottom is None else max(0, bottom) // 2 // self.band_rows + 1
        )
        self.stamp += 1
        self.quiet[bands] = 0
        self.changed[bands] = self.woken = self.stamp
        if top == 0 and bottom is None:
            self.remade = self.stamp

    @property
    def settled(self):
        """Whether nothing can move any more, whatever the probabilities, under the schedule last run."""
        return bool((self.quiet >= CYCLE).all())
