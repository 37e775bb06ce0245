"""Firelight: what glows lights up what is near."""

import numpy as np

from game.core.draw.firelight import LEVELS, TILE, count_glowing, find_lit, lay_light, padded, spread_light, tiles_of
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
        self._counts = np.empty((height, padded(view.shape[1])), np.int32)
        self._across = np.empty_like(self._tiles)
        self.look_through(view)

    def look_through(self, view):
        """Light another view of the same lattice."""
        self._view, self._rows, self._columns = view, view.rows, view.columns
        self._lit = self._where_lit()

    def follow(self, world):
        """Take the light that a world has now; return the lattice rows, (first, last + 1), whose light changed."""
        tiles, four = np.empty_like(self._tiles), planes_where(world.planes, world.layout, self._codes)
        count_glowing(four, world.layout.rows, world.layout.words, self._counts)
        spread_light(self._counts, REACH, GAIN * BRIGHTEST, self._across, tiles)
        changed = np.flatnonzero((tiles != self._tiles).any(axis=1))
        self._tiles = tiles
        self._lit = self._where_lit()
        if not len(changed):
            return None
        return (int(changed[0]) - 1) * TILE, (int(changed[-1]) + 2) * TILE

    def draw(self, pixels, top, bottom):
        """Lay the light over the rows from `top` to before `bottom` of `pixels`, an (h, w) uint32 array, in place."""
        left, first, _, _ = self._view.seen
        rows = self._rows[top - first : bottom - first]
        lay_light(self._tiles, self._lights, self._lit, self._columns, rows, pixels, top, left)

    def _where_lit(self):
        """Return the first and the last + 1 tile with light in each row of tiles, and of their pixel columns."""
        lit = np.empty((len(self._tiles), 4), np.int64)
        find_lit(self._tiles, self._columns, lit)
        return lit


def _lights(brightest, map_rgb):
    """Return the pixel value of each level of light, (LEVELS,) uint32."""
    colours = np.outer(np.arange(LEVELS) / BRIGHTEST, brightest).astype(int).tolist()
    return np.array([map_rgb(*each) for each in colours], np.uint32)
