"""The neck: the one narrow gap in the walls that all sand above it must pass."""

from dataclasses import dataclass

import numpy as np

from game.core import planes as bit_planes
from game.world.sand.material_codes import EMPTY

FUNNEL = 2  # how many times wider than a neck the room above it is, at least
TRIES = 12  # narrow places that are looked at; more only where walls are strewn about, which have no neck


@dataclass(frozen=True, eq=False)
class Neck:
    """A gap between two walls. above: from where sand can come to it, four planes of a layout."""

    row: int  # the first row that is not above
    columns: slice
    above: np.ndarray  # (4, length) uint64

    def grains_above(self, world):
        """Return how many grains have the neck still before them, or will never pass it."""
        return int(np.bitwise_count(world.filled_planes & self.above).sum())


def find_neck(world):
    """Return the Neck of a world, or None where sand has several ways down or no narrow one.

    It is the narrowest gap between two walls of one row through which alone the sand in the wider room above can go
    down; of equally narrow ones the nearest to the middle of the lattice. With no sand above it is the neck of a glass
    that has run out, or of an empty one: a wider room lies below too, with sand in it, if there is any, that can have
    come through the gap alone, and none is as high.
    """
    walls = world.walls
    sand = bit_planes.unpack_where(world.planes, world.layout, world.codes.filled)
    for row, start, end in _gaps(walls):
        above = _cells_above(walls, row, start, end)
        if not _is_wide(above, end - start) or not _is_only_way(sand & above, walls, row, start, end):
            continue
        if (sand & above).any() or (not sand[:row].any() and _has_run_out(sand, walls, row, start, end)):
            planes = bit_planes.pack(above.view(np.uint8), world.layout._replace(outside=EMPTY))
            return Neck(row, slice(start, end), planes[:4])
    return None


def _gaps(walls):
    """Return up to TRIES (row, start, end) of gaps narrower than any other of their rows, the narrowest first."""
    height, width = walls.shape
    edges = np.diff(np.pad(~walls, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    rows, starts = np.nonzero(edges == 1)
    ends = np.nonzero(edges == -1)[1]
    between = (starts > 0) & (ends < width) & (rows > 0)
    rows, starts, ends = rows[between], starts[between], ends[between]
    wide = ends - starts
    narrowest = np.full(height, width + 1)
    np.minimum.at(narrowest, rows, wide)
    is_narrowest = wide == narrowest[rows]
    alone = is_narrowest & (np.bincount(rows[is_narrowest], minlength=height)[rows] == 1)
    order = np.lexsort((np.abs(2 * rows - height), wide))
    chosen = [number for number in order if alone[number]][:TRIES]
    return [(int(rows[number]), int(starts[number]), int(ends[number])) for number in chosen]


def _cells_above(walls, row, start, end):
    """Return the cells above `row` from which sand can fall and topple to the gap there, (H, W) bool."""
    above = np.zeros_like(walls)
    reached = np.zeros(walls.shape[1], bool)
    reached[start:end] = True
    for y in range(row - 1, -1, -1):
        reached = above[y] = _runs_with(reached, ~walls[y])
        if not reached.any():
            break
    return above


def _has_run_out(sand, walls, row, start, end):
    """Return whether a wide room lies below a gap, with sand in it, if there is any, that came through there alone."""
    sand, walls, row = sand[::-1], walls[::-1], len(walls) - 1 - row
    below = _cells_above(walls, row, start, end)
    fallen = sand & below
    came = fallen.any() and _is_only_way(fallen, walls, row, start, end)
    return _is_wide(below, end - start) and (came or not sand.any())


def _is_wide(room, gap):
    """Return whether a room, (H, W) bool, is much wider than a gap."""
    return room.sum(axis=1).max() >= FUNNEL * gap


def _is_only_way(sand, walls, row, start, end):
    """Return whether `sand`, all of it above `row`, can come to that row in the gap alone."""
    reached = np.zeros(walls.shape[1], bool)
    for y in range(row + 1):
        reached = _runs_with(reached | sand[y], ~walls[y])
    reached[start:end] = False
    return not reached.any()


def _runs_with(marked, free):
    """Return the cells of a row that no wall parts from a marked one; marked, free: (W,) bool."""
    numbers = np.cumsum(np.diff(free, prepend=False))  # of each stretch of free cells or of walls
    hit = np.zeros(numbers[-1] + 1, bool)
    hit[numbers[marked & free]] = True
    return free & hit[numbers]
