"""Claims: which of the laws of real sand each kind of sand bears out, read off the rows that say so."""

from game.study.physics.kinds import KINDS, ROLLING
from game.study.report.report import AGREES
from game.study.report.table import Table, measurement

CAPTION = "What real sand does, and which rule bears it out (measured, in the unit of the row of `study.md`)."
CLAIMS = {  # words: the quantities that say so, one for each of KINDS
    "a heap of dry sand stands at 30-35°": (
        "final slope, p = 0.75, degrees",
        f"final slope, stop = {ROLLING.rule.stop:g}, paper, degrees, rolling-sand",
    ),
    "an hourglass runs out to the last grain": (
        "grains that stay in the upper bulb, sand, p = 0.75",
        "grains that stay in the upper bulb, rolling-sand",
    ),
    "the flow does not depend on how much is left": (
        "exponent of the flow in the sand left, from 80 % to 40 %, p = 0.75",
        f"exponent of the flow in the sand left, from 80 % to 40 %, rolling-sand, stop = {ROLLING.rule.stop:g}",
    ),
    "the flow goes with width^3/2 of the neck": (
        "exponent of the later flow in the neck's width, balanced",
        "exponent of the later flow in the neck's width, balanced, rolling-sand",
    ),
    "grains fall faster and faster, by ½gt²": (
        "exponent of the fallen height in time",
        "exponent of the fallen height in time, rolling-sand",
    ),
}


def claim_table(rows):
    """Return the Table of CLAIMS from the rows of the part."""
    found = {row.quantity: row for row in rows}
    heads = ("real sand", *(kind.name for kind in KINDS))
    told = [(words, *(_answer(found[quantity]) for quantity in quantities)) for words, quantities in CLAIMS.items()]
    return Table.of(CAPTION, heads, told)


def _answer(row):
    return f"{'yes' if row.verdict == AGREES else 'no'}: {measurement(row.measured, row.error)}"
