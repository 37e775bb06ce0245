"""The splash: a glass that runs out while kernels are made ready. It is drawn without any of them."""

import math

import numpy as np
import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.world.looks.themes import GRAIN, INSIDE, SURFACE, WALL, WOOD
from game.world.scenes.hourglass_maker import glass_within

SIZE = 156, 208  # cells of the glass, across and down
HIGH = 0.45  # of the window that it takes, about
LEAST = 0.5  # pixels across a cell; larger ones have whole pixels
SLOPE = 0.8  # rows that the sand's surface goes up or down from column to column
FALLS = 180  # rows that a grain of the stream falls in a second
EVERY = 8  # the stream has a gap after so many rows
STEP_S = 8.0  # within about which most of a step is done
BEHIND, GLASS, WOODEN, AIR, SAND, LIGHT = range(6)  # what a pixel of the picture shows


class Splash:
    """Says what is being made ready, and shows how much of it is done by the sand of a glass."""

    def __init__(self, theme):
        self._theme = theme
        glass = glass_within(*SIZE)
        self._plain = _picture(glass)
        sand, inside = glass.cells()[0], glass.inside()
        lower = inside.copy()
        lower[: glass.height // 2] = False
        slant = SLOPE * np.abs(np.arange(glass.width) - (glass.width - 1) / 2)
        rows = np.arange(glass.height)[:, None]
        self._above = _ordered(sand, rows + slant)  # the cells of sand, the last to leave first
        self._below = _ordered(lower, rows - slant)  # where it comes to rest, in this order
        self._neck, self._axis = glass.height // 2, glass.width // 2
        mean = theme.colours.mean
        colours = theme.rgb(look.SUNKEN), mean(WALL, "glass"), mean(WOOD), mean(INSIDE), mean(GRAIN), mean(SURFACE)
        self._colours = np.array(colours).round().astype(np.uint8)

    def draw(self, surface, what, done, now_s):
        """Fill a surface with the glass, `done` (0 … 1) of its sand below, and with what is being made ready."""
        px, (width, height) = self._theme.px, surface.get_size()
        surface.fill(self._theme.rgb(look.SUNKEN))
        picture = pygame.image.frombuffer(self._colours[self.cells(done, now_s)].tobytes(), SIZE, "RGB")
        wanted = HIGH * height / SIZE[1]
        scale = round(wanted) if wanted > (1 + LEAST) / 2 else LEAST
        picture = pygame.transform.scale(picture, tuple(round(scale * side) for side in SIZE))
        place = picture.get_rect(center=(width // 2, height // 2))
        surface.blit(picture, place)
        title = 0, place.top - px(38), width, px(30)
        draw_list.words(surface, self._theme, title, "Sandglass", look.HEADING, look.BRIGHT_ACCENT, 0.5)
        words = px(8), place.bottom + px(8), width - 2 * px(8), px(24)
        draw_list.words(surface, self._theme, words, what, look.BODY, look.DIM, 0.5)

    def cells(self, done, now_s):
        """Return what each pixel of the glass shows, (h, w) uint8."""
        cells, flat = self._plain.copy(), len(self._above[0])
        fallen = round(min(max(done, 0.0), 1.0) * flat)
        for (rows, columns), count in ((self._above, flat - fallen), (self._below, fallen)):
            cells[rows[:count], columns[:count]] = SAND
        if fallen < flat:
            self._pour(cells, now_s)
        surface = (cells == SAND) & (np.roll(cells, 1, axis=0) == AIR)
        cells[surface] = LIGHT
        return cells

    def _pour(self, cells, now_s):
        """Let the stream fall from the neck to the pile."""
        for row in range(self._neck, len(cells)):
            if cells[row, self._axis] != AIR:
                return
            if (row - math.floor(FALLS * now_s)) % EVERY:
                cells[row, self._axis - 1 : self._axis + 1] = SAND


def _picture(glass):
    """Return the empty glass."""
    walls, cells = glass.cells()[1], np.full((glass.height, glass.width), BEHIND, np.uint8)
    cells[glass.inside()] = AIR
    cells[walls] = GLASS
    cells[walls & (walls.mean(axis=1) > 0.5)[:, None]] = WOODEN
    return cells


def _ordered(mask, key):
    """Return (rows, columns) of the cells of a mask, those with the largest keys first."""
    rows, columns = np.nonzero(mask)
    order = np.argsort(-key[rows, columns], kind="stable")
    return rows[order], columns[order]


class Progress:
    """Steps done as a share that goes on within a step, the slower the longer that takes."""

    def __init__(self, count):
        self._count, self._done, self._since_s = count, 0, None

    def at(self, done, now_s):
        """Return the share (0 … 1) where so many steps are done."""
        if self._since_s is None or done != self._done:
            self._done, self._since_s = done, now_s
        return (done + 1 - math.exp((self._since_s - now_s) / STEP_S)) / self._count
