"""The lattice of the peers: a byte for each cell, with a row and a column of wall past the lower right edges.

The padding completes the blocks that the edge cuts, whatever the offset of the partition.
"""

import numpy as np

EMPTY, SAND, WALL = range(3)


def lattice(world):
    """Return the cells of `world`, an (H + 1, W + 1) uint8 array."""
    height, width = world.shape
    cells = np.full((height + 1, width + 1), WALL, np.uint8)
    inside = cells[:height, :width]
    inside[...] = world.sand
    inside[world.walls] = WALL
    return cells


def sand(cells):
    """Return where sand is: an (H, W) bool array."""
    return cells[:-1, :-1] == SAND
