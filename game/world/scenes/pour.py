"""Pouring: sand from one glass into another, in which every grain keeps its place if it can."""

import numpy as np


def pour(grains, room):
    """Return (grains in their new places, how many found none).

    grains: (h, w) uint8, 0 for none, laid over the middle of the new lattice. room: (H, W) bool, where grains may be.
    One that would lie elsewhere is poured onto the sand of its half, or of the other one if that is full.
    """
    poured = np.zeros(room.shape, np.uint8)
    rows, columns = np.nonzero(grains)
    kinds = grains[rows, columns]
    down, across = ((new - old) // 2 for new, old in zip(room.shape, grains.shape, strict=True))
    rows, columns = rows + down, columns + across
    stays = (rows >= 0) & (rows < room.shape[0]) & (columns >= 0) & (columns < room.shape[1])
    stays[stays] = room[rows[stays], columns[stays]]
    poured[rows[stays], columns[stays]] = kinds[stays]
    middle = room.shape[0] // 2
    for half in (slice(0, middle), slice(middle, None)):
        homeless = ~stays & (rows < middle if half.start == 0 else rows >= middle)
        _settle(poured[half], room[half], kinds[homeless], stays, np.flatnonzero(homeless))
    homeless = np.flatnonzero(~stays)
    _settle(poured, room, kinds[homeless], stays, homeless)
    return poured, int(np.count_nonzero(~stays))


def _settle(poured, room, kinds, stays, numbers):
    """Put grains into the lowest free cells, the nearest to the axis first, in place; mark those that found one."""
    if not len(kinds):
        return
    free = room & (poured == 0)
    below = np.cumsum(np.count_nonzero(free, axis=1)[::-1])[::-1]  # free cells in each row and those under it
    top = max(0, np.count_nonzero(below >= len(kinds)) - 1)  # the rows from here on hold all, if any rows do
    rows, columns = np.nonzero(free[top:])
    rows, axis = rows + top, (room.shape[1] - 1) / 2
    places = np.lexsort((np.abs(columns - axis), -rows))[: len(kinds)]
    poured[rows[places], columns[places]] = kinds[: len(places)]
    stays[numbers[: len(places)]] = True
