"""The stir: how much sand moved between two looks, and where from left to right; cheap, from a sample of its rows."""

import numpy as np

from game.core.planes import BITS, SAND, WALLS

MOST_ROWS = 128  # plane rows that are looked at
ZONES = 8  # from left to right: the bytes of a word


class Stir:
    """Remembers some rows of the sand as they were."""

    def __init__(self):
        self._rows = self._layout = None

    def look(self, world):
        """Return (grains, side): how many moved since the last look, about; the middle of them, -1 left … 1 right.

        The first look at a lattice sees nothing move. A grain that moved and was followed by another is not seen.
        """
        where = world.layout
        step = -(-where.rows // MOST_ROWS)
        sand = world.planes[SAND:WALLS, : where.rows * where.stride].reshape(4, where.rows, where.stride)
        rows = np.ascontiguousarray(sand[:, ::step, : where.words])
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
