"""What a player can do to a world, as data: made by tools, keys and sliders, applied by one function."""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from game.core.paint.ink import ANY, Ink
from game.core.paint.primitives import ELLIPSE, RECTANGLE
from game.core.paint.strokes import DIAMOND, ROUND, SQUARE
from game.world.rules.rule import Rule
from game.world.sand.erasing import is_in_figure, is_under_brush
from game.world.sand.grain_account import NO_GRAINS, added
from game.world.sand.material_codes import EMPTY
from game.world.sand.sand_colours import AMBER, DYES
from game.world.sand.stamp import Stamp, cut_out, put
from game.world.sand.world import World
from game.world.scenes.hourglass_maker import cells_of, pour
from game.world.scenes.hourglass_spec import Glass
from game.world.scenes.scene import Scene
from game.world.sessions.patch import Patch, alike

ERASE, EMPTY_CELLS = "erase", "empty"  # the names of air where it is painted, and where it is painted over
SHAPES = {"round": ROUND, "square": SQUARE, "diamond": DIAMOND}
USUAL_SHAPE = "round"
FIGURES = {"rectangle": RECTANGLE, "ellipse": ELLIPSE}
ANCHORS = {  # the part of a lattice that stays where it is: halves of what is more across and down come before it
    **{"top left": (0, 0), "top": (1, 0), "top right": (2, 0), "left": (0, 1), "middle": (1, 1), "right": (2, 1)},
    **{"bottom left": (0, 2), "bottom": (1, 2), "bottom right": (2, 2)},
}


@dataclass(frozen=True, slots=True)
class Paint:
    """A stroke of the brush from one place to another: `start` and `end` are (column, row), in cells.

    A material that the world has not is not painted.
    """

    material: str  # its name, or ERASE
    start: tuple
    end: tuple
    diameter: int  # cells
    over_walls: bool = False
    shape: str = USUAL_SHAPE  # a key of SHAPES
    only: str = ""  # a material or EMPTY_CELLS: no other cells change, and these do whether `over_walls` or not
    spray: int = 0  # 0, or a number that picks a few of the cells: the others stay
    colour: str = AMBER  # of sand: one of DYES


@dataclass(frozen=True, slots=True)
class Draw:
    """A figure between two places (column, row), in cells: those that hold its opposite corners."""

    figure: str  # a key of FIGURES
    material: str  # its name, or ERASE
    start: tuple
    end: tuple
    edge: int = 0  # cells drawn inwards from the outline; 0 for all
    over_walls: bool = False
    colour: str = AMBER  # of sand: one of DYES


@dataclass(frozen=True, slots=True)
class Fill:
    """Gives a material to the cell at a place (column, row), and to all that touch it through others of its kind."""

    material: str  # its name, or ERASE
    place: tuple
    colour: str = AMBER  # of sand: one of DYES


@dataclass(frozen=True, slots=True)
class Paste:
    """Puts a stamp into the world, its upper left cell at a place (column, row)."""

    stamp: Stamp
    place: tuple
    air: bool = False  # its empty cells empty those below them


@dataclass(frozen=True, slots=True)
class Move:
    """Takes all in a box to another place, mirrored and then turned; the box is that of `Draw`.

    It takes its taps and drains along, and leaves nothing behind.
    """

    start: tuple
    end: tuple
    place: tuple  # (column, row) of the upper left cell there
    quarters: int = 0  # of a turn, clockwise
    mirrored: bool = False


@dataclass(frozen=True, slots=True)
class Resize:
    """Gives the lattice another size, and cuts off what lies outside of it."""

    width: int  # cells
    height: int
    anchor: str  # a key of ANCHORS


@dataclass(frozen=True, slots=True)
class Flip:
    """Turns the lattice over."""


@dataclass(frozen=True, slots=True)
class Turn:
    """Turns the table: the lattice goes round by 90 degrees, clockwise, so many times."""

    quarters: int  # 1, 2 or 3


