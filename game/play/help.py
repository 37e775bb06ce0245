"""The page of keys: all of them on one screen, whatever its size, with the text as large as there is room for."""

from typing import NamedTuple

import pygame

from game.play.keys import GROUPS
from game.play.ui import paint
from game.play.ui import theme as look
from game.play.ui.acts import key_name
from game.world import knob

PAD = 22  # pixels at scale 1: around the page, and between columns
HEAD = 34
GAP = 12  # between a key and its meaning
LEADING = 1.25  # height of a line, in heights of its text
MOST_COLUMNS = 6
SMALLER = 0.93  # from one size of text that is tried to the next
SHADE = 150  # of what lies behind the page: 0 is black, 255 as it is


class Help:
    """The page, if it is open. It takes the place of everything else in the window; the sand goes on behind it."""

    def __init__(self, toy):
        self._toy = toy
        self.shown = False
        self._drawn = None

    def toggle(self):
        """Open the page, or close it."""
        self.shown = not self.shown
        self._drawn = None
        if not self.shown:
            self._toy.lay_out_anew()

    def forget(self):
        """Draw everything next time."""
        self._drawn = None

    def listen(self, events, now_s, mouse_pos):
        """Close at a click, and leave the keys to their commands."""
        rest = []
        for event in events:
            if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1 and self.shown:
                self.toggle()
            elif event.type not in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEWHEEL):
                rest.append(event)
        return rest

    def draw(self, surface):
        """Draw the page if that was not done yet at this size; return the rects that changed."""
        size = surface.get_size()
        if size == self._drawn:
            return []
        self._drawn = size
        theme, strokes = lay_out(self._toy.theme, pygame.Rect((0, 0), size))
        surface.fill((SHADE,) * 3, special_flags=pygame.BLEND_MULT)
        paint.draw(surface, theme, strokes)
        return [pygame.Rect((0, 0), size)]


class _Print(NamedTuple):
    """A way to set the page: in a text size, of a theme, in columns of groups."""

    theme: look.Theme
    size: int  # of the text
    columns: list  # of lists of groups (title, rows)

    @property
    def line(self):
        return round(self.theme.line_height(self.size) * LEADING)

    @property
    def height(self):
        return max(_lines(column) for column in self.columns) * self.line

    def widths(self, column):
        """Return the widths of a column's keys and of their meanings, in pixels."""
        pairs = [row for _, rows in column for row in rows]
        keys, meanings = (max(self.theme.width(pair[part], self.size) for pair in pairs) for part in (0, 1))
        titles = max(self.theme.width(title, look.HEADING) for title, _ in column)
        return keys, max(meanings, titles - keys)

    @property
    def width(self):
        px = self.theme.px
        columns = [sum(self.widths(column)) + px(GAP) for column in self.columns]
        return sum(columns) + px(PAD) * (len(columns) - 1)


def groups():
    """Return [(title, [(key, meaning)])] as the page shows them."""
    return [
        (title, [(key_name(key.label), key.meaning) for key in keys if key.label]) for title, keys in GROUPS.items()
    ]


def lay_out(theme, window):
    """Return (theme, strokes) of the page in the middle of `window`, its text the largest that fits."""
    way = _fitting(theme, window)
    theme, px = way.theme, way.theme.px
    page = pygame.Rect(0, 0, way.width + 2 * px(PAD), way.height + px(HEAD) + 2 * px(PAD))
    page.center = window.center
    strokes = [(paint.box, page, look.EDGE, px(8)), (paint.box, page.inflate(-2, -2), look.GROUND, px(8))]
    head = pygame.Rect(page.x + px(PAD), page.y + px(PAD) // 2, page.width - 2 * px(PAD), px(HEAD))
    strokes.append((paint.words, head, "Keys", look.HEADING, look.HANDLE, 0))
    strokes.append((paint.words, head, "F1 closes", look.SMALL, look.FAINT, 1))
    x = head.x
    for column in way.columns:
        keys, meanings = way.widths(column)
        strokes += _column(way, column, pygame.Rect(x, head.bottom, keys, way.line), meanings)
        x += keys + px(GAP) + meanings + px(PAD)
    return theme, strokes


def _column(way, column, place, meanings):
    """Yield the strokes of a column whose first key goes to the rect `place`."""
    gap = way.theme.px(GAP)
    for title, rows in column:
        wide = pygame.Rect(place.x, place.y, place.width + gap + meanings, place.height)
        yield paint.words, wide, title, look.HEADING, look.TEXT, 0
        for key, meaning in rows:
            place = place.move(0, way.line)
            yield paint.words, place, key, way.size, look.ACCENT, 0
            beside = pygame.Rect(place.right + gap, place.y, meanings, place.height)
            yield paint.words, beside, meaning, way.size, look.DIM, 0
        place = place.move(0, 2 * way.line)


def _fitting(theme, window):
    """Return the largest print that fits into the window, or the smallest there is."""
    scales = [theme.scale]
    while scales[-1] > knob.UI_SCALE.low:
        scales.append(max(scales[-1] * SMALLER, knob.UI_SCALE.low))
    scale = scales[_first(lambda scale: _print_in(_at(theme, scale), window)[1], scales)]
    return _print_in(_at(theme, scale), window)[0]


def _at(theme, scale):
    return theme if scale == theme.scale else look.theme_of(scale, theme.colours)


def _first(fits, scales):
    """Return the place of the first of `scales` that fits, if those after it do as well, or of the last."""
    low, high = 0, len(scales) - 1
    while low < high:
        middle = (low + high) // 2
        low, high = (low, middle) if fits(scales[middle]) else (middle + 1, high)
    return low


def _print_in(theme, window):
    """Return (the largest print of a theme that fits into the window, or the last one tried; whether it fits)."""
    every = groups()
    room = window.inflate(-2 * theme.px(PAD) - 2, -2 * theme.px(PAD) - theme.px(HEAD) - 2)
    for size in (look.BODY, look.SMALL):
        for count in range(1, min(MOST_COLUMNS, len(every)) + 1):
            way = _Print(theme, size, _columns(every, count))
            if way.height <= room.height and way.width <= room.width:
                return way, True
    return way, False


def _columns(every, count):
    """Return the groups, in order, in at most `count` columns, the highest of them as low as possible."""
    for limit in range(max(_lines([group]) for group in every), _lines(every) + 1):
        columns = [[]]
        for group in every:
            if _lines([*columns[-1], group]) > limit:
                columns.append([])
            columns[-1].append(group)
        if len(columns) <= count:
            return columns
    return [every]


def _lines(column):
    """Return how many lines high a column is: titles, rows, and one free between groups."""
    return sum(len(rows) + 2 for _, rows in column) - 1
