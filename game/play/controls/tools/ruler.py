"""The ruler: a line between two places on the sand, with its length in cells and its angle in degrees."""

import math

from game.play.controls.gestures import straightened
from game.play.ui import theme as look
from game.play.ui.card import draw_lines_near
from game.play.view.overlays.outlines import Mark

TOOL = "ruler"


class RulerTool:
    """The gesture that lays the ruler; it changes nothing of the sand."""

    def __init__(self, brush, place, world):
        self._brush, self._start = brush, place

    def go(self, place, straight):
        """Lay it to a place; `straight`: in steps of 45 degrees."""
        self._brush.ruled = self._start, straightened(self._start, place) if straight else place
        return []

    end = go
    outlines = None


class Ruler:
    """What lies on the sand while the tool is in hand, and the card that says how long it is."""

    def __init__(self, brush, display):
        self._brush, self._display = brush, display
        self._drawn = None  # what the card was last drawn for

    @property
    def shown(self):
        """Whether the ruler lies anywhere."""
        return self._brush.tool == TOOL and self._brush.ruled is not None

    @property
    def lines(self):
        """What it says, as lines."""
        (x0, y0), (x1, y1) = self._brush.ruled
        across, down = abs(x1 - x0), abs(y1 - y0)
        angle = math.degrees(math.atan2(down, across))
        return f"{angle:.1f}°", f"{math.hypot(across, down):.1f} cells", f"{across:.1f} across, {down:.1f} high"

    def marks(self, view):
        """Return the Marks of the line, and of the level that its angle is measured from."""
        if not self.shown:
            return ()
        start, end = (tuple(map(round, view.pixel(*place))) for place in self._brush.ruled)
        level = Mark((start, (end[0], start[1])), look.TEXT, closed=False)
        return level, Mark((start, end), look.RING, closed=False)

    def update(self, now_s):
        """Have the card drawn anew where it says or stands otherwise."""
        now = (self._brush.ruled, self._display.sand_view.view) if self.shown else None
        if now != self._drawn:
            self._drawn = now
            self._display.refresh()

    def draw(self, surface, theme, area):
        """Draw the card; return the rects that it covers."""
        at = self._display.sand_view.view.pixel(*self._brush.ruled[1])
        title, *others = self.lines
        lines = [(title, look.HANDLE), *((line, look.TEXT) for line in others)]
        return draw_lines_near(surface, theme, area, tuple(map(round, at)), lines)
