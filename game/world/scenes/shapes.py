"""The shapes a scene is drawn with: what a table [[shape]] says, painted on a lattice of any size."""

from dataclasses import dataclass

import numpy as np

from game.world.files.checked_table import CheckedTable
from game.world.sand.parameters import SIDE, Knob
from game.world.sand.sand_colours import AMBER
from game.world.sand.sand_colours import COLOURS as DYES
from game.world.scenes import geometry
from game.world.scenes.cell_arrays import EMPTY, MATERIALS, SANDS, WALL
from game.world.scenes.hourglass import CURVE, FILL, NECK, THICKNESS, hourglass
from game.world.scenes.hourglass_spec import Glass

PLACE = Knob("place", 0.0, -SIDE.high, SIDE.high, "cells", "a distance from the left or upper side of the scene")
REPEAT = Knob("repeat", 1, 1, 1000, "", "how often a shape is painted", whole=True)
PICK = Knob("seed", 0, 0, 2**31, "", "picks one of the possible patterns", whole=True)
SHARE = Knob("share", 1.0, 0.0, 1.0, "", "part of the places that are taken")
LENGTH = Knob("length", 1.0, 0.01, SIDE.high, "cells", "the size of a shape, or of a part of it")
BOX = ("x", "y", "width", "height")  # a shape's left, top and size; left out, the whole scene
DYE = "dye"  # what is no material: it gives sand another colour and leaves the rest
HOURGLASS = (*BOX, "neck", "curve", "wall", "fill")
BAND = 128  # rows painted at a time: bounds the memory that painting takes on the largest lattice


@dataclass(frozen=True)
class Scale:
    """The scene's own size in cells, and how many cells of the lattice to paint make one of them."""

    width: float
    height: float
    x: float
    y: float


def paint(cells, table, scale):
    """Paint on `cells`, in place, the shape that `table` describes; raise TableError where it does not."""
    kind = table.choice("kind", ("hourglass", *KINDS))
    table = CheckedTable(table.file, table.values, f"{table.where[:-1]} ({kind}).")
    for each in _repeated(table):
        _paint_once(cells, kind, each, scale)


def _repeated(table):
    """Yield the tables of a shape that is painted `repeat` = [across, down] times, a `step` = [x, y] apart."""
    across, down = table.pair("repeat", REPEAT, (1, 1))
    if across * down > REPEAT.high:
        raise table.error("repeat", f"{across}·{down}", f"{REPEAT.high} at most in all")
    x, y = table.pair("step", PLACE, (0.0, 0.0))
    plain = {key: value for key, value in table.values.items() if key not in ("repeat", "step")}
    yield CheckedTable(table.file, plain, table.where)  # checked as it is written, before it is moved
    for number in range(1, across * down):
        by = number % across * x, number // across * y
        yield CheckedTable(table.file, plain | _moved(plain, *by), table.where)


def _moved(values, x, y):
    """Return the keys of a shape that say where it lies, moved."""
    if "points" in values:
        return {"points": [[left + x, top + y] for left, top in values["points"]]}
    return {"x": values.get("x", 0.0) + x, "y": values.get("y", 0.0) + y}


def _paint_once(cells, kind, table, scale):
    if kind == "hourglass":
        _paint_hourglass(cells, table, scale)
        return
    keys, described = KINDS[kind]
    table.allow(("kind", "material", "colour", *keys))
    name = table.choice("material", (*MATERIALS, DYE))
    if "colour" in table and name not in ("sand", DYE):
        raise table.error("colour", f"it beside {name}", f"it only beside sand or {DYE}")
    material = _sand(table) if name in ("sand", DYE) else MATERIALS[name]
    _paint_region(cells, described(table, scale), material, scale, only_sand=name == DYE)


def middle_of_glass(table, height):
    """Return the place of the neck's middle, in cells from the top of a scene of `height`; None for no hourglass."""
    if table.choice("kind", ("hourglass", *KINDS)) != "hourglass":
        return None
    return table.number("y", PLACE, 0.0) + table.number("height", LENGTH, height) / 2


def _sand(table):
    """Return the material that is sand of the colour that the table names."""
    return SANDS[DYES.index(table.choice("colour", DYES, AMBER))]


def _paint_region(cells, shape, material, scale, only_sand):
    """Give `material` to the cells whose centres the region holds, or to those of them that are sand, in place."""
    height, width = cells.shape
    left, right = (int(np.clip(x * scale.x, 0, width)) for x in (shape.left, shape.right + 1 / scale.x))
    top, bottom = (int(np.clip(y * scale.y, 0, height)) for y in (shape.top, shape.bottom + 1 / scale.y))
    x = (np.arange(left, right) + 0.5) / scale.x
    for first in range(top, bottom, BAND):
        rows = slice(first, min(first + BAND, bottom))
        y = (np.arange(rows.start, rows.stop) + 0.5) / scale.y
        with np.errstate(all="ignore"):  # a point a hair from the next one makes an endless slope, and that is right
            held = shape.inside(x, y[:, None])
        part = cells[rows, left:right]
        part[held & (part != EMPTY) & (part != WALL) if only_sand else held] = material


