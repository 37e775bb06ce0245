"""The page of keys: on one screen, with its text as large as set or a little smaller; otherwise it scrolls."""

from itertools import product
from typing import NamedTuple

import pygame

from game.play.controls.keymap import GROUPS
from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.input import key_name
from game.play.ui.scroll import thumb
from game.world.sand import parameters

PAD = 22  # pixels at scale 1: around the page, and between columns
HEAD = 34
GAP = 12  # between a key and its meaning
LEADING = 1.25  # height of a line, in heights of its text
MOST_COLUMNS = 6
SMALLER = 0.93  # from one size of text that is tried to the next
SMALLEST = 0.8  # of the size asked for: what is not whole on the screen in this size is scrolled
WHEEL = 3  # lines for a notch
HINTS = "Wheel, arrows and Page keys scroll    F1 closes", "Wheel scrolls    F1 closes", "F1 closes"


class HelpPage:
    """The page, over the window while it is open. The sand goes on behind it."""

    fills_window = False

    def __init__(self, display):
        self._display = display
        self.shown = False
        self._page = self._made_for = None  # the Page, once it is laid out, and the theme and size that it is for
        self._top = 0  # the first line that shows
        self._drawn = None  # the line that was drawn at the top

    def toggle(self):
        """Open the page, or close it."""
        self.shown = not self.shown
        self._top, self._drawn = 0, None
        self._display.lay_out_anew()

    def forget(self):
        """Draw everything next time."""
        self._drawn = None

    def handle_events(self, events, now_s, mouse_pos):
        """Close at a click, scroll if there is more than shows, and leave other keys to their commands."""
        return [event for event in events if not (self.shown and self._handle(event))]

    def _handle(self, event):
        """Handle an event; return whether it was meant for the page."""
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            self.toggle()
        elif event.type == pygame.MOUSEWHEEL:
            self._scroll(-WHEEL * event.y)
        elif event.type == pygame.KEYDOWN and self._page and self._page.more:
            lines = {
                pygame.K_UP: -1,
                pygame.K_DOWN: 1,
                pygame.K_HOME: -self._page.lines,
                pygame.K_END: self._page.lines,
            }
            lines |= {pygame.K_PAGEUP: 1 - self._page.seen, pygame.K_PAGEDOWN: self._page.seen - 1}
            self._scroll(lines.get(event.key, 0))
            return event.key in lines
        return event.type in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEWHEEL)

    def _scroll(self, lines):
        if self._page:
            self._top = min(max(self._top + lines, 0), self._page.more)

    def draw(self, surface):
        """Draw the page where it looks different; return the rects that changed."""
        made_for = self._display.theme, surface.get_size()
        if made_for != self._made_for:
            self._made_for, self._drawn = made_for, None
            self._page = lay_out(self._display.theme, surface.get_rect())
            self._scroll(0)
        if self._top == self._drawn:
            return []
        self._drawn, page = self._top, self._page
        draw_list.draw(surface, page.theme, [*page.frame, *page.thumb(self._top)])
        surface.set_clip(page.room)
        draw_list.draw(surface, page.theme, page.rows, (0, -self._top * page.line))
        surface.set_clip(None)
        return [surface.get_rect()]


