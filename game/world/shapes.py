"""The shapes a scene is drawn with: where each kind lies, and how it is painted on a lattice of any size."""

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from game.world.drawing import MATERIALS, SAND, WALL
from game.world.glass import CURVE, FILL, NECK, THICKNESS, hourglass
from game.world.knob import SIDE, Knob
from game.world.table import Table

PLACE = Knob("place", 0.0, -SIDE.high, SIDE.high, "cells", "a distance from the left or upper side of the scene")
LENGTH = Knob("length", 1.0, 0.01, SIDE.high, "cells", "the size of a shape, or of a part of it")
BOX = ("x", "y", "width", "height")  # a shape's left, top and size; left out, the whole scene
BAND = 128  # rows painted at a time: bounds the memory that painting takes on the largest lattice
TIE = 1e-9  # cells: a centre this near to an edge lies on it, so that mirrored shapes stay mirrored


@dataclass(frozen=True)
class Scale:
    """The scene's own size in cells, and how many cells of the lattice to paint make one of them."""

    width: float
    height: float
    x: float
    y: float


@dataclass(frozen=True)
class Region:
    """A part of the plane, in cells of the scene: inside(x, y) is true in it, and it lies within the bounds."""

    left: float
    top: float
    right: float
    bottom: float
    inside: Callable  # of x (W,) and y (H, 1) to (H, W) bool


def paint(cells, table, scale):
    """Paint on `cells`, in place, the shape that `table` describes; raise SceneError where it does not."""
    kind = table.choice("kind", ("hourglass", *REGIONS))
    table = Table(table.file, table.values, f"{table.where[:-1]} ({kind}).")
    if kind == "hourglass":
        _paint_hourglass(cells, table, scale)
        return
    keys, region = REGIONS[kind]
    table.allow(("kind", "material", *keys))
    material = MATERIALS[table.choice("material", tuple(MATERIALS))]
    _paint_region(cells, region(table, scale), material, scale)


def _paint_region(cells, region, material, scale):
    height, width = cells.shape
    left, right = (int(np.clip(x * scale.x, 0, width)) for x in (region.left, region.right + 1 / scale.x))
    top, bottom = (int(np.clip(y * scale.y, 0, height)) for y in (region.top, region.bottom + 1 / scale.y))
    x = (np.arange(left, right) + 0.5) / scale.x
    for first in range(top, bottom, BAND):
        rows = slice(first, min(first + BAND, bottom))
        y = (np.arange(rows.start, rows.stop) + 0.5) / scale.y
        with np.errstate(all="ignore"):  # a point a hair from the next one makes an endless slope, and that is right
            cells[rows, left:right][region.inside(x, y[:, None])] = material


def _paint_hourglass(cells, table, scale):
    table.allow(("kind", *BOX, "neck", "curve", "wall", "fill"))
    x, y, width, height = _box(table, scale)
    for key, low, size, most in (("width", x, width, scale.width), ("height", y, height, scale.height)):
        if low < 0 or low + size > most:
            raise table.error(key, f"{low:g} + {size:g}", f"a glass within the {most:g} cells of the scene")
    neck, wall = table.number("neck", NECK, NECK.default), table.number("wall", THICKNESS, THICKNESS.default)
    curve, fill = table.number("curve", CURVE, CURVE.default), table.number("fill", FILL, FILL.default)
    left, right = round(x * scale.x), round((x + width) * scale.x)
    top, bottom = round(y * scale.y), round((y + height) * scale.y)
    try:
        thickness = wall * min(scale.x, scale.y)
        sand, walls = hourglass(bottom - top, right - left, neck * scale.x, curve, thickness, fill)
    except ValueError:
        raise table.error("width", f"{right - left}×{bottom - top} cells", "at least 5×5 for an hourglass") from None
    box = cells[top:bottom, left:right]
    box[sand], box[walls] = SAND, WALL


def _box(table, scale):
    x, y = table.number("x", PLACE, 0.0), table.number("y", PLACE, 0.0)
    return x, y, table.number("width", LENGTH, scale.width), table.number("height", LENGTH, scale.height)


