"""Tables: what was measured, as plain text, Markdown and data."""

import textwrap
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

from game.study.bench.goals import Goal
from game.study.bench.rounds import Timing

WIDTH = 118  # characters to a line of the notes


@dataclass(frozen=True)
class Column:
    """One column: the rows' key, its heading, and how a value reads."""

    key: str
    heading: str
    show: Callable = str


@dataclass
class Table:
    """Rows (dicts of raw values, None where there is none) under columns, with notes that say what was measured how."""

    key: str
    title: str
    columns: tuple
    rows: list = field(default_factory=list)
    notes: list = field(default_factory=list)
    further_goals: list = field(default_factory=list)  # of the table as a whole, shown as notes

    @property
    def goals(self):
        """All goals: beside the rows, and of the table."""
        return [row["goal"] for row in self.rows if row.get("goal")] + self.further_goals

    @property
    def remarks(self):
        """The lines under the table."""
        return self.notes + [goal.line for goal in self.further_goals]

    def cells(self):
        """The headings and then the rows, as lists of strings."""
        shown = [["" if row.get(each.key) is None else each.show(row[each.key]) for each in self.columns]
                 for row in self.rows]  # fmt: skip
        return [[each.heading for each in self.columns], *shown] if shown else []

    def text(self):
        """Return the table for a terminal, its columns aligned."""
        columns = []
        for each, cells in zip(self.columns, zip(*self.cells(), strict=True), strict=False):
            width = max(map(len, cells))
            columns.append([cell.ljust(width) if self._in_words(each) else cell.rjust(width) for cell in cells])
        lines = ["  " + "  ".join(line).rstrip() for line in zip(*columns, strict=True)]
        wrap = partial(textwrap.fill, width=WIDTH, initial_indent="  · ", subsequent_indent="    ")
        return "\n".join([self.title, "", *lines, *map(wrap, self.remarks)])

    def markdown(self):
        """Return the table as Markdown under a heading."""
        lines = self.cells()
        if lines:
            lines.insert(1, [":---" if self._in_words(each) else "---:" for each in self.columns])
        drawn = ["| " + " | ".join(line) + " |" for line in lines]
        return "\n".join([f"## {self.title}", "", *drawn, "", *(f"- {each}" for each in self.remarks), ""])

    def as_dict(self):
        """The table as data for JSON."""
        rows = [{key: _plain(value) for key, value in row.items()} for row in self.rows]
        return {"title": self.title, "rows": rows, "notes": self.remarks}

    def _in_words(self, column):
        return any(isinstance(row.get(column.key), str | Goal) for row in self.rows)


def _plain(value):
    return value.as_dict() if isinstance(value, Timing | Goal) else value


# --- how values read ---


def figure(value):
    """Three significant digits, thousands apart: 0.0391, 2.07, 85.9, 2,070."""
    if value == 0:
        return "0"
    return f"{value:,.0f}" if abs(value) >= 99.95 else f"{value:#.3g}".rstrip(".")


def whole(value):
    """A count: 8,294,400."""
    return f"{value:,}"


def size(value):
    """A (width, height): 1920×1080."""
    return "×".join(map(str, value))


def ratio(value):
    """A factor: 1.46×."""
    return f"{figure(value)}×"


def percent(value):
    """A part: 1.7 %."""
    return f"{figure(100 * value)} %"


def spread(unit_ns):
    """Return how a Timing reads in a unit of so many nanoseconds: the median, and the range over the rounds."""

    def show(timing):
        low, high = (figure(each / unit_ns) for each in (timing.low, timing.high))
        return f"{figure(timing.median / unit_ns)} ({low}–{high})"

    return show


MILLISECONDS, MICROSECONDS = spread(1e6), spread(1e3)
