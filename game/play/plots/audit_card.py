"""The audit's card: the account of the grains, as sums and, for coloured sand, with a row for each colour.

A row is a sum: start + painted - erased + poured - swallowed = now. A column of zeros is left out. Where there is too
little room for that, one column tells what came and one what went; then large numbers are rounded; and in the end only
the grains that are there now are shown, with as many rows beside each other as it takes, or the sums alone.
"""

import math
from itertools import product
from typing import NamedTuple

import pygame

from game.play.plots import charts
from game.play.ui import draw_list
from game.play.ui import theme as look

SWATCH = 9  # pixels at scale 1
GAP = 5  # from one column to the next
WIDE, NARROW = 210, 72  # a row with all its columns, and one of what there is now
CLOSEST = 0.9  # of their usual height: lines where there is little room
KEPT = "the books balance"  # where materials become others
ALL = "all"  # the row of the sums


class ColourColumn(NamedTuple):
    """A word, its sign in the sum, and its numbers: for each colour, and for all of them."""

    word: str
    sign: str
    numbers: tuple
    total: int


class AuditTable(NamedTuple):
    """A layout of the card: with or without the sums, rows in one column or two, and which numbers of a row."""

    sums: bool
    across: int
    columns: tuple
    spell: object

    def lines(self, account):
        """Return how many lines it is high."""
        rows = -(-len(account.rows) // self.across)
        return rows + 1 + (len(account.lines) if self.sums else 1)


def card(theme, rect, account, counted, swatches):
    """Return the strokes of the card of a GrainAccount in `rect`, where so many grains of each kind were counted.

    swatches: the RGB of each kind.
    """
    grains, balanced = sum(counted), account.agrees(counted)
    kept = KEPT if any(account.formed_by_kind) or any(account.used_by_kind) else "every grain is there"
    strokes, room = charts.card(theme, rect, "Audit", kept if balanced else "")
    if not balanced:
        head = (room.x, rect.y + theme.px(charts.PAD // 2), room.width, theme.px(charts.HEAD))
        said = f"but {grains:,} are there" if grains != account.expected else "but in other colours"
        strokes.append((draw_list.words, head, said, look.SMALL, look.ACCENT, 1))
    table = _fitting(theme, room, account) if account.mixed else None
    if table is None:
        sums = _fitting_sums(theme, room, account)
        return strokes + _sums(theme, room, sums, len(sums))
    if table.sums:
        strokes += _sums(theme, room, account.lines, table.lines(account))
    return strokes + _rows(theme, room, account, table, swatches)


def heights(theme, account):
    """Return the heights in pixels that a card would like, the greatest first: with the sums, and without them."""
    line = theme.line_height(look.SMALL)
    return [_chrome(theme) + AuditTable(sums, 1, (), None).lines(account) * line for sums in (True, False)]


def widths(theme, account, room):
    """Return the widths in pixels that a card of `room` pixels' height would like, the greatest first."""
    line = _least_line(theme)
    fits = (across for across in ACROSS if _chrome(theme) + _rows_alone(across).lines(account) * line <= room)
    across = next(fits, ACROSS[-1])
    return [theme.px(across * wide) for wide in ((WIDE, NARROW) if across > 2 else (WIDE,))]


def _rows_alone(across):
    return AuditTable(False, across, (), None)


def _least_line(theme):
    """Return the pixels of the lowest line that can be read."""
    return math.ceil(CLOSEST * theme.line_height(look.SMALL))


def _chrome(theme):
    """Return the pixels of a card's height that are not the room left by charts.card."""
    return 2 * theme.px(charts.PAD // 2) + theme.px(charts.HEAD) + theme.px(4)


def _fitting_sums(theme, room, account):
    """Return all sums, or those that are not zero where there is no room for all."""
    if len(account.lines) * _least_line(theme) <= room.height:
        return account.lines
    return [each for each in account.lines if each[0] not in ("+", "-") or each[2]]


def _sums(theme, room, sums, lines):
    """Return the strokes of sums, in the first of so many lines."""
    line = min(theme.line_height(look.SMALL), room.height // lines)
    strokes = []
    for number, (sign, word, grains) in enumerate(sums):
        row = (room.x, room.y + number * line, room.width, line)
        colour = look.TEXT if sign == "=" else look.DIM
        strokes.append((draw_list.words, row, f"{sign} {word}".strip(), look.SMALL, colour, 0))
        strokes.append((draw_list.words, row, f"{grains:,}", look.SMALL, colour, 1))
    return strokes


def _fitting(theme, room, account):
    """Return the fullest AuditTable that fits the room, or None."""
    high = _least_line(theme)
    for (sums, across, columns), spell in product(LAYOUTS, (_exact, _rounded)):
        table = AuditTable(sums, across, tuple(columns(account)), spell)
        if table.lines(account) * high <= room.height and _is_wide_enough(theme, room, table):
            return table
    return None


def _is_wide_enough(theme, room, table):
    wide = _widths(theme, room, table)[1] - theme.px(GAP)
    texts = [table.spell(each.sign, number) for each in table.columns for number in (*each.numbers, each.total)]
    return max(theme.width(text, look.SMALL) for text in [*texts, *(each.word for each in table.columns)]) <= wide


def _widths(theme, room, table):
    """Return the widths of a row, of one of its columns, and of what stands before them."""
    row = (room.width - (table.across - 1) * theme.px(2 * GAP)) // table.across
    first = max(theme.px(SWATCH), theme.width(ALL, look.SMALL))
    return row, (row - first) // max(1, len(table.columns)), first


def _rows(theme, room, account, table, swatches):
    """Return the strokes of the table, in the last of its lines."""
    lines, (row, wide, first) = table.lines(account), _widths(theme, room, table)
    high = min(theme.line_height(look.SMALL), room.height // lines)
    top = room.y + (high * len(account.lines) if table.sums else 0)
    deep = -(-len(account.rows) // table.across)
    strokes = []
    for across in range(table.across):
        left = room.x + across * (row + theme.px(2 * GAP))
        cells = [pygame.Rect(left + first + number * wide, top, wide, high) for number in range(len(table.columns))]
        for cell, each in zip(cells, table.columns, strict=True):
            strokes.append((draw_list.words, tuple(cell), each.word, look.SMALL, look.FAINT, 1))
        for down, number in enumerate(range(across * deep, min((across + 1) * deep, len(account.rows))), 1):
            side = min(theme.px(SWATCH), high - 2)
            box = (left, top + down * high + (high - side) // 2, side, side)
            strokes.append((draw_list.box, box, swatches[account.rows[number][0]], theme.px(2)))
            texts = [table.spell(each.sign, each.numbers[number]) for each in table.columns]
            strokes += _line([cell.move(0, down * high) for cell in cells], texts)
    if not table.sums:
        place = pygame.Rect(room.x, top + (deep + 1) * high, first, high)
        strokes.append((draw_list.words, tuple(place), ALL, look.SMALL, look.TEXT, 0))
        cells = [pygame.Rect(place.right + number * wide, place.y, wide, high) for number in range(len(table.columns))]
        strokes += _line(cells, [table.spell(each.sign, each.total) for each in table.columns])
    return strokes


def _line(cells, texts):
    """Return the strokes of the numbers of one row, the last of which is what there is now."""
    colours = [look.DIM] * (len(cells) - 1) + [look.TEXT]
    return [
        (draw_list.words, tuple(cell), text, look.SMALL, colour, 1)
        for cell, text, colour in zip(cells, texts, colours, strict=True)
    ]


def _all_columns(account):
    """Return the columns that are not all zeros."""
    words = ("start", ""), ("painted", "+"), ("erased", "-"), ("poured", "+"), ("swallowed", "-")
    words += ("formed", "+"), ("used", "-"), ("now", "=")
    numbers = list(zip(*account.rows, strict=True))[1:]
    found = [ColourColumn(*word, each, sum(each)) for word, each in zip(words, numbers, strict=True)]
    return [each for each in found if each.total or each.word in ("start", "now")]


def _came_and_went(account):
    """Return the columns of what there was, what came, what went, and what there is."""
    _, start, painted, erased, poured, swallowed, formed, used, now = zip(*account.rows, strict=True)
    came = tuple(map(sum, zip(painted, poured, formed, strict=True)))
    went = tuple(map(sum, zip(erased, swallowed, used, strict=True)))
    columns = ("start", "", start), ("came", "+", came), ("went", "-", went), ("now", "=", now)
    return [ColourColumn(word, sign, each, sum(each)) for word, sign, each in columns]


def _now_alone(account):
    return _came_and_went(account)[-1:]


ACROSS = 1, 2, 3, 4  # so many rows beside each other
LAYOUTS = (  # the fullest first: with the sums?, columns of rows, numbers of a row
    (True, 1, _all_columns),
    (True, 1, _came_and_went),
    (False, 1, _all_columns),
    (False, 1, _came_and_went),
    (False, 2, _all_columns),
    (False, 2, _came_and_went),
    (False, 3, _came_and_went),
    (False, 4, _came_and_went),
    *((False, across, _now_alone) for across in ACROSS),
)


def _exact(sign, number):
    """Return a number in a sum; a zero that came or went is left out."""
    return f"{sign}{number:,}" if number or sign not in ("+", "-") else ""


def _rounded(sign, number):
    if number < 10_000:
        return _exact(sign, number)
    return f"{sign}{number / 1e6:.3g}M" if number >= 999_500 else f"{sign}{number / 1e3:.3g}k"