def _rectangle(table, scale):
    x, y, width, height = _box(table, scale)
    left, width = _seen(x, width, scale.x)
    top, height = _seen(y, height, scale.y)
    right, bottom = left + width, top + height

    def inside(x, y):
        return (x >= left - TIE) & (x < right - TIE) & (y >= top - TIE) & (y < bottom - TIE)

    return Region(left, top, right, bottom, inside)


def _ellipse(table, scale):
    x, y, width, height = _box(table, scale)
    left, width = _seen(x, width, scale.x)
    top, height = _seen(y, height, scale.y)
    middle_x, middle_y = left + width / 2, top + height / 2

    def inside(x, y):
        return ((x - middle_x) / (width / 2)) ** 2 + ((y - middle_y) / (height / 2)) ** 2 <= 1.0 + TIE

    return Region(left, top, left + width, top + height, inside)


def _line(table, scale):
    points = table.points("points", PLACE, 2)
    thickness = table.number("thickness", LENGTH, 1.0)
    reach = max(thickness, 1 / scale.x, 1 / scale.y) / 2
    return _stroke(points, reach)


def _polygon(table, scale):
    points = table.points("points", PLACE, 3)
    outline = _stroke([*points, points[0]], TIE)

    def inside(x, y):
        odd = np.zeros((len(y), len(x)), bool)
        for (x0, y0), (x1, y1) in zip(points, [*points[1:], points[0]], strict=True):
            crossed = (y0 <= y) != (y1 <= y)
            odd ^= crossed & (x < x0 + (y - y0) * ((x1 - x0) / (y1 - y0 or 1.0)))
        return odd | outline.inside(x, y)

    return Region(outline.left, outline.top, outline.right, outline.bottom, inside)


def _pegs(table, scale):
    left, top, width, height = _box(table, scale)
    size, across, down = (table.number(key, LENGTH) for key in ("size", "across", "down"))
    middle = left + width / 2

    def inside(x, y):
        row = np.floor((y - top) / down)
        beside = np.abs((x - middle + across / 2 * (row % 2 + 1)) % across - across / 2)
        above = np.abs((y - top) - (row + 0.5) * down)
        in_box = (x >= left) & (x < left + width) & (y >= top) & (y < top + height)
        return in_box & (beside + above <= size / 2 + TIE)

    return Region(left, top, left + width, top + height, inside)


def _bars(table, scale):
    left, top, width, height = _box(table, scale)
    size, across = (table.number(key, LENGTH) for key in ("size", "across"))
    reach, middle = max(size, 1 / scale.x) / 2, left + width / 2

    def inside(x, y):
        beside = np.abs((x - middle + across / 2) % across - across / 2)
        return (beside <= reach + TIE) & (x >= left) & (x < left + width) & (y >= top) & (y < top + height)

    return Region(left, top, left + width, top + height, inside)


def _stroke(points, reach):
    """Return the region within `reach` cells of the line through `points`."""

    def inside(x, y):
        near = np.zeros((len(y), len(x)), bool)
        for (x0, y0), (x1, y1) in itertools.pairwise(points):
            along_x, along_y = x1 - x0, y1 - y0
            length2 = along_x**2 + along_y**2
            part = np.clip(((x - x0) * along_x + (y - y0) * along_y) / (length2 or 1.0), 0.0, 1.0)
            near |= (x - x0 - part * along_x) ** 2 + (y - y0 - part * along_y) ** 2 <= reach**2 + TIE
        return near

    xs, ys = zip(*points, strict=True)
    return Region(min(xs) - reach, min(ys) - reach, max(xs) + reach, max(ys) + reach, inside)


def _seen(start, size, scale):
    """Return (start, size), widened about its middle to one cell of the lattice: a thin wall must not vanish."""
    wider = max(size, 1 / scale)
    return start - (wider - size) / 2, wider


# A kind of shape: the keys it takes beside kind and material, and what turns its table into a Region.
REGIONS = {
    "rectangle": (BOX, _rectangle),
    "ellipse": (BOX, _ellipse),
    "line": (("points", "thickness"), _line),
    "polygon": (("points",), _polygon),
    "bars": ((*BOX, "size", "across"), _bars),
    "pegs": ((*BOX, "size", "across", "down"), _pegs),
}
