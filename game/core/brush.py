"""Strokes on planes: cells near a line become sand, wall or empty."""

import numpy as np

from game.core.jit import gate, kernel
from game.core.planes import SAND, SHIFTED_WALLS, WALLS

ERASE, PAINT_SAND, PAINT_WALL = range(3)

_ONE = np.uint64(1)


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
def _set(plane, at, bit, on):
    plane[at] = plane[at] | bit if on else plane[at] & ~bit


@gate
def _set_wall(planes, plane, start, word, words, bit, on):
    """Set a wall's bit, and in even columns its copy for odd x."""
    _set(planes[WALLS + plane], start + word, bit, on)
    if plane & 1:
        return
    copy = planes[SHIFTED_WALLS + (plane >> 1)]
    if word:
        _set(copy, start + word, bit, on)
    elif bit > _ONE:
        _set(copy, start + words, bit >> _ONE, on)


@kernel
def stroke(planes, height, width, words, x0, y0, x1, y1, radius, material, over_walls):
    """Paint the cells whose middle is within `radius` of the line from (x0, y0) to (x1, y1), in place.

    Lengths are in cells. Sand leaves walls standing unless `over_walls`. Return the change in grains.
    """
    painted = 0
    reach = radius * radius + 1e-9
    for y in range(max(0, int(np.floor(min(y0, y1) - radius))), min(height, int(np.ceil(max(y0, y1) + radius)) + 1)):
        for x in range(max(0, int(np.floor(min(x0, x1) - radius))), min(width, int(np.ceil(max(x0, x1) + radius)) + 1)):
            if _distance_squared(x + 0.5, y + 0.5, x0, y0, x1, y1) > reach:
                continue
            plane = 2 * (y & 1) + (x & 1)
            lane = (x >> 1) // words
            word = (x >> 1) - lane * words
            start = (y >> 1) * (words + 1)
            at = start + word
            bit = _ONE << np.uint64(lane)
            was_sand = (planes[SAND + plane, at] & bit) != 0
            is_wall = (planes[WALLS + plane, at] & bit) != 0
            if material == PAINT_SAND and is_wall and not over_walls:
                continue
            is_sand = material == PAINT_SAND
            _set(planes[SAND + plane], at, bit, is_sand)
            _set_wall(planes, plane, start, word, words, bit, material == PAINT_WALL)
            painted += int(is_sand) - int(was_sand)
    return painted
