"""Scrolling: how far a tall column is scrolled inside its view, and the thumb that shows it."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look


class Scroll:
    """An offset kept between 0 and what does not fit; `content` and `view` are heights."""

    def __init__(self):
        self.offset = 0
        self.content = 0
        self.view = 0
        self.shortest = 1  # height that the thumb is never below
        self._grab = 0  # where on the thumb the pointer holds it

    @property
    def limit(self):
        """How far the column can go: 0 if all of it fits."""
        return max(0, self.content - self.view)

    def to(self, offset):
        """Scroll to an offset, as far as there is content."""
        self.offset = min(max(round(offset), 0), self.limit)

    def reveal(self, top, bottom):
        """Scroll as little as needed to show the span from `top` to `bottom` of the column."""
        if top < self.offset:
            self.to(top)
        elif bottom > self.offset + self.view:
            self.to(bottom - self.view)

    @property
    def thumb(self):
        """(top, height) of the scroll bar's thumb in the view, or None if all fits."""
        if not self.limit:
            return None
        height = max(self.shortest, self.view * self.view // self.content)
        return round(self.offset / self.limit * (self.view - height)), height

    def grab(self, y):
        """Take the thumb where the pointer is on it, or else bring its middle to the pointer; `y` is in the view."""
        top, height = self.thumb
        self._grab = y - top if top <= y < top + height else height // 2
        self.drag(y)

    def drag(self, y):
        """Move the grabbed thumb with the pointer."""
        if self.thumb:
            self.to((y - self._grab) / max(1, self.view - self.thumb[1]) * self.limit)


def thumb(theme, track, first, seen, total, colour=look.EDGE):
    """Return the strokes of a thumb in the rect `track`, where `seen` of `total` rows show from `first` on."""
    if seen >= total:
        return []
    top, height = track.y + track.height * first // total, track.height * seen // total
    return [(draw_list.box, pygame.Rect(track.x, top, track.width, height), colour, theme.px(2))]
