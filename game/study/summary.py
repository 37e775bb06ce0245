"""The summary: what the README of the study keeps of a report."""

from game.study.physics.claims import CAPTION as CLAIMS
from game.study.report.report import VERDICTS, Picture, count_verdicts
from game.study.report.table import Table

HEADLINES = frozenset(
    {
        "p = 0.5: chi-square per degree of freedom",
        "seven different: chi-square per degree of freedom",
        "cells that differ between 5 seeds at p = 1, t = 500",
        "pile's contour grows in height from p = 0.5 to 0.25, cells",
        "pile's contour grows in width from p = 0.5 to 0.25, cells",
        "exponent of the settling time in p, from 0.25 to 0.5",
        "exponent of the settling time in p, from 0.5 to 1",
        "grains stuck on the left slope, margolus, glass moved right by 0",
        "grains stuck on the left slope, margolus, glass moved right by 1",
        "largest surplus of grains on one side of the pile, margolus, p = 1",
        "largest surplus of grains on one side of the pile, balanced, p = 1",
        "rms difference in floors, plain kernel with fresh draws against the toy's",
        "rms error in floors, draws: fixed noise by place",
        "lean of the pile, paper, p = 0.75, %",
        "lean of the pile, balanced, p = 0.75, %",
        "exponent of the later flow in the neck's width, balanced",
        "exponent of the flow in the sand left, from 80 % to 40 %, p = 0.75",
        "exponent of the flow in the sand left, from 80 % to 40 %, p = 0.5",
        "final slope, p = 0.75, degrees",
        "exponent of the fallen height in time",
    }
)
PICTURES = ("density", "trade")
LEGEND = (
    "*differs* marks a claim of the paper, or a law of real sand, that the model does not bear out. *disagrees* marks "
    "a fault of this program. The same run writes `study.md`, with every row, table and picture."
)
DEFAULTS = (
    "So the defaults are: p to 32 bits and a fresh draw for every candidate, since less costs as much and shows; "
    "10,000 runs for a density; about three pixels to a cell, where a glass still looks like the fine one at a "
    "fraction of its cost."
)


def summary(report):
    """Return the items of the summary: counts of verdicts, the HEADLINES, the CLAIMS, the PICTURES and what follows."""
    counts = [(section.title, *count_verdicts(section.rows).values()) for section in report.sections]
    return [
        LEGEND,
        Table.of("", ("part", *VERDICTS), counts),
        *(row for row in report.rows if row.quantity in HEADLINES),
        *(item for item in report.items if isinstance(item, Table) and item.caption == CLAIMS),
        *(item for item in report.items if isinstance(item, Picture) and item.name in PICTURES),
        DEFAULTS,
    ]
