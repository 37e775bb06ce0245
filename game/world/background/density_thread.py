"""The density thread: where sand is at the present iteration, of many runs of several worlds, beside the frames."""

import time
from contextlib import suppress
from functools import partial
from typing import NamedTuple

import numpy as np

from game.core.draw.heatmap import heat_levels
from game.world.background.wished_thread import WishedThread
from game.world.sand.ensemble import Cancelled, FollowedRuns

WORDS = 2**21  # of all runs of one world, 16 MiB: more cells, fewer runs
RUNS = 64, 1024  # fewest and most of a world
ANSWER_S = 0.1  # from one answer to the next, about, while the runs are behind
FIRST_STRIDE = 8  # iterations


class DensityStart(NamedTuple):
    """Where the runs of one world begin."""

    world: object  # a World that nobody changes any more
    rule: object
    of: str  # the material


class DensityMaps(NamedTuple):
    """What the runs say."""

    about: object  # what the asker knows it again by
    now: int  # iterations since the start
    runs: int
    levels: dict  # {name: (H, W) uint8 levels of heat}
    certain: bool  # nothing is left to chance


def runs_of(cells):
    """Return how many runs of a world of so many cells are followed."""
    fewest, most = RUNS
    return max(fewest, min(most, WORDS // cells * 64))


class DensityThread(WishedThread):
    """Follows runs to the iteration that is wanted. Neither wishing nor looking for the answer ever blocks."""

    name = "density"

    def __init__(self):
        super().__init__()
        self._wanted = None  # (about, {name: DensityStart}, iterations since the start)
        self.answer = None  # the latest DensityMaps

    @property
    def working(self):
        """Whether an answer is on its way."""
        wanted, answer = self._wanted, self.answer
        return wanted is not None and (answer is None or (answer.about, answer.now) != (wanted[0], wanted[2]))

    def follow(self, about, starts, moment):
        """Wish for the maps at a moment, iterations since the start; `starts` are read where `about` is another."""
        with self._bell:
            self._wanted = about, starts, moment
            self._wake()

    def close(self):
        """Drop everything, the answer too, and end the thread; a later wish begins another."""
        super().close()
        self.answer = None

    def _drop(self):
        self._wanted = None

    def _work(self):
        about, runs, walls, stride = None, {}, {}, FIRST_STRIDE
        while wanted := self._next():
            begin = time.monotonic()
            with suppress(Cancelled):
                if wanted[0] is not about or wanted[2] < min((each.now for each in runs.values()), default=0):
                    about, runs, walls = wanted[0], {}, {}
                    runs = {name: _followed(start) for name, start in wanted[1].items()}
                    walls = {name: start.world.walls for name, start in wanted[1].items()}
                now = next(iter(runs.values())).now
                goal = min(wanted[2], now + stride)
                for each in runs.values():
                    each.run_to(goal, partial(self._is_dropped, about))
                self.answer = _maps(about, runs, walls)
                took_s = time.monotonic() - begin
                if goal - now == stride:
                    stride = max(1, round(stride * min(2.0, ANSWER_S / max(took_s, 1e-3))))

    def _is_dropped(self, about):
        wanted = self._wanted
        return wanted is None or wanted[0] is not about

    def _next(self):
        """Wait until another answer is wanted than the latest; return what is wanted, or None at the end."""
        with self._bell:
            self._bell.wait_for(lambda: self.working or self._closed)
            return None if self._closed else self._wanted


def _followed(start):
    return FollowedRuns(start.world, start.rule, runs_of(start.world.shape[0] * start.world.shape[1]), start.of)


def _maps(about, runs, walls):
    levels = {}
    for name, each in runs.items():
        levels[name] = np.empty(walls[name].shape, np.uint8)
        heat_levels(each.counts(), each.runs, walls[name], levels[name])
    some = next(iter(runs.values()))
    return DensityMaps(about, some.now, some.runs, levels, all(each.certain for each in runs.values()))
