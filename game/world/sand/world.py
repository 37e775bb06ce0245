"""The world: bit planes, an iteration and a seed. With the rule, they decide its whole future."""

import hashlib
import math
from dataclasses import replace

import numpy as np

from game.core import planes as bit_planes
from game.core.paint.flood_fill import colour_of, flood, kind_of
from game.core.paint.ink import EMPTY, GRAIN, RAINBOW, Ink, by_colour
from game.core.paint.primitives import figure
from game.core.paint.strokes import stroke
from game.world.sand import parameters
from game.world.sand.active_bands import ActiveBands

RAINBOW_PACE = 192  # iterations until the rainbow's stripes have changed by one colour


class World:
    """A lattice of cells, each empty, sand or wall, at one moment.

    Make one with `World.from_cells`. Everything random that will happen to it is decided by `seed` and `iteration`.
    """

    __slots__ = ("activity", "fixtures", "iteration", "layout", "planes", "seed")

    def __init__(self, planes, layout, iteration, seed, fixtures=()):
        self.planes = planes  # uint64: sand, walls, walls for odd x; colours, if any grain ever had one
        self.layout = layout
        self.iteration = iteration  # iterations since the start, a non-negative int of any size
        self.seed = seed  # in [0, 2**64)
        self.fixtures = fixtures  # a tuple of Fixture: taps and drains
        self.activity = ActiveBands(layout)

    @classmethod
    def from_cells(cls, sand, walls, seed=0, colours=None):
        """Return a world with sand and walls where two (H, W) bool arrays say so, at iteration 0.

        H and W are in [1, 16384]; seed is in [0, 2**64). colours: (H, W) uint8, the colour of each grain in [0, 8), a
        place in `sand_colours.COLOURS`, and 0 where there is no sand; all 0 if left out. Raises ValueError for other
        shapes, dtypes or seeds, for a cell that is both sand and wall, and for unknown colours.
        """
        sand, walls = check_cells(sand, walls)
        if colours is not None:
            colours = check_colours(colours, sand)
        planes = bit_planes.pack(sand, walls, colours if colours is not None and colours.any() else None)
        return cls(planes, bit_planes.layout(*sand.shape), 0, parameters.SEED.check(seed))

    @property
    def shape(self):
        """(height, width) in cells."""
        return self.layout.height, self.layout.width

    @property
    def sand(self):
        """Where sand is: a new (H, W) bool array."""
        return bit_planes.unpack(self.planes, self.layout, bit_planes.SAND)

    @property
    def walls(self):
        """Where walls are: a new (H, W) bool array."""
        return bit_planes.unpack(self.planes, self.layout, bit_planes.WALLS)

    @property
    def grains(self):
        """The number of cells that hold sand."""
        return bit_planes.count(self.planes, self.layout, bit_planes.SAND)

    @property
    def coloured(self):
        """Whether the world carries colours: it does from the first coloured grain until it is cleared."""
        return len(self.planes) > bit_planes.PLANES

    @property
    def colours(self):
        """The colour of each grain, 0 where there is no sand: a new (H, W) uint8 array."""
        return bit_planes.unpack_colours(self.planes, self.layout)

    @property
    def grains_by_colour(self):
        """The number of grains of each colour: a tuple of eight."""
        return tuple(bit_planes.count_colours(self.planes, self.layout))

    def copy(self):
        """Return a world of its own with the same cells, iteration and seed."""
        planes = bit_planes.empty(self.layout, len(self.planes))
        planes[:] = self.planes
        return World(planes, self.layout, self.iteration, self.seed, self.fixtures)

    def same(self):
        """Return another World of the same planes: what this one is, until a stroke or an iteration changes them."""
        return World(self.planes, self.layout, self.iteration, self.seed, self.fixtures)

    def __reduce__(self):
        """Let `copy`, `deepcopy` and `pickle` make what `copy` does: a world that shares nothing with this one."""
        return _again, (self.planes, self.layout, self.iteration, self.seed, self.fixtures)

    def flip(self):
        """Turn the lattice by 180 degrees, in place; twice is the identity."""
        self.planes = bit_planes.turned(self.planes, self.layout, 2)
        self.fixtures = tuple(each.turned(2, self.shape) for each in self.fixtures)
        self.activity.wake()

    def turned(self, quarters):
        """Return the world after so many quarter turns, clockwise: a new one, its height and width exchanged if odd."""
        height, width = self.shape[::-1] if quarters % 2 else self.shape
        planes, layout = bit_planes.turned(self.planes, self.layout, quarters), bit_planes.layout(height, width)
        fixtures = tuple(each.turned(quarters, self.shape) for each in self.fixtures)
        return World(planes, layout, self.iteration, self.seed, fixtures)

    def within(self, sand, walls, colours=None):
        """Return the world with other cells, its middle where it was: a new one at the same iteration.

        sand, walls: (H, W) bool. colours: (H, W) uint8, or None for a world without.
        """
        down, across = ((new - old) // 2 for new, old in zip(sand.shape, self.shape, strict=True))
        fixtures = tuple(replace(each, x=each.x + across, y=each.y + down) for each in self.fixtures)
        layout = bit_planes.layout(*sand.shape)
        return World(bit_planes.pack(sand, walls, colours), layout, self.iteration, self.seed, fixtures)

    def clear(self):
        """Take all sand away, with its colours, and leave the walls, in place."""
        if self.coloured:
            self.planes = bit_planes.without_colours(self.planes, self.layout)
        self.planes[bit_planes.SAND : bit_planes.WALLS] = 0
        self.activity.wake()

    def stroke(self, start, end, diameter, shape, ink):
        """Give `ink` to the cells that a brush covers on its way from one place (column, row) to another.

        diameter: in cells. shape: `ROUND`, `SQUARE` or `DIAMOND` of `core.paint.strokes`. Return the change in the
        grains of each colour, a tuple of eight.
        """
        where, radius, ink = self.layout, diameter / 2, self.mixed(ink)
        rows = start[1], end[1]
        self.activity.wake(math.floor(min(rows) - radius) - 1, math.ceil(max(rows) + radius) + 2)
        change = stroke(self.planes, where.height, where.width, where.words, *start, *end, radius, shape, ink)
        return by_colour(change, ink)

    def figure(self, kind, box, edge, ink):
        """Give `ink` to the cells of a figure, or only to those up to `edge` cells from its outline; 0 for all.

        kind: `RECTANGLE` or `ELLIPSE` of `core.paint.primitives`. box: first column and row, then those after the last.
        Return the change in the grains of each colour, a tuple of eight.
        """
        where, ink = self.layout, self.mixed(ink)
        self.activity.wake(box[1] - 1, box[3] + 1)
        change = figure(self.planes, where.height, where.width, where.words, kind, *box, edge, ink)
        return by_colour(change, ink)

    def fill(self, column, row, ink):
        """Give `ink` to a cell, and to all cells connected with it through cells of its kind.

        Return the change in the grains of each colour, a tuple of eight.
        """
        if self.kind_at(column, row) is None:
            return by_colour(0, Ink(EMPTY))
        ink = self.mixed(ink)
        change, top, bottom = flood(self.planes, self.layout, column, row, ink)
        self.activity.wake(top - 1, bottom + 1)
        return by_colour(change, ink)

    def mixed(self, ink):
        """Return the ink as kernels need it for this world: with room to count colours, or without a colour.

        The first coloured ink gives the world its planes of colours.
        """
        if ink.colour and ink.material == GRAIN and not self.coloured:
            self.planes = bit_planes.with_colours(self.planes, self.layout)
        if not self.coloured:
            return ink._replace(colour=None, tally=None)
        first = self.iteration // RAINBOW_PACE % RAINBOW if ink.colour == RAINBOW else 0
        return ink._replace(colour=ink.colour + first, tally=np.zeros(RAINBOW, np.int64))

    def kind_at(self, column, row):
        """Return the kind of a cell, `EMPTY`, `GRAIN` or `WALL` of `core.paint.ink`; None outside of the lattice."""
        height, width = self.shape
        if not (0 <= column < width and 0 <= row < height):
            return None
        return kind_of(self.planes, self.layout, column, row)

    def colour_at(self, column, row):
        """Return the number of the colour of a cell's sand, 0 where there is none."""
        if not self.coloured or self.kind_at(column, row) != GRAIN:
            return 0
        return colour_of(self.planes, self.layout, column, row)

    def digest(self):
        """Return 32 hex digits that name all that decides the future: shape, cells, seed, iteration and fixtures."""
        digest = hashlib.blake2b(digest_size=16)
        digest.update(f"{self.shape} {self.seed} {self.iteration} ".encode())
        digest.update("".join(f"{each} " for each in self.fixtures).encode())
        for first in (bit_planes.SAND, bit_planes.WALLS):
            for rows in bit_planes.bands(self.planes, self.layout, first):
                digest.update(np.packbits(rows, axis=1).tobytes())
        if any(self.grains_by_colour[1:]):
            digest.update(self.colours.tobytes())
        return digest.hexdigest()


def _again(*parts):
    return World(*parts).copy()


def check_cells(sand, walls):
    """Return two (H, W) bool arrays, contiguous, true being 1, or raise ValueError saying what cells must be."""
    sand, walls = check_bools(sand, "sand"), check_bools(walls, "walls")
    if sand.shape != walls.shape:
        raise ValueError(f"sand and walls must have one shape, got {sand.shape} and {walls.shape}")
    if (sand & walls).any():
        row, column = np.argwhere(sand & walls)[0]
        raise ValueError(f"a cell is sand or wall, not both: row {row}, column {column}")
    return sand, walls


def check_colours(colours, sand):
    """Return an (H, W) uint8 array, contiguous, or raise ValueError saying what the colours of `sand` must be."""
    colours = np.ascontiguousarray(colours)
    if colours.dtype != np.uint8 or colours.shape != sand.shape:
        found = f"{colours.dtype} of shape {colours.shape}"
        raise ValueError(f"colours must be a uint8 array of shape {sand.shape}, got {found}")
    wrong = (colours >= 2**bit_planes.DEPTH) | ((colours > 0) & ~sand)
    if wrong.any():
        row, column = np.argwhere(wrong)[0]
        found = f"{colours[row, column]} in row {row}, column {column}"
        raise ValueError(f"a colour must be in [0, {2**bit_planes.DEPTH}), and 0 where there is no sand, got {found}")
    return colours


def check_bools(cells, name):
    """Return an (H, W) bool array, contiguous, whose bytes are 0 and 1, or raise ValueError; name: what it is of.

    A view of other bytes as bools may hold any, and kernels work with bytes.
    """
    cells = np.ascontiguousarray(cells)
    if cells.dtype != np.bool_ or cells.ndim != 2:
        raise ValueError(f"{name} must be a bool array of shape (H, W), got {cells.dtype} of shape {cells.shape}")
    for side in cells.shape:
        parameters.SIDE.check(side)
    octets = cells.view(np.uint8)
    return cells if octets.max() <= 1 else octets != 0
