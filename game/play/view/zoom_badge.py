"""The zoom badge: how large a cell is and what is in sight, in the status line for a moment after that has changed."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look

STAY_S = 1.2
GAP = 12  # pixels at scale 1 beside its words
PAD = 4  # pixels at scale 1 above and below the map of the lattice


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

    def drawing(self, theme, rect):
        """Return (strokes, what is left of `rect`): at its right the zoom level, and the lattice if it is not whole."""
        view, left = self._display.sand_view.view, pygame.Rect(rect)
        strokes = []
        if view.frame:
            strokes, left = _map(theme, view, left)
        text = words(view.cell)
        strokes.append((draw_list.words, tuple(left), text, look.SMALL, look.TEXT, 1))
        left.width -= theme.width(text, look.SMALL) + theme.px(GAP)
        return strokes, left


def words(cell):
    """Return how large a cell of `cell` pixels is."""
    if cell >= 1:
        return f"{_figure(cell)} px per cell"
    cells = _figure(1 / cell)
    return f"1 px = {cells} × {cells} cells"


def _figure(number):
    return f"{round(number, 1 if number < 10 else 0):g}"


def _map(theme, view, rect):
    """Return (strokes of the lattice, and in it of the part in sight, at the right of `rect`, what is left of that)."""
    px, (height, width) = theme.px, view.shape
    page = pygame.Rect(0, rect.y, 0, rect.height).inflate(0, -2 * px(PAD))
    scale = min(page.height / height, rect.width / 4 / width)
    page.size = max(px(4), round(width * scale)), max(px(4), round(height * scale))
    page.right, page.centery = rect.right, rect.centery
    left, top, right, bottom = view.seen
    first, last = view.place(left, top), view.place(right, bottom)
    part = pygame.Rect(page.x + first[0] * scale, page.y + first[1] * scale, 0, 0)
    part.size = (max(px(3), (last[0] - first[0]) * scale), max(px(3), (last[1] - first[1]) * scale))
    strokes = [
        (draw_list.fill, tuple(page.inflate(2, 2)), look.EDGE),
        (draw_list.fill, tuple(page), look.GROUND),
        (draw_list.fill, tuple(part.clip(page)), look.ACCENT),
    ]
    return strokes, pygame.Rect(rect.x, rect.y, page.left - px(GAP) - rect.x, rect.height)