def _paint_hourglass(cells, table, scale):
    table.allow(("kind", *HOURGLASS, "colour"))
    x, y, width, height = _box(table, scale)
    for key, low, size, most in (("width", x, width, scale.width), ("height", y, height, scale.height)):
        if low < 0 or low + size > most:
            raise table.error(key, f"{low:g} + {size:g}", f"a glass within the {most:g} cells of the scene")
    numbers = _numbers_of_glass(table, scale)
    left, top, right, bottom = _box_of_glass(table, scale)
    try:
        sand, walls = hourglass(bottom - top, right - left, *numbers)
    except ValueError:
        raise table.error("width", f"{right - left}×{bottom - top} cells", "at least 5×5 for an hourglass") from None
    box = cells[top:bottom, left:right]
    box[sand], box[walls] = _sand(table), WALL


def only_glass(table, width, height, scale):
    """Return the Glass on a lattice of that size that a shape's table describes; None if it is none or off the middle.

    The table has been painted from before, so that what it says is right.
    """
    if table.values.get("kind") != "hourglass" or not set(table.values) <= {"kind", *HOURGLASS}:
        return None
    left, top, right, bottom = _box_of_glass(table, scale)
    if (right, bottom) != (width - left, height - top):
        return None
    try:
        return Glass(width, height, left, top, *_numbers_of_glass(table, scale))
    except ValueError:  # a neck or a wall as thick on this lattice as no slider goes
        return None


def _box_of_glass(table, scale):
    """Return the first column and row of an hourglass and those after its last."""
    x, y, width, height = _box(table, scale)
    return round(x * scale.x), round(y * scale.y), round((x + width) * scale.x), round((y + height) * scale.y)


def _numbers_of_glass(table, scale):
    """Return neck, curve, wall and fill of an hourglass on the lattice."""
    neck, curve, wall, fill = (table.number(each.name, each, each.default) for each in (NECK, CURVE, THICKNESS, FILL))
    return neck * scale.x, curve, wall * min(scale.x, scale.y), fill


def _rectangle(table, scale):
    return geometry.rectangle(*_seen(_box(table, scale), scale))


def _ellipse(table, scale):
    return geometry.ellipse(*_seen(_box(table, scale), scale))


def _line(table, scale):
    thickness = table.number("thickness", LENGTH, LENGTH.default)
    return geometry.stroke(table.points("points", PLACE, 2), max(thickness, 1 / scale.x, 1 / scale.y) / 2)


def _polygon(table, scale):
    return geometry.polygon(table.points("points", PLACE, 3))


def _bars(table, scale):
    size, across = (table.number(key, LENGTH) for key in ("size", "across"))
    return geometry.bars(*_box(table, scale), max(size, 1 / scale.x), across)


def _pegs(table, scale):
    return geometry.pegs(*_box(table, scale), *(table.number(key, LENGTH) for key in ("size", "across", "down")))


def _slats(table, scale):
    size, thickness = table.number("size", LENGTH), table.number("thickness", LENGTH, LENGTH.default)
    share, seed = table.number("share", SHARE, SHARE.default), table.number("seed", PICK, PICK.default)
    return geometry.slats(*_box(table, scale), size, max(thickness, 1 / scale.x), share, seed)


def _box(table, scale):
    x, y = table.number("x", PLACE, 0.0), table.number("y", PLACE, 0.0)
    return x, y, table.number("width", LENGTH, scale.width), table.number("height", LENGTH, scale.height)


def _seen(box, scale):
    """Return the box, widened about its middle to a cell of the lattice each way: a thin wall must not vanish."""
    x, y, width, height = box
    wider, higher = max(width, 1 / scale.x), max(height, 1 / scale.y)
    return x - (wider - width) / 2, y - (higher - height) / 2, wider, higher


# A kind of shape: the keys it takes beside kind and material, and what makes its table a region.
KINDS = {
    "rectangle": (BOX, _rectangle),
    "ellipse": (BOX, _ellipse),
    "line": (("points", "thickness"), _line),
    "polygon": (("points",), _polygon),
    "bars": ((*BOX, "size", "across"), _bars),
    "pegs": ((*BOX, "size", "across", "down"), _pegs),
    "slats": ((*BOX, "size", "thickness", "share", "seed"), _slats),
}
