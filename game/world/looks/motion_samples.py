"""Samples of the last few iterations of a world in play, so that falling sand can be drawn as their mean."""

import time

import numpy as np

from game.core import planes as bit_planes
from game.core.draw.looks import SAND, falling, falling_substances
from game.core.draw.motion_blur import PLANES, SAMPLES, take_sample

FROM_SPEED = 60  # iterations per second: below one in a frame, each one can be seen by itself
MOST_CELLS = 2**22  # in a larger lattice it takes too much of a frame, and cells are too small for stripes to show
SPARE = 0.05  # of a frame's budget: what a cycle of iterations may take beyond it
NO_SAMPLES = np.empty((0, PLANES, 0), np.uint64)


class MotionSamples:
    """Where there was something that falls in the last iterations of one world. It never changes the world."""

    def __init__(self, substances=SAND):
        self.substances = substances  # what the cells can hold
        self._trails = len(falling_substances(substances)) > 1
        self.samples = NO_SAMPLES  # (SAMPLES, PLANES, length) uint64
        self.trail = NO_SAMPLES[:, 0]  # four planes for each bit of the code of what fell last, if that may be several
        self.forget()

    def forget(self):
        """Drop all samples: the next world is taken to have been at rest."""
        self._world, self._iteration, self._stamp = None, -1, 0
        self.moving = np.zeros(0, np.uint8)  # for each band: in how many samples more it may differ from the others

    @staticmethod
    def are_worth(shape, speed):
        """Return whether samples improve how a lattice of that shape looks, at so many iterations per second."""
        return speed >= FROM_SPEED and shape[0] * shape[1] <= MOST_CELLS

    def follows(self, world):
        """Return whether the samples lead up to this moment of the world."""
        return self._knows(world) and world.iteration == self._iteration

    def copy(self, world):
        """Return the same samples, as those of a copy of the world."""
        twin = MotionSamples(self.substances)
        twin.samples, twin.trail, twin.moving = self.samples.copy(), self.trail.copy(), self.moving.copy()
        twin._world, twin._iteration, twin._stamp = world, self._iteration, world.activity.stamp
        return twin

    def take_acts(self, world):
        """Take what was changed from outside since the last iteration to have been so in all samples."""
        activity, where = world.activity, world.layout
        if not self.follows(world) or activity.woken <= self._stamp:
            return
        band_words = activity.band_rows * where.stride
        for band in np.flatnonzero(activity.changed > self._stamp).tolist():
            words = slice(band * band_words, (band + 1) * band_words + where.stride)
            self._take_all(world, words)
        self._stamp = activity.stamp

    def run(self, timeline, iterations, budget_ns=None):
        """Run the timeline as its `run` does, with a sample taken after each of the last iterations.

        Where the budget cuts the run short, the last ones are run beyond it if they take next to nothing.
        """
        start = time.perf_counter_ns()
        together = max(0, iterations - SAMPLES)
        done = timeline.run(together, budget_ns) if together else 0
        last = min(iterations, done + SAMPLES)
        while done < last:
            spent_ns = time.perf_counter_ns() - start
            foreseen_ns = spent_ns + spent_ns / max(done, 1)  # with one more
            late = budget_ns is not None and foreseen_ns >= budget_ns
            if late and done and SAMPLES * spent_ns > SPARE * budget_ns * done:
                break
            done += timeline.run(1)
            self.note(timeline.moment.world)
        return done

    def note(self, world):
        """Take a sample of a world that has just run an iteration."""
        activity, where = world.activity, world.layout
        if not self._knows(world) or world.iteration != self._iteration + 1:
            self._begin(world)
        else:
            what = self.substances, world.planes, self.samples[world.iteration % SAMPLES], self.trail
            stamps = activity.changed, self._stamp
            take_sample(*what, self.moving, *stamps, activity.band_rows * where.stride, where.stride)
        self._stamp, self._iteration = activity.stamp, world.iteration

    def _knows(self, world):
        """Return whether the world is the one that was watched, and was not turned over or cleared since."""
        return world is self._world and world.activity.remade <= self._stamp

    def _begin(self, world):
        """Take all samples to be what the world is now."""
        if self.samples.shape[2:] != (world.layout.length,):
            self.samples = bit_planes.empty(world.layout, SAMPLES * PLANES).reshape(SAMPLES, PLANES, -1)
            self.trail = bit_planes.empty(world.layout, PLANES * self.substances.bits * self._trails)
        self._take_all(world, slice(None))
        self.moving = np.zeros(len(world.activity.changed), np.uint8)
        self._world = world

    def _take_all(self, world, words):
        """Take some words of all samples to be what the world is now."""
        own = world.planes[: PLANES * self.substances.bits, words]
        self.samples[:, :, words] = falling(self.substances, own.reshape(-1, PLANES, own.shape[1]))[0]
        if self._trails:
            self.trail[:, words] = own
