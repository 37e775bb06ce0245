"""The hourglass maker: the scene that a glass makes, and the glass that suits a size or a time."""

import math
from dataclasses import replace

from game.world.sand import parameters
from game.world.sand.parameters import Knob
from game.world.sand.rule import Rule
from game.world.scenes.hourglass import NECK, THICKNESS
from game.world.scenes.hourglass_spec import SMALLEST, Glass
from game.world.scenes.scene import Scene

HEIGHT = Knob("size", 240, 24, 1200, "cells", "height of the glass and its surroundings", whole=True)
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
    """Return the Scene of a Glass."""
    sand, walls = glass.cells()
    cell = round(min(max(WINDOW / glass.height, parameters.CELL.low), parameters.CELL.high))
    return Scene(
        "glass", "Your glass", "", sand, walls, rule, speed, cell, neck=glass.height // 2, made_of="glass", glass=glass
    )


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


def good_pace(seconds):
    """Return the iterations per second at which sand looks best over so many seconds: the longer, the calmer."""
    (short_s, fast), (long_s, slow) = LIVELY, CALM
    part = math.log(seconds / short_s) / math.log(long_s / short_s)
    return min(max(fast * (slow / fast) ** part, SLOWEST), fast)


def _margin(cells, side):
    """Return a margin of about so many cells that leaves room for a glass between two of them, if `side` does."""
    return max(0, min(round(cells), (side - SMALLEST) // 2))
