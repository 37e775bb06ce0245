"""Heights: what rests on the ground, counted column by column."""

import numpy as np
import pytest

from game import World
from game.core import planes as bit_planes
from game.world.sand.measure import grains_above, pile, pile_heights


def plain_heights(sand, walls, top):
    """Count from the ground up, cell by cell; nothing rests on air, and no second pile is begun above a first."""
    heights, surface = np.zeros(sand.shape[1], int), np.zeros(sand.shape[1], int)
    for column in range(sand.shape[1]):
        rests = True
        for row in range(sand.shape[0] - 1, top - 1, -1):
            if walls[row, column]:
                rests = rests or heights[column] == 0
            elif sand[row, column]:
                heights[column] += rests
                surface[column] = sand.shape[0] - row if rests else surface[column]
            else:
                rests = False
    return heights, surface


@pytest.mark.parametrize("shape", [(1, 1), (2, 3), (37, 1), (1, 300), (64, 127), (65, 130), (70, 259)])
def test_piles_are_what_rests_on_the_ground_however_full_the_lattice_is(shape):
    generator = np.random.default_rng(80)
    for share in (0.2, 0.9, 0.99, 1.0):
        walls = generator.random(shape) < 0.02
        sand = (generator.random(shape) < share) & ~walls
        world = World.from_cells(sand, walls)
        for top in {0, 1, shape[0] // 2, shape[0]}:
            found = pile(world, top), plain_heights(sand, walls, top)
            assert all((mine == its).all() for mine, its in zip(*found, strict=True))


def test_a_glass_that_stands_above_the_edge_has_its_pile():
    rows = ["#o#", "...", ".o.", "oo.", "###", "..."]
    cells = np.array([list(row) for row in rows])
    assert pile_heights(World.from_cells(cells == "o", cells == "#"), 1).tolist() == [1, 2, 0]


def test_the_deepest_pile_is_counted_to_the_last_grain():
    sand = np.ones((16384, 2), bool)
    assert pile_heights(World.from_cells(sand, ~sand)).tolist() == [16384, 16384]


@pytest.mark.parametrize("shape", [(1, 1), (7, 130), (64, 64), (33, 257)])
def test_grains_above_a_row_are_counted_from_bits_whatever_is_in_the_seams(shape):
    generator = np.random.default_rng(81)
    sand = generator.random(shape) < 0.6
    world = World.from_cells(sand, np.zeros(shape, bool))
    where = world.layout
    world.planes[:4, where.words :: where.stride] = generator.integers(0, 2**63)
    for row in range(-1, shape[0] + 2):
        assert grains_above(world, row) == sand[: max(row, 0)].sum()
    assert bit_planes.count_set(world.filled_planes, where, shape[0]) == sand.sum()
