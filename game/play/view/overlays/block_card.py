"""The card beside the pointer, while blocks are shown: what can happen in the block under it, and what just has."""

import math

from game.play.ui import theme as look
from game.play.ui.card import draw_lines_near


class BlockCard:
    """Lines over the sand, in sight as long as there is anything to say."""

    def __init__(self, overlay, display, pointer):
        self._overlay, self._display, self._pointer = overlay, display, pointer
        self.lines = ()  # of (text, colour)
        self._at = None  # the pointer

    @property
    def shown(self):
        """Whether there is anything to say."""
        return bool(self.lines)

    def update(self, now_s):
        """Look at the block under the pointer; have the card drawn anew where it says or stands otherwise."""
        at = self._pointer.place if self._overlay.shown else None
        lines = tuple(self._write(at)) if at is not None else ()
        if lines != self.lines or (lines and at != self._at):
            self._display.refresh()
        self.lines, self._at = lines, at

    def _write(self, at):
        column, row = (math.floor(part) for part in self._display.sand_view.view.place(*at))
        coming, done = self._overlay.told(column, row)
        if coming:
            yield "Can happen here", look.HANDLE
            yield from ((line, look.TEXT) for line in coming)
        if done:
            yield "Has just happened", look.HANDLE
            yield from ((line, look.TEXT) for line in done)

    def draw(self, surface, theme, area):
        """Draw the card; return the rects that it covers."""
        return draw_lines_near(surface, theme, area, self._at, self.lines)
