"""Cards in a row or a column, each worked out and drawn in a frame of its own, since together they take long."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look


class CardStrip:
    """What is drawn of some cards, and which of them are to be worked out anew."""

    def __init__(self):
        self._cards = ()  # of (rect, function that returns the strokes of its card)
        self._drawn = None  # the strokes of each card
        self._due = []  # numbers of cards
        self._stale = True

    @property
    def busy(self):
        """Whether the next frame works a card out."""
        return self._stale or bool(self._due)

    def forget(self):
        """Draw all cards anew next time, at once."""
        self._drawn, self._stale = None, True

    def renew(self):
        """Work all cards out anew from the next frame on, one in each."""
        self._stale = True

    def draw(self, surface, theme, area, place):
        """Draw what is due and looks different; return the rects that changed.

        place: returns [(rect, function that returns the strokes of its card)], all within `area`.
        """
        if self._stale:
            before, self._cards, self._stale = [rect for rect, _ in self._cards], place(), False
            self._due = [*range(len(self._cards))]
            if self._drawn is None or before != [rect for rect, _ in self._cards]:
                self._drawn, self._due = [strokes() for _, strokes in self._cards], []
                background = (draw_list.fill, tuple(area), look.SUNKEN)
                draw_list.draw(surface, theme, [background, *(each for card in self._drawn for each in card)])
                return [area]
        if not self._due:
            return []
        number = self._due.pop(0)
        rect, strokes = self._cards[number]
        if (new := strokes()) == self._drawn[number]:
            return []
        self._drawn[number] = new
        draw_list.draw(surface, theme, [(draw_list.fill, tuple(rect), look.SUNKEN), *new])
        return [pygame.Rect(rect)]
