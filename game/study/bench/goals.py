"""Goals: what is wanted of each figure, said once, and whether it was met."""

from dataclasses import asdict, dataclass

from game.study.report.report import Section
from game.study.report.table import Column, Table

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
TABLE_PEER = 10.0  # times as fast as bytes and a table of block states in C++, sixteen materials, every cell in motion
HEADER_PEER = 8.0  # the same for the exported header
HEADER = 2.0  # times the iteration of ours for the exported header, sand
WATER = 2.2  # times the iteration of sand, with water besides
FRAME_MS = 16.0  # 99 of 100 frames, all their iterations run
WARM_S = 1.0  # from the command to the first frame
COLD_SPLASH_S = 1.0  # from the command to the splash, no kernel compiled before
COLD_S = 5.0  # from the command to the first frame, no kernel compiled before
PLANES_MB = 200.0  # of the largest lattice


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
        reason = f" ({self.spoiled})" if self.spoiled else ""
        return f"{self.wanted}: {'met' if self.met else 'not met'}{reason}"

    def __str__(self):
        """What was measured and what was wanted: 'settled …: 1.7 %, wanted ≤ 2 %: met'."""
        return f"{self.what}: {self.reading}, wanted {self.verdict}"

    @property
    def reading(self):
        """What was measured, with its unit."""
        return f"{self.measured:.3g}{self.unit}"

    def as_dict(self):
        """Return the goal as data for JSON."""
        return {**asdict(self), "wanted": self.wanted, "met": self.met}


def at_least(what, measured, limit, unit="×"):
    """Return the goal that a figure is no less than `limit`."""
    return Goal(what, measured, limit, unit, at_least=True)


def at_most(what, measured, limit, unit="×", spoiled=""):
    """Return the goal that a figure is no more than `limit`."""
    return Goal(what, measured, limit, unit, at_least=False, spoiled=spoiled)


COLUMN = Column("goal", "goal", lambda goal: goal.verdict)


def goals_of(section):
    """Return the goals in the rows of a section and among its notes."""
    beside_rows = [row["goal"] for table in section.tables for row in table.rows if row.get("goal")]
    return beside_rows + [item for item in section.items if isinstance(item, Goal)]


def goal_section(sections):
    """Return a Section with every goal of the sections, and in its title how many were met."""
    goals = [goal for section in sections for goal in goals_of(section)]
    rows = [(goal.what, goal.reading, goal.verdict) for goal in goals]
    title = f"Goals: {sum(goal.met for goal in goals)} of {len(goals)} met"
    return Section("goals", title, [Table.of("", ("figure", "measured", "wanted"), rows)])
