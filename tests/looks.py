"""What every cell looks like: the plain twin of the drawing."""

import numpy as np

from game.core.draw import cells, glass_decor


def looks_of(sand, walls, places=None):
    """Return the (H, W) looks of cells; places: (H, W) what decorates them, or None."""
    height, width = sand.shape

    def is_wall(y, x):
        return y >= 0 and (y >= height or not 0 <= x < width or walls[y, x])

    def is_covered(y, x):
        return y >= 0 and (sand[y, x] or walls[y, x])

    def look(y, x):
        left, right, above, below = (is_wall(*at) for at in ((y, x - 1), (y, x + 1), (y - 1, x), (y + 1, x)))
        place = glass_decor.FREE if places is None else places[y, x]
        if walls[y, x]:
            body, rim, edge = (cells.WALL, cells.RIM, cells.EDGE)
            if place == glass_decor.WOOD:
                body, rim, edge = (cells.WOOD, cells.WOOD_RIM, cells.WOOD_EDGE)
            return body if left and above and right and below else rim if not (left and above) else edge
        if sand[y, x]:
            if not is_covered(y - 1, x):
                return cells.SURFACE
            if left or right or above:
                return cells.GRAIN_BY_WALL
            return cells.GRAIN if is_covered(y - 2, x) else cells.UNDER
        if place >= glass_decor.GLEAM:
            return cells.GLEAM if place == glass_decor.GLEAM else cells.POST
        by_wall = left or right or above or below
        if place == glass_decor.INSIDE:
            return cells.INSIDE_BY_WALL if by_wall else cells.INSIDE
        return cells.AIR_BY_WALL if by_wall else cells.AIR

    return np.array([[look(y, x) for x in range(width)] for y in range(height)])
