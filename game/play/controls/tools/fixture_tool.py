"""The fixture tool: puts taps and drains where the pointer lets go, and moves them."""

from dataclasses import replace

from game.play.view.overlays.outlines import box_outline
from game.world.sand.fixtures import MOST, TAP, Fixture
from game.world.sand.material_codes import WALL_NAME
from game.world.sand.sand_colours import AMBER
from game.world.sessions.action import ERASE, SetFixtures, cell, snap

NEAR = 1  # cells: a fixture is taken hold of this far beside it


class FixtureTool:
    """Carries a new fixture, or the one that lies where the button goes down, and puts it where it comes up."""

    def __init__(self, brush, place, world):
        self._present, self._shape = world.fixtures, world.shape
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
        fresh_one = self._held is None
        if self._carried == self._held or (fresh_one and len(self._present) >= MOST):
            return []
        if fresh_one and not self._carried.reaches(*self._shape[::-1]):
            return []
        others = tuple(each for each in self._present if each is not self._held)
        return [SetFixtures((*others, self._carried))]

    def outlines(self):
        """Return the outline of its cells."""
        return [box_outline(*self._carried.box)]


def fresh(brush, place):
    """Return the fixture that the brush would put at a place: as wide as the brush, a cell high."""
    column, row = cell((snap(place, brush.diameter)[0] - brush.diameter / 2, place[1]))
    fixture = Fixture(brush.tool, column, row, int(brush.diameter), 1)
    if brush.tool != TAP:
        return fixture
    poured = next(name for name in (brush.material, *brush.materials) if name not in (WALL_NAME, ERASE))
    return replace(fixture, every=brush.every, colour=brush.colour if brush.has_colours else AMBER, material=poured)


def _is_near(fixture, place):
    left, top, right, bottom = fixture.box
    return left - NEAR <= place[0] < right + NEAR and top - NEAR <= place[1] < bottom + NEAR
