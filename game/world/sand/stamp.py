"""A stamp: a piece of a world, to be put anywhere in this world or in another one."""

from dataclasses import dataclass, replace

import numpy as np

from game.core import planes as bit_planes
from game.core.paint.primitives import RECTANGLE
from game.world.sand.erasing import is_in_figure
from game.world.sand.fixtures import DRAIN, MOST
from game.world.sand.grain_account import NO_GRAINS
from game.world.sand.material_codes import EMPTY, SAND
from game.world.sand.world import World


@dataclass(frozen=True, eq=False)
class Stamp:
    """Cells by the names of their materials, with the colours of their sand and the taps and drains among them."""

    names: tuple  # of the materials, by code, air first
    cells: np.ndarray  # (H, W) uint8, codes
    colours: np.ndarray | None = None  # (H, W) uint8, of the sand; None where all of it is amber
    fixtures: tuple = ()  # of Fixture, counted from its upper left cell

    def __eq__(self, other):
        """Tell whether another stamp would leave the same."""
        if not isinstance(other, Stamp) or (self.names, self.fixtures) != (other.names, other.fixtures):
            return False
        return np.array_equal(self.cells, other.cells) and np.array_equal(_dyes(self), _dyes(other))

    def __hash__(self):
        return hash((self.names, self.shape, self.cells.tobytes()))

    @property
    def shape(self):
        """(height, width) in cells."""
        return self.cells.shape

    def turned(self, quarters):
        """Return it after so many quarter turns, clockwise."""
        fixtures = tuple(each.turned(quarters, self.shape) for each in self.fixtures)
        return self._changed(lambda cells: np.rot90(cells, -quarters), fixtures)

    def mirrored(self):
        """Return it with left and right exchanged."""
        width = self.shape[1]
        fixtures = tuple(replace(each, x=width - each.x - each.width) for each in self.fixtures)
        return self._changed(np.fliplr, fixtures)

    def _changed(self, change, fixtures):
        colours = None if self.colours is None else np.ascontiguousarray(change(self.colours))
        return Stamp(self.names, np.ascontiguousarray(change(self.cells)), colours, fixtures)


def _dyes(stamp):
    return np.zeros_like(stamp.cells) if stamp.colours is None else stamp.colours


def cut_out(world, box):
    """Return the Stamp of the cells in a box: first column and row, then those after the last; None if there are none.

    It has the taps and drains that erasing the box would take away.
    """
    height, width = world.shape
    left, top, right, bottom = max(box[0], 0), max(box[1], 0), min(box[2], width), min(box[3], height)
    if left >= right or top >= bottom:
        return None
    codes, colours = (np.ascontiguousarray(rows[:, left:right]) for rows in _rows(world, top, bottom))
    inside = (each for each in world.fixtures if is_in_figure(each, RECTANGLE, (left, top, right, bottom)))
    fixtures = tuple(each.moved(-left, -top) for each in inside)
    return Stamp(world.codes.names, codes, colours if colours.any() else None, fixtures)


def put(world, stamp, left, top, air=False):
    """Put a stamp into a world, in place, its upper left cell at a column and row; what lies beyond is left out.

    Materials land by their names; those that the world has not are left out too. air: its empty cells empty those
    below them. Return (the change in `amounts`, whether anything changed).
    """
    fixtures = _with_fixtures(world, stamp, left, top)
    changed, world.fixtures = fixtures != world.fixtures, fixtures
    (height, width), (high, wide) = world.shape, stamp.shape
    first, last, begin, end = max(top, 0), min(top + high, height), max(left, 0), min(left + wide, width)
    if first >= last or begin >= end:
        return NO_GRAINS, changed
    part = slice(first - top, last - top), slice(begin - left, end - left)
    new, old = _landing(stamp, world.codes)[stamp.cells[part]], stamp.cells[part]
    taken = (new != EMPTY) | (air & (old == EMPTY))
    dyes = _dyes(stamp)[part] * (new == SAND) if world.codes.is_sand else np.zeros_like(new)
    return _lay(world, (first, last, begin, end), new, dyes, taken, changed)


