"""Fixtures: taps that pour sand and drains that swallow it. They belong to a world and are no cells of it."""

import math
from dataclasses import asdict, dataclass, replace
from typing import NamedTuple

from game.core.paint.ink import EMPTY, GRAIN, Ink, by_colour
from game.core.paint.primitives import RECTANGLE, figure
from game.world.sand import parameters
from game.world.sand.grain_account import NO_GRAINS, added, split
from game.world.sand.sand_codes import WALL
from game.world.sand.sand_colours import AMBER, DYES

TAP, DRAIN = "tap", "drain"
FIRST_CELL = parameters.Knob(
    "place", 0, -parameters.SIDE.high, parameters.SIDE.high, "cells", "from the left or upper side", whole=True
)
SIDE = parameters.Knob("side", 1, 1, parameters.SIDE.high, "cells", "width or height of a fixture", whole=True)
MOST = 1000  # fixtures of a world


class Traffic(NamedTuple):
    """How many grains of each colour came into a world and left it through its fixtures: tuples of eight."""

    poured: tuple
    swallowed: tuple


@dataclass(frozen=True)
class Fixture:
    """A tap puts a grain into each of its cells that is empty, a drain takes the sand in its cells.

    It does so before each iteration whose number is a multiple of `every`. Its cells are a rectangle, which may reach
    out of the lattice.
    """

    kind: str  # TAP or DRAIN
    x: int  # its first column
    y: int  # its first row
    width: int = 1  # cells
    height: int = 1
    every: int = 1  # iterations
    colour: str = AMBER  # of the sand that a tap pours: one of DYES

    def __post_init__(self):
        for key in ("x", "y"):  # no lattice has cells beyond that, and files refuse such places
            object.__setattr__(self, key, min(max(getattr(self, key), FIRST_CELL.low), FIRST_CELL.high))

    def __str__(self):
        """What digests are made of: amber goes without saying, as it did before taps had colours."""
        return f"Fixture({', '.join(f'{key}={value!r}' for key, value in self.as_dict().items())})"

    @property
    def box(self):
        """First column and row, then those after the last."""
        return self.x, self.y, self.x + self.width, self.y + self.height

    @property
    def ink(self):
        """What it leaves in its cells, and which of them take it."""
        if self.kind == TAP:
            return Ink(GRAIN, 1 << EMPTY, colour=DYES.index(self.colour))
        return Ink(EMPTY, 1 << GRAIN)

    def moved(self, right, down):
        """Return it so many cells away."""
        return replace(self, x=self.x + right, y=self.y + down)

    def turned(self, quarters, shape):
        """Return it as it is after so many quarter turns, clockwise, of a lattice of `shape` (height, width)."""
        height, width = shape
        if quarters % 4 == 0:
            return self
        turned = replace(self, x=height - self.y - self.height, y=self.x, width=self.height, height=self.width)
        return turned.turned(quarters % 4 - 1, (width, height))

    def scaled(self, x, y):
        """Return it on a lattice so many times as wide and as high."""
        sides = (int(min(max(1, round(side)), SIDE.high)) for side in (self.width * x, self.height * y))
        return Fixture(self.kind, math.floor(self.x * x), math.floor(self.y * y), *sides, self.every, self.colour)

    def as_dict(self):
        """The fields by name, for JSON; without the colour if it is amber."""
        fields = asdict(self)
        if self.colour == AMBER:
            del fields["colour"]
        return fields


def act(world):
    """Let the fixtures act that are due before the world's next iteration, in their order, and return the Traffic."""
    where, poured, swallowed = world.layout, NO_GRAINS, NO_GRAINS
    for each in world.fixtures:
        if world.iteration % each.every == 0:
            ink = world.mixed(each.ink)
            change = figure(world.planes, where.height, where.width, where.words, RECTANGLE, *each.box, 0, ink)
            if change:
                world.activity.wake(each.y - 1, each.y + each.height + 1)
                came, went = split(by_colour(change, ink))
                poured, swallowed = added(poured, came), added(swallowed, went)
    return Traffic(poured, swallowed)


def act_on_replicas(fixtures, iteration, group):
    """Let the fixtures act that are due before an iteration, in place, on a group of Replicas."""
    height, width = group.awake.shape[0] - 2, group.awake.shape[1] - 2
    for each in fixtures:
        left, top, right, bottom = each.box
        left, top, right, bottom = max(left, 0) + 1, max(top, 0) + 1, min(right, width) + 1, min(bottom, height) + 1
        if iteration % each.every or left >= right or top >= bottom:
            continue
        free = group.codes[top:bottom, left:right, None] != WALL
        group.cells[top:bottom, left:right, 0] = group.full * free if each.kind == TAP else 0
        group.awake[top - 1 : bottom, left - 1 : right] = 1


def pause(fixtures, iteration):
    """Return after how many iterations from `iteration` on the next fixture acts, 1 at least."""
    return min(each.every - iteration % each.every for each in fixtures)