@dataclass(frozen=True, slots=True)
class Reshape:
    """Puts a glass in place of all walls, and pours the sand into it; `refill`: fills it anew instead."""

    glass: Glass
    refill: bool = False


@dataclass(frozen=True, slots=True)
class SetFixtures:
    """Gives the world other taps and drains in place of those that it has."""

    fixtures: tuple  # of Fixture


@dataclass(frozen=True, slots=True)
class Clear:
    """Takes all sand away and leaves walls and fixtures."""


@dataclass(frozen=True, slots=True)
class SetRule:
    """Changes how sand moves."""

    rule: Rule


@dataclass(frozen=True, slots=True)
class Load:
    """Puts a scene in place of the world."""

    scene: Scene
    seed: int


# Acts that change the planes of a world; others make new ones or leave them.
IN_PLACE = Paint, Draw, Fill, Paste, Move, Clear


class Applied(NamedTuple):
    """What an act comes to."""

    world: World  # the one given, changed in place, or another
    rule: Rule
    grains: tuple  # the tally of the grains that the act put into the world given, less those that it took
    changed: bool  # whether anything about world and rule is not as it was


def apply(action, world, rule):
    """Return (world, rule) after `action`; the world given is changed in place or replaced."""
    return perform(action, world, rule)[:2]


def perform(action, world, rule):
    """Return what `action` makes of a world and a rule; the world given is changed in place or replaced."""
    match action:
        case Paint():
            return Applied(world, rule, *_paint(action, world))
        case Draw():
            return Applied(world, rule, *_draw(action, world))
        case Fill():
            return Applied(world, rule, *_fill(action, world))
        case Paste():
            return Applied(world, rule, *put(world, action.stamp, *cell(action.place), action.air))
        case Move():
            return Applied(world, rule, *_move(action, world))
        case Resize():
            resized = _resize(action, world)
            grains = difference(resized.amounts, world.amounts)
            return Applied(resized, rule, grains, resized.shape != world.shape)
        case Flip():
            before = world.same()
            world.flip()
            return Applied(world, rule, NO_GRAINS, not alike(before, world))
        case Turn():
            turned = world.turned(action.quarters)
            return Applied(turned, rule, NO_GRAINS, not alike(world, turned))
        case Reshape():
            reshaped, grains = _reshape(action, world)
            return Applied(reshaped, rule, grains, not alike(world, reshaped))
        case SetFixtures():
            before, world.fixtures = world.fixtures, action.fixtures
            return Applied(world, rule, NO_GRAINS, before != world.fixtures)
        case Clear():
            before, anything = world.amounts, world.grains > 0
            if anything:
                world.clear()
            return Applied(world, rule, difference(world.amounts, before), anything)
        case SetRule():
            return Applied(world.of(action.rule.codes), action.rule, NO_GRAINS, action.rule != rule)
        case Load():
            loaded, loaded_rule = action.scene.world(action.seed), action.scene.rule
            return Applied(loaded, loaded_rule, NO_GRAINS, loaded_rule != rule or not alike(world, loaded))
    raise TypeError(f"not an action: {action!r}")


def _paint(paint, world):
    """Return the tally of a stroke, and whether it changed anything."""
    start, end = snap(paint.start, paint.diameter), snap(paint.end, paint.diameter)
    ink = _ink(world, paint.material, paint.over_walls, paint.only, paint.spray, paint.colour)
    if ink is None:
        return NO_GRAINS, False
    shape, radius = SHAPES[paint.shape], paint.diameter / 2
    left, top, right, bottom = box(start, end)
    far = math.ceil(radius) + 1  # no cell that the brush reaches lies further from the ends
    before = Patch(world, (left - far, top - far, right + far, bottom + far))
    if paint.material == ERASE and not paint.only and not paint.spray:
        world.fixtures = tuple(each for each in world.fixtures if not is_under_brush(each, shape, start, end, radius))
    return world.stroke(start, end, paint.diameter, shape, ink), before.settle(world)


