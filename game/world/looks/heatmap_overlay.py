"""The heatmap overlay: lays the levels of a forecast over pixels of the sand."""

from functools import lru_cache

import numpy as np

from game.core.draw.heatmap import covers_of, lay_heat, mean_levels
from game.world.looks.heatmap_colours import cover, density_cover, mark_cover


class HeatmapOverlay:
    """Levels, (height, width) uint8, over the cells of a CropBox."""

    def __init__(self, box, levels, covers):
        """`covers`: how levels look, `forecast_covers` or another function of map_rgb, see `themes.palette`."""
        self.covers = covers
        self._box, self._all = box, levels
        self._view = None  # the view that everything below is computed for

    def draw(self, pixels, view, spans, map_rgb):
        """Lay the heat over the spans (top, bottom) of rows of `pixels`, an (h, w) uint32 array, in place, once."""
        if view is not self._view:
            self._look_through(view)
            self._covers = self.covers(map_rgb)
        for top, bottom in spans:
            rows = self._rows[max(top - self._top, 0) : max(bottom - self._top, 0)]
            lay_heat(self._levels, self._covers, self._columns, rows, pixels, max(top, self._top), self._left)

    def _look_through(self, view):
        """Find out which level each pixel shows; where pixels hold many cells, the mean of their levels."""
        self._view, box = view, self._box
        if view.dense:
            first, columns = _edges_inside(view.column_edges, box.left, box.width)
            above, rows = _edges_inside(view.row_edges, box.top, box.height)
            self._levels = np.empty((max(len(rows) - 1, 0), max(len(columns) - 1, 0)), np.uint8)
            mean_levels(self._all, columns, rows, self._levels)
            self._rows, self._columns = (np.arange(side, dtype=np.int32) for side in self._levels.shape)
        else:
            first, self._columns = _inside(view.columns, box.left, box.width)
            above, self._rows = _inside(view.rows, box.top, box.height)
            self._levels = self._all
        self._left, self._top = view.seen[0] + first, view.seen[1] + above


@lru_cache(maxsize=8)
def forecast_covers(map_rgb):
    """Return how the levels of a forecast look over sand."""
    return covers_of(*cover(map_rgb))


@lru_cache(maxsize=8)
def stale_covers(map_rgb):
    """Return how the levels of a forecast look that no longer fits the sand."""
    return covers_of(*cover(map_rgb, stale=True))


@lru_cache(maxsize=8)
def density_covers(map_rgb):
    """Return how the levels of a density map look, which leaves nothing of the sand below it to be seen."""
    return covers_of(*density_cover(map_rgb))


@lru_cache(maxsize=8)
def mark_covers(colour):
    """Return a function of map_rgb that returns how cells look that are marked with a colour, RGB."""

    @lru_cache(maxsize=8)
    def covers(map_rgb):
        return covers_of(*mark_cover(map_rgb, colour))

    return covers


def _inside(cells, first, size):
    """Return (number of the first pixel that shows one of `size` cells from `first`, the cells shown from there on).

    cells: the lattice's row or column of each pixel, rising. The cells returned count from `first`.
    """
    low, high = np.searchsorted(cells, (first, first + size))
    return int(low), np.ascontiguousarray(cells[low:high] - np.int32(first))


def _edges_inside(edges, first, size):
    """Return (number of the first pixel all of whose cells are among `size` from `first`, the edges from there on)."""
    low, high = np.searchsorted(edges, first), np.searchsorted(edges, first + size, side="right")
    return int(low), np.ascontiguousarray(edges[low:high] - np.int32(first))
