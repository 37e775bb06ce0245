"""The world's look: which colour each cell has, and worlds drawn into arrays of pixels. No window is needed."""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.core.draw import cells
from game.core.draw.cells import LOOKS, TEXTURE, draw_cells, dyed, mixed_columns, pairs_of, shades_of
from game.core.draw.downscaled import draw_density, shift_edges
from game.core.draw.glass_decor import decor_of
from game.core.planes import WALLS, layout
from game.world.looks import colour_space
from game.world.looks.motion_samples import NO_SAMPLES
from game.world.looks.themes import NIGHT, dyed_palette, rgb

NO_ENDS = np.zeros(0, np.int32)
NO_BLENDS = np.zeros((0, 0, 0, 0), np.uint32)
MIXED_BY_TWO = 0.5  # pixels to a cell: from here on a pixel holds no more than two cells in a row, and they are mixed
MOST_DECORATED = 2**24  # cells: in a larger lattice, a painted wall would hold a frame up for too long


def texture():
    """Return the shade of each place, (TEXTURE, TEXTURE) uint8. It is fixed, so that sand at rest does not flicker."""
    y, x = np.mgrid[0:TEXTURE, 0:TEXTURE].astype(np.uint64)
    z = (y * np.uint64(TEXTURE) + x + np.uint64(1)) * np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(29))) * np.uint64(0xBF58476D1CE4E5B9)
    return (z >> np.uint64(62)).astype(np.uint8)


class CellPaints(NamedTuple):
    """Look-up tables that cells are drawn with, whatever the view."""

    pairs: np.ndarray  # of a world without colours, and of one with: what `pairs_of` gives
    dyed_pairs: np.ndarray
    lights: tuple | None  # what `colour_space.lights` gives, where cells share pixels
    channels: np.ndarray | None  # what `colour_space.channels` gives, there
    blends: np.ndarray  # what `colour_space.blends` gives, there


@lru_cache(maxsize=16)
def paints_of(colours, walls, map_rgb, mixes):
    """Return the CellPaints of a theme for a `Painter`. They are cached, since a window is laid out often."""
    codes = dyed_palette(colours, walls, map_rgb)
    plain = np.array([dyed(look)[0] for look in range(LOOKS)])
    pairs = pairs_of(codes[plain]), pairs_of(codes)
    if not mixes:
        return CellPaints(*pairs, None, None, NO_BLENDS)
    values, channels = dyed_palette(colours, walls), colour_space.channels(map_rgb)
    return CellPaints(
        *pairs, colour_space.lights(values), channels, colour_space.blends(values, channels, colours.stream)
    )


