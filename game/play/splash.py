"""The splash before the first frame."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look


def draw_splash(surface, theme, what, part):
    """Fill the window with the title, what is being made ready, and how much of it is done (0 … 1)."""
    px = theme.px
    width, height = surface.get_size()
    surface.fill(theme.rgb(look.SUNKEN))
    middle = height // 2
    draw_list.words(
        surface, theme, (0, middle - px(64), width, px(30)), "Sandglass", look.HEADING, look.BRIGHT_ACCENT, 0.5
    )
    draw_list.words(surface, theme, (0, middle - px(32), width, px(24)), what, look.BODY, look.DIM, 0.5)
    track = pygame.Rect(0, 0, px(220), px(4))
    track.center = width // 2, middle + px(12)
    surface.fill(theme.rgb(look.GROOVE), track)
    surface.fill(theme.rgb(look.ACCENT), (track.x, track.y, round(track.width * part), track.height))
