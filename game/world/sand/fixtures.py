"""Fixtures: taps that pour a material and drains that swallow all. They belong to a world and are no cells of it."""

import math
from dataclasses import asdict, dataclass, replace
from typing import NamedTuple

import numpy as np

from game.core.paint.ink import Ink
from game.core.paint.primitives import RECTANGLE, figure
from game.world.sand import parameters
from game.world.sand.grain_account import NO_GRAINS, added, split
from game.world.sand.material_codes import EMPTY, SAND_NAME
from game.world.sand.sand_colours import AMBER, DYES

TAP, DRAIN = "tap", "drain"
FIRST_CELL = parameters.Knob(
    "place", 0, -parameters.SIDE.high, parameters.SIDE.high, "cells", "from the left or upper side", whole=True
)
SIDE = parameters.Knob("side", 1, 1, parameters.SIDE.high, "cells", "width or height of a fixture", whole=True)
MOST = 1000  # fixtures of a world


class Traffic(NamedTuple):
    """How many grains of each kind came into a world and left it through its fixtures: tallies."""

    poured: tuple
    swallowed: tuple


@dataclass(frozen=True)
class Fixture:
    """A tap puts a grain into each of its cells that is empty, a drain takes what is in its cells, walls apart.

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
    material: str = SAND_NAME  # that a tap pours

    def __post_init__(self):
        for key in ("x", "y"):  # no lattice has cells beyond that, and files refuse such places
            object.__setattr__(self, key, min(max(getattr(self, key), FIRST_CELL.low), FIRST_CELL.high))
        if self.kind == DRAIN:  # it pours nothing, and files refuse what it would pour
            object.__setattr__(self, "colour", AMBER)
            object.__setattr__(self, "material", SAND_NAME)

    def __str__(self):
        """What digests are made of: amber and sand go without saying, as they did when there was nothing else."""
        return f"Fixture({', '.join(f'{key}={value!r}' for key, value in self.as_dict().items())})"

    @property
    def box(self):
        """First column and row, then those after the last."""
        return self.x, self.y, self.x + self.width, self.y + self.height

    def reaches(self, width, height):
        """Return whether it has a cell in a lattice of that size."""
        left, top, right, bottom = self.box
        return right > 0 and bottom > 0 and left < width and top < height

    def ink(self, codes):
        """Return what it leaves in its cells in a world of MaterialCodes, and which of them take it."""
        if self.kind == TAP:
            code = codes.code(self.material)
            return Ink(code or EMPTY, 1 << EMPTY, colour=DYES.index(self.colour))
        return Ink(EMPTY, sum(1 << code for code in codes.filled))

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
        sides = [int(min(max(1, round(side)), SIDE.high)) for side in (self.width * x, self.height * y)]
        left, top = math.floor(self.x * x), math.floor(self.y * y)
        return replace(self, x=left, y=top, width=sides[0], height=sides[1])

    def as_dict(self):
        """The fields by name, for JSON; without the colour if it is amber, and the material if it is sand."""
        usual = {"colour": AMBER, "material": SAND_NAME}
        return {key: value for key, value in asdict(self).items() if usual.get(key) != value}


def act(world):
    """Let the fixtures act that are due before the world's next iteration, in their order, and return the Traffic."""
    where, poured, swallowed = world.layout, NO_GRAINS, NO_GRAINS
    for each in world.fixtures:
        if world.iteration % each.every == 0:
            tally = world.tally(each.ink(world.codes))
            figure(world.planes, where.height, where.width, where.words, RECTANGLE, *each.box, 0, tally)
            if tally.change.any():
                world.activity.wake(each.y - 1, each.y + each.height + 1)
                came, went = split(world.change(tally))
                poured, swallowed = added(poured, came), added(swallowed, went)
    return Traffic(poured, swallowed)


def changed_bits(fixtures, codes):
    """Return the bits of a cell's code that fixtures change in a world of MaterialCodes, as a number."""
    found = 0
    for each in fixtures:
        found |= codes.code(each.material) or 0 if each.kind == TAP else np.bitwise_or.reduce([0, *codes.filled])
    return int(found)


def act_on_replicas(fixtures, codes, iteration, group):
    """Let the fixtures act that are due before an iteration, in place, on a group of Replicas of MaterialCodes."""
    height, width = group.awake.shape[0] - 2, group.awake.shape[1] - 2
    for each in fixtures:
        left, top, right, bottom = each.box
        left, top, right, bottom = max(left, 0) + 1, max(top, 0) + 1, min(right, width) + 1, min(bottom, height) + 1
        if iteration % each.every or left >= right or top >= bottom:
            continue
        cells, held = group.cells[top:bottom, left:right], group.codes[top:bottom, left:right, None]
        bits = np.flatnonzero(group.changing)
        lasting = int(sum(1 << bit for bit in range(len(group.changing)) if not group.changing[bit]))
        wall = np.full(cells.shape[:2] + cells.shape[3:], group.full)
        empty = group.full & ~np.bitwise_or.reduce(cells, axis=2) & -((held & lasting) == 0).astype(np.uint64)
        for at, bit in enumerate(bits):
            wall &= cells[:, :, at] if codes.wall >> bit & 1 else ~cells[:, :, at]
        wall &= -((held ^ codes.wall) & lasting == 0).astype(np.uint64)
        code = codes.code(each.material) or EMPTY
        for at, bit in enumerate(bits):
            if each.kind != TAP:
                cells[:, :, at] &= wall
            elif code >> bit & 1:
                cells[:, :, at] |= empty
        group.awake[top - 1 : bottom, left - 1 : right] = 1


def pause(fixtures, iteration):
    """Return after how many iterations from `iteration` on the next fixture acts, 1 at least."""
    return min(each.every - iteration % each.every for each in fixtures)
