"""The veil: a forecast's heat, laid over the sand where the stage has just drawn it."""

import numpy as np

from game.core.heat import lay_heat
from game.world.heat_colours import cover


class Veil:
    """One forecast as it lies over the stage; another one is another veil."""

    def __init__(self, part, levels, stale):
        self.stale = stale
        self._part, self._levels = part, levels
        self._view = None  # what the maps below are for

    def draw(self, pixels, view, spans, map_rgb):
        """Lay the heat over the spans (top, bottom) of rows of `pixels`, an (h, w) uint32 array, in place, once."""
        if view is not self._view:
            self._view = view
            first, self._columns = _inside(view.columns, self._part.left, self._part.width)
            above, self._rows = _inside(view.rows, self._part.top, self._part.height)
            self._left, self._top = view.seen[0] + first, view.seen[1] + above
            self._cover = cover(map_rgb, self.stale)
        for top, bottom in spans:
            rows = self._rows[max(top - self._top, 0) : max(bottom - self._top, 0)]
            lay_heat(self._levels, *self._cover, self._columns, rows, pixels, max(top, self._top), self._left)


def _inside(cells, first, size):
    """Return (number of the first pixel that shows one of `size` cells from `first`, the cells shown from there on).

    cells: the lattice's row or column of each pixel, rising. The cells returned count from `first`.
    """
    low, high = np.searchsorted(cells, (first, first + size))
    return int(low), np.ascontiguousarray(cells[low:high] - np.int32(first))
