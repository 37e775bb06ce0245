"""The layout: where the parts of the window lie, and how large the window is when it opens for the first time."""

from itertools import takewhile

import pygame

from game.play.window.window import room_on
from game.world.sand import parameters

MARGIN = 8  # pixels at scale 1 around the sand
TIME_BAR, STATUS_LINE = 22, 30  # their heights in pixels at scale 1
PANEL = 300  # its width in pixels at scale 1
NARROWEST_PANEL = 240  # at scale 1: all words of the controls still fit
LOWEST_WINDOW = 160  # at scale 1: sand, pages and cards still have room
PLOTS = 210, 132  # pixels at scale 1: width of a column of plots, height of a strip
PLOTS_COLUMN, PLOTS_STRIP = 460, 760  # the least height of the one and width of the other
LEAST_SAND = 240  # what the plots leave to the sand, or they are not shown

SHARE = 0.7  # of the desktop that a window grows to
LARGEST = 2880, 1620  # pixels: drawing many more of them would take a good part of each frame
FINE, FINE_SCALE = 2000, 1.5  # a desktop of so many pixels from top to bottom has small ones: the panel begins larger
LOWEST = 560  # pixels at scale 1: of a window whose panel is still of use


class Layout:
    """The parts' rects in a window of `size` (width, height) in pixels, with the panel shown or not."""

    def __init__(self, theme, size, panel_shown, plotted=None):
        """`plotted`: the shape of the lattice whose plots are shown beside it, or None."""
        width, height = size
        self.panel = _panel_in(theme, size)
        wide = width - (self.panel.width if panel_shown else 0)
        bar, line = theme.px(TIME_BAR), theme.px(STATUS_LINE)
        self.sand = pygame.Rect(0, 0, wide, height - bar - line)
        self.bar = pygame.Rect(0, self.sand.bottom, wide, bar)
        self.status_line = pygame.Rect(0, height - line, wide, line)
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


def fitting_scale(ui_scale, window_size):
    """Return the UI scale, smaller than wanted where the narrowest panel would take more than half of the window.

    It is smaller as well where the window is too low.
    """
    width, height = window_size
    return max(parameters.UI_SCALE.low, min(ui_scale, width / (2 * NARROWEST_PANEL), height / LOWEST_WINDOW))


def _panel_in(theme, window_size):
    """Return the panel's rect in a window of that size."""
    wide = max(min(theme.px(PANEL), window_size[0] * 9 // 20), theme.px(NARROWEST_PANEL))
    return pygame.Rect(window_size[0] - wide, 0, wide, window_size[1])


def window_size(scene, cell, theme):
    """Return the (width, height) in pixels of a window that shows `scene` with `cell` pixels to a cell."""
    px = theme.px
    height, width = (side * cell + 2 * px(MARGIN) for side in scene.shape)
    return width + px(PANEL), max(height + px(TIME_BAR) + px(STATUS_LINE), px(LOWEST))


def first_scale(desktop):
    """Return the size that the panel and its text begin with on a desktop of (width, height) in pixels."""
    return FINE_SCALE if desktop[1] >= FINE else parameters.UI_SCALE.default


def first_size(scene, theme, desktop):
    """Return the size of a window whose cells are as large as suits a desktop of (width, height) in pixels.

    The cells grow from what the scene asks for, in whole pixels. A scene that needs more than there is gets what it
    asks for; Window cuts that.
    """
    room = room_on(desktop)

    def suits(size):
        fits = all(side <= min(*most) for side, *most in zip(size, room, LARGEST, strict=True))
        return fits and size[0] * size[1] <= SHARE * desktop[0] * desktop[1]

    sizes = (window_size(scene, cell, theme) for cell in range(scene.cell, parameters.CELL.high + 1))
    return [window_size(scene, scene.cell, theme), *takewhile(suits, sizes)][-1]
