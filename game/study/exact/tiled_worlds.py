"""Large worlds tiled with copies of a small lattice, to run many histories at once.

Copies stand at even places, so that their blocks are those of the lattice itself, with walls between them. In a single
stack a copy's left edge is the world's own; side by side they have seams between words in all places.
"""

import numpy as np

from game import World, advance
from game.world.sand.parameters import SIDE

ACROSS = 1000  # copies side by side: worlds some 8000 cells wide, of many words and with seams
SAND, WALL = np.frombuffer(b"o#", np.uint8)
DOWN = 128  # such rows of copies in a world: 8 million cells at a time


def sand_and_walls(rows):
    """Return (sand, walls), two (H, W) bool arrays, of rows of '.', 'o' and '#'."""
    cells = np.array([list(map(ord, row)) for row in rows], np.uint8)
    return cells == SAND, cells == WALL


def stacked_states(rows, rule, iterations, runs, seed):
    """Return the (runs,) uint64 states of copies in stacks, each with edges of its own, after `iterations`.

    A state has bit y·W + x set where cell (x, y) of the copy holds sand.
    """
    return _states(rows, rule, iterations, runs, seed, across=1, margin=0, down=SIDE.high // _tile_height(rows))


def tiled_states(rows, rule, iterations, runs, seed):
    """Return the (runs,) uint64 states of copies set in walls, side by side in wide worlds, after `iterations`."""
    return _states(rows, rule, iterations, runs, seed, across=ACROSS, margin=2, down=DOWN)


def _tile_height(rows):
    return len(rows) + 2 - len(rows) % 2


def _states(rows, rule, iterations, runs, seed, across, margin, down):
    """Run world after world, of `down` by `across` copies with seeds in a row, until there are enough copies."""
    down = min(down, -(-runs // across))
    first = _world(rows, across, margin, down)
    worlds = -(-runs // (across * down))
    states = [_run(first, rule, iterations, seed + number) for number in range(worlds)]
    shape = down, _tile_height(rows), across, first.shape[1] - margin
    return np.concatenate([_encode(sand[:, margin:], shape, rows) for sand in states])[:runs]


def _world(rows, across, margin, down):
    """Return a world of copies, walls between them and `margin` columns of walls on their left."""
    height, width = _tile_height(rows), len(rows[0]) + (2 - len(rows[0]) % 2 if across > 1 else 0)
    tile = np.full((height, width), WALL, np.uint8)
    tile[: len(rows), : len(rows[0])] = [list(map(ord, row)) for row in rows]
    cells = np.tile(tile, (down, across))
    if margin:
        cells = np.hstack([np.full((len(cells), margin), WALL), cells])
    return World.from_cells(cells == SAND, cells == WALL)


def _run(first, rule, iterations, seed):
    world = first.copy()
    world.seed = seed
    advance(world, rule, iterations)
    return world.sand


def _encode(sand, shape, rows):
    """Return the states of the copies in a world's sand. shape: copies down, height of each, copies across, columns."""
    down, height, across, width = shape
    cells = sand.reshape(down, height, across, width // across)[:, : len(rows), :, : len(rows[0])]
    bits = np.zeros((down * across, 64), bool)
    bits[:, : len(rows) * len(rows[0])] = cells.transpose(0, 2, 1, 3).reshape(down * across, -1)
    return np.packbits(bits, axis=1, bitorder="little").view("<u8")[:, 0]
