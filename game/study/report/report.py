"""The report: rows with verdicts, tables, pictures and paragraphs, in sections.

`close`, `same`, `within`, `claimed`, `likely` and `noted` each compare a measurement with what was expected, in their
own way, and return the Finding.
"""

from collections import Counter
from dataclasses import dataclass, field, replace
from itertools import groupby
from math import hypot, isfinite
from time import strftime
from typing import Any

from game.study.report import machine
from game.study.report.table import Column, Table, measurement

AGREES = "agrees"
DISAGREES = "disagrees"
DIFFERS = "differs"  # from a claim about the world outside: a finding, where DISAGREES is a fault
NOTED = "noted"  # measured, with nothing to compare it with
VERDICTS = (AGREES, DISAGREES, DIFFERS, NOTED)
SIGMAS = 4.0  # standard errors between measured and expected that still agree: 1 in 16,000 comparisons is further off
UNLIKELY = 1e-4  # a p-value below this disagrees, its looks already counted: about as far off as SIGMAS
COLUMNS = (
    Column("quantity", "quantity"),
    Column("reading", "measured"),
    Column("expected", "expected"),
    Column("source", "source"),
    Column("verdict", "verdict"),
)


@dataclass(frozen=True)
class Finding:
    """One quantity, what was measured, what was expected and why, and whether they agree."""

    quantity: str  # with its unit
    measured: float | str
    error: float | None  # standard error of `measured`; None where it is exact or is no number
    expected: float | str
    source: str  # where `expected` comes from
    verdict: str  # one of VERDICTS


@dataclass(frozen=True)
class Picture:
    """A figure (anything with matplotlib's `savefig`) to be written as `name`.png, and what it shows."""

    name: str
    figure: Any
    caption: str


@dataclass
class Section:
    """One part of a report: Rows, Tables, Pictures and paragraphs (anything with a `str`), in the order of reading."""

    name: str
    title: str
    items: list = field(default_factory=list)
    seconds: float = 0.0

    @property
    def rows(self):
        """The rows among the items."""
        return [item for item in self.items if isinstance(item, Finding)]

    @property
    def tables(self):
        """The tables among the items."""
        return [item for item in self.items if isinstance(item, Table)]


@dataclass
class Report:
    """Everything that one run found, when, and on which machine."""

    name: str  # of the command that makes it
    title: str
    quick: bool
    sections: list = field(default_factory=list)
    date: str = field(default_factory=lambda: strftime("%Y-%m-%d"))
    machine: str = field(default_factory=machine.line)

    @property
    def command(self):
        """The command line that makes the report again."""
        return f"python main.py {self.name}{' --quick' if self.quick else ''} --out DIR"

    @property
    def rows(self):
        """The rows of all sections."""
        return [row for section in self.sections for row in section.rows]

    @property
    def items(self):
        """The items of all sections, each section after its title."""
        return [item for section in self.sections for item in (f"## {section.title}", *section.items)]


def count_verdicts(rows):
    """Return {verdict: how many of the rows got it}."""
    found = Counter(row.verdict for row in rows)
    return {verdict: found[verdict] for verdict in VERDICTS}


def verdict_table(rows):
    """Return the Table of rows with their verdicts."""
    return Table("", COLUMNS, [{**vars(row), "reading": measurement(row.measured, row.error)} for row in rows])


def blocks(items):
    """Yield the items with each run of Rows as one Table."""
    for are_rows, group in groupby(items, lambda item: isinstance(item, Finding)):
        if are_rows:
            yield verdict_table(group)
        else:
            yield from group


def _row(quantity, measured, error, expected, source, holds):
    return Finding(quantity, measured, error, expected, source, AGREES if holds else DISAGREES)


def close(quantity, measured, error, expected, source, expected_error=0.0):
    """Agree if measured and expected differ by at most SIGMAS of their standard errors, taken together."""
    apart = abs(measured - expected)
    return _row(quantity, measured, error, expected, source, apart <= SIGMAS * hypot(error, expected_error))


def same(quantity, measured, expected, source):
    """Agree if measured is exactly what was expected."""
    return _row(quantity, measured, None, expected, source, measured == expected)


def within(quantity, measured, error, low, high, source):
    """Agree if measured lies in [low, high] (either may be infinite), give or take SIGMAS standard errors, if any."""
    margin = SIGMAS * (error or 0.0)
    return _row(quantity, measured, error, _range(low, high), source, low - margin <= measured <= high + margin)


def claimed(quantity, measured, error, low, high, source):
    """Hold a measurement against a claim about the paper's sand or real sand, which this model need not bear out.

    Agree as in `within`; a measurement outside of [low, high] differs, and that is a finding and no fault.
    """
    row = within(quantity, measured, error, low, high, source)
    return row if row.verdict == AGREES else replace(row, verdict=DIFFERS)


def likely(quantity, p_value, source):
    """Agree if a p-value, corrected for the number of looks, is not below UNLIKELY."""
    return _row(quantity, p_value, None, f"p ≥ {UNLIKELY:g}", source, p_value >= UNLIKELY)


def noted(quantity, measured, error=None, expected="", source=""):
    """Report a measurement that nothing is to be compared with, or that is only to be looked at."""
    return Finding(quantity, measured, error, expected, source, NOTED)


def _range(low, high):
    if isfinite(low) and isfinite(high):
        return f"{low:g} … {high:g}"
    return f"≥ {low:g}" if isfinite(low) else f"≤ {high:g}"
