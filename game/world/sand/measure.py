"""Measures of a world: flow, heights, slope, motion. Rows count from the top, heights from the ground."""

import math
from typing import NamedTuple

import numpy as np

from game.core.pile_heights import stack_heights
from game.core.planes import BITS, count_set, planes_where
from game.world.sand.advance import advance

FLANK = 0.2, 0.8  # parts of a pile's height between which its slope is taken: foot and tip are rounded
PARTS, LEAST_PART = 3, 4  # of a flank, whose slopes tell the error; and the fewest columns of a part
MOST_ROWS = 128  # plane rows that a MotionMeter looks at
ZONES = 8  # from left to right: the bytes of a word


def grains_above(world, row):
    """Return the number of grains in the rows above `row`."""
    return count_set(world.filled_planes, world.layout, min(max(row, 0), world.shape[0]))


def flow(world, rule, iterations, row):
    """Advance the world and return the mean number of grains per iteration that left the rows above `row`."""
    before = grains_above(world, row)
    advance(world, rule, iterations)
    return (before - grains_above(world, row)) / iterations


def pile_heights(world, top=0):
    """Return how many grains rest on the ground in each column, (W,) int, below row `top`; falling grains are left out.

    The ground is the lattice's edge, or the wall that carries the lowest sand there is on a wall.
    """
    return pile(world, top).heights


class Pile(NamedTuple):
    """What rests below a row, column by column, as (W,) int64 in cells."""

    heights: np.ndarray  # the grains that rest there
    surface: np.ndarray  # from the lattice's lower edge up to the top of the uppermost of them; 0 where there is none

    @property
    def height(self):
        """From the lowest ground that carries a grain to the top of the uppermost, in cells."""
        there = self.heights > 0
        return int(self.surface.max() - (self.surface - self.heights)[there].min()) if there.any() else 0


def pile(world, top=0):
    """Return the Pile below row `top`; see `pile_heights`."""
    height, width = world.shape
    found = Pile(np.zeros(width, np.int64), np.zeros(width, np.int64))
    where = world.layout
    stack_heights(world.filled_planes, world.wall_planes, where.stride, where.words, top, height, *found)
    return found


def surface_slope(surface):
    """Return (slope, its standard error) of a pile's two flanks, in degrees, from the (W,) heights of its surface.

    The slope is that of straight lines through the flanks between a fifth and four fifths of their height. The error is
    that of the mean of their PARTS: how much they differ says how straight the flanks are. NaN stands for what is not
    known: a flank is as far as sand reaches without a gap from the peak.
    """
    surface = np.asarray(surface)
    peak = int(np.argmax(surface))
    flanks = [_flank(surface[peak::-1]), _flank(surface[peak:])]
    slopes = [_line(each) for each in flanks]
    parts = [_line(part) for each in flanks for part in np.array_split(each, PARTS) if len(part) >= LEAST_PART]
    degrees = np.degrees(np.arctan(parts))
    error = float(degrees.std(ddof=1)) / math.sqrt(len(degrees)) if len(degrees) > 2 else math.nan
    return math.degrees(math.atan(sum(slopes) / 2)), error


def _flank(falling):
    """Return the heights of the straight part of a flank, from the peak outwards."""
    gaps = np.flatnonzero(falling == 0)
    falling = falling[: gaps[0]] if len(gaps) else falling
    if not len(falling):
        return falling
    low, high = (falling.min() + part * (falling[0] - falling.min()) for part in FLANK)
    inside = np.flatnonzero((falling >= low) & (falling <= high))
    return falling[inside[0] : inside[-1] + 1] if len(inside) else falling[:0]


def _line(falling):
    """Return by how much heights fall from column to column, by least squares; NaN for fewer than two."""
    if len(falling) < 2:
        return math.nan
    away = np.arange(len(falling)) - (len(falling) - 1) / 2
    return -float(away @ falling) / float(away @ away)


def slope_degrees(heights):
    """Return the mean slope of the two flanks of a pile, from (W,) heights with one peak; NaN if it has no flanks."""
    heights = np.asarray(heights)
    peak = int(np.argmax(heights))
    slopes = [_slope(heights[: peak + 1]), _slope(heights[peak:][::-1])]
    return math.degrees(math.atan(sum(slopes) / 2))


def _slope(rising):
    low, high = (part * rising.max() for part in FLANK)
    flank = np.flatnonzero((rising >= low) & (rising <= high))
    if len(flank) < 2:
        return math.nan
    return float(rising[flank[-1]] - rising[flank[0]]) / float(flank[-1] - flank[0])


class MotionMeter:
    """Estimates how much sand moves between two looks, and on which side, from a sample of the rows."""

    def __init__(self):
        self._rows = self._layout = None

    def look(self, world):
        """Return (grains, side): how many moved since the last look, about; the middle of them, -1 left … 1 right.

        The first look at a lattice sees nothing move. A grain that moved and was followed by another is not seen.
        """
        where = world.layout
        step = -(-where.rows // MOST_ROWS)
        planes = world.planes[: 4 * where.bits, : where.rows * where.stride].reshape(-1, where.rows, where.stride)
        sampled = np.ascontiguousarray(planes[:, ::step, : where.words])
        layout = where._replace(length=sampled[0].size)
        rows = planes_where(sampled.reshape(len(sampled), -1), layout, world.codes.filled)
        rows = rows.reshape(4, *sampled.shape[1:])
        before, self._rows = self._rows, rows
        known, self._layout = self._layout == where, where
        if not known:
            return 0.0, 0.0
        zones = _zones(rows ^ before)
        moved = float(zones.sum())
        if not moved:
            return 0.0, 0.0
        middles = (np.arange(ZONES) + 0.5) * (2 * BITS * where.words / ZONES / where.width)
        side = 2 * float(zones @ middles) / moved - 1
        return moved * step / 2, min(max(side, -1.0), 1.0)  # a grain that moves changes two cells


def _zones(words):
    """Return the number of bits set in each zone of the lattice's padded width, from left to right."""
    octets = words.astype("<u8", copy=False).view(np.uint8).reshape(-1, ZONES)
    return np.bitwise_count(octets).sum(axis=0, dtype=np.int64)
