"""The world's look: which colour each cell has and where it lies in an array of pixels. No window is needed."""

from dataclasses import dataclass

import numpy as np

from game.core.pixels import EMPTY, GRAIN, SHADES, SURFACE, TEXTURE, WALL, draw_cells, pairs_of, shades_of
from game.core.planes import layout

GROUND = (24, 21, 18)  # around the lattice
WHOLE_ENOUGH = 0.8  # of the width that would fit: the least a view may shrink to for the sake of whole pixels
DARK_AND_LIGHT = {  # the range of shades of each look, as RGB
    EMPTY: ((35, 31, 27), (35, 31, 27)),
    GRAIN: ((196, 142, 62), (226, 176, 92)),
    SURFACE: ((238, 192, 108), (255, 222, 146)),
    WALL: ((96, 104, 108), (110, 118, 122)),
}


def rgb(red, green, blue):
    """Return the pixel value 0xRRGGBB."""
    return red << 16 | green << 8 | blue


def palette(map_rgb=rgb):
    """Return the (looks, SHADES) uint32 pixel values, `map_rgb` turning red, green, blue in 0 … 255 into one."""
    values = np.empty((len(DARK_AND_LIGHT), SHADES), np.uint32)
    for look, (dark, light) in DARK_AND_LIGHT.items():
        for shade in range(SHADES):
            mixed = (d + (bright - d) * shade // (SHADES - 1) for d, bright in zip(dark, light, strict=True))
            values[look, shade] = map_rgb(*mixed)
    return values


def texture():
    """Return the shade of each place, (TEXTURE, TEXTURE) uint8: it stays with the place, so sand at rest is calm."""
    y, x = np.mgrid[0:TEXTURE, 0:TEXTURE].astype(np.uint64)
    z = (y * np.uint64(TEXTURE) + x + np.uint64(1)) * np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(29))) * np.uint64(0xBF58476D1CE4E5B9)
    return (z >> np.uint64(61)).astype(np.uint8)


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

    def __init__(self, view, colours=None):
        self.view = view
        self._columns, self._rows = view.columns.astype(np.uint32), view.rows
        self._pairs = pairs_of(palette() if colours is None else colours)
        self._shades = shades_of(texture(), layout(*view.shape).words)
        self._world, self._seen = None, 0  # what was drawn last, and its stamp then

    def draw(self, world, pixels, damage=()):
        """Draw what differs from the last drawing into `pixels`, an (h, w) uint32 array that holds the view, in place.

        damage: spans (top, bottom) of pixel rows that were overwritten since. Return the spans drawn, from the top.
        """
        spans = [*self._changed(world), *(self._clipped(*span) for span in damage)]
        self._world, self._seen = world, world.activity.stamp
        drawn = _merged(spans)
        for top, bottom in drawn:
            self._draw_rows(world, pixels, top, bottom)
        return drawn

    def forget(self):
        """Draw everything next time."""
        self._world = None

    def _changed(self, world):
        """Yield the spans of pixel rows that show bands changed since the last drawing."""
        if world is not self._world:
            yield self.view.top, self.view.top + self.view.height
            return
        band_height = 2 * world.activity.band_rows
        for band in np.nonzero(world.activity.changed > self._seen)[0]:
            # a band's blocks reach a row further down, and what lies below that is lit from above
            rows = band * band_height, (band + 1) * band_height + 2
            top, bottom = np.searchsorted(self._rows, rows)
            yield self.view.top + int(top), self.view.top + int(bottom)

    def _clipped(self, top, bottom):
        return max(top, self.view.top), min(bottom, self.view.top + self.view.height)

    def _draw_rows(self, world, pixels, top, bottom):
        where, rows = world.layout, self._rows[top - self.view.top : bottom - self.view.top]
        columns, shades, pairs = self._columns, self._shades, self._pairs
        draw_cells(world.planes, where.stride, where.words, columns, rows, shades, pairs, pixels, top, self.view.left)


def _merged(spans):
    """Return the spans (top, bottom) in order, those that touch as one, empty ones left out."""
    merged = []
    for top, bottom in sorted(span for span in spans if span[0] < span[1]):
        if merged and top <= merged[-1][1]:
            merged[-1] = merged[-1][0], max(bottom, merged[-1][1])
        else:
            merged.append((top, bottom))
    return merged
