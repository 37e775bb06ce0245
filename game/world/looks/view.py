"""The view: where a lattice lies on the screen, in pixels, and which part of it is in sight."""

from dataclasses import dataclass
from functools import cached_property
from math import ceil

import numpy as np

WHOLE_ENOUGH = 0.8  # of the width that would fit: the least a view may shrink to for the sake of whole pixels
WHOLE = (1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 48, 64, 80, 96, 128, 160, 192, 256)
LEVELS = tuple(1 / cells for cells in WHOLE[:0:-1]) + WHOLE  # of zoom, in pixels to a cell: one or the other is whole


@dataclass(frozen=True)
class View:
    """A lattice of `shape` (height, width) cells on a rectangle of pixels, of which those inside `frame` are in sight.

    The rectangle may begin and end within a pixel. A pixel shows the cell under its middle; where cells are smaller
    than pixels, those whose middles it holds.
    """

    shape: tuple
    left: float  # pixels
    top: float
    width: float
    height: float
    frame: tuple | None = None  # left, top, width and height of whole pixels; None: all of the rectangle is in sight

    @classmethod
    def fit(cls, shape, left, top, width, height):
        """Return the largest view inside a rectangle of pixels, its cells square.

        Cells are whole pixels wide, and so all alike, unless that would waste too much of the rectangle.
        """
        rows, columns = shape
        cell = min(width / columns, height / rows)
        if int(cell) >= WHOLE_ENOUGH * cell:
            cell = int(cell)
        wide, high = max(1, int(columns * cell)), max(1, int(rows * cell))
        return cls(shape, left + (width - wide) // 2, top + (height - high) // 2, wide, high)

    @classmethod
    def near(cls, shape, frame, cell, place, x, y):
        """Return the view in `frame` with `cell` pixels to a cell that has a place in the middle of pixel (x, y).

        The lattice fills the frame or lies in the middle of it, so near its ends the place may lie elsewhere.
        """
        left, top, width, height = frame
        wide, high = max(1.0, shape[1] * cell), max(1.0, shape[0] * cell)
        start_x = _held(x + 0.5 - place[0] * wide / shape[1], wide, left, width)
        start_y = _held(y + 0.5 - place[1] * high / shape[0], high, top, height)
        return cls(shape, start_x, start_y, wide, high, tuple(frame))

    @property
    def cell(self):
        """Pixels to a cell."""
        return self.width / self.shape[1]

    @cached_property
    def dense(self):
        """Whether a pixel holds more than one cell."""
        return self.width < self.shape[1] or self.height < self.shape[0]

    @cached_property
    def seen(self):
        """(left, top, right, bottom) of the pixels that show the lattice, the last two just beyond."""
        left, top = _first_pixel(self.left), _first_pixel(self.top)
        right, bottom = _first_pixel(self.left + self.width), _first_pixel(self.top + self.height)
        if self.frame is None:
            return left, top, right, bottom
        x, y, wide, high = self.frame
        return max(left, x), max(top, y), min(right, x + wide), min(bottom, y + high)

    @property
    def columns(self):
        """The lattice column of each pixel column in sight: int32."""
        return _cells(self.seen[0], self.seen[2], self.left, self.width, self.shape[1])

    @property
    def rows(self):
        """The lattice row of each pixel row in sight: int32."""
        return _cells(self.seen[1], self.seen[3], self.top, self.height, self.shape[0])

    @property
    def column_edges(self):
        """The lattice columns between which the pixel columns in sight lie, one more than they are: int32."""
        return _edges(self.seen[0], self.seen[2], self.left, self.width, self.shape[1])

    @property
    def row_edges(self):
        """The lattice rows between which the pixel rows in sight lie, one more than they are: int32."""
        return _edges(self.seen[1], self.seen[3], self.top, self.height, self.shape[0])

    def place(self, x, y):
        """Return the place in the lattice (column, row), in fractions of cells, of the middle of pixel (x, y)."""
        return (
            (x - self.left + 0.5) * self.shape[1] / self.width,
            (y - self.top + 0.5) * self.shape[0] / self.height,
        )

    def pixel(self, column, row):
        """Return the pixel position (x, y), in fractions, of a place in the lattice."""
        return self.left + column * self.width / self.shape[1], self.top + row * self.height / self.shape[0]


def level(cell, steps):
    """Return the zoom, in pixels to a cell, that lies `steps` levels above `cell`, or below it."""
    for _ in range(abs(steps)):
        if steps > 0:
            cell = next((each for each in LEVELS if each > cell * 1.001), cell)
        else:
            cell = next((each for each in LEVELS[::-1] if each < cell * 0.999), cell)
    return cell


def _held(start, length, low, room):
    """Return where a stretch that should begin at `start` does so that it fills the room, or lies in its middle."""
    if length <= room:
        return low + (room - length) // 2
    return min(max(start, low + room - length), low)


def _first_pixel(start):
    """Return the first pixel whose middle is not before `start`."""
    return ceil(start - 0.5)


def _cells(first, last, start, length, count):
    cells = (np.arange(first, last) - start + 0.5) * count / length
    return np.clip(cells, 0, count - 1).astype(np.int32)


def _edges(first, last, start, length, count):
    edges = np.ceil((np.arange(first, last + 1) - start) * count / length - 0.5)
    if first == _first_pixel(start):
        edges[0] = 0
    if last == _first_pixel(start + length):
        edges[-1] = count
    return np.clip(edges, 0, count).astype(np.int32)
