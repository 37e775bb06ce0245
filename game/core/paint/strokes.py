"""Strokes on planes: cells near a line take ink."""

import numpy as np

from game.core.jit import gate, kernel
from game.core.paint.ink import put

ROUND, SQUARE, DIAMOND = range(3)  # shapes of a brush
TIE = 1e-9  # cells: a middle this near to the edge lies on it


@gate
def _distance_squared(x, y, x0, y0, x1, y1):
    """Return the squared distance of a point from the line from (x0, y0) to (x1, y1)."""
    along_x, along_y = x1 - x0, y1 - y0
    length = along_x * along_x + along_y * along_y
    part = 0.0 if length == 0.0 else ((x - x0) * along_x + (y - y0) * along_y) / length
    part = min(max(part, 0.0), 1.0)
    away_x, away_y = x - x0 - part * along_x, y - y0 - part * along_y
    return away_x * away_x + away_y * away_y


@gate
def _while_near(away, along, radius):
    """Return (from, to), the parts of a line `along` one axis at which a point `away` from its start is within reach.

    to < from where it never is.
    """
    if along == 0.0:
        return (0.0, 1.0) if abs(away) <= radius else (1.0, 0.0)
    one, other = (away - radius) / along, (away + radius) / along
    return max(min(one, other), 0.0), min(max(one, other), 1.0)


@gate
def _in_square(x, y, x0, y0, x1, y1, radius):
    """Return whether a point is in the square of half width `radius` that moves from (x0, y0) to (x1, y1)."""
    from_x, to_x = _while_near(x - x0, x1 - x0, radius)
    from_y, to_y = _while_near(y - y0, y1 - y0, radius)
    return max(from_x, from_y) <= min(to_x, to_y) + TIE


@gate
def _reached(shape, x, y, x0, y0, x1, y1, radius):
    """Return whether a brush that moves from (x0, y0) to (x1, y1) comes over a point."""
    if shape == SQUARE:
        return _in_square(x, y, x0, y0, x1, y1, radius + TIE)
    if shape == DIAMOND:  # a square in axes turned by 45 degrees
        return _in_square(x + y, x - y, x0 + y0, x0 - y0, x1 + y1, x1 - y1, radius + TIE)
    return _distance_squared(x, y, x0, y0, x1, y1) <= radius * radius + TIE


@kernel
def comes_over(shape, x, y, x0, y0, x1, y1, radius):
    """Return whether `stroke` reaches the cell in column x and row y."""
    return _reached(shape, x + 0.5, y + 0.5, x0, y0, x1, y1, radius)


@kernel
def stroke(planes, height, width, words, x0, y0, x1, y1, radius, shape, tally):
    """Let the cells take the ink of a Tally whose middle a brush comes over from (x0, y0) to (x1, y1), in place.

    Lengths are in cells; radius: half the brush's width.
    """
    for y in range(max(0, int(np.floor(min(y0, y1) - radius))), min(height, int(np.ceil(max(y0, y1) + radius)) + 1)):
        for x in range(max(0, int(np.floor(min(x0, x1) - radius))), min(width, int(np.ceil(max(x0, x1) + radius)) + 1)):
            if _reached(shape, x + 0.5, y + 0.5, x0, y0, x1, y1, radius):
                put(planes, words, x, y, tally)
