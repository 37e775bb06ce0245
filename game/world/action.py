"""What a player can do to a world, as data: made by tools, keys and sliders, applied by one function."""

import math
from dataclasses import dataclass

from game.core import brush
from game.world.rule import Rule
from game.world.scene import Scene

MATERIALS = {"erase": brush.ERASE, "sand": brush.PAINT_SAND, "wall": brush.PAINT_WALL}


@dataclass(frozen=True)
class Paint:
    """A stroke of the brush from one place to another: `start` and `end` are (column, row), in cells."""

    material: str  # a key of MATERIALS
    start: tuple
    end: tuple
    diameter: int  # cells
    over_walls: bool = False


@dataclass(frozen=True)
class Flip:
    """Turns the lattice over."""


@dataclass(frozen=True)
class Clear:
    """Takes all sand away and leaves the walls."""


@dataclass(frozen=True)
class SetRule:
    """Changes how sand moves."""

    rule: Rule


@dataclass(frozen=True)
class Load:
    """Puts a scene in place of the world."""

    scene: Scene
    seed: int


def apply(action, world, rule):
    """Return (world, rule) after `action`; the world given is changed in place or replaced."""
    return perform(action, world, rule)[:2]


def perform(action, world, rule):
    """Return (world, rule, change) as `apply` does; change: grains that the act put into the world given, or took."""
    change = 0
    match action:
        case Paint():
            start, end = snap(action.start, action.diameter), snap(action.end, action.diameter)
            change = world.stroke(start, end, action.diameter, MATERIALS[action.material], action.over_walls)
        case Flip():
            world.flip()
        case Clear():
            change = -world.grains
            world.clear()
        case SetRule():
            rule = action.rule
        case Load():
            world, rule = action.scene.world(action.seed), action.scene.rule
        case _:
            raise TypeError(f"not an action: {action!r}")
    return world, rule, change


def snap(place, diameter):
    """Return the nearest place to centre a brush of `diameter` cells: a cell's middle if odd, a corner if even."""
    return tuple(math.floor(part) + 0.5 if diameter % 2 else float(round(part)) for part in place)
