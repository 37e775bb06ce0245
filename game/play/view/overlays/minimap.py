"""The minimap: the whole lattice in a corner of the sand, and what of it is in sight, while that is only a part."""

import numpy as np
import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.world.looks.painter import Painter
from game.world.looks.themes import substances_of
from game.world.looks.view import View

LARGEST = 150  # pixels at scale 1: its longer side
SHARE = 0.3  # of the sides of the sand's part of the window that it takes at most
MARGIN = 10  # pixels at scale 1 from the edges of that
SMALLEST = 6  # pixels: what is in sight is outlined at least so large


class Minimap:
    """An overlay that is shown while only a part of the lattice is in sight."""

    def __init__(self, sessions, display):
        self._sessions, self._display = sessions, display
        self._painter, self._of = None, None  # and what it paints, in which looks
        self._pixels = np.zeros((1, 1), np.uint32)

    @property
    def shown(self):
        """Whether there is anything to find one's way in."""
        sand_view, view = self._display.sand_view, self._display.sand_view.view
        lattice = pygame.Rect(view.left, view.top, view.width, view.height)
        return not sand_view.turn and not sand_view.area.contains(lattice)

    @property
    def rect(self):
        """Where it lies in the window."""
        theme, area = self._display.theme, self._display.sand_view.area
        height, width = self._display.sand_view.view.shape
        room = [min(theme.px(LARGEST), SHARE * side) for side in area.size]
        scale = min(room[0] / width, room[1] / height)
        rect = pygame.Rect(0, 0, max(1, round(width * scale)), max(1, round(height * scale)))
        rect.bottomright = area.right - theme.px(MARGIN), area.bottom - theme.px(MARGIN)
        return rect

    def is_at(self, pos):
        """Return whether it is shown and lies at a place in the window."""
        return self.shown and self.rect.collidepoint(pos)

    def place(self, pos):
        """Return the (column, row) of the lattice that it shows at a place in the window, or near it."""
        rect, (height, width) = self.rect, self._display.sand_view.view.shape
        parts = (pos[0] + 0.5 - rect.x) / rect.width, (pos[1] + 0.5 - rect.y) / rect.height
        return tuple(min(max(part, 0.0), 1.0) * side for part, side in zip(parts, (width, height), strict=True))

    def draw(self, surface, theme, area):
        """Draw it over the sand; return the rects that it covers."""
        rect = self.rect
        edge = rect.inflate(2 * theme.px(1), 2 * theme.px(1))
        draw_list.fill(surface, theme, edge, look.EDGE)
        surface.blit(self._picture(rect.size), rect)
        draw_list.ring(surface, theme, self._in_sight(rect), look.BRIGHT_ACCENT, 0, max(1, theme.px(1)))
        return [edge]

    def _in_sight(self, rect):
        """Return where it outlines what is in sight."""
        view = self._display.sand_view.view
        left, top, right, bottom = view.seen
        scale = rect.width / view.shape[1], rect.height / view.shape[0]
        (x0, y0), (x1, y1) = view.place(left, top), view.place(right, bottom)
        part = pygame.Rect(rect.x + x0 * scale[0], rect.y + y0 * scale[1], (x1 - x0) * scale[0], (y1 - y0) * scale[1])
        part.size = max(SMALLEST, part.width), max(SMALLEST, part.height)
        return part.clamp(rect) if part.width <= rect.width and part.height <= rect.height else part.clip(rect)

    def _picture(self, size):
        """Return the lattice as it is now, as a surface of that size."""
        session, colours = self._sessions.now, self._display.theme.colours
        substances = substances_of(session.rule.definition.materials)
        now = session.world.shape, size, colours.name, session.scene.made_of, substances
        if now != self._of:
            self._of, self._pixels = now, np.zeros(size[::-1], np.uint32)
            view = View(session.world.shape, 0, 0, *size)
            self._painter = Painter(view, colours, session.scene.made_of, substances=substances)
        self._painter.draw(session.world, self._pixels)
        return pygame.image.frombuffer(self._pixels.tobytes(), size, "BGRA").convert()
