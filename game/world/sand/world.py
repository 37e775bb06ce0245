"""The world: bit planes, an iteration and a seed. With the rule, they decide its whole future."""

import hashlib
import math
from dataclasses import replace

import numpy as np

from game.core import planes as bit_planes
from game.core.paint.flood_fill import content_of, flood
from game.core.paint.ink import RAINBOW, Tally
from game.core.paint.primitives import figure
from game.core.paint.strokes import stroke
from game.world.sand import parameters
from game.world.sand.active_bands import ActiveBands
from game.world.sand.material_codes import EMPTY, SAND, SAND_CODES, SAND_NAME, WALL, WALL_NAME

RAINBOW_PACE = 192  # iterations until the rainbow's stripes have changed by one colour


class World:
    """A lattice of cells at one moment, each of one material: empty, sand or wall, or what another rule is of.

    Make one with `World.from_cells` or `World.from_materials`. Everything random that will happen to it is decided by
    `seed` and `iteration`.
    """

    __slots__ = ("activity", "codes", "fixtures", "iteration", "layout", "planes", "seed")

    def __init__(self, planes, layout, codes, iteration, seed, fixtures=()):
        self.planes = planes  # uint64: four for each bit of a code; then of colours, if any grain ever had one
        self.layout = layout
        self.codes = codes  # MaterialCodes
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
        return cls.of_codes(codes_of(sand, walls), SAND_CODES, seed, colours)

    @classmethod
    def from_materials(cls, cells, rule, seed=0):
        """Return a world of the materials of `rule`, at iteration 0.

        cells: (H, W) uint8, the code of each cell's material, a place in `rule.materials`; H and W are in [1, 16384].
        seed is in [0, 2**64). Raises ValueError for other shapes, dtypes, codes or seeds.
        """
        return cls.of_codes(check_codes(cells, rule.materials), rule.codes, seed)

    @classmethod
    def of_codes(cls, cells, codes, seed=0, colours=None):
        """Return a world of checked cells, (H, W) uint8, that stand for MaterialCodes, with colours of its sand."""
        layout = bit_planes.layout(*cells.shape, len(codes.names), codes.wall)
        planes = bit_planes.pack(cells, layout, colours if colours is not None and colours.any() else None)
        return cls(planes, layout, codes, 0, parameters.SEED.check(seed))

    @property
    def shape(self):
        """(height, width) in cells."""
        return self.layout.height, self.layout.width

    @property
    def materials(self):
        """The code of each cell's material: a new (H, W) uint8 array."""
        return bit_planes.unpack(self.planes, self.layout)

    def where(self, material):
        """Return where a material is, in all its forms: a new (H, W) bool array.

        Raises ValueError unless it is one of the world's materials.
        """
        return bit_planes.unpack_where(self.planes, self.layout, self.codes.codes_of(material))

    @property
    def sand(self):
        """Where sand is: a new (H, W) bool array."""
        return self.where(SAND_NAME)

    @property
    def walls(self):
        """Where walls are: a new (H, W) bool array."""
        return self.where(WALL_NAME)

    @property
    def filled_planes(self):
        """Four planes of the cells that are neither air nor wall, only to be read."""
        return bit_planes.planes_where(self.planes, self.layout, self.codes.filled)

    @property
    def wall_planes(self):
        """Four planes of the cells that are wall, only to be read."""
        return bit_planes.planes_where(self.planes, self.layout, {self.codes.wall})

    @property
    def grains(self):
        """The number of cells that are neither air nor wall: in a world of sand its grains."""
        return bit_planes.count_set(self.filled_planes, self.layout)

    @property
    def coloured(self):
        """Whether the world carries colours: it does from the first coloured grain until it is cleared."""
        return bit_planes.has_colours(self.planes, self.layout)

    @property
    def colours(self):
        """The colour of each grain, 0 where there is no sand: a new (H, W) uint8 array."""
        return bit_planes.unpack_colours(self.planes, self.layout)

    @property
    def amounts(self):
        """How many cells there are of each kind: a tuple of ints.

        The kinds are the eight colours of sand, or in a world of other materials these by code, air and walls left 0.
        """
        if not self.codes.is_sand:
            return self._filled(bit_planes.count(self.planes, self.layout, range(len(self.codes.names))))
        if not self.coloured:
            return (self.grains, *[0] * (RAINBOW - 1))
        return bit_planes.count(self.planes, self.layout, self._contents_of_sand())

    def copy(self):
        """Return a world of its own with the same cells, iteration and seed."""
        planes = bit_planes.empty(self.layout, len(self.planes))
        planes[:] = self.planes
        return World(planes, self.layout, self.codes, self.iteration, self.seed, self.fixtures)

    def same(self):
        """Return another World of the same planes: what this one is, until a stroke or an iteration changes them."""
        return World(self.planes, self.layout, self.codes, self.iteration, self.seed, self.fixtures)

    def __reduce__(self):
        """Let `copy`, `deepcopy` and `pickle` make what `copy` does: a world that shares nothing with this one."""
        return _again, (self.planes, self.layout, self.codes, self.iteration, self.seed, self.fixtures)

    def flip(self):
        """Turn the lattice by 180 degrees, in place; twice is the identity."""
        self.planes = bit_planes.turned(self.planes, self.layout, 2)
        self.fixtures = tuple(each.turned(2, self.shape) for each in self.fixtures)
        self.activity.wake()

    def turned(self, quarters):
        """Return the world after so many quarter turns, clockwise: a new one, its height and width exchanged if odd."""
        height, width = self.shape[::-1] if quarters % 2 else self.shape
        layout = bit_planes.layout(height, width, self.layout.codes, self.layout.outside)
        planes = bit_planes.turned(self.planes, self.layout, quarters)
        fixtures = tuple(each.turned(quarters, self.shape) for each in self.fixtures)
        return World(planes, layout, self.codes, self.iteration, self.seed, fixtures)

    def within(self, cells, colours=None):
        """Return the world with other cells, its middle where it was: a new one at the same iteration.

        cells: (H, W) uint8, codes of its materials. colours: (H, W) uint8, or None for a world without.
        """
        down, across = ((new - old) // 2 for new, old in zip(cells.shape, self.shape, strict=True))
        world = World.of_codes(cells, self.codes, self.seed, colours)
        world.iteration = self.iteration
        world.fixtures = tuple(replace(each, x=each.x + across, y=each.y + down) for each in self.fixtures)
        return world

    def resized(self, height, width, right, down):
        """Return the world in a lattice of another size, its cells so many further: a new one at the same iteration.

        What comes to lie outside is cut off, and with it the taps and drains that reach none of the cells any more.
        """
        cells, colours = np.zeros((2, height, width), np.uint8)
        spans = zip((down, right), self.shape, (height, width), strict=True)
        there = tuple(slice(max(by, 0), max(by, 0, min(by + old, new))) for by, old, new in spans)
        here = tuple(slice(each.start - by, each.stop - by) for each, by in zip(there, (down, right), strict=True))
        cells[there] = self.materials[here]
        if self.coloured:
            colours[there] = self.colours[here]
        world = World.of_codes(cells, self.codes, self.seed, colours if self.coloured else None)
        world.iteration = self.iteration
        moved = (each.moved(right, down) for each in self.fixtures)
        world.fixtures = tuple(each for each in moved if each.reaches(width, height))
        return world

    def of(self, codes):
        """Return the world for a rule of other materials: itself if they are its own; what they have not is gone."""
        if codes == self.codes:
            return self
        numbers = [codes.code(name) or EMPTY for name in self.codes.names]
        world = World.of_codes(np.array(numbers, np.uint8)[self.materials], codes, self.seed)
        world.iteration, world.fixtures = self.iteration, self.fixtures
        return world

    def clear(self):
        """Take everything away but the walls, with the colours of sand, in place."""
        if self.coloured:
            self.planes = bit_planes.without_colours(self.planes, self.layout)
        walls = self.wall_planes.copy()
        for first in range(0, len(self.planes), 4):
            self.planes[first : first + 4] &= walls
        self.activity.wake()

    def stroke(self, start, end, diameter, shape, ink):
        """Give `ink` to the cells that a brush covers on its way from one place (column, row) to another.

        diameter: in cells. shape: `ROUND`, `SQUARE` or `DIAMOND` of `core.paint.strokes`. Return the change in
        `amounts`.
        """
        where, radius, tally = self.layout, diameter / 2, self.tally(ink)
        rows = start[1], end[1]
        self.activity.wake(math.floor(min(rows) - radius) - 1, math.ceil(max(rows) + radius) + 2)
        stroke(self.planes, where.height, where.width, where.words, *start, *end, radius, shape, tally)
        return self.change(tally)

    def figure(self, kind, box, edge, ink):
        """Give `ink` to the cells of a figure, or only to those up to `edge` cells from its outline; 0 for all.

        kind: `RECTANGLE` or `ELLIPSE` of `core.paint.primitives`. box: first column and row, then those after the last.
        Return the change in `amounts`.
        """
        where, tally = self.layout, self.tally(ink)
        self.activity.wake(box[1] - 1, box[3] + 1)
        figure(self.planes, where.height, where.width, where.words, kind, *box, edge, tally)
        return self.change(tally)

    def fill(self, column, row, ink):
        """Give `ink` to a cell, and to all cells connected with it through cells of its code.

        Return the change in `amounts`.
        """
        tally = self.tally(ink)
        if self.code_at(column, row) is not None:
            top, bottom = flood(self.planes, self.layout, column, row, tally)
            self.activity.wake(top - 1, bottom + 1)
        return self.change(tally)

    def tally(self, ink):
        """Return a Tally for kernels that give cells of this world an ink.

        The first coloured ink gives the world its planes of colours.
        """
        dyes = self.codes.is_sand and ink.code == SAND
        if dyes and ink.colour and not self.coloured:
            self.planes = bit_planes.with_colours(self.planes, self.layout)
        first = self.iteration // RAINBOW_PACE % RAINBOW if ink.colour == RAINBOW else 0
        ink = ink._replace(colour=ink.colour + first if dyes and self.coloured else 0)
        return Tally(ink, self.layout.bits, np.zeros(2 ** (len(self.planes) // 4), np.int64))

    def change(self, tally):
        """Return the change in `amounts` that a Tally has counted."""
        if not self.codes.is_sand:
            return self._filled(tally.change[: len(self.codes.names)].tolist())
        change = [int(tally.change[content]) for content in self._contents_of_sand()]
        return (*change, *[0] * (RAINBOW - len(change)))

    def _contents_of_sand(self):
        """Return the contents that are sand of each colour, in a world of sand."""
        return range(SAND, 2 ** (len(self.planes) // 4), 2**self.layout.bits)

    def _filled(self, numbers):
        return tuple(number * (code in self.codes.filled) for code, number in enumerate(numbers))

    def code_at(self, column, row):
        """Return the code of a cell; None outside of the lattice."""
        height, width = self.shape
        if not (0 <= column < width and 0 <= row < height):
            return None
        return content_of(self.planes, self.layout, column, row) % 2**self.layout.bits

    def colour_at(self, column, row):
        """Return the number of the colour of a cell's sand, 0 where there is none."""
        if not self.coloured or self.code_at(column, row) != SAND:
            return 0
        return content_of(self.planes, self.layout, column, row) >> self.layout.bits

    def digest(self):
        """Return 32 hex digits that name all that decides the future: shape, cells, seed, iteration and fixtures."""
        digest = hashlib.blake2b(digest_size=16)
        digest.update(f"{self.shape} {self.seed} {self.iteration} ".encode())
        digest.update("".join(f"{each} " for each in self.fixtures).encode())
        if not self.codes.is_sand:
            digest.update(f"{', '.join(self.codes.names)} ".encode())
        for bit in range(self.layout.bits):
            for rows in bit_planes.bands(self.planes[4 * bit : 4 * bit + 4], self.layout):
                digest.update(np.packbits(rows, axis=1).tobytes())
        if self.codes.is_sand and any(self.amounts[1:]):
            digest.update(self.colours.tobytes())
        return digest.hexdigest()


def _again(*parts):
    return World(*parts).copy()


def codes_of(sand, walls):
    """Return the (H, W) uint8 codes of cells of a world of sand, from two bool arrays."""
    return sand.view(np.uint8) * np.uint8(SAND) + walls.view(np.uint8) * np.uint8(WALL)


def check_codes(cells, materials):
    """Return (H, W) uint8 codes, contiguous, or raise ValueError saying what codes of `materials` must be."""
    cells = np.ascontiguousarray(cells)
    if cells.dtype != np.uint8 or cells.ndim != 2:
        raise ValueError(f"cells must be a uint8 array of shape (H, W), got {cells.dtype} of shape {cells.shape}")
    for side in cells.shape:
        parameters.SIDE.check(side)
    if cells.max() >= len(materials):
        row, column = np.argwhere(cells >= len(materials))[0]
        found = f"{cells[row, column]} in row {row}, column {column}"
        raise ValueError(f"a code must be in [0, {len(materials) - 1}], one of {', '.join(materials)}, got {found}")
    return cells


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
