"""The lattice of the peers: a byte for each cell, with a border of wall.

The padding completes the blocks that the edge cuts, whatever the offset of the partition.
"""

import numpy as np

EMPTY, SAND, WALL = range(3)


def lattice(world):
    """Return the cells of `world` by code, an (H + 2, W + 2) uint8 array; its border is wall."""
    return np.pad(world.materials, 1, constant_values=world.codes.wall)


def sand(cells):
    """Return where sand is: an (H, W) bool array."""
    return cells[1:-1, 1:-1] == SAND
