"""The shapes a scene is drawn with: each table [[shape]] read once, then painted on a lattice of any size."""

from dataclasses import dataclass

import numpy as np

from game.world.files.checked_table import CheckedTable
from game.world.sand.parameters import SIDE, Knob
from game.world.sand.sand_colours import AMBER
from game.world.sand.sand_colours import COLOURS as DYES
from game.world.scenes import geometry
from game.world.scenes.cell_arrays import EMPTY, SAND, SAND_PALETTE, CellPalette
from game.world.scenes.hourglass import CURVE, FILL, NECK, THICKNESS, hourglass
from game.world.scenes.hourglass_spec import Glass

PLACE = Knob("place", 0.0, -SIDE.high, SIDE.high, "cells", "a distance from the left or upper side of the scene")
REPEAT = Knob("repeat", 1, 1, 1000, "", "how often a shape is painted", whole=True)
PICK = Knob("seed", 0, 0, 2**31, "", "picks one of the possible patterns", whole=True)
SHARE = Knob("share", 1.0, 0.0, 1.0, "", "part of the places that are taken")
LENGTH = Knob("length", 1.0, 0.01, SIDE.high, "cells", "the size of a shape, or of a part of it")
BOX = ("x", "y", "width", "height")  # a shape's left, top and size; left out, the whole scene
DYE = "dye"  # not a material: it gives sand another colour and leaves the rest
HOURGLASS = (*BOX, "neck", "curve", "wall", "fill")
MOST_WORK = 2**32  # cells that all shapes of a scene may come over, or minutes go by
LEAST_WORK = 2**12  # cells that reading a point or painting a shape is worth
BAND = 128  # rows painted at a time: bounds the memory that painting takes on the largest lattice


@dataclass(frozen=True)
class Scale:
    """A scene's own size, the size of the lattice that it is painted on, in cells, and what its cells can hold."""

    own_width: int
    own_height: int
    width: int
    height: int
    palette: CellPalette = SAND_PALETTE

    @property
    def x(self):
        """Columns of the lattice to a cell of the scene."""
        return self.width / self.own_width

    @property
    def y(self):
        """Rows of the lattice to a cell of the scene."""
        return self.height / self.own_height


@dataclass(frozen=True)
class Shape:
    """A region that takes a material or a colour."""

    region: geometry.Region
    number: int  # of the CellPalette
    only_sand: bool  # leaves all but sand as it is


@dataclass(frozen=True)
class HourglassShape:
    """An hourglass, in cells of the scene's own size, with sand of a material."""

    x: float
    y: float
    width: float
    height: float
    neck: float
    curve: float
    wall: float
    fill: float
    number: int  # of the CellPalette
    table: CheckedTable  # that spells it, for what is found wrong as it is painted

    def box_on(self, scale):
        """Return its first column and row on a lattice, and those after its last."""
        left, top, right, bottom = self.x, self.y, self.x + self.width, self.y + self.height
        return round(left * scale.x), round(top * scale.y), round(right * scale.x), round(bottom * scale.y)

    def numbers_on(self, scale):
        """Return neck, curve, wall and fill on a lattice."""
        return self.neck * scale.x, self.curve, self.wall * min(scale.x, scale.y), self.fill


def read_shapes(table, scale):
    """Yield what a table [[shape]] spells, one shape for each time it is repeated; raise TableError if it is wrong."""
    kind = table.choice("kind", ("hourglass", *KINDS))
    table = CheckedTable(table.file, table.values, f"{table.where[:-1]} ({kind}).")
    read = _read_hourglass if kind == "hourglass" else _read_shape
    return (read(each, scale) for each in _repeated(table))


def neck_of(shapes, scale):
    """Return the row on a lattice in the middle of the first hourglass, or None where there is none."""
    glasses = (each for each in shapes if isinstance(each, HourglassShape))
    return next((round((each.y + each.height / 2) * scale.y) for each in glasses), None)


def glass_of(shapes, scale):
    """Return the Glass on a lattice that is all there is and in the middle of it; None for others.

    If its sand has a colour it is none.
    """
    if len(shapes) != 1 or not isinstance(shapes[0], HourglassShape):
        return None
    codes, number = scale.palette.codes, shapes[0].number
    if codes.is_sand and number != SAND:
        return None
    material = "" if codes.is_sand else codes.names[number]
    left, top, right, bottom = shapes[0].box_on(scale)
    if (right, bottom) != (scale.width - left, scale.height - top):
        return None
    try:
        return Glass(scale.width, scale.height, left, top, *shapes[0].numbers_on(scale), material)
    except ValueError:  # no slider makes a neck as wide, or a wall as thick, as it is on this lattice
        return None


def work_of(shape, scale):
    """Return about how many cells of a lattice are come over as a shape is painted."""
    if isinstance(shape, HourglassShape):
        left, top, right, bottom = shape.box_on(scale)
        return LEAST_WORK + (right - left) * (bottom - top)
    region = shape.region
    boxes = np.array(region.parts or [(region.left, region.top, region.right, region.bottom)])
    left, right = (np.clip(boxes[:, side] * scale.x, 0, scale.width) for side in (0, 2))
    top, bottom = (np.clip(boxes[:, side] * scale.y, 0, scale.height) for side in (1, 3))
    return int(((right - left + 1) * (bottom - top + 1)).sum()) + LEAST_WORK * len(boxes)


