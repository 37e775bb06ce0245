"""The layout: where the parts of the window lie."""

import pygame

from game.play import hud, panel, timebar


class Layout:
    """The parts' rects in a window of `size` (width, height) in pixels, with the panel shown or not."""

    def __init__(self, theme, size, panel_shown):
        width, height = size
        self.panel = panel.area(theme, size)
        wide = width - (self.panel.width if panel_shown else 0)
        bar, line = theme.px(timebar.HEIGHT), theme.px(hud.HEIGHT)
        self.sand = pygame.Rect(0, 0, wide, height - bar - line)
        self.bar = pygame.Rect(0, self.sand.bottom, wide, bar)
        self.hud = pygame.Rect(0, height - line, wide, line)
