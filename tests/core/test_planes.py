"""The layout: cells go into planes and come out as they were."""

import numpy as np
import pytest

from game.core import planes
from tests.cells import random_world

SHAPES = [(1, 1), (1, 300), (300, 1), (2, 2), (5, 127), (5, 128), (5, 129), (64, 255), (65, 256), (66, 257)]


@pytest.mark.parametrize(("height", "width"), SHAPES)
def test_cells_come_out_of_planes_as_they_went_in(height, width):
    generator = np.random.default_rng(1)
    walls = generator.random((height, width)) < 0.3
    sand = (generator.random((height, width)) < 0.5) & ~walls
    where, packed = planes.layout(height, width), planes.pack(sand, walls)
    assert (planes.unpack(packed, where) == sand).all()
    assert (planes.unpack(packed, where, planes.WALLS) == walls).all()
    assert planes.count(packed, where) == sand.sum()


@pytest.mark.parametrize(("height", "width"), SHAPES)
def test_bands_are_the_cells_from_top_to_bottom(height, width):
    world = random_world(np.random.default_rng(2), height, width)
    assert (np.concatenate(list(planes.bands(world.planes, world.layout))) == world.sand).all()


def test_planes_of_power_of_two_widths_do_not_start_at_the_same_place_in_a_page():
    length = planes.layout(4096, 4096).length
    starts = {plane * length % planes.PAGE for plane in range(planes.PLANES)}
    assert len(starts) == planes.PLANES


def test_the_largest_lattice_takes_at_most_200_megabytes():
    assert planes.PLANES * planes.layout(16384, 16384).length * 8 <= 200e6
