"""Small worlds as rows of characters: '.' empty, 'o' sand, '#' wall; or strewn at random."""

import numpy as np

from game import World
from game.world.rules.rule import PROBABILITIES
from game.world.scenes.hourglass_spec import Glass

NAMES = [each.name for each in PROBABILITIES]


def world_of(rows, seed=0):
    """Return a World from rows of characters."""
    cells = np.array([list(row) for row in rows])
    return World.from_cells(cells == "o", cells == "#", seed)


def rows_of(world):
    """Return the world's cells as rows of characters."""
    letters = np.where(world.walls, "#", np.where(world.sand, "o", "."))
    return ["".join(row) for row in letters]


def random_world(generator, height, width, seed=0, sand=0.4, walls=0.2):
    """Return a World with sand and walls strewn at random."""
    wall_cells = generator.random((height, width)) < walls
    return World.from_cells((generator.random((height, width)) < sand) & ~wall_cells, wall_cells, seed)


def strewn(rule, number, height, width, lumps=1):
    """Return a World with all materials of a rule strewn at random, in squares of so many cells."""
    shape = -(-height // lumps), -(-width // lumps)
    codes = np.random.default_rng(number).integers(0, len(rule.materials), shape, np.uint8)
    cells = codes.repeat(lumps, axis=0).repeat(lumps, axis=1)[:height, :width]
    return World.from_materials(cells, rule, seed=number)


def coloured(world, generator):
    """Return the world with a colour at random for each grain."""
    colours = generator.integers(0, 8, world.shape, np.uint8) * world.sand
    dyed = World.from_cells(world.sand, world.walls, world.seed, colours)
    dyed.iteration = world.iteration
    return dyed


def joined_to(cells, row, column):
    """Return the places (row, column) that one is joined to, side by side, through cells like its own: a plain walk."""
    reached, waiting = {(row, column)}, [(row, column)]
    while waiting:
        y, x = waiting.pop()
        for near in ((y - 1, x), (y + 1, x), (y, x - 1), (y, x + 1)):
            inside = 0 <= near[0] < cells.shape[0] and 0 <= near[1] < cells.shape[1]
            if inside and near not in reached and cells[near] == cells[row, column]:
                reached.add(near)
                waiting.append(near)
    return reached


def small_glass(height):
    """Return a thin Glass of that height."""
    return Glass(round(0.75 * height), height, height // 12, 1, curve=0.95, wall=1)


def grains_over_a_pile_below_a_band():
    """Return a World in which grains fall out of the first band of rows onto a pile whose top is in the second."""
    sand, walls = np.zeros((1100, 12), bool), np.zeros((1100, 12), bool)
    end = 2 * World.from_cells(sand, walls).activity.band_rows
    walls[end + 5] = True
    sand[end + 1 : end + 5] = True
    for x in range(0, 12, 3):
        sand[end - 9 - x, x] = True
    return World.from_cells(sand, walls)
