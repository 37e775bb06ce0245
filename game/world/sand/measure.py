"""Measures: numbers that can be read off a world of sand. Rows count from the top, heights from the ground."""

import math

import numpy as np

from game.core.pile_heights import stack_heights
from game.core.planes import count_above
from game.world.sand.advance import advance

FLANK = 0.2, 0.8  # parts of a pile's height between which its slope is taken: foot and tip are rounded


def grains_above(world, row):
    """Return the number of grains in the rows above `row`."""
    return count_above(world.planes, world.layout, min(max(row, 0), world.shape[0]))


def flow(world, rule, iterations, row):
    """Advance the world and return the mean number of grains per iteration that left the rows above `row`."""
    before = grains_above(world, row)
    advance(world, rule, iterations)
    return (before - grains_above(world, row)) / iterations


def pile_heights(world, top=0):
    """Return how many grains rest on the ground in each column, (W,) int, below row `top`; falling grains are left out.

    The ground is the lattice's edge, or the wall that carries the lowest sand there is on a wall.
    """
    height, width = world.shape
    heights = np.zeros(width, np.int64)
    stack_heights(world.planes, world.layout.stride, world.layout.words, top, height, heights)
    return heights


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
