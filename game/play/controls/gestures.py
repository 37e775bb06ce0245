"""Gestures: what a tool does between the press of a button and its release, as acts, and what it shows meanwhile.

Each is made at the place (column, row) of the press. `go` is called there, at every place it moves to, and once a frame
where it rests; `end` where the button comes up. Both return the acts that this comes to. `outlines` returns the lines
to show meanwhile, in cells, or None for those of the tool at rest.
"""

import math

from game.play.view.overlays.outlines import box_outline, brush_outline, ellipse_outline, hull
from game.world.sessions.action import EMPTY_CELLS, Draw, Fill, Paint, box, cell, snap

STEP = math.pi / 4  # a line that is held straight goes in steps of this angle


def straightened(start, place):
    """Return the place nearest to another to which a line from `start` goes in steps of 45 degrees."""
    away = place[0] - start[0], place[1] - start[1]
    angle = round(math.atan2(away[1], away[0]) / STEP) * STEP
    length = away[0] * math.cos(angle) + away[1] * math.sin(angle)
    return start[0] + length * math.cos(angle), start[1] + length * math.sin(angle)


class Trail:
    """Paints where it goes and where it rests; as a spray, or only on what it began on."""

    outlines = None

    def __init__(self, brush, place, world):
        self._brush, self._last = brush, place
        self._only = material_at(world, place) if brush.tool == "replace" else ""

    def go(self, place, _straight):
        """Paint on the way to a place."""
        return [self._paint(place)]

    end = go

    def _paint(self, place):
        start, self._last = self._last, place
        brush = self._brush
        number = brush.next_spray() if brush.tool == "spray" else 0
        over_walls = brush.over_walls
        return Paint(brush.ink, start, place, brush.diameter, over_walls, brush.shape, self._only, number, brush.dye)


class Span:
    """Stretches a line, a rectangle or an ellipse between two places; it is drawn when the button comes up."""

    def __init__(self, brush, place, world):
        self._brush, self._start, self._end = brush, place, place
        self._figure = brush.tool if brush.tool in ("rectangle", "ellipse") else "line"

    def go(self, place, straight):
        """Stretch to a place; `straight`: as a line in steps of 45 degrees, or with sides alike."""
        self._end = self._straightened(place) if straight else place
        return []

    def end(self, place, straight):
        """Draw what is stretched to a place."""
        self.go(place, straight)
        brush, start, end = self._brush, self._start, self._end
        if self._figure == "line":
            return [Paint(brush.ink, start, end, brush.diameter, brush.over_walls, brush.shape, colour=brush.dye)]
        edge = brush.diameter if brush.edge_only else 0
        return [Draw(self._figure, brush.ink, snap(start, 1), snap(end, 1), edge, brush.over_walls, brush.dye)]

    def outlines(self):
        """Return the outline of what would be drawn."""
        brush, left_top_right_bottom = self._brush, box(self._start, self._end)
        if self._figure == "rectangle":
            return [box_outline(*left_top_right_bottom)]
        if self._figure == "ellipse":
            return [ellipse_outline(*left_top_right_bottom)]
        ends = (snap(place, brush.diameter) for place in (self._start, self._end))
        return [hull([point for end in ends for point in brush_outline(brush.shape, brush.diameter, end)])]

    def _straightened(self, place):
        """Return the nearest place that makes a line go in steps of 45 degrees, or the sides of a figure alike."""
        if self._figure == "line":
            return straightened(self._start, place)
        away = place[0] - self._start[0], place[1] - self._start[1]
        side = max(abs(part) for part in away)
        return tuple(start + math.copysign(side, part) for start, part in zip(self._start, away, strict=True))


class Press:
    """Does all it does when the button goes down: fills, or picks what to paint with."""

    outlines = None

    def __init__(self, brush, _place, world):
        self._brush, self._world = brush, world

    def go(self, place, _straight):
        """Do it, if it is not done."""
        brush, world, self._world = self._brush, self._world, None
        if world is None:
            return []
        if brush.tool == "fill":
            return [Fill(brush.ink, snap(place, 1), brush.dye)]
        brush.take(material_at(world, place), world.colour_at(*cell(place)))
        return []

    end = go


def material_at(world, place):
    """Return the name of what a cell holds; that of nothing for air and outside of the lattice."""
    code = world.code_at(*cell(place))
    return world.codes.names[code] if code else EMPTY_CELLS
