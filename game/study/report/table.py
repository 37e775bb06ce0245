"""Tables: rows of raw values under columns, and how numbers read as text."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from math import floor, isfinite, log10
from numbers import Integral, Real

DIGITS = 4  # significant digits of a number whose error is not known
WORD = re.compile(r"[^\W\d_]{2}")  # two letters in a row
MANY = 1e15  # floats below this are exact when they are whole


def number(value):
    """Return a number with DIGITS significant digits, or any other value, as text."""
    if isinstance(value, bool) or not isinstance(value, Real):
        return str(value)
    if isinstance(value, Integral) or (abs(value) < MANY and value == int(value)):
        return f"{int(value):,}"
    if 10**DIGITS <= abs(value) < MANY:
        return f"{value:,.0f}"
    return f"{value:.{DIGITS}g}"


def measurement(value, error):
    """Return 'value ± error', the error with two significant digits and the value with as many decimals."""
    if error is None:
        return number(value)
    if not (error > 0 and isfinite(error) and isfinite(value)):
        return f"{number(value)} ± {number(error)}"
    decimals = 1 - floor(log10(error))
    if not -3 <= decimals <= 8:
        return f"{value:.6g} ± {error:.2g}"
    decimals = max(decimals, 0)
    return f"{value:,.{decimals}f} ± {error:,.{decimals}f}"


def three_digits(value):
    """Return three significant digits, thousands separated: 0.0391, 2.07, 85.9, 2,070."""
    if value == 0:
        return "0"
    return f"{value:,.0f}" if abs(value) >= 99.95 else f"{value:#.3g}".rstrip(".")


def size(value):
    """Return a (width, height) as 1920×1080."""
    return "×".join(map(str, value))


def ratio(value):
    """Return a factor as 1.46×."""
    return f"{three_digits(value)}×"


def percent(value):
    """Return a part as 1.7 %."""
    return f"{three_digits(100 * value)} %"


@dataclass(frozen=True)
class Column:
    """One column: the key of its values in the rows, its heading, and how a value reads."""

    key: str
    heading: str
    show: Callable = number


@dataclass(frozen=True)
class Table:
    """Rows, dicts of raw values, under columns. A value that is None or missing leaves its cell empty."""

    caption: str
    columns: tuple
    rows: list

    @classmethod
    def of(cls, caption, heads, rows):
        """Return a Table of `rows` of values in the order of `heads`."""
        columns = tuple(Column(head, head) for head in heads)
        return cls(caption, columns, [dict(zip(heads, row, strict=True)) for row in rows])

    def cells(self):
        """Return the rows as lists of text."""
        return [
            ["" if row.get(each.key) is None else each.show(row[each.key]) for each in self.columns]
            for row in self.rows
        ]

    def columns_of_figures(self):
        """Return, column by column, whether no cell has a word in it: such columns are aligned on the right."""
        return [not any(WORD.search(cell) for cell in cells) for cells in zip(*self.cells(), strict=True)]