def paint(cells, shape, scale):
    """Paint a shape on the cells of a lattice, in place; raise TableError where an hourglass is too small there."""
    if isinstance(shape, HourglassShape):
        _paint_hourglass(cells, shape, scale)
    else:
        _paint_region(cells, shape, scale)


def _repeated(table):
    """Yield the tables of a shape that is painted `repeat` = [across, down] times, a `step` = [x, y] apart."""
    across, down = table.pair("repeat", REPEAT, (1, 1))
    if across * down > REPEAT.high:
        raise table.error("repeat", f"{across}·{down}", f"{REPEAT.high} at most in all")
    x, y = table.pair("step", PLACE, (0.0, 0.0))
    plain = {key: value for key, value in table.values.items() if key not in ("repeat", "step")}
    yield CheckedTable(table.file, plain, table.where)  # read as it is written, before it is moved
    for number in range(1, across * down):
        by = number % across * x, number // across * y
        yield CheckedTable(table.file, plain | _moved(plain, *by), table.where)


def _moved(values, x, y):
    """Return the keys of a shape that say where it lies, moved."""
    if "points" in values:
        return {"points": [[left + x, top + y] for left, top in values["points"]]}
    return {"x": values.get("x", 0.0) + x, "y": values.get("y", 0.0) + y}


def _read_shape(table, scale):
    keys, read_region = KINDS[table.values["kind"]]
    table.allow(("kind", "material", "colour", *keys))
    palette = scale.palette
    name = table.choice("material", (*palette.names, *([DYE] if palette.sands else [])))
    if "colour" in table and (name not in ("sand", DYE) or not palette.sands):
        wanted = f"it only beside sand or {DYE}" if palette.sands else "it only in a scene of the rule of sand"
        raise table.error("colour", f"it beside {name}", wanted)
    number = _sand(table, palette) if name in ("sand", DYE) and palette.sands else palette.number(name)
    return Shape(read_region(table, scale), number, only_sand=name == DYE)


def _read_hourglass(table, scale):
    table.allow(("kind", *HOURGLASS, "colour" if scale.palette.sands else "material"))
    x, y, width, height = _box(table, scale)
    for key, low, size, most in (("width", x, width, scale.own_width), ("height", y, height, scale.own_height)):
        if low < 0 or low + size > most:
            raise table.error(key, f"{low:g} + {size:g}", f"a glass within the {most:g} cells of the scene")
    numbers = (table.number(each.name, each, each.default) for each in (NECK, CURVE, THICKNESS, FILL))
    return HourglassShape(x, y, width, height, *numbers, _filling(table, scale.palette), table)


def _filling(table, palette):
    """Return the number of what a glass is filled with: sand of a colour, or a material of the rule."""
    if palette.sands:
        return _sand(table, palette)
    names = [palette.names[code] for code in sorted(palette.codes.filled)]
    return palette.number(table.choice("material", names, palette.codes.usual))


def _sand(table, palette):
    """Return the number of sand of the colour that the table names."""
    return palette.sands[DYES.index(table.choice("colour", DYES, AMBER))]


def _paint_region(cells, shape, scale):
    """Give the shape's material to the cells whose centres the region holds, in place."""
    (height, width), region = cells.shape, shape.region
    left, right = (int(np.clip(x * scale.x, 0, width)) for x in (region.left, region.right + 1 / scale.x))
    top, bottom = (int(np.clip(y * scale.y, 0, height)) for y in (region.top, region.bottom + 1 / scale.y))
    x = (np.arange(left, right) + 0.5) / scale.x
    for first in range(top, bottom, BAND):
        rows = slice(first, min(first + BAND, bottom))
        y = (np.arange(rows.start, rows.stop) + 0.5) / scale.y
        with np.errstate(all="ignore"):  # between two points a hair apart, the slope is infinite, and that is right
            held = region.inside(x, y[:, None])
        part = cells[rows, left:right]
        if shape.only_sand:
            held = held & (part != EMPTY) & (part != scale.palette.wall)
        _fill(part, held, shape.number)


def _fill(part, held, number):
    """Give `number` to the cells that are held, in place; those of a rectangle at once, which is ten times as quick."""
    columns = np.flatnonzero(held[0])
    if len(columns) and np.count_nonzero(held) == len(held) * len(columns):
        first, after = columns[0], columns[-1] + 1
        if after - first == len(columns) and held[:, first:after].all():
            part[:, first:after] = number
            return
    np.copyto(part, number, where=held)


def _paint_hourglass(cells, shape, scale):
    left, top, right, bottom = shape.box_on(scale)
    try:
        sand, walls = hourglass(bottom - top, right - left, *shape.numbers_on(scale))
    except ValueError:
        found = f"{right - left}×{bottom - top} cells"
        raise shape.table.error("width", found, "at least 5×5 for an hourglass") from None
    box = cells[top:bottom, left:right]
    box[sand], box[walls] = shape.number, scale.palette.wall


def _rectangle(table, scale):
    return geometry.rectangle(*_seen(_box(table, scale), scale))


def _ellipse(table, scale):
    return geometry.ellipse(*_seen(_box(table, scale), scale))


def _line(table, scale):
    thickness, points = table.number("thickness", LENGTH, LENGTH.default), table.points("points", PLACE, 2)
    return geometry.stroke(points, max(thickness, 1 / scale.x, 1 / scale.y) / 2)


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
    return x, y, table.number("width", LENGTH, scale.own_width), table.number("height", LENGTH, scale.own_height)


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
