"""A canvas: an empty scene of any size under any rule, with walls around it or without."""

import numpy as np

from game.world.sand import parameters
from game.world.scenes.scene import Scene

CELLS_PER_WALL = 200  # a canvas so many cells high has walls two cells thick, and so on


def canvas(width, height, rule, walls=False):
    """Return an empty Scene of width × height cells; walls: along all four sides."""
    cells = np.zeros((height, width), np.uint8)
    if walls:
        thick = 1 + min(width, height) // CELLS_PER_WALL
        cells[:thick] = cells[-thick:] = cells[:, :thick] = cells[:, -thick:] = rule.codes.wall
    title = f"Canvas {width}×{height}"
    speed, cell = parameters.SPEED.default, parameters.CELL.default
    return Scene("canvas", title, "", cells, rule, speed, cell)
