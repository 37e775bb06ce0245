"""The world's look: which colour each cell has, and worlds drawn into arrays of pixels. No window is needed."""

import math
from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np

from game.core.draw import cells
from game.core.draw.cells import TEXTURE, CellPass, mixed_columns, pairs_of, shades_of
from game.core.draw.downscaled import CountPass, shift_edges
from game.core.draw.glass_decor import decor_of
from game.core.draw.looks import (
    AIR,
    GLEAM,
    INSIDE,
    LIQUID_SURFACE,
    POST,
    SAND,
    Look,
    dyed,
    falling_substances,
    has_glass,
    looks_of,
    sand_of,
    walls_of,
)
from game.core.planes import DEPTH, layout
from game.world.looks import colour_space
from game.world.looks.firelight import MOST_LIT, Firelight
from game.world.looks.motion_samples import NO_SAMPLES
from game.world.looks.row_threads import draw_rows
from game.world.looks.themes import NIGHT, palette, rgb

NO_ENDS = np.zeros(0, np.int32)
NO_DECOR = np.zeros((0, 0), np.uint64)
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

    pairs: np.ndarray  # what `pairs_of` gives
    lights: tuple | None  # what `colour_space.lights` gives, where cells share pixels
    channels: np.ndarray | None  # what `colour_space.channels` gives, there
    blends: np.ndarray  # what `colour_space.blends` gives, there


@lru_cache(maxsize=16)
def paints_of(colours, walls, map_rgb, mixes, substances):
    """Return the CellPaints of a theme for a `Painter`. They are cached, since a window is laid out often."""
    pairs = pairs_of(palette(colours, walls, map_rgb, substances))
    if not mixes:
        return CellPaints(pairs, None, None, NO_BLENDS)
    values, channels = palette(colours, walls, substances=substances), colour_space.channels(map_rgb)
    grounds = (AIR, INSIDE, GLEAM, POST) if has_glass(substances) else (AIR,) * 4
    streams = _stream_looks(substances, colours.stream)
    blends = colour_space.blends(values, channels, streams, grounds)
    return CellPaints(pairs, colour_space.lights(values, substances), channels, blends)


def _stream_looks(substances, stream):
    """Return the look of what falls, by its colour where it is sand alone, else by its code."""
    falling = falling_substances(substances)
    if falling == [sand_of(substances)]:
        return dyed(stream)
    looks, numbers = looks_of(substances), [AIR] * 2**substances.bits
    for each in falling:
        for code in each.codes:
            numbers[code] = looks.index(Look(stream if each.kind == "powder" else LIQUID_SURFACE, each))
    return numbers if len(falling) != 1 else [numbers[falling[0].codes[0]]]


class Painter:
    """Draws worlds into pixel arrays through one view, and of a world drawn before only the bands that changed."""

    def __init__(self, view, colours=NIGHT, walls="stone", map_rgb=rgb, mixes=True, substances=SAND):
        """`walls`: what they are made of; those of glass are decorated. map_rgb: makes a pixel of three numbers.

        mixes: cells that share a pixel mix their light; otherwise it shows one of them. substances: what the cells can
        hold, see `themes.substances_of`.
        """
        self._substances = substances
        self._paints = paints_of(colours, walls, map_rgb, mixes, substances)
        self._passes = {}  # what `_pass` gave
        self._shades = shades_of(texture(), layout(*view.shape).words)
        self._samples, self._trail, self._moving = NO_SAMPLES, None, ()  # as drawn last: see MotionSamples
        self._seen = 0  # the stamp of the world drawn last
        self._drawn_at = None  # its iteration
        is_small = view.shape[0] * view.shape[1] <= MOST_DECORATED
        self._glass = walls == "glass" and is_small and has_glass(substances)
        self._decor, self._decorated = NO_DECOR, None  # what decorates the glass, and its walls
        self._firelight = None
        glowing = [each for each in substances.all if each.glows]
        if glowing and colours.glow and mixes and view.shape[0] * view.shape[1] <= MOST_LIT:
            self._firelight = Firelight(glowing, colours.glow, map_rgb, view)
        self.look_through(view)

    def look_through(self, view):
        """Draw through another view of the same lattice, everything at first."""
        self.view, self._world = view, None
        if self._firelight:
            self._firelight.look_through(view)
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
        Raises ValueError for a world of another shape than the view's: memory beyond its own would be written.
        """
        if world.shape != self.view.shape:
            raise ValueError(f"a view of {self.view.shape} cells shows no world of {world.shape}")
        if self._glass:
            self._decorate(world)
        smooth = streams is not None and streams.follows(world) and self._paints.channels is not None
        if smooth != (len(self._samples) > 0):
            self._drawn_at = None
        spans = [*self._changed(world), *(self._clipped(*span) for span in damage)]
        self._world, self._seen, self._drawn_at = world, world.activity.stamp, world.iteration
        self._samples, self._moving = (streams.samples, streams.moving > 0) if smooth else (NO_SAMPLES, ())
        self._trail = streams.trail if smooth else None
        if self._firelight and spans:
            lit = self._firelight.follow(world)
            spans += [self._pixels_of(*lit)] if lit else []
        drawn = _merged(spans)
        for top, bottom in drawn:
            draw_rows(partial(self._draw_part, world, pixels), top, bottom, self.view.seen[2] - self.view.seen[0])
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
        if world is self._world and world.activity.woken <= self._seen:
            return
        own = world.planes[: 4 * self._substances.bits]
        walls = walls_of(self._substances, own.reshape(-1, 4, own.shape[1]))
        if self._decorated is None or not np.array_equal(walls, self._decorated):
            self._decorated = walls.copy()
            self._decor = decor_of(walls, world.layout)
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
        edges = np.flatnonzero(np.diff(np.pad(changed, 1).astype(np.int8)))
        for first, last in edges.reshape(-1, 2) * band_height:  # of bands in a row
            # a band's blocks reach a row further down, and looks tell of the two rows above
            yield self._pixels_of(first, last + 3)

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

    def _draw_part(self, world, pixels, part, top, bottom):
        """Draw rows of pixels in memory that no other part uses."""
        left, first, _, _ = self.view.seen
        paints, planes, rows = self._paints, world.planes, self._rows[top - first : bottom - first + self._mixes]
        colours = planes[4 * self._substances.bits :]
        what = planes, world.layout, self._decor, self._columns
        if self._counts:
            plain, decor, dyes = paints.lights
            lights = np.vstack([plain, decor[: len(decor) * self._glass], dyes[: len(dyes) * (len(colours) > 0)]])
            self._pass(CountPass, colours, part).draw(*what, rows, lights, paints.channels, pixels, top, left)
        else:
            ends = np.maximum(rows[1:] - 1, rows[:-1]) if self._mixes else NO_ENDS
            rows = rows[:-1] if self._mixes else rows
            trail = colours if self._trail is None or not len(self._trail) else self._trail
            streams = self._samples, trail, paints.blends
            cells = self._pass(CellPass, colours, part)
            cells.draw(*what, rows, ends, self._shades, paints.pairs, *streams, pixels, top, left)
        if self._firelight:
            self._firelight.draw(pixels, top, bottom)

    def _pass(self, kind, colours, part):
        """Return the CellPass or CountPass of worlds with or without colours, for a part of the rows."""
        depth = DEPTH if len(colours) and sand_of(self._substances) else 0
        if (kind, depth, part) not in self._passes:
            words = layout(*self.view.shape).words
            self._passes[kind, depth, part] = kind(self._substances, words, self._glass, depth)
        return self._passes[kind, depth, part]


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
