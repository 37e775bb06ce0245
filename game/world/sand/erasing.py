"""Which fixtures an eraser reaches: those of which it comes over the middle of a cell.

Brushes and figures are convex and the same on both sides of their middle, so that a few cells stand for all the others.
"""

import numpy as np

from game.core.paint.primitives import covers
from game.core.paint.strokes import comes_over


def is_in_figure(fixture, kind, box):
    """Return whether a filled figure of core.paint.primitives that fills `box` covers a cell of the fixture."""
    left, top, right, bottom = fixture.box
    column = _nearest((box[0] + box[2] - 1) / 2, left, right)
    row = _nearest((box[1] + box[3] - 1) / 2, top, bottom)
    return bool(covers(kind, column, row, *box))


def is_under_brush(fixture, shape, start, end, radius):
    """Return whether a brush of core.paint.strokes comes over a cell of the fixture from `start` to `end`."""
    (x0, y0), (x1, y1) = start, end
    left, top, right, bottom = fixture.box
    first = max(top, int(np.floor(min(y0, y1) - radius)) - 1)
    rows = np.arange(first, min(bottom, int(np.ceil(max(y0, y1) + radius)) + 2))
    part = np.clip((rows + 0.5 - y0) / (y1 - y0), 0.0, 1.0) if y0 != y1 else np.zeros(len(rows))
    way = x0 + part * (x1 - x0) - 0.5  # nowhere in its row is the brush nearer to where it goes
    columns = np.clip(way, left, right - 1)
    for number in np.argsort(np.abs(columns - way), kind="stable").tolist():
        row = int(rows[number])
        for column in {int(np.floor(columns[number])), int(np.ceil(columns[number]))}:
            if comes_over(shape, column, row, *start, *end, radius):
                return True
    return False


def _nearest(middle, first, end):
    """Return the number in [first, end) of the cell nearest to a middle."""
    return int(min(max(np.floor(middle + 0.5), first), end - 1))
