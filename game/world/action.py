"""What a player can do to a world, as data: made by tools, keys and sliders, applied by one function."""

import math
from dataclasses import dataclass

from game.core.brush import DIAMOND, ROUND, SQUARE
from game.core.figures import ELLIPSE, RECTANGLE
from game.core.ink import ANY, EMPTY, GRAIN, WALL, Ink
from game.world.rule import Rule
from game.world.scene import Scene

MATERIALS = {"erase": EMPTY, "sand": GRAIN, "wall": WALL}
KINDS = {"empty": EMPTY, "sand": GRAIN, "wall": WALL}
SHAPES = {"round": ROUND, "square": SQUARE, "diamond": DIAMOND}
FIGURES = {"rectangle": RECTANGLE, "ellipse": ELLIPSE}


@dataclass(frozen=True)
class Paint:
    """A stroke of the brush from one place to another: `start` and `end` are (column, row), in cells."""

    material: str  # a key of MATERIALS
    start: tuple
    end: tuple
    diameter: int  # cells
    over_walls: bool = False
    shape: str = "round"  # a key of SHAPES
    only: str = ""  # a key of KINDS: no other cells change, and these do whether `over_walls` or not
    spray: int = 0  # 0, or a number that picks a few of the cells: the others stay


@dataclass(frozen=True)
class Draw:
    """A figure between two places (column, row), in cells: those that hold its opposite corners."""

    figure: str  # a key of FIGURES
    material: str  # a key of MATERIALS
    start: tuple
    end: tuple
    edge: int = 0  # cells drawn inwards from the outline; 0 for all
    over_walls: bool = False


@dataclass(frozen=True)
class Fill:
    """Gives a material to the cell at a place (column, row), and to all that touch it through others of its kind."""

    material: str  # a key of MATERIALS
    place: tuple


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
            kinds = 1 << KINDS[action.only] if action.only else taken_by(action.material, action.over_walls)
            ink = Ink(MATERIALS[action.material], kinds, action.spray)
            change = world.stroke(start, end, action.diameter, SHAPES[action.shape], ink)
        case Draw():
            ink = Ink(MATERIALS[action.material], taken_by(action.material, action.over_walls))
            change = world.figure(FIGURES[action.figure], box(action.start, action.end), action.edge, ink)
        case Fill():
            change = world.fill(*cell(action.place), Ink(MATERIALS[action.material]))
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


def cell(place):
    """Return the (column, row) of the cell that holds a place."""
    return math.floor(place[0]), math.floor(place[1])


def box(start, end):
    """Return the cells between two places: first column and row, and those after the last."""
    (x0, y0), (x1, y1) = cell(start), cell(end)
    return min(x0, x1), min(y0, y1), max(x0, x1) + 1, max(y0, y1) + 1


def taken_by(material, over_walls):
    """Return the kinds of cells that take a material, as bits: sand leaves walls standing unless `over_walls`."""
    return ANY & ~(1 << WALL) if material == "sand" and not over_walls else ANY