def landed(stamp, codes):
    """Return a World of MaterialCodes with what a stamp would leave there, and nothing else."""
    cells = _landing(stamp, codes)[stamp.cells]
    return World.of_codes(cells, codes, 0, _dyes(stamp) * (cells == SAND) if codes.is_sand else None)


def _landing(stamp, codes):
    """Return the code of each of a stamp's codes among MaterialCodes: that of air where there is no such material."""
    return np.array([codes.code(name) or EMPTY for name in stamp.names], np.uint8)


def _lay(world, place, new, dyes, taken, changed):
    """Give cells in rows and columns of a world other codes and colours where they are `taken`."""
    first, last, begin, end = place
    codes, colours = _rows(world, first, last)
    was, had = codes[:, begin:end].copy(), colours[:, begin:end].copy()
    now, has = np.where(taken, new, was), np.where(taken, dyes, had)
    if np.array_equal(was, now) and np.array_equal(had, has):
        return NO_GRAINS, changed
    if has.any() and not world.coloured:
        world.planes = bit_planes.with_colours(world.planes, world.layout)
    codes[:, begin:end], colours[:, begin:end] = now, has
    _write(world, first, codes, colours)
    world.activity.wake(first - 1, last + 1)
    before, after = _amounts(world.codes, was, had), _amounts(world.codes, now, has)
    return tuple((after - before).tolist()), True


def _with_fixtures(world, stamp, left, top):
    """Return the fixtures of a world with those of a stamp that reach it and that its rule has the material for."""
    height, width = world.shape
    known = (each for each in stamp.fixtures if each.kind == DRAIN or world.codes.code(each.material) is not None)
    more = [each.moved(left, top) for each in known]
    fresh = [each for each in more if each.reaches(width, height) and each not in world.fixtures]
    return (*world.fixtures, *fresh[: max(MOST - len(world.fixtures), 0)])


def _amounts(codes, cells, colours):
    """Return how many cells there are of each kind, as `World.amounts` counts them, as an array."""
    if codes.is_sand:
        return np.bincount(colours[cells == SAND], minlength=8)
    filled = np.isin(np.arange(len(codes.names)), list(codes.filled))
    return np.bincount(cells.ravel(), minlength=len(codes.names)) * filled


def _lines(world, top, bottom):
    """Return the words of the plane rows that hold lattice rows, and the layout of those rows alone."""
    where, first = world.layout, top // 2
    rows = slice(first * where.stride, -(-bottom // 2) * where.stride)
    return rows, where._replace(height=min(2 * -(-bottom // 2), where.height) - 2 * first)


def _rows(world, top, bottom):
    """Return the codes and the colours of some rows of a world, (bottom - top, W) uint8; colours are 0 without sand."""
    rows, where = _lines(world, top, bottom)
    part = np.ascontiguousarray(world.planes[:, rows])
    codes = bit_planes.unpack(part, where)
    colours = bit_planes.unpack_colours(part, where) if world.coloured else np.zeros_like(codes)
    above = top % 2
    return codes[above : above + bottom - top], colours[above : above + bottom - top]


def _write(world, top, codes, colours):
    """Write the codes and colours of whole rows, in place."""
    bottom = top + len(codes)
    rows, where = _lines(world, top, bottom)
    first = 2 * (top // 2)
    around = _rows(world, first, first + where.height)
    for whole, own in zip(around, (codes, colours), strict=True):
        whole[top - first : bottom - first] = own
    numbers = [(around[0], bit) for bit in range(where.bits)]
    numbers += [(around[1], bit) for bit in range(len(world.planes) // 4 - where.bits)]
    for start, (cells, bit) in zip(range(0, len(world.planes), 4), numbers, strict=True):
        four = np.ascontiguousarray(world.planes[start : start + 4, rows])
        bit_planes.set_bit(np.ascontiguousarray(cells), bit, four, where)
        world.planes[start : start + 4, rows] = four
