"""The zoom badge: how large a cell is and what is in sight, for a moment after that has changed."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look

STAY_S = 1.2
HEIGHT = 30  # pixels at scale 1
PAD = 12
AWAY = 10  # from the corner of the sand
MAP = 96  # the longer side of the map of the lattice


class ZoomBadge:
    """Shows itself, and goes away by itself."""

    def __init__(self, display):
        self._display = display
        self.shown = False
        self._until_s = None

    def show(self):
        """Come up, or stay for longer."""
        self.shown, self._until_s = True, None

    def update(self, now_s):
        """Note how late it is."""
        if self.shown and self._until_s is None:
            self._until_s = now_s + STAY_S
        elif self.shown and now_s > self._until_s:
            self.shown = False
            self._display.refresh()

    def draw(self, surface, theme, area):
        """Draw the zoom level, and the lattice under it, unless all of it is in sight.

        It is at the right of `area`, or at its left if the leading one of several worlds is further right. Return the
        rects that they cover.
        """
        px, stage, view = theme.px, self._display.stage, self._display.stage.view
        text = words(view.cell)
        box = pygame.Rect(0, stage.area.y + px(AWAY), theme.width(text, look.BODY) + 2 * px(PAD), px(HEIGHT))
        box.right = area.right - px(AWAY)
        if stage.area.x > area.x:
            box.x = area.x + px(AWAY)
        draw_list.box(surface, theme, box, look.RAISED, px(6))
        draw_list.words(surface, theme, box.inflate(-2 * px(PAD), 0), text, look.BODY, look.TEXT, 0.5)
        return [box, _draw_map(surface, theme, view, box)] if view.frame else [box]


def words(cell):
    """Return how large a cell of `cell` pixels is."""
    if cell >= 1:
        return f"{_figure(cell)} px per cell"
    cells = _figure(1 / cell)
    return f"1 px = {cells} × {cells} cells"


def _figure(number):
    return f"{round(number, 1 if number < 10 else 0):g}"


def _draw_map(surface, theme, view, below):
    """Draw the lattice, and in it the part that is in sight, right under `below`; return the rect that it covers."""
    px, (height, width) = theme.px, view.shape
    scale = px(MAP) / max(height, width)
    page = pygame.Rect(0, below.bottom + px(4), max(px(4), round(width * scale)), max(px(4), round(height * scale)))
    page.right = below.right
    left, top, right, bottom = view.seen
    first, last = view.place(left, top), view.place(right, bottom)
    part = pygame.Rect(page.x + first[0] * scale, page.y + first[1] * scale, 0, 0)
    part.size = (max(px(3), (last[0] - first[0]) * scale), max(px(3), (last[1] - first[1]) * scale))
    draw_list.fill(surface, theme, page.inflate(2, 2), look.EDGE)
    draw_list.fill(surface, theme, page, look.SUNKEN)
    draw_list.fill(surface, theme, part.clip(page), look.ACCENT)
    return page.inflate(2, 2)
