"""What a study says: rows with a verdict, tables, pictures and paragraphs, in sections."""

from collections import Counter
from dataclasses import dataclass, field
from typing import Any

AGREES = "agrees"
DISAGREES = "disagrees"
DIFFERS = "differs"  # from a claim about the world outside: a finding, where DISAGREES is a fault
NOTED = "noted"  # measured, with nothing to compare it with
VERDICTS = (AGREES, DISAGREES, DIFFERS, NOTED)


@dataclass(frozen=True)
class Row:
    """One quantity, what was measured, what was expected and why, and whether they agree."""

    quantity: str  # with its unit
    measured: float | str
    error: float | None  # standard error of `measured`; None where it is exact or is no number
    expected: float | str
    source: str  # where `expected` comes from
    verdict: str  # one of VERDICTS


@dataclass(frozen=True)
class Table:
    """Figures without verdicts: a caption, column heads, and rows of as many numbers or words."""

    caption: str
    heads: tuple
    rows: list


@dataclass(frozen=True)
class Picture:
    """A figure (anything with matplotlib's `savefig`) to be written as `name`.png, and what it shows."""

    name: str
    figure: Any
    caption: str


@dataclass
class Section:
    """One part of the study: its Rows, Tables, Pictures and paragraphs (str), in the order of reading."""

    name: str
    title: str
    items: list = field(default_factory=list)
    seconds: float = 0.0

    @property
    def rows(self):
        """The rows among the items."""
        return [item for item in self.items if isinstance(item, Row)]

    @property
    def verdicts(self):
        """How many rows got each verdict."""
        return count_verdicts(self.rows)


@dataclass
class Report:
    """Everything one run of the study found, and on what it ran."""

    about: dict  # words or numbers by name: version, machine, …
    sections: list = field(default_factory=list)

    @property
    def rows(self):
        """The rows of all sections."""
        return [row for section in self.sections for row in section.rows]

    @property
    def verdicts(self):
        """How many rows got each verdict."""
        return count_verdicts(self.rows)


def count_verdicts(rows):
    """Return {verdict: how many of the rows got it}."""
    found = Counter(row.verdict for row in rows)
    return {verdict: found[verdict] for verdict in VERDICTS}
