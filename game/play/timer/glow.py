"""The glow: the edges of the sand light up for a while and fade."""

import math

import pygame

from game.play.ui import theme as look

LASTS_S = 4.0
RISES_S = 0.4
WIDTH = 26  # pixels at scale 1
LINE = 3  # of the still frame that is drawn instead where motion is reduced


class Glow:
    """An overlay that is shown only while the edges glow."""

    def __init__(self, display, settings):
        self._display, self._settings = display, settings
        self._since_s = None
        self._age_s = 0.0
        self._strips, self._of = [], None  # the glow at its brightest, and what it was drawn for

    @property
    def shown(self):
        """Whether the edges glow."""
        return self._since_s is not None

    def start(self, now_s):
        """Glow from now on."""
        self._since_s, self._age_s = now_s, 0.0
        self._display.refresh()

    def stop(self):
        """Stop glowing at once."""
        if self.shown:
            self._since_s = None
            self._display.refresh()

    def update(self, now_s):
        """Let time pass."""
        if not self.shown:
            return
        self._age_s = now_s - self._since_s
        if self._age_s > LASTS_S:
            self.stop()
        elif not self._settings["reduced_motion"]:
            self._display.refresh()

    def draw(self, surface, theme, area):
        """Draw the glow inside `area`; return the rects that it covers."""
        if self._settings["reduced_motion"]:
            pygame.draw.rect(surface, theme.rgb(look.ACCENT), area, theme.px(LINE))
            return [rect.move(area.topleft) for rect in _edges(area.size, theme.px(LINE))]
        self._prepare(area, theme.px(WIDTH), theme.rgb(look.ACCENT))
        for place, strip in self._strips:
            strip.set_alpha(round(255 * self._strength()))
            surface.blit(strip, place)
        return [place for place, _ in self._strips]

    def _strength(self):
        """Return how bright it is, 0 … 1: it rises, breathes once, and fades."""
        rise = min(self._age_s / RISES_S, 1.0)
        fade = min(max((LASTS_S - self._age_s) / (LASTS_S / 2), 0.0), 1.0)
        return rise * fade * (0.8 + 0.2 * math.cos(2 * math.pi * self._age_s / (LASTS_S / 2)))

    def _prepare(self, area, wide, colour):
        if self._of == (tuple(area), wide, colour):
            return
        self._of = tuple(area), wide, colour
        sheet = pygame.Surface(area.size, pygame.SRCALPHA, 32)
        for inset in range(wide):
            alpha = round(230 * (1 - inset / wide) ** 2.2)
            pygame.draw.rect(sheet, (*colour, alpha), sheet.get_rect().inflate(-2 * inset, -2 * inset), 1)
        self._strips = [(edge.move(area.topleft), sheet.subsurface(edge).copy()) for edge in _edges(area.size, wide)]


def _edges(size, wide):
    """Return the rects of a frame `wide` pixels wide inside a rectangle of `size`."""
    width, height = size
    edges = (0, 0, width, wide), (0, height - wide, width, wide)
    edges += (0, wide, wide, height - 2 * wide), (width - wide, wide, wide, height - 2 * wide)
    return [pygame.Rect(edge) for edge in edges if min(edge[2:]) > 0]
