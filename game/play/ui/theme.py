"""How the window looks: colours, sizes under one scale factor, the shipped font, and small smooth sprites."""

import weakref
from functools import lru_cache, partial

import pygame

from game.world.files.paths import asset
from game.world.looks.themes import NIGHT
from game.world.sand import parameters

FONT_FILE = asset("font", "NotoSans-Regular.ttf")

# Roles of colours: strokes name them, and the theme says when they are drawn what colour that is.
GROUND = "ground"
RAISED = "raised"  # buttons, boxes, tooltips
HOVER = "hover"
PRESSED = "pressed"
GROOVE = "groove"  # the empty part of a track
SUNKEN = "sunken"
EDGE = "edge"
TEXT = "text"
DIM = "dim"
FAINT = "faint"
ACCENT = "accent"
BRIGHT_ACCENT = "bright accent"
HANDLE = "handle"
BRIGHT_HANDLE = "bright handle"
STONE = "stone"  # an occupied cell in a picture, be it sand or wall
RING = "ring"

# Text sizes in pixels at scale 1.
BODY = 14
HEADING = 15
SMALL = 12

MOST_KEPT = 4  # themes: more hold more text and sprites, fewer draw them anew at each change of size
SMOOTHING = 8  # sprites are drawn this many times larger and shrunk

_kept = {}  # (scale, id of the colours): Theme, the one used last at the end


class Theme:
    """Everything a panel is drawn with at one UI scale and in one set of colours; make a new one to change either."""

    def __init__(self, scale=parameters.UI_SCALE.default, colours=NIGHT):
        self.scale = scale
        self.colours = colours
        self.px = self._remembering(Theme._px, 256)
        pygame.font.init()
        self._font = self._remembering(Theme._font_of, 32)
        self.words = self._remembering(Theme._words, 512)
        self.width = self._remembering(Theme._width, 1024)
        self.fitted = self._remembering(Theme._fitted, 512)
        self.lines = self._remembering(Theme._lines, 128)
        self.corners = self._remembering(Theme._corners, 64)
        self.disc = self._remembering(Theme._disc, 32)
        self.polygon = self._remembering(Theme._polygon, 64)

    def _remembering(self, method, most):
        """Return a method that keeps its last results, and not the theme: megabytes of text go as soon as it does."""
        return lru_cache(maxsize=most)(partial(method, weakref.proxy(self)))

    def _px(self, size):
        """Return `size`, given in pixels at scale 1, in whole pixels of the screen, at least 1."""
        return max(1, round(size * self.scale))

    def _font_of(self, size):
        """Return the font in a size."""
        return pygame.font.Font(str(FONT_FILE), self.px(size))

    def rgb(self, colour):
        """Return the RGB of a role; RGB stays as it is."""
        return self.colours.panel[colour] if isinstance(colour, str) else colour

    def line_height(self, size):
        """Return the height in pixels of a line of text."""
        return self._font(size).get_linesize()

    def _width(self, text, size):
        """Return the width in pixels of one line of text."""
        return self._font(size).size(_spelled(text))[0]

    def _words(self, text, size, colour):
        """Return one line of text as a surface."""
        return self._font(size).render(_spelled(text), True, self.rgb(colour))

    def _fitted(self, text, size, width):
        """Return `text`, cut and ended with … where it is wider than `width` pixels."""
        if self.width(text, size) <= width:
            return text
        while text and self._width(text.rstrip() + "…", size) > width:
            text = text[:-1]
        return text.rstrip() + "…" if text else ""

    def _lines(self, text, size, width):
        """Return `text` broken between words into a tuple of lines at most `width` pixels wide."""
        lines = [""]
        for word in text.split():
            longer = f"{lines[-1]} {word}".lstrip()
            if lines[-1] and self._width(longer, size) > width:
                lines.append(word)
            else:
                lines[-1] = longer
        return tuple(self.fitted(line, size, width) for line in lines)

    def _corners(self, radius, colour, stroke):
        """Return the four quarters of a disc, or of a ring `stroke` pixels thick, from the upper left clockwise."""
        big, colour = radius * SMOOTHING, self.rgb(colour)

        def quarter(canvas):
            pygame.draw.circle(canvas, colour, (big, big), big)
            if stroke:
                pygame.draw.circle(canvas, (*colour, 0), (big, big), big - stroke * SMOOTHING)

        first = _smooth((radius, radius), colour, quarter)
        flip = pygame.transform.flip
        return first, flip(first, True, False), flip(first, True, True), flip(first, False, True)

    def _disc(self, diameter, colour):
        """Return a filled circle."""
        big, colour = diameter * SMOOTHING / 2, self.rgb(colour)
        return _smooth((diameter, diameter), colour, lambda canvas: pygame.draw.circle(canvas, colour, (big, big), big))

    def _polygon(self, size, points, colour):
        """Return a polygon whose points are given as fractions of `size` (width, height)."""
        big = [(x * size[0] * SMOOTHING, y * size[1] * SMOOTHING) for x, y in points]
        colour = self.rgb(colour)
        return _smooth(size, colour, lambda canvas: pygame.draw.polygon(canvas, colour, big))


def theme_of(scale, colours):
    """Return the Theme at a UI scale and in a set of colours; the last few are kept, with all that they have drawn."""
    key = scale, id(colours)  # a theme keeps its colours alive, and so their id its own
    theme = _kept.pop(key, None) or Theme(scale, colours)
    _kept[key] = theme
    if len(_kept) > MOST_KEPT:
        del _kept[next(iter(_kept))]
    return theme


def _spelled(text):
    """Return `text` with ? for each byte of a file's name that spells no letter; no font takes such a text as it is."""
    return text.encode("utf-8", "replace").decode()


def _smooth(size, colour, draw):
    """Return a sprite with soft edges: `draw` paints it large, in `colour` on the same colour made transparent."""
    canvas = pygame.Surface((size[0] * SMOOTHING, size[1] * SMOOTHING), pygame.SRCALPHA, 32)
    canvas.fill((*colour, 0))
    draw(canvas)
    return pygame.transform.smoothscale(canvas, size)
