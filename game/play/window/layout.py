"""The layout: where the parts of the window lie, and how large the window is when it opens for the first time."""

from itertools import pairwise

import pygame

from game.play.window.window import room_on
from game.world.sand import parameters

MARGIN = 8  # pixels at scale 1 around the sand
TIME_BAR, STATUS_LINE = 22, 40  # their heights in pixels at scale 1; the line has room for two rows of words
BUTTONS = 112  # width in pixels at scale 1 of those beside the time bar
PANEL = 300  # its width in pixels at scale 1
NARROWEST_PANEL = 240  # at scale 1: all words of the controls still fit
LOWEST_WINDOW = 160  # at scale 1: sand, pages and cards still have room
PLOTS = 210, 132  # pixels at scale 1: width of a column of plots, height of a strip
PLOTS_ALL, PLOTS_FEW = (450, 760), (180, 320)  # height of the one and width of the other for all plots, and for two
PLOTS_ON_STAGE = 280, 450  # … for those that stand there
STAGE_PLOTS = 0.38  # of the width, that a column of plots takes on the stage
LEAST_SAND = 240  # pixels, whatever the scale, that the plots leave to the sand, or they are not shown
COLUMN = 242  # pixels at scale 1: width of a column of cards
CARDS = {
    "legend": (196, 96),
    "density": (124, 96),
    "figures": (196, 108),
}  # pixels at scale 1: their heights in a column and in a strip
STRIP = 480  # pixels at scale 1: the least width in which two cards stand side by side
MOST_CARDS = 0.5  # of the height of the sand's part of the window, that cards below it may take

SHARE = 0.8  # of each side of the desktop's room that a window takes when it opens for the first time
LARGEST = 3072, 1728  # pixels of such a window: drawing many more of them would take a good part of each frame
FINE, FINE_SCALE = 2000, 1.5  # a desktop of so many pixels from top to bottom has small ones: the panel begins larger
LOWEST = 560  # pixels at scale 1: of a window whose panel is still of use


