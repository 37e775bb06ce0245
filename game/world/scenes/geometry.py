"""Regions of the plane that shapes cover, in cells of the scene: x to the right, y down, from its upper left corner."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

TIE = 1e-9  # cells: a centre this near to an edge lies on it, so that mirrored shapes stay mirrored


@dataclass(frozen=True)
class Region:
    """A part of the plane within the bounds; inside(x, y), for sorted x (W,) and y (H, 1), is (H, W) bool."""

    left: float
    top: float
    right: float
    bottom: float
    inside: Callable
    parts: tuple = ()  # (left, top, right, bottom) of what `inside` works on one by one, if not on the whole at once


def rectangle(left, top, width, height):
    """Return the region of a rectangle: its left and upper edges belong to it, the other two do not."""
    return Region(left, top, left + width, top + height, _within(left, top, width, height))


def ellipse(left, top, width, height):
    """Return the region of the ellipse that touches the four sides of a rectangle."""
    middle_x, middle_y = left + width / 2, top + height / 2

    def inside(x, y):
        return ((x - middle_x) / (width / 2)) ** 2 + ((y - middle_y) / (height / 2)) ** 2 <= 1.0 + TIE

    return Region(left, top, left + width, top + height, inside)


def stroke(points, reach):
    """Return the region within `reach` of the straight lines that lead from point (x, y) to point."""

    def inside(x, y):
        near = np.zeros((len(y), len(x)), bool)
        for start, end in pairwise(points):
            columns, rows = _span(x, start[0], end[0], reach), _span(y[:, 0], start[1], end[1], reach)
            near[rows, columns] |= _distance2(x[columns], y[rows], start, end) <= reach**2 + TIE
        return near

    xs, ys = np.array(points).T
    lows, highs = (np.array([side(each[:-1], each[1:]) for each in (xs, ys)]) for side in (np.minimum, np.maximum))
    parts = tuple(zip(*(lows - reach), *(highs + reach), strict=True))
    return Region(xs.min() - reach, ys.min() - reach, xs.max() + reach, ys.max() + reach, inside, parts)


def polygon(points):
    """Return the region that the closed line through `points` encloses an odd number of times, and the line itself."""
    closed = [*points, points[0]]
    outline = stroke(closed, TIE)

    def inside(x, y):
        odd = np.zeros((len(y), len(x)), bool)
        for (x0, y0), (x1, y1) in pairwise(closed):
            rows = slice(*np.searchsorted(y[:, 0], (min(y0, y1), max(y0, y1))))
            odd[rows] ^= x < x0 + (y[rows] - y0) * ((x1 - x0) / (y1 - y0 or 1.0))
        return odd | outline.inside(x, y)

    across = tuple((outline.left, top, outline.right, bottom) for _, top, _, bottom in outline.parts)
    return Region(outline.left, outline.top, outline.right, outline.bottom, inside, outline.parts + across)


def bars(left, top, width, height, size, across):
    """Return upright bars `size` wide in a rectangle, one on its axis, the next ones `across` further on each side."""
    within, middle = _within(left, top, width, height), left + width / 2

    def inside(x, y):
        return within(x, y) & (_beside(x - middle, across) <= size / 2 + TIE)

    return Region(left, top, left + width, top + height, inside)


def pegs(left, top, width, height, size, across, down):
    """Return diamonds `size` wide in a rectangle, `across` apart in rows `down` apart, every other row displaced."""
    within, middle = _within(left, top, width, height), left + width / 2

    def inside(x, y):
        row = np.floor((y - top) / down)
        beside = _beside(x - middle - across / 2 * (row % 2), across)
        above = np.abs((y - top) - (row + 0.5) * down)
        return within(x, y) & (beside + above <= size / 2 + TIE)

    return Region(left, top, left + width, top + height, inside)


def slats(left, top, width, height, size, thickness, share, seed):
    """Return slanting bars, corner to corner in squares of a grid in a rectangle, to either side by chance.

    share: the part of the squares that have one. seed: picks which, and their slants.
    """
    within = _within(left, top, width, height)

    def inside(x, y):
        column, row = np.floor((x - left) / size), np.floor((y - top) / size)
        along, down = x - left - column * size, y - top - row * size
        coin = _coin(column.astype(np.int64), row.astype(np.int64), seed)
        rises, there = coin & 1 == 1, coin >> 1 < share * 2**15
        beside = np.abs(np.where(rises, along + down - size, along - down)) / np.sqrt(2)
        return within(x, y) & (beside <= thickness / 2 + TIE) & there

    return Region(left, top, left + width, top + height, inside)


def _coin(column, row, seed):
    """Return a number in [0, 2**16) for each square, (H, W) int64: the same for the same square and seed."""
    z = column * 0x9E3779B1 + row * 0x85EBCA77 + seed * 0xC2B2AE3D
    z = (z ^ (z >> 15)) * 0x2C1B3C6D & 0xFFFFFFFF
    return (z ^ (z >> 12)) & 0xFFFF


def _within(left, top, width, height):
    right, bottom = left + width, top + height
    return lambda x, y: (x >= left - TIE) & (x < right - TIE) & (y >= top - TIE) & (y < bottom - TIE)


def _beside(distance, across):
    """Return how far `distance` is from the nearest multiple of `across`."""
    return np.abs((distance + across / 2) % across - across / 2)


def _span(centres, one, other, reach):
    """Return the slice of the sorted `centres` between `one` and `other`, and `reach` beyond either."""
    beyond = reach + 2 * TIE**0.5  # no less than what the tie allows
    return slice(*np.searchsorted(centres, (min(one, other) - beyond, max(one, other) + beyond)))


def _distance2(x, y, start, end):
    """Return the squared distance of (x, y) from the straight line that leads from `start` to `end`."""
    along_x, along_y = end[0] - start[0], end[1] - start[1]
    from_x, from_y = x - start[0], y - start[1]
    part = np.clip((from_x * along_x + from_y * along_y) / ((along_x**2 + along_y**2) or 1.0), 0.0, 1.0)
    return (from_x - part * along_x) ** 2 + (from_y - part * along_y) ** 2