class Painter:
    """Draws worlds into pixel arrays through one view, and of a world drawn before only the bands that changed."""

    def __init__(self, view, colours=NIGHT, walls="stone", map_rgb=rgb, mixes=True):
        """`walls`: what they are made of; those of glass are decorated. map_rgb: makes a pixel of three numbers.

        mixes: cells that share a pixel mix their light; otherwise it shows one of them.
        """
        self._paints = paints_of(colours, walls, map_rgb, mixes)
        self._shades = shades_of(texture(), layout(*view.shape).words)
        self._samples, self._moving = NO_SAMPLES, ()  # as drawn last: see MotionSamples
        self._seen = 0  # the stamp of the world drawn last
        self._drawn_at = None  # its iteration
        self._glass = walls == "glass" and view.shape[0] * view.shape[1] <= MOST_DECORATED
        self._decor = self._decorated = None  # what decorates the glass, and its walls
        self.look_through(view)

    def look_through(self, view):
        """Draw through another view of the same lattice, everything at first."""
        self.view, self._world = view, None
        self._mixes = view.dense and self._paints.lights is not None
        self._counts = self._mixes and view.cell < MIXED_BY_TWO
        words = layout(*view.shape).words
        if self._mixes:
            self._columns = (shift_edges if self._counts else mixed_columns)(view.column_edges, words)
            self._rows = view.row_edges
        else:
            self._columns, self._rows = view.columns.astype(np.uint32), view.rows

    def draw(self, world, pixels, damage=(), streams=None):
        """Draw what differs from the last drawing into `pixels`, an (h, w) uint32 array that holds the view, in place.

        damage: spans (top, bottom) of pixel rows that were overwritten since. streams: the MotionSamples of the world,
        if falling sand is drawn as the mean of the last iterations. Return the spans drawn, from the top.
        """
        if self._glass:
            self._decorate(world)
        smooth = streams is not None and streams.follows(world) and self._paints.channels is not None
        if smooth != (len(self._samples) > 0):
            self._drawn_at = None
        spans = [*self._changed(world), *(self._clipped(*span) for span in damage)]
        self._world, self._seen, self._drawn_at = world, world.activity.stamp, world.iteration
        self._samples, self._moving = (streams.samples, streams.moving > 0) if smooth else (NO_SAMPLES, ())
        drawn = _merged(spans)
        for top, bottom in drawn:
            self._draw_rows(world, pixels, top, bottom)
        return drawn

    def differs(self, world):
        """Return whether a world looks different from what was drawn last."""
        if self._glass:
            self._decorate(world)
        return any(top < bottom for top, bottom in self._changed(world))

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
        _, top, _, bottom = self.view.seen
        if world is not self._world:
            yield top, bottom
            return
        band_height = 2 * world.activity.band_rows
        changed = world.activity.changed > self._seen
        if len(self._moving) and world.iteration != self._drawn_at:
            changed |= self._moving  # they were drawn as means of what was still to change
        for band in np.nonzero(changed)[0]:
            # a band's blocks reach a row further down, and looks tell of the two rows above
            yield self._pixels_of(band * band_height, (band + 1) * band_height + 3)

    def _pixels_of(self, first, last):
        """Return the span of pixel rows in sight that show any of the lattice rows from `first` to before `last`."""
        top, rows = self.view.seen[1], self._rows
        if self._mixes:
            first, last = max(np.searchsorted(rows, first, "right") - 1, 0), np.searchsorted(rows[:-1], last)
        else:
            first, last = np.searchsorted(rows, (first, last))
        return top + int(first), top + int(last)

    def _clipped(self, top, bottom):
        return max(top, self.view.seen[1]), min(bottom, self.view.seen[3])

    def _draw_rows(self, world, pixels, top, bottom):
        left, first, _, _ = self.view.seen
        where, columns, rows = world.layout, self._columns, self._rows[top - first : bottom - first + self._mixes]
        how = where.stride, where.words, columns
        if self._counts:
            plain, decor, dyes = self._paints.lights
            lights = [plain, *([] if self._decor is None else [decor]), *([dyes] if world.coloured else [])]
            draw_density(
                world.planes,
                self._decor,
                world.coloured,
                *how,
                rows,
                np.concatenate(lights),
                self._paints.channels,
                pixels,
                top,
                left,
            )
        else:
            ends = np.maximum(rows[1:] - 1, rows[:-1]) if self._mixes else NO_ENDS
            rows = rows[:-1] if self._mixes else rows
            pairs = self._paints.dyed_pairs if world.coloured else self._paints.pairs
            coloured = True if world.coloured else None  # a constant to the compiler, which halves the time to compile
            what = world.planes, self._decor, coloured, *how
            draw_cells(*what, rows, ends, self._shades, pairs, self._samples, self._paints.blends, pixels, top, left)


def _merged(spans):
    """Return the spans (top, bottom) in order, those that touch as one, empty ones left out."""
    merged = []
    for top, bottom in sorted(span for span in spans if span[0] < span[1]):
        if merged and top <= merged[-1][1]:
            merged[-1] = merged[-1][0], max(bottom, merged[-1][1])
        else:
            merged.append((top, bottom))
    return merged


def draw_turned(picture, ground, angle, zoom, pixels, frame):
    """Draw a picture turned by `angle` radians and `zoom` times smaller into `frame` of `pixels`, `ground` around it.

    picture, pixels: (h, w) uint32. frame: (left, top, width, height).
    """
    left, top, width, height = frame
    cells.draw_turned(picture, ground, math.cos(angle), math.sin(angle), zoom, pixels, top, left, height, width)
