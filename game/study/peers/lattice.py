"""The lattice of the peers: a byte for each cell, with a border of wall.

The padding completes the blocks that the edge cuts, whatever the offset of the partition.
"""

import numpy as np

EMPTY, SAND, WALL = range(3)


def lattice(world):
    """Return the cells of `world`, an (H + 2, W + 2) uint8 array."""
    height, width = world.shape
    cells = np.full((height + 2, width + 2), WALL, np.uint8)
    inside = cells[1:-1, 1:-1]
    inside[...] = world.sand
    inside[world.walls] = WALL
    return cells


def sand(cells):
    """Return where sand is: an (H, W) bool array."""
    return cells[1:-1, 1:-1] == SAND
