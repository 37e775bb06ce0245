"""Measurements of a session over time; when there are too many, every other one is dropped."""

import math
from itertools import pairwise
from typing import NamedTuple

from game.world.sand.measure import grains_above, pile_heights, slope_degrees
from game.world.sand.sand_colours import COLOURS
from game.world.sessions.action import SetRule

MOST = 1000  # samples kept: when there are more, every other one is dropped
_COLUMNS = (
    "iteration",
    "seconds",
    "above_grains",
    "below_grains",
    "flow_grains_per_iteration",
    "pile_height_cells",
    "pile_slope_degrees",
    "slowest_frame_ms",
)
PROFILE_COLUMNS = "column", "pile_height_cells"


class Measurement(NamedTuple):
    """What was measured at one moment. Above and below are so of the row of Measurements."""

    now: int  # iterations since the scene was loaded
    seconds: float  # since measuring began
    above: int  # grains
    below: int
    height: int  # of the pile below the row, in cells
    slope: float  # of its flanks, in degrees; NaN if it has none
    frame_ms: float  # the slowest frame since the sample before
    act: object  # the last act before
    amounts: tuple  # the grains of each colour, or in another world the cells of each material


class Measurements:
    """Samples of a session, the earliest first, as long as its world holds the same materials."""

    def __init__(self, session, row):
        self.session, self.row, self.codes = session, row, session.world.codes
        self.samples = []
        self._loaded_at = session.timeline.moment.loaded_at
        self.heights = pile_heights(session.world, row)  # (W,) int64: the pile at the last sample

    def follow(self, seconds, frame_ms):
        """Take a sample; what was sampled of a future that is left, or of another scene, is forgotten."""
        session, world = self.session, self.session.world
        if session.timeline.moment.loaded_at != self._loaded_at:
            self._loaded_at, self.samples = session.timeline.moment.loaded_at, []
        while self.samples and self.samples[-1].now >= world.iteration:
            self.samples.pop()
        above, self.heights = grains_above(world, self.row), pile_heights(world, self.row)
        height, slope = int(self.heights.max()), slope_degrees(self.heights)
        act = session.timeline.history.latest(session.now)
        amounts = world.amounts
        below = world.grains - above
        self.samples.append(Measurement(world.iteration, seconds, above, below, height, slope, frame_ms, act, amounts))
        if len(self.samples) > MOST:
            self.samples = _thinned(self.samples)

    def flows(self):
        """Return the grains per iteration that went below the row before each sample; NaN where an act fell between."""
        flows = [math.nan] * len(self.samples)
        for number, (one, other) in enumerate(pairwise(self.samples), 1):
            if _undisturbed(one.act, other.act):
                flows[number] = (one.above - other.above) / (other.now - one.now)
        return flows

    @property
    def columns(self):
        """What the numbers of a row are."""
        if self.codes.is_sand:
            return *_COLUMNS, *(f"{colour}_grains" for colour in COLOURS)
        return *_COLUMNS, *(f"{name.replace(' ', '_')}_cells" for name in self.codes.names)

    def rows(self):
        """Return the story as rows of numbers, as `columns` names them."""
        return [
            (*each[:4], flow, *each[4:7], *each.amounts) for each, flow in zip(self.samples, self.flows(), strict=True)
        ]


def _undisturbed(before, after):
    """Return whether from one act to another of a line nothing but the rule was changed."""
    while after is not before and isinstance(after.action, SetRule):
        after = after.before
    return after is before


def _thinned(samples):
    """Return every other sample, the last one too; each keeps the slowest frame of the one left out before it."""
    pairs = zip(samples[-1::-2], [*samples[-2::-2], samples[0]], strict=False)
    return [each._replace(frame_ms=max(each.frame_ms, left.frame_ms)) for each, left in pairs][::-1]


def csv(columns, rows):
    """Return rows of numbers as the bytes of a CSV file with a header; what is not known is left empty."""
    lines = [",".join(columns)]
    lines += [",".join(_spelled(number) for number in row) for row in rows]
    return ("\r\n".join(lines) + "\r\n").encode("ascii")


def _spelled(number):
    if isinstance(number, float):
        return "" if math.isnan(number) else f"{number:.6g}"
    return str(number)