class WindowLayout:
    """The parts' rects in a window of `size` (width, height) in pixels, with the panel shown or not.

    Nothing lies over the sand: plots and cards take room from its part of the window.
    """

    def __init__(
        self, theme, size, panel_shown, shape=None, plotted=False, cards=(), board=0, on_stage=False, worlds=1
    ):
        """`shape`: of the lattice, whose plots and whose `cards`, names in CARDS, are shown beside it.

        board: the pixels that large letters take below the sand. on_stage: there is no status line, and plots are wide.
        worlds: how many lattices stand side by side.
        """
        width, height = size
        self.panel = _panel_in(theme, size)
        wide = width - (self.panel.width if panel_shown else 0)
        bar, line = theme.px(TIME_BAR), 0 if on_stage else theme.px(STATUS_LINE)
        self.sand = pygame.Rect(0, 0, wide, max(1, height - bar - line - board))
        buttons = min(theme.px(BUTTONS), wide // 2)
        self.bar = pygame.Rect(0, self.sand.bottom, wide - buttons, bar)
        self.buttons = pygame.Rect(self.bar.right, self.bar.y, buttons, bar)
        self.board = pygame.Rect(0, self.bar.bottom, wide, board)  # of large letters
        self.status_line = pygame.Rect(0, height - line, wide, line)
        self.plots = None  # or their rect, where there is room for them
        if plotted:
            self._place_plots(theme, shape, worlds, STAGE_PLOTS * wide if on_stage else 0)
        self.cards = {}  # {name: rect}
        if cards:
            self._place_cards(theme, shape, worlds, cards)

    def _place_plots(self, theme, shape, worlds, least_width):
        """Give the plots a column beside the sand or a strip below it, whichever leaves larger cells."""
        sand, wide, high = self.sand, max(theme.px(PLOTS[0]), round(least_width)), theme.px(PLOTS[1])
        beside = pygame.Rect(wide, 0, sand.width - wide, sand.height), pygame.Rect(0, 0, wide, sand.height)
        above, below = pygame.Rect(sand.x, 0, sand.width, sand.height - high), pygame.Rect(0, 0, sand.width, high)
        for column, strip in (PLOTS_ON_STAGE if least_width else PLOTS_ALL, PLOTS_FEW):
            ways = []
            if sand.width >= wide + LEAST_SAND and sand.height >= theme.px(column):
                ways.append(beside)
            if sand.height >= high + LEAST_SAND and sand.width >= theme.px(strip):
                ways.append((above, below.move(0, above.bottom)))
            if ways:
                self.sand, self.plots = max(ways, key=lambda way: _cell(way[0], shape, worlds))
                return

    def _place_cards(self, theme, shape, worlds, names):
        """Give the cards the way that leaves the largest cells, and of such ways the one that moves the sand least.

        They stand on both sides of the sand, in a column at its left, or in a strip below it.
        """
        ways = _beside(theme, self.sand, names), _in_a_column(theme, self.sand, names), _below(theme, self.sand, names)
        self.sand, self.cards = max(ways, key=lambda way: _cell(way[0], shape, worlds))


def _cell(sand, shape, worlds):
    """Return how large a cell of a lattice is where so many of them share their part of the window."""
    rows = [number for number in range(1, worlds + 1) if worlds % number == 0]
    return max(min(sand.height / each / shape[0], sand.width * each / worlds / shape[1]) for each in rows)


def _beside(theme, sand, names):
    """Return (sand, {name: rect}) with the cards in columns at both sides, so that the sand's middle stays."""
    wide = theme.px(COLUMN)
    places = {}
    for name in names:
        left = sand.x if name == names[0] else sand.right - wide
        places[name] = pygame.Rect(left, sand.y, wide, min(theme.px(CARDS[name][0]), sand.height))
    return pygame.Rect(sand.x + wide, sand.y, max(0, sand.width - 2 * wide), sand.height), places


def _in_a_column(theme, sand, names):
    """Return (sand, {name: rect}) with the cards one below another at the left."""
    wide, places, top = theme.px(COLUMN), {}, sand.y
    for name in names:
        places[name] = pygame.Rect(sand.x, top, wide, min(theme.px(CARDS[name][0]), sand.height // len(names)))
        top = places[name].bottom
    return pygame.Rect(sand.x + wide, sand.y, max(0, sand.width - wide), sand.height), places


def _below(theme, sand, names):
    """Return (sand, {name: rect}) with the cards in a strip below, side by side or one below another."""
    heights, most, wide = [theme.px(CARDS[name][1]) for name in names], MOST_CARDS * sand.height, theme.px(COLUMN)
    if len(names) > 1 and sand.width >= theme.px(STRIP):
        high = round(min(max(heights), most))
        rects = pygame.Rect(sand.x, 0, wide, high), pygame.Rect(sand.x + wide, 0, sand.width - wide, high)
    else:
        part = min(1.0, most / sum(heights))
        tops = [round(part * sum(heights[:number])) for number in range(len(names) + 1)]
        rects = [pygame.Rect(sand.x, top, sand.width, end - top) for top, end in pairwise(tops)]
        high = tops[-1]
    top = sand.bottom - high
    left = pygame.Rect(sand.x, sand.y, sand.width, top - sand.y)
    return left, {name: rect.move(0, top) for name, rect in zip(names, rects, strict=True)}


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


def room_of(layout, theme):
    """Return the (width, height) in pixels of the part of a window that a lattice can fill."""
    margins = 2 * theme.px(MARGIN)
    return layout.sand.width - margins, layout.sand.height - margins


def window_size(scene, cell, theme):
    """Return the (width, height) in pixels of a window that shows `scene` with `cell` pixels to a cell."""
    px = theme.px
    height, width = (side * cell + 2 * px(MARGIN) for side in scene.shape)
    return width + px(PANEL), max(height + px(TIME_BAR) + px(STATUS_LINE), px(LOWEST))


def first_scale(desktop):
    """Return the size that the panel and its text begin with on a desktop of (width, height) in pixels."""
    return FINE_SCALE if desktop[1] >= FINE else parameters.UI_SCALE.default


def first_size(scene, theme, desktop):
    """Return the size of the first window on a desktop of (width, height) in pixels: a good part of its room.

    A scene that needs more gets what it asks for, as far as there is room.
    """
    sides = zip(window_size(scene, scene.cell, theme), room_on(desktop), LARGEST, strict=True)
    return tuple(min(room, max(wanted, min(round(SHARE * room), most))) for wanted, room, most in sides)
