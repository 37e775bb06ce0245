"""Fittings: how taps and drains are shown, put where the pointer lets go, and moved."""

import math

from game.play.ui import theme as look
from game.play.view.outlines import Mark, box_outline
from game.world.sand.fixtures import MOST, TAP, Fixture
from game.world.sessions.action import SetFixtures, cell, snap

NEAR = 1  # cells: a fixture is taken hold of this far beside it
LEAST = 8  # pixels at scale 1: the least width of a symbol
STEM = 4  # pixels at scale 1: from a symbol's edge to its handle


class Carry:
    """Carries a new fixture, or the one that lies where the button goes down, and puts it where it comes up."""

    def __init__(self, brush, place, world):
        self._present = world.fixtures
        self._held = next((each for each in reversed(self._present) if _is_near(each, place)), None)
        self._grip = cell(place)
        self._carried = self._held or fresh(brush, place)

    def go(self, place, _straight):
        """Carry it to a place."""
        (column, row), (from_column, from_row) = cell(place), self._grip
        self._grip = column, row
        self._carried = self._carried.moved(column - from_column, row - from_row)
        return []

    def end(self, place, straight):
        """Let go of it at a place."""
        self.go(place, straight)
        if self._carried == self._held or (self._held is None and len(self._present) >= MOST):
            return []
        others = tuple(each for each in self._present if each is not self._held)
        return [SetFixtures((*others, self._carried))]

    def outlines(self):
        """Return the outline of its cells."""
        return [box_outline(*self._carried.box)]


def fresh(brush, place):
    """Return the fixture that the brush would put at a place: as wide as the brush, a cell high."""
    column, row = cell((snap(place, brush.diameter)[0] - brush.diameter / 2, place[1]))
    sand = (brush.every, brush.colour) if brush.tool == TAP else ()
    return Fixture(brush.tool, column, row, int(brush.diameter), 1, *sand)


def marks(fixtures, view, px):
    """Return the Marks of fixtures seen through `view`: a lid with a handle is a tap, a basin with a foot a drain.

    px: what a size at scale 1 is in pixels of the screen.
    """
    return tuple(_symbol(each, view, px) for each in fixtures)


def _symbol(fixture, view, px):
    left, top, right, bottom = fixture.box
    (x0, y0), (x1, y1) = view.pixel(left, top), view.pixel(right, bottom)
    middle, half = (x0 + x1) / 2, max(x1 - x0, px(LEAST)) / 2
    x0, x1, lip = middle - half, middle + half - 1, min(half, max(px(2), y1 - y0))
    far, near, way = (y0 - px(2), y0 + lip, -px(STEM)) if fixture.kind == TAP else (y1 + px(1), y1 - lip, px(STEM))
    stem, handle = (middle, far + way), min(half, px(STEM))
    points = [(x0, near), (x0, far), (middle, far), stem, (middle - handle, stem[1]), (middle + handle, stem[1])]
    points += [stem, (middle, far), (x1, far), (x1, near)]
    colour = look.BRIGHT_ACCENT if fixture.kind == TAP else look.RING
    return Mark(tuple((math.floor(x), math.floor(y)) for x, y in points), colour, closed=False)


def _is_near(fixture, place):
    left, top, right, bottom = fixture.box
    return left - NEAR <= place[0] < right + NEAR and top - NEAR <= place[1] < bottom + NEAR
