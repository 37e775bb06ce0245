"""A part of a lattice: copying its planes is cheap; its cells are unpacked later, in another thread."""

from typing import NamedTuple

import numpy as np

from game.core import planes as bit_planes
from game.world.sand.world import World


class CropBox(NamedTuple):
    """A rectangle of cells. Its corner lies on an even row and column, so that blocks lie in it as in the lattice."""

    top: int
    left: int
    height: int
    width: int

    @classmethod
    def within(cls, shape, top, left, bottom, right):
        """Return the box that holds the cells from (top, left) to before (bottom, right), cut to the lattice."""
        height, width = shape
        top, left = min(max(0, top), height - 1) // 2 * 2, min(max(0, left), width - 1) // 2 * 2
        return cls(top, left, max(min(bottom, height) - top, 1), max(min(right, width) - left, 1))

    @property
    def cells(self):
        """The number of cells."""
        return self.height * self.width

    def grown(self, margin, shape):
        """Return the box with `margin` cells more on each side, as far as the lattice goes."""
        bottom, right = self.top + self.height, self.left + self.width
        return CropBox.within(shape, self.top - margin, self.left - margin, bottom + margin, right + margin)

    def shrunk(self, most):
        """Return the middle of the box, `most` cells at most, of the same proportions."""
        share = min(1.0, (most / self.cells) ** 0.5)
        height, width = max(1, int(self.height * share)), max(1, int(self.width * share))
        top, left = self.top + (self.height - height) // 4 * 2, self.left + (self.width - width) // 4 * 2
        return CropBox(top, left, height, width)


def forecast_box(shape, sight, ahead, most):
    """Return (the box to look `ahead` iterations in, whether what lies around it cannot matter).

    It is the whole where that has no more than `most` cells, else the box in `sight` with all from which sand could
    get there, else as much of the sight as may be. In one iteration a cell depends on its neighbours alone.
    """
    height, width = shape
    whole, reach = CropBox(0, 0, height, width), sight.grown(ahead, shape)
    if whole.cells <= most:
        return whole, True
    return (reach, True) if reach.cells <= most else (sight.shrunk(most), False)


class Crop:
    """The cells of a box at one moment, in a copy of its own."""

    def __init__(self, world, box):
        where, row = world.layout, box.top // 2
        words = slice(row * where.stride, (row + -(-box.height // 2)) * where.stride)
        self.box = box
        self._fixtures = tuple(each.moved(-box.left, -box.top) for each in world.fixtures)
        self._codes, self._planes = world.codes, world.planes[: 4 * where.bits, words].copy()
        self.iteration, self._seed = world.iteration, world.seed
        self._band = where._replace(height=box.height)

    @property
    def cells(self):
        """The codes of the cells: a new (height, width) uint8 array."""
        columns = slice(self.box.left, self.box.left + self.box.width)
        return np.ascontiguousarray(bit_planes.unpack(self._planes, self._band)[:, columns])

    def world(self):
        """Return a World of the cells, with the fixtures, the seed and the iteration of the one that they are of."""
        world = World.of_codes(self.cells, self._codes, self._seed)
        world.iteration, world.fixtures = self.iteration, self._fixtures
        return world
