"""The tabs: the names of the panel's sections above its column; one that is chosen brings its section to the top."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look

HEIGHT = 28  # of a row of tabs, in pixels at scale 1
LEAST = 3  # pixels at scale 1 on each side of a word, or the tabs take two rows
LINE = 2  # under the chosen one
LEFT = 1


class Tabs:
    """Knows where each name stands, and which one the pointer is over."""

    def __init__(self, names):
        self.names = names
        self._places = []  # of each name, a Rect in the window
        self._pointed = None

    def place(self, theme, panel):
        """Take the upper part of the panel; return what is left of it."""
        widths = [theme.width(name, look.SMALL) for name in self.names]
        rows = 1 if sum(widths) + 2 * len(widths) * theme.px(LEAST) <= panel.width else 2
        high, count = theme.px(HEIGHT), -(-len(widths) // rows)
        self._places = []
        for row in range(rows):
            shares = widths[row * count : (row + 1) * count]
            spare, left = panel.width - sum(shares), 0.0
            for wide in shares:
                right = left + wide + spare / len(shares)
                place = pygame.Rect(panel.x + round(left), panel.y + row * high, round(right) - round(left), high)
                self._places.append(place)
                left = right
        return pygame.Rect(panel.x, panel.y + rows * high, panel.width, max(1, panel.height - rows * high))

    def handle_events(self, events, mouse_pos):
        """Return (the events that are not theirs, the number of the tab that was pressed or None)."""
        self._pointed = self._at(mouse_pos)
        rest, pressed = [], None
        for event in events:
            number = self._at(event.pos) if event.type == pygame.MOUSEBUTTONDOWN else None
            if number is not None:
                pressed = number if event.button == LEFT else pressed
            elif event.type != pygame.MOUSEWHEEL or self._pointed is None:
                rest.append(event)
        return rest, pressed

    @property
    def rect(self):
        """The part of the window that they take."""
        return self._places[0].unionall(self._places[1:])

    def drawing(self, chosen):
        """Return their strokes, with one of them chosen."""
        strokes = [(draw_list.fill, tuple(self.rect), look.SUNKEN)]
        for number, (name, place) in enumerate(zip(self.names, self._places, strict=True)):
            colour = look.HANDLE if number == chosen else look.TEXT if number == self._pointed else look.DIM
            strokes.append((draw_list.words, tuple(place), name, look.SMALL, colour, 0.5))
            if number == chosen:
                line = place.inflate(-2 * LEAST, 0)
                strokes.append((draw_list.fill, (line.x, place.bottom - LINE, line.width, LINE), look.ACCENT))
        return strokes

    def _at(self, pos):
        return None if pos is None else next((i for i, each in enumerate(self._places) if each.collidepoint(pos)), None)
