"""What every cell looks like: the plain twin of the drawing."""

import numpy as np

from game.core import decor, pixels


def looks_of(sand, walls, places=None):
    """Return the (H, W) looks of cells; places: (H, W) what decorates them, or None."""
    height, width = sand.shape

    def is_wall(y, x):
        return y >= 0 and (y >= height or not 0 <= x < width or walls[y, x])

    def is_covered(y, x):
        return y >= 0 and (sand[y, x] or walls[y, x])

    def look(y, x):
        left, right, above, below = (is_wall(*at) for at in ((y, x - 1), (y, x + 1), (y - 1, x), (y + 1, x)))
        place = decor.FREE if places is None else places[y, x]
        if walls[y, x]:
            body, rim, edge = (pixels.WALL, pixels.RIM, pixels.EDGE)
            if place == decor.WOOD:
                body, rim, edge = (pixels.WOOD, pixels.WOOD_RIM, pixels.WOOD_EDGE)
            return body if left and above and right and below else rim if not (left and above) else edge
        if sand[y, x]:
            if not is_covered(y - 1, x):
                return pixels.SURFACE
            if left or right or above:
                return pixels.GRAIN_BY_WALL
            return pixels.GRAIN if is_covered(y - 2, x) else pixels.UNDER
        if place >= decor.GLEAM:
            return pixels.GLEAM if place == decor.GLEAM else pixels.POST
        by_wall = left or right or above or below
        if place == decor.INSIDE:
            return pixels.INSIDE_BY_WALL if by_wall else pixels.INSIDE
        return pixels.AIR_BY_WALL if by_wall else pixels.AIR

    return np.array([[look(y, x) for x in range(width)] for y in range(height)])