def _draw(draw, world):
    """Return the tally of a figure, and whether it changed anything."""
    figure, cells = FIGURES[draw.figure], box(draw.start, draw.end)
    ink = _ink(world, draw.material, draw.over_walls, colour=draw.colour)
    if ink is None:
        return NO_GRAINS, False
    before = Patch(world, cells)
    if draw.material == ERASE and not draw.edge:
        world.fixtures = tuple(each for each in world.fixtures if not is_in_figure(each, figure, cells))
    return world.figure(figure, cells, draw.edge, ink), before.settle(world)


def _fill(fill, world):
    """Return the tally of a fill, and whether it changed anything."""
    place, ink = cell(fill.place), _ink(world, fill.material, over_walls=True, colour=fill.colour)
    code = world.code_at(*place)
    may_dye = world.codes.is_sand and ink is not None and (world.coloured or ink.colour)
    if ink is None or code is None or (code == ink.code and not may_dye):
        return NO_GRAINS, False
    height, width = world.shape
    before = Patch(world, (0, 0, width, height)) if code == ink.code else None
    grains = world.fill(*place, ink)
    return grains, before is None or before.settle(world)


def _ink(world, material, over_walls=False, only="", spray=0, colour=AMBER):
    """Return the ink of an act in a world, or None if it has not the material, or not the one painted over."""
    code, taken = code_of(world.codes, material), taken_by(world.codes, material, over_walls)
    if only:
        taken = 1 << code_of(world.codes, only) if code_of(world.codes, only) is not None else 0
    return None if code is None or not taken else Ink(code, taken, spray, DYES.index(colour))


def code_of(codes, name):
    """Return the code of a material among MaterialCodes, or of none; None if there is no such material."""
    return EMPTY if name in (ERASE, EMPTY_CELLS) else codes.code(name)


def difference(after, before):
    """Return the tally of a change from one to another."""
    return tuple(now - then for now, then in zip(after, before, strict=True))


def _reshape(reshape, world):
    before, codes = world.amounts, world.codes
    cells, colours = cells_of(reshape.glass, codes), None
    if not reshape.refill:
        filled = np.isin(world.materials, sorted(codes.filled))
        grains = (world.materials + world.colours) * filled
        poured, _ = pour(grains, reshape.glass.inside())
        walls = (cells == codes.wall) * np.uint8(codes.wall)
        if world.coloured:
            cells, colours = walls + (poured > 0), np.maximum(poured, 1) - 1
        else:
            cells = walls + poured
    world = world.within(cells, colours)
    return world, difference(world.amounts, before)


def _move(move, world):
    """Return the tally of what a move takes and puts, and whether it changed anything."""
    cells, place = box(move.start, move.end), cell(move.place)
    stamp = cut_out(world, cells)
    if stamp is None:
        return NO_GRAINS, False
    stamp = (stamp.mirrored() if move.mirrored else stamp).turned(move.quarters)
    high, wide = stamp.shape
    ends = (*map(min, cells[:2], place), *map(max, cells[2:], (place[0] + wide, place[1] + high)))
    before = Patch(world, ends)
    taken, _ = _draw(Draw("rectangle", ERASE, move.start, move.end), world)
    given, _ = put(world, stamp, *place)
    return added(taken, given), before.settle(world)


def _resize(resize, world):
    more = resize.width - world.shape[1], resize.height - world.shape[0]
    right, down = (cells * halves // 2 for cells, halves in zip(more, ANCHORS[resize.anchor], strict=True))
    return world.resized(resize.height, resize.width, right, down)


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


def taken_by(codes, material, over_walls):
    """Return the codes of the cells that take a material, as bits: all but an eraser and walls leave walls standing."""
    return ANY if over_walls or material in (ERASE, codes.names[codes.wall]) else ANY & ~(1 << codes.wall)
