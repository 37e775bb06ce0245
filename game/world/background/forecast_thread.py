"""The forecaster: forecasts worked out in a thread beside the frames, the newest request first."""

import time
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from game.core.draw.heatmap import heat_levels
from game.world.background.wished_thread import WishedThread
from game.world.rules.rule import Rule
from game.world.sand.crop import Crop
from game.world.sand.ensemble import Cancelled, certain, growing_counts
from game.world.sand.material_codes import SAND_NAME

PATIENCE_S = 0.15  # a forecast of a past moment is not refined for longer than this: so five fit into a second
LONG_S = 1.0  # a request that is no longer asked is dropped after this, even if nothing has been said to it


@dataclass(frozen=True, eq=False)
class ForecastRequest:
    """What is asked: where a material of a Crop will be."""

    crop: Crop
    rule: Rule
    ahead: int  # iterations
    runs: int  # at most
    of: str = SAND_NAME  # the material
    about: object = None  # what the asker knows it again by


@dataclass(frozen=True, eq=False)
class Forecast:
    """What the runs so far say."""

    request: ForecastRequest
    counts: np.ndarray  # (height, width) int64: how many runs have sand in each cell
    levels: np.ndarray  # (height, width) uint8: the same as levels of heat
    runs: int

    @property
    def certain(self):
        """Whether the rule leaves nothing to chance."""
        return certain(self.request.rule)

    @property
    def error(self):
        """The largest standard error that a cell's share of the runs has: that of one half."""
        return standard_error(0.5, self.runs) if not self.certain else 0.0


def standard_error(share, runs):
    """Return the standard error of a share of independent runs."""
    return (share * (1.0 - share) / runs) ** 0.5


class ForecastThread(WishedThread):
    """A thread that computes forecasts. Neither asking nor looking for the answer ever blocks."""

    name = "forecaster"

    def __init__(self, count=growing_counts):
        super().__init__()
        self._count = count
        self._asked, self._hurry = None, False  # the request that waits, if any
        self.answer = None  # the latest Forecast
        self.working = False

    def ask(self, request, hurry=False):
        """Take a request in place of one that waits; `hurry`: it is a new one, not the same at a later moment.

        What is being worked out gives way: to one that hurries once it has told something, to others when it has had
        its time.
        """
        with self._bell:
            self._asked, self._hurry, self.working = request, self._hurry or hurry, True
            self._wake()

    def close(self):
        """Drop everything, the answer too, and end the thread; a later request begins another."""
        super().close()
        self.working, self.answer = False, None

    def _drop(self):
        self._asked = None

    def _work(self):
        while asked := self._next():
            with suppress(Cancelled, MemoryError):  # what does not fit is not answered; the next request may fit
                self._answer(*asked)

    def _next(self):
        """Wait for a request and take it; return it and whether it hurries, or None when there will be none."""
        with self._bell:
            self.working = self._asked is not None
            self._bell.wait_for(lambda: self._asked or self._closed)
            asked = self._asked and (self._asked, self._hurry)
            self._asked, self._hurry = None, False
            return asked

    def _answer(self, request, hurries):
        """Say more and more of where the sand will be, until it is said or something else is to be done.

        Where an earlier moment has been answered already, few runs are no news: then more are awaited first.
        """
        begin, told = time.monotonic(), False

        def dropped():
            return self._closed or (self._hurry and (told or time.monotonic() - begin > LONG_S))

        world = request.crop.world()
        walls = world.walls
        growing = self._count(world, request.rule, request.ahead, request.runs, request.of, cancelled=dropped)
        for runs, counts in growing:
            late = time.monotonic() - begin > PATIENCE_S
            if hurries or late or runs == request.runs:
                self.answer, told = forecast_of(request, walls, counts, runs), True
            if dropped() or (late and self._asked):
                return


def forecast_of(request, walls, counts, runs):
    """Return the Forecast that the runs so far give; `counts` may change after that."""
    levels = np.empty(counts.shape, np.uint8)
    heat_levels(counts, runs, walls, levels)
    return Forecast(request, counts.copy(), levels, runs)
