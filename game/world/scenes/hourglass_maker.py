"""The hourglass maker: a glass as a scene, a glass for a size or a time, and sand poured from one into another."""

import math
from dataclasses import replace

import numpy as np

from game.world.rules.rule import Rule
from game.world.sand import parameters
from game.world.sand.parameters import Knob
from game.world.scenes.hourglass import NECK, THICKNESS
from game.world.scenes.hourglass_spec import SMALLEST, Glass
from game.world.scenes.scene import Scene

HEIGHT = Knob(
    "size", 240, 24, 1200, "cells", "height of the glass and its surroundings", whole=True, ends=("small", "large")
)
SLIMNESS = 0.75  # the lattice's width as a part of its height
MARGIN = 1 / 9, 1 / 60  # parts of the lattice's width and height that are left free at each side
CURVE = 0.95
WINDOW = 720  # pixels: about as high a new glass is shown

# A glass that suits a time. Sand passes a neck grain by grain at a pace that hardly depends on its width, so a glass
# runs for as many iterations as it has sand, and that grows with the square of its height.
RULE = Rule.with_p(0.75, "balanced")
ITERATIONS = 9400  # that a glass of HEIGHT.default cells takes, as measured; others within a few per cent in proportion
LIVELY, CALM = (10, 240), (1500, 60)  # (seconds, iterations per second) of a short time and a long one
SLOWEST = 30  # iterations per second; sand that moves more slowly stutters


def scene_of(glass, rule=RULE, speed=parameters.SPEED.default):
    """Return the Scene of a Glass, filled."""
    cell = round(min(max(WINDOW / glass.height, parameters.CELL.low), parameters.CELL.high))
    cells = cells_of(glass, rule.codes)
    return Scene("glass", "Your glass", "", cells, rule, speed, cell, glass.height // 2, "glass", glass=glass)


def cells_of(glass, codes):
    """Return the codes of a full Glass, (H, W) uint8, in a world of MaterialCodes."""
    filled, walls = glass.cells()
    code = codes.code(glass.material)
    code = code if code in codes.filled else codes.code(codes.usual)
    return np.where(filled, np.uint8(code), walls * np.uint8(codes.wall))


def glass_within(width, height):
    """Return a glass of the usual shape on a lattice of that size, in cells; raise ValueError if it is too small."""
    margins = (_margin(part * side, side) for part, side in zip(MARGIN, (width, height), strict=True))
    wall = max(THICKNESS.low, THICKNESS.default * math.sqrt(height / HEIGHT.default))
    return Glass(width, height, *margins, neck=NECK.default, curve=CURVE, wall=min(wall, THICKNESS.high))


def glass_for(seconds):
    """Return a glass that runs for about so many seconds at a good pace."""
    height = HEIGHT.default * math.sqrt(seconds * good_pace(seconds) / ITERATIONS)
    height = round(min(max(height, HEIGHT.low), HEIGHT.high))
    return glass_within(round(SLIMNESS * height), height)


def resized(glass, height):
    """Return the glass on a lattice of another height, in proportion as far as a lattice and a glass can be so.

    Neck and wall keep their cells.
    """
    part = height / glass.height
    width = min(max(round(part * glass.width), SMALLEST), parameters.SIDE.high)
    across, down = _margin(part * glass.across, width), _margin(part * glass.down, height)
    return replace(glass, width=width, height=height, across=across, down=down)


def scene_for(seconds):
    """Return the Scene of a glass that runs for about so many seconds, at the pace at which it does."""
    return scene_of(glass_for(seconds), speed=good_pace(seconds))


def good_pace(seconds):
    """Return the iterations per second at which sand looks best over so many seconds: the longer, the calmer."""
    (short_s, fast), (long_s, slow) = LIVELY, CALM
    part = math.log(seconds / short_s) / math.log(long_s / short_s)
    return min(max(fast * (slow / fast) ** part, SLOWEST), fast)


def _margin(cells, side):
    """Return a margin of about so many cells that leaves room for a glass between two of them, if `side` does."""
    return max(0, min(round(cells), (side - SMALLEST) // 2))


def pour(grains, room):
    """Return (grains in their new places, how many found none).

    grains: (h, w) uint8, 0 for none, laid over the middle of the new lattice. room: (H, W) bool, where grains may be.
    One that would lie elsewhere is poured onto the sand of its half, or of the other one if that is full.
    """
    poured = np.zeros(room.shape, np.uint8)
    rows, columns = np.nonzero(grains)
    kinds = grains[rows, columns]
    down, across = ((new - old) // 2 for new, old in zip(room.shape, grains.shape, strict=True))
    rows, columns = rows + down, columns + across
    stays = (rows >= 0) & (rows < room.shape[0]) & (columns >= 0) & (columns < room.shape[1])
    stays[stays] = room[rows[stays], columns[stays]]
    poured[rows[stays], columns[stays]] = kinds[stays]
    middle = room.shape[0] // 2
    for half in (slice(0, middle), slice(middle, None)):
        homeless = ~stays & (rows < middle if half.start == 0 else rows >= middle)
        _settle(poured[half], room[half], kinds[homeless], stays, np.flatnonzero(homeless))
    homeless = np.flatnonzero(~stays)
    _settle(poured, room, kinds[homeless], stays, homeless)
    return poured, int(np.count_nonzero(~stays))


def _settle(poured, room, kinds, stays, numbers):
    """Put grains into the lowest free cells, the nearest to the axis first, in place; mark those that found one."""
    if not len(kinds):
        return
    free = room & (poured == 0)
    below = np.cumsum(np.count_nonzero(free, axis=1)[::-1])[::-1]  # free cells in each row and those under it
    top = max(0, np.count_nonzero(below >= len(kinds)) - 1)  # the rows from here on hold all, if any rows do
    rows, columns = np.nonzero(free[top:])
    rows, axis = rows + top, (room.shape[1] - 1) / 2
    places = np.lexsort((np.abs(columns - axis), -rows))[: len(kinds)]
    poured[rows[places], columns[places]] = kinds[: len(places)]
    stays[numbers[: len(places)]] = True
