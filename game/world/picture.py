"""The world's look: which colour each cell has and where it lies in an array of pixels. No window is needed."""

from dataclasses import dataclass

import numpy as np

from game.core.decor import decor_of
from game.core.pixels import TEXTURE, draw_cells, pairs_of, shades_of
from game.core.planes import WALLS, layout
from game.world.colours import NIGHT, palette, rgb

WHOLE_ENOUGH = 0.8  # of the width that would fit: the least a view may shrink to for the sake of whole pixels
MOST_DECORATED = 2**24  # cells: in a larger lattice, a painted wall would hold a frame up for too long


def texture():
    """Return the shade of each place, (TEXTURE, TEXTURE) uint8: it stays with the place, so sand at rest is calm."""
    y, x = np.mgrid[0:TEXTURE, 0:TEXTURE].astype(np.uint64)
    z = (y * np.uint64(TEXTURE) + x + np.uint64(1)) * np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(29))) * np.uint64(0xBF58476D1CE4E5B9)
    return (z >> np.uint64(62)).astype(np.uint8)


@dataclass(frozen=True)
class View:
    """Where a lattice of `shape` (height, width) cells lies among the pixels."""

    shape: tuple
    left: int  # pixels
    top: int
    width: int
    height: int

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

    @property
    def cell(self):
        """Pixels to a cell."""
        return self.width / self.shape[1]

    @property
    def columns(self):
        """The lattice column of each pixel column: int32."""
        return (np.arange(self.width, dtype=np.int64) * self.shape[1] // self.width).astype(np.int32)

    @property
    def rows(self):
        """The lattice row of each pixel row: int32."""
        return (np.arange(self.height, dtype=np.int64) * self.shape[0] // self.height).astype(np.int32)

    def place(self, x, y):
        """Return the place in the lattice (column, row), in fractions of cells, of the middle of pixel (x, y)."""
        return (
            (x - self.left + 0.5) * self.shape[1] / self.width,
            (y - self.top + 0.5) * self.shape[0] / self.height,
        )

    def pixel(self, column, row):
        """Return the pixel position (x, y), in fractions, of a place in the lattice."""
        return self.left + column * self.width / self.shape[1], self.top + row * self.height / self.shape[0]


class Painter:
    """Draws worlds into pixel arrays through one view, and of a world drawn before only the bands that changed."""

    def __init__(self, view, colours=NIGHT, walls="stone", map_rgb=rgb):
        """`walls`: what they are made of; those of glass are decorated. map_rgb: makes a pixel of three numbers."""
        self.view = view
        self._columns, self._rows = view.columns.astype(np.uint32), view.rows
        self._pairs = pairs_of(palette(colours, walls, map_rgb))
        self._shades = shades_of(texture(), layout(*view.shape).words)
        self._world, self._seen = None, 0  # what was drawn last, and its stamp then
        self._glass = walls == "glass" and view.shape[0] * view.shape[1] <= MOST_DECORATED
        self._decor = self._decorated = None  # what decorates the glass, and its walls

    def draw(self, world, pixels, damage=()):
        """Draw what differs from the last drawing into `pixels`, an (h, w) uint32 array that holds the view, in place.

        damage: spans (top, bottom) of pixel rows that were overwritten since. Return the spans drawn, from the top.
        """
        if self._glass:
            self._decorate(world)
        spans = [*self._changed(world), *(self._clipped(*span) for span in damage)]
        self._world, self._seen = world, world.activity.stamp
        drawn = _merged(spans)
        for top, bottom in drawn:
            self._draw_rows(world, pixels, top, bottom)
        return drawn

    def forget(self):
        """Draw everything next time."""
        self._world = None

    def _decorate(self, world):
        """Decorate the glass anew, and forget what was drawn, if its walls are not those decorated last."""
        activity, walls = world.activity, world.planes[WALLS : WALLS + 4]
        if world is self._world and activity.woken <= self._seen:
            return
        if self._decorated is None or not np.array_equal(walls, self._decorated):
            self._decorated = walls.copy()
            self._decor = decor_of(world.planes, world.layout)
            self.forget()

    def _changed(self, world):
        """Yield the spans of pixel rows that show bands changed since the last drawing."""
        if world is not self._world:
            yield self.view.top, self.view.top + self.view.height
            return
        band_height = 2 * world.activity.band_rows
        for band in np.nonzero(world.activity.changed > self._seen)[0]:
            # a band's blocks reach a row further down; looks tell of the two rows above and of walls below
            rows = band * band_height - 1, (band + 1) * band_height + 3
            top, bottom = np.searchsorted(self._rows, rows)
            yield self.view.top + int(top), self.view.top + int(bottom)

    def _clipped(self, top, bottom):
        return max(top, self.view.top), min(bottom, self.view.top + self.view.height)

    def _draw_rows(self, world, pixels, top, bottom):
        where, rows = world.layout, self._rows[top - self.view.top : bottom - self.view.top]
        columns, shades, pairs = self._columns, self._shades, self._pairs
        draw_cells(
            world.planes,
            self._decor,
            where.stride,
            where.words,
            columns,
            rows,
            shades,
            pairs,
            pixels,
            top,
            self.view.left,
        )


def _merged(spans):
    """Return the spans (top, bottom) in order, those that touch as one, empty ones left out."""
    merged = []
    for top, bottom in sorted(span for span in spans if span[0] < span[1]):
        if merged and top <= merged[-1][1]:
            merged[-1] = merged[-1][0], max(bottom, merged[-1][1])
        else:
            merged.append((top, bottom))
    return merged