class Page(NamedTuple):
    """The page as it is laid out in a window: strokes of what stands still, and of the rows that may be scrolled."""

    theme: look.Theme
    frame: list
    rows: list
    room: pygame.Rect  # in which the rows show
    line: int  # its height in pixels
    lines: int  # how many there are
    seen: int  # … and how many of them show at a time

    @property
    def more(self):
        """How many lines there are beyond those that show."""
        return max(0, self.lines - self.seen)

    def thumb(self, top):
        """Return the strokes of the scroll bar's thumb with the line `top` at the top, where not all lines show."""
        px, room = self.theme.px, self.room
        track = pygame.Rect(room.right + px(PAD) // 2, room.y, px(4), room.height)
        return thumb(self.theme, track, top, self.seen, self.lines)


class _Setting(NamedTuple):
    """One way to set the page in type: theme, text size, and groups in columns."""

    theme: look.Theme
    size: int  # of the text
    columns: list  # of lists of groups (title, rows)

    @property
    def line(self):
        return round(self.theme.line_height(self.size) * LEADING)

    @property
    def lines(self):
        return max(_lines(column) for column in self.columns)

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
    """Return the Page in the middle of `window`: whole, or to be scrolled where its text would become too small."""
    way = _fitting(theme, window)
    theme, px = way.theme, way.theme.px
    seen = min(way.lines, _room(theme, window).height // way.line)
    page = pygame.Rect(0, 0, way.width + 2 * px(PAD), seen * way.line + px(HEAD) + 2 * px(PAD))
    page.center = window.center
    strokes = [(draw_list.box, page, look.EDGE, px(8)), (draw_list.box, page.inflate(-2, -2), look.GROUND, px(8))]
    head = pygame.Rect(page.x + px(PAD), page.y + px(PAD) // 2, page.width - 2 * px(PAD), px(HEAD))
    room = head.width - theme.width("Keys", look.HEADING) - px(GAP)
    hints = [each for each in HINTS[2 * (seen == way.lines) :] if theme.width(each, look.SMALL) <= room]
    strokes.append((draw_list.words, head, "Keys", look.HEADING, look.HANDLE, 0))
    strokes += [(draw_list.words, head, each, look.SMALL, look.FAINT, 1) for each in hints[:1]]
    rows, x = [], head.x
    for column in way.columns:
        keys, meanings = way.widths(column)
        rows += _column(way, column, pygame.Rect(x, head.bottom, keys, way.line), meanings)
        x += keys + px(GAP) + meanings + px(PAD)
    shown = pygame.Rect(head.x, head.bottom, head.width, seen * way.line)
    return Page(theme, strokes, rows, shown, way.line, way.lines, seen)


def _column(way, column, place, meanings):
    """Yield the strokes of a column whose first key goes to the rect `place`."""
    gap = way.theme.px(GAP)
    for title, rows in column:
        wide = pygame.Rect(place.x, place.y, place.width + gap + meanings, place.height)
        yield draw_list.words, wide, title, look.HEADING, look.TEXT, 0
        for key, meaning in rows:
            place = place.move(0, way.line)
            yield draw_list.words, place, key, way.size, look.ACCENT, 0
            beside = pygame.Rect(place.right + gap, place.y, meanings, place.height)
            yield draw_list.words, beside, meaning, way.size, look.DIM, 0
        place = place.move(0, 2 * way.line)


def _fitting(theme, window):
    """Return the largest setting that fits the window or, if its text were too small, only the window's width."""
    low = parameters.UI_SCALE.low
    for least, whole in ((max(SMALLEST * theme.scale, low), True), (low, False)):
        scales = [theme.scale]
        while scales[-1] > least:
            scales.append(max(scales[-1] * SMALLER, least))
        scale = scales[_first(lambda scale, whole=whole: _set_in(_at(theme, scale), window, whole)[1], scales)]
        way, fits = _set_in(_at(theme, scale), window, whole)
        if fits:
            break
    return way


def _at(theme, scale):
    return theme if scale == theme.scale else look.theme_of(scale, theme.colours)


def _first(fits, scales):
    """Return the place of the first of `scales` that fits, if those after it do as well, or of the last."""
    low, high = 0, len(scales) - 1
    while low < high:
        middle = (low + high) // 2
        low, high = (low, middle) if fits(scales[middle]) else (middle + 1, high)
    return low


def _set_in(theme, window, whole):
    """Return (the largest setting in a theme that fits the window, or the last one tried; whether it fits).

    whole: all of it is to be seen at once; otherwise only its width must fit, in as many columns as possible.
    """
    every, room, sizes = groups(), _room(theme, window), (look.BODY, look.SMALL)
    counts = range(1, min(MOST_COLUMNS, len(every)) + 1)
    ways = product(sizes, counts) if whole else ((size, count) for count in reversed(counts) for size in sizes)
    for size, count in ways:
        way = _Setting(theme, size, _columns(every, count))
        if way.width <= room.width and (not whole or way.lines * way.line <= room.height):
            return way, True
    return way, False


def _room(theme, window):
    """Return how much of the window the rows may take."""
    return window.inflate(-2 * theme.px(PAD) - 2, -2 * theme.px(PAD) - theme.px(HEAD) - 2)


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
