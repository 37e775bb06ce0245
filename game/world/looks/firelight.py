"""Firelight: what glows lights up what is near."""

import numpy as np

from game.core.draw.firelight import FULL, LEVELS, TILE, count_glowing, lay_light, light_between, padded, tiles_of
from game.core.planes import planes_where

REACH = 5  # tiles from one that glows to the first that it does not light
GAIN = 3.0  # a tile is as bright as can be where a third of what is around it glows
BRIGHTEST = LEVELS - 1
MOST_LIT = 2**21  # cells: in a larger lattice glowing would hold a frame up


class Firelight:
    """The light in one world as drawn last."""

    def __init__(self, glowing, strength, map_rgb, view):
        """glowing: the Substances that do. strength: of the brightest light, up to 1. view: of the world."""
        self._codes = frozenset(code for each in glowing for code in each.codes)
        self._lights = _lights(strength * np.mean([each.colour for each in glowing], axis=0), map_rgb)
        height, width = tiles_of(*view.shape)
        self._tiles = np.zeros((height, width), np.float32)  # whole numbers, 0 … BRIGHTEST
        self._down, self._across = _weights(height), _weights(width)
        self.look_through(view)

    def look_through(self, view):
        """Light another view of the same lattice."""
        self._view, self._rows, self._columns = view, view.rows, view.columns

    def follow(self, world):
        """Take the light that a world has now; return the lattice rows, (first, last + 1), whose light changed."""
        tiles = self._down @ self._glowing(world) @ self._across
        tiles = np.floor(np.minimum(tiles * np.float32(GAIN * BRIGHTEST), np.float32(BRIGHTEST)))
        changed = np.flatnonzero((tiles != self._tiles).any(axis=1))
        self._tiles = tiles
        if not len(changed):
            return None
        return (int(changed[0]) - 1) * TILE, (int(changed[-1]) + 2) * TILE

    def draw(self, pixels, top, bottom):
        """Lay the light over the rows from `top` to before `bottom` of `pixels`, an (h, w) uint32 array, in place."""
        left, first, _, _ = self._view.seen
        rows = self._rows[top - first : bottom - first]
        lit = np.flatnonzero(self._tiles[max(rows[0] // TILE - 1, 0) : rows[-1] // TILE + 2].any(axis=0))
        if not len(lit):
            return
        start, end = np.searchsorted(self._columns, ((lit[0] - 1) * TILE, (lit[-1] + 2) * TILE))
        if start == end:
            return
        levels = np.empty((rows[-1] - rows[0] + 1, self._view.shape[1]), np.uint8)
        light_between(self._tiles, int(rows[0]), levels)
        columns = self._columns[start:end]
        lay_light(levels, self._lights, columns, rows - rows[0], pixels, top, left + start)

    def _glowing(self, world):
        """Return how much of each tile glows: (h, w) float32, 0 … 1."""
        four, where = planes_where(world.planes, world.layout, self._codes), world.layout
        height, width = tiles_of(where.height, where.width)
        counts = np.zeros((height + 1, padded(where.width)), np.int32)
        count_glowing(four, where.rows, where.words, counts)
        return counts[:height, :width] / np.float32(FULL)


def _weights(number):
    """Return how much light each of a row of tiles has from each: (number, number) float32."""
    away = np.abs(np.subtract.outer(np.arange(number), np.arange(number)))
    return (np.maximum(REACH - away, 0) / REACH**2).astype(np.float32)


def _lights(brightest, map_rgb):
    """Return the pixel value of each level of light, (LEVELS,) uint32."""
    colours = np.outer(np.arange(LEVELS) / BRIGHTEST, brightest).astype(int).tolist()
    return np.array([map_rgb(*each) for each in colours], np.uint32)
