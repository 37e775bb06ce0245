"""Measurements of a session over time; when there are too many, every other one is dropped."""

import math
from collections import Counter
from itertools import pairwise
from typing import NamedTuple

from game.world.sand.measure import grains_above, pile, surface_slope
from game.world.sand.reaction_counts import ReactionMeter
from game.world.sand.sand_colours import COLOURS
from game.world.sessions.action import SetRule

LATELY = 8  # samples by which reactions are put in order
MOST = 1000  # samples kept: when there are more, every other one is dropped
COMMON_COLUMNS = (
    "iteration",
    "seconds",
    "above_grains",
    "below_grains",
    "flow_grains_per_iteration",
    "pile_height_cells",
    "pile_slope_degrees",
    "pile_slope_error_degrees",
    "slowest_frame_ms",
)
PROFILE_COLUMNS = "column", "pile_height_cells", "surface_height_cells"


class Measurement(NamedTuple):
    """What was measured at one moment. Above and below are so of the row of Measurements."""

    now: int  # iterations since the scene was loaded
    seconds: float  # since measuring began
    above: int  # grains
    below: int
    height: int  # of the pile below the row, in cells
    slope: float  # of the surface of its flanks, in degrees; NaN if it has none
    slope_error: float  # standard error
    frame_ms: float  # the slowest frame since the sample before
    act: object  # the last act before
    amounts: tuple  # the grains of each colour, or in another world the cells of each material
    reactions: dict  # {name of an event: how often it has made other materials since measuring began, about}


class Measurements:
    """Samples of a session, the earliest first, as long as its world holds the same materials."""

    def __init__(self, session, row):
        self.session, self.row, self.codes = session, row, session.world.codes
        self.samples = []
        self._loaded_at = session.timeline.moment.loaded_at
        self.pile = pile(session.world, row)  # at the last sample
        self._meter = ReactionMeter()
        self._watched, self._watched_at, self._reacted = 0, None, Counter()  # iterations since the last sample

    def watch(self):
        """Count reactions of the coming iteration; it stands for those not watched until the next sample."""
        session = self.session
        if session.now != self._watched_at:
            self._reacted += self._meter.look(session.world, session.rule)
            self._watched, self._watched_at = self._watched + 1, session.now

    def follow(self, seconds, frame_ms):
        """Take a sample; what was sampled of a future that is left, or of another scene, is forgotten."""
        session, world = self.session, self.session.world
        if session.timeline.moment.loaded_at != self._loaded_at:
            self._loaded_at, self.samples = session.timeline.moment.loaded_at, []
        while self.samples and self.samples[-1].now >= world.iteration:
            self.samples.pop()
        above, self.pile = grains_above(world, self.row), pile(world, self.row)
        slope = surface_slope(self.pile.surface)
        act = session.timeline.history.latest(session.now)
        now, amounts = world.iteration, world.amounts
        below = sum(amounts) - above
        here = now, seconds, above, below, self.pile.height, *slope, frame_ms, act, amounts
        self.samples.append(Measurement(*here, self._reactions(now)))
        if len(self.samples) > MOST:
            self.samples = _thinned(self.samples)

    def _reactions(self, now):
        """Return how often each event has come about up to iteration `now`, and begin to count for the next sample."""
        last = self.samples[-1] if self.samples else None
        each = (now - last.now) / self._watched if last and self._watched else 0.0
        told = Counter(last.reactions if last else ()) + Counter({name: n * each for name, n in self._reacted.items()})
        self._watched, self._reacted = 0, Counter()
        return dict(told)

    def reactions(self):
        """Return {name of an event: [how often it came about in an iteration before each sample]}.

        Those come first that came about most in the last samples.
        """
        told = [each.reactions for each in self.samples]
        spans = [other.now - one.now for one, other in pairwise(self.samples)]
        found = {}
        for name in told[-1] if told else ():
            totals = [each.get(name, 0.0) for each in told]
            rates = [(other - one) / span for (one, other), span in zip(pairwise(totals), spans, strict=True)]
            found[name] = [math.nan, *rates]
        return dict(sorted(found.items(), key=lambda each: (-sum(each[1][1:][-LATELY:]), -told[-1][each[0]])))

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
        return *self.lasting_columns, *(f"{name.replace(' ', '_')}_per_iteration" for name in self.reactions())

    @property
    def lasting_columns(self):
        """The first columns, without those of what has reacted so far."""
        if self.codes.is_sand:
            return *COMMON_COLUMNS, *(f"{colour}_grains" for colour in COLOURS)
        return *COMMON_COLUMNS, *(f"{name.replace(' ', '_')}_cells" for name in self.codes.names)

    def rows(self):
        """Return the story as rows of numbers, as `columns` names them."""
        reactions = zip(*self.reactions().values(), strict=True) if self.reactions() else ((),) * len(self.samples)
        return [
            (*each[:4], flow, *each[4:8], *each.amounts, *rates)
            for each, flow, rates in zip(self.samples, self.flows(), reactions, strict=True)
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
    """Return rows of numbers, and of words without commas, as the bytes of a CSV file with a header.

    What is not known is left empty.
    """
    lines = [",".join(columns)]
    lines += [",".join(_spelled(number) for number in row) for row in rows]
    return ("\r\n".join(lines) + "\r\n").encode("ascii")


def _spelled(number):
    if isinstance(number, float):
        return "" if math.isnan(number) else f"{number:.6g}"
    return str(number)
