"""Figures on planes: the cells of a rectangle or an ellipse, filled or only their edge, take ink."""

from game.core.jit import gate, kernel
from game.core.paint.ink import put

RECTANGLE, ELLIPSE = range(2)
TIE = 1e-9  # of the radius: a middle this near to the edge lies on it


@gate
def _inside(kind, x, y, middle_x, middle_y, radius_x, radius_y):
    """Return whether a point is in the figure that reaches so far from its middle."""
    if radius_x <= 0.0 or radius_y <= 0.0:
        return False
    across, down = abs(x - middle_x) / radius_x, abs(y - middle_y) / radius_y
    if kind == ELLIPSE:
        return across * across + down * down <= 1.0 + TIE
    return max(across, down) <= 1.0


@kernel
def covers(kind, x, y, left, top, right, bottom):
    """Return whether a figure that is not only its edge reaches the cell in column x and row y."""
    radius_x, radius_y = (right - left) / 2, (bottom - top) / 2
    return _inside(kind, x + 0.5, y + 0.5, (left + right) / 2, (top + bottom) / 2, radius_x, radius_y)


@kernel
def figure(planes, height, width, words, kind, left, top, right, bottom, edge, tally):
    """Let the cells of the figure that fills columns left … right - 1, rows top … bottom - 1 take the ink of a Tally.

    edge: how many cells of it are drawn inwards from its outline; 0 draws all.
    """
    middle_x, middle_y = (left + right) / 2, (top + bottom) / 2
    radius_x, radius_y = (right - left) / 2, (bottom - top) / 2
    for y in range(max(0, top), min(height, bottom)):
        for x in range(max(0, left), min(width, right)):
            if not _inside(kind, x + 0.5, y + 0.5, middle_x, middle_y, radius_x, radius_y):
                continue
            if edge and _inside(kind, x + 0.5, y + 0.5, middle_x, middle_y, radius_x - edge, radius_y - edge):
                continue
            put(planes, words, x, y, tally)
