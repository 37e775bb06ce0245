"""Goals: what is wanted of each figure, said once, and whether it was met."""

from dataclasses import asdict, dataclass

PACE_P1 = 1.0  # of the xor pass, p = 1, every cell in motion, from 1920×1080 on …
PACE_P1_LARGEST = 1.5  # … and on the largest lattice, which no cache holds
PACE_CHANCE = 0.7  # of the xor pass, the paper's p on an hourglass in mid-flow …
PACE_CHANCE_LARGEST = 1.0  # … and on the largest lattice
PACED_FROM = 1920 * 1080  # cells
LARGEST = 16384 * 16384  # cells
SMALL_US = {(61, 61): 1.0, (240, 180): 2.0}  # microseconds per iteration in a batch
SETTLED = 0.02  # of the time of a lattice in motion
SEVEN = 3.0  # times the rule that leaves only the two topples to chance
COLOURS = 2.5  # times the iteration of the same sand without colours
FRAME_MS = 16.0  # 99 of 100 frames, all their iterations run
WARM_S = 1.0  # from the command to the first frame
COLD_SPLASH_S = 1.0  # from the command to the splash, no kernel compiled before
COLD_S = 10.0  # from the command to the first frame, no kernel compiled before
PLANES_MB = 200.0  # of the largest lattice
THREADS = 1.6  # times the pace on two cores from which a second thread would be worth its trouble


@dataclass(frozen=True)
class Goal:
    """What was wanted of a figure, and what it is."""

    what: str
    measured: float
    limit: float
    unit: str
    at_least: bool
    spoiled: str = ""  # why the goal is missed whatever the figure says

    @property
    def met(self):
        """Whether the figure is on the right side of the limit."""
        return not self.spoiled and (self.measured >= self.limit if self.at_least else self.measured <= self.limit)

    @property
    def wanted(self):
        """The limit in words: '≥ 0.7×'."""
        return f"{'≥' if self.at_least else '≤'} {self.limit:g}{self.unit}"

    @property
    def verdict(self):
        """The limit and whether it was met: '≥ 0.7×: met'."""
        return f"{self.wanted}: {'met' if self.met else 'not met'}{self.spoiled and f' ({self.spoiled})'}"

    @property
    def line(self):
        """What was measured and what was wanted: 'settled …: 1.7 %, wanted ≤ 2 %: met'."""
        return f"{self.what}: {self.measured:.3g}{self.unit}, wanted {self.verdict}"

    def as_dict(self):
        """The goal as data for JSON."""
        return {**asdict(self), "wanted": self.wanted, "met": self.met}


def at_least(what, measured, limit, unit="×"):
    """Return the goal that a figure is no less than `limit`."""
    return Goal(what, measured, limit, unit, at_least=True)


def at_most(what, measured, limit, unit="×", spoiled=""):
    """Return the goal that a figure is no more than `limit`."""
    return Goal(what, measured, limit, unit, at_least=False, spoiled=spoiled)


def verdict(goal):
    """Return how a goal reads beside its figure."""
    return goal.verdict
