"""The buttons of the view: zoom, fit and full screen, at the sand's lower edge."""

from itertools import pairwise

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.input import key_name

GRID = 12  # an icon is drawn on so many units a side, …
SIDE = 12  # … which are so many pixels at scale 1
CORNERS = (
    *((0, 0, 4, 2), (0, 0, 2, 4), (8, 0, 4, 2), (10, 0, 2, 4)),
    *((0, 10, 4, 2), (0, 8, 2, 4), (8, 10, 4, 2), (10, 8, 2, 4)),
)
FRAME = ((0, 0, 12, 1), (0, 11, 12, 1), (0, 0, 1, 12), (11, 0, 1, 12))
BUTTONS = (  # command, what it does, its key, and the filled parts of its icon as (x, y, width, height) in units
    ("view.zoom -1", "Zoom out", "Ctrl -", ((1, 5, 10, 2),)),
    ("view.zoom 1", "Zoom in", "Ctrl +", ((1, 5, 10, 2), (5, 1, 2, 10))),
    ("view.show_all", "Show the whole lattice", "0", (*FRAME, (3, 3, 6, 6))),
    ("view.toggle_fullscreen", "Full screen, and back", "F11", CORNERS),
)
LEFT = 1


class ViewButtons:
    """Gives a command where a button is pressed, and says what the one under the pointer does."""

    def __init__(self, pointer, give):
        """`give(command)` carries out a command of the keymap."""
        self._pointer, self._give = pointer, give
        self.area, self.theme = pygame.Rect(0, 0, 0, 0), None

    def place(self, area, theme):
        """Lie in `area` of the window from now on."""
        self.area, self.theme = area, theme

    def handle_event(self, event):
        """Take in an event and return whether it was a press on a button."""
        number = self._at(event.pos) if event.type == pygame.MOUSEBUTTONDOWN else None
        if number is not None and event.button == LEFT:
            self._give(BUTTONS[number][0])
        return number is not None

    @property
    def words(self):
        """What the button under the pointer does, and its key; or ""."""
        if self._pointed is None:
            return ""
        _, meaning, key, _ = BUTTONS[self._pointed]
        return f"{meaning}  ({key_name(key)})"

    def drawing(self):
        """Return their strokes."""
        strokes, pointed = [(draw_list.fill, tuple(self.area), look.SUNKEN)], self._pointed
        side = self.theme.px(SIDE)
        for number, place in enumerate(self.places):
            if number == pointed:
                strokes.append((draw_list.box, tuple(place.inflate(-2, -2)), look.HOVER, self.theme.px(4)))
            icon = pygame.Rect(0, 0, side, side)
            icon.center = place.center
            colour = look.HANDLE if number == pointed else look.DIM
            strokes += [(draw_list.fill, _scaled(part, icon), colour) for part in BUTTONS[number][3]]
        return strokes

    @property
    def places(self):
        """The rects of the buttons in the window."""
        edges = [self.area.x + self.area.width * number // len(BUTTONS) for number in range(len(BUTTONS) + 1)]
        return [pygame.Rect(x, self.area.y, right - x, self.area.height) for x, right in pairwise(edges)]

    @property
    def _pointed(self):
        return None if self._pointer.in_window is None else self._at(self._pointer.in_window)

    def _at(self, pos):
        return next((number for number, place in enumerate(self.places) if place.collidepoint(pos)), None)


def _scaled(part, icon):
    """Return a part of an icon, in units, as pixels inside its rect; none is thinner than a pixel."""
    x, y, width, height = (number * icon.width / GRID for number in part)
    left, top = round(x), round(y)
    return icon.x + left, icon.y + top, max(1, round(x + width) - left), max(1, round(y + height) - top)
