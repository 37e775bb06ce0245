"""An hourglass as numbers: the one in the middle of a lattice that the maker's sliders describe."""

from dataclasses import asdict, dataclass, fields
from functools import lru_cache

import numpy as np

from game.world.sand import parameters
from game.world.sand.parameters import Knob
from game.world.scenes.hourglass import CURVE, FILL, NECK, THICKNESS, hourglass

SMALLEST = 5  # cells each way


@dataclass(frozen=True)
class Glass:
    """An hourglass as far from the left of its lattice as from the right, and from the top as from the bottom.

    Raises ValueError for numbers out of range.
    """

    width: int  # of the lattice, cells
    height: int
    across: int  # cells left free at the left and right
    down: int  # above and below
    neck: float = NECK.default
    curve: float = CURVE.default
    wall: float = THICKNESS.default
    fill: float = FILL.default
    material: str = ""  # what it is filled with, if the world has that; else sand, or what its materials begin with

    def __post_init__(self):
        for each in KNOBS:
            object.__setattr__(self, each.name, each.check(getattr(self, each.name)))
        for side, margin in ((self.width, self.across), (self.height, self.down)):
            if side - 2 * margin < SMALLEST:
                raise ValueError(f"a glass must have at least {SMALLEST} cells each way, got {side - 2 * margin}")

    def cells(self):
        """Return (sand, walls), two (height, width) bool arrays that are not writable, the upper bulb filled."""
        return _cells(self)

    def inside(self):
        """Return where sand can be, (height, width) bool, not writable: the cells with glass at both sides."""
        return _inside(self)

    def as_dict(self):
        """The fields by name, without a material that is left to the world."""
        return {name: value for name, value in asdict(self).items() if value != ""}


def _margin(name):
    return Knob(name, 0, 0, parameters.SIDE.high // 2, "cells", "room beside the glass", whole=True)


def _side(name):
    return Knob(
        name,
        parameters.SIDE.default,
        parameters.SIDE.low,
        parameters.SIDE.high,
        "cells",
        "a side of the lattice",
        whole=True,
    )


KNOBS = _side("width"), _side("height"), _margin("across"), _margin("down"), NECK, CURVE, THICKNESS, FILL


def read(table):
    """Return the Glass that a CheckedTable spells as `as_dict` does; raise TableError where it does not."""
    table.allow([field.name for field in fields(Glass)])
    numbers = {each.name: table.number(each.name, each) for each in KNOBS}
    try:
        return Glass(**numbers, material=table.line("material", ""))
    except ValueError as error:
        raise table.error("width", f"{numbers['width']}×{numbers['height']}", str(error)) from None


@lru_cache(maxsize=4)
def _cells(glass):
    sand, walls = np.zeros((2, glass.height, glass.width), bool)
    box = slice(glass.down, glass.height - glass.down), slice(glass.across, glass.width - glass.across)
    high, wide = walls[box].shape
    sand[box], walls[box] = hourglass(high, wide, glass.neck, glass.curve, glass.wall, glass.fill)
    sand.flags.writeable = walls.flags.writeable = False
    return sand, walls


@lru_cache(maxsize=4)
def _inside(glass):
    walls = glass.cells()[1]
    columns, first = np.arange(glass.width), walls.argmax(axis=1)
    last = np.where(walls.any(axis=1), glass.width - 1 - walls[:, ::-1].argmax(axis=1), -1)
    inside = (columns > first[:, None]) & (columns < last[:, None]) & ~walls
    inside.flags.writeable = False
    return inside
