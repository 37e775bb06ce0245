"""The layout: where the parts of the window lie."""

import pygame

from game.play.controls import time_bar
from game.play.panel import panel
from game.play.view import status_line

MARGIN = 8  # pixels at scale 1 around the sand
PLOTS = 210, 132  # pixels at scale 1: width of a column of plots, height of a strip
PLOTS_COLUMN, PLOTS_STRIP = 460, 760  # the least height of the one and width of the other
LEAST_SAND = 240  # what the plots leave to the sand, or they are not shown


class Layout:
    """The parts' rects in a window of `size` (width, height) in pixels, with the panel shown or not."""

    def __init__(self, theme, size, panel_shown, plotted=None):
        """`plotted`: the shape of the lattice whose plots are shown beside it, or None."""
        width, height = size
        self.panel = panel.area(theme, size)
        wide = width - (self.panel.width if panel_shown else 0)
        bar, line = theme.px(time_bar.HEIGHT), theme.px(status_line.HEIGHT)
        self.sand = pygame.Rect(0, 0, wide, height - bar - line)
        self.bar = pygame.Rect(0, self.sand.bottom, wide, bar)
        self.hud = pygame.Rect(0, height - line, wide, line)
        self.plots = None  # or their rect, where there is room for them
        if plotted:
            self._make_room(theme, plotted)

    def _make_room(self, theme, shape):
        """Give the plots a column beside the sand or a strip below it, whichever leaves larger cells."""
        sand, wide, high = self.sand, theme.px(PLOTS[0]), theme.px(PLOTS[1])
        ways = []
        if sand.width >= wide + theme.px(LEAST_SAND) and sand.height >= theme.px(PLOTS_COLUMN):
            ways.append((pygame.Rect(wide, 0, sand.width - wide, sand.height), pygame.Rect(0, 0, wide, sand.height)))
        if sand.height >= high + theme.px(LEAST_SAND) and sand.width >= theme.px(PLOTS_STRIP):
            below = pygame.Rect(0, sand.height - high, sand.width, high)
            ways.append((pygame.Rect(0, 0, sand.width, sand.height - high), below))
        if ways:
            self.sand, self.plots = max(ways, key=lambda way: min(way[0].height / shape[0], way[0].width / shape[1]))
