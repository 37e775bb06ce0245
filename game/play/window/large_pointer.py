"""The large pointer: an arrow that is found from the back of a room."""

from contextlib import suppress

import pygame

ARROW = (0, 0), (0, 17), (4, 13.2), (6.8, 19.4), (9.4, 18.3), (6.6, 12.2), (12, 12.2)  # in pixels of a usual one
GROWN = 3.0  # times as large, at scale 1
EDGE, BODY = (0, 0, 0), (255, 255, 255)


def show_large(scale):
    """Make the pointer large; where the system has none of that kind, it stays as it is."""
    with suppress(pygame.error):
        pygame.mouse.set_cursor(pygame.cursors.Cursor((1, 1), picture(scale)))


def show_usual():
    """Give the pointer its usual size."""
    with suppress(pygame.error):
        pygame.mouse.set_cursor(pygame.SYSTEM_CURSOR_ARROW)


def picture(scale):
    """Return the arrow as a surface, its tip in the upper left corner."""
    points = [(1 + GROWN * scale * x, 1 + GROWN * scale * y) for x, y in ARROW]
    wide, high = (int(max(side)) + 3 for side in zip(*points, strict=True))
    surface = pygame.Surface((wide, high), pygame.SRCALPHA, 32)
    pygame.draw.polygon(surface, BODY, points)
    pygame.draw.lines(surface, EDGE, True, points, max(2, round(1.5 * scale)))
    return surface
