"""The layout: cells go into planes and come out as they were."""

import numpy as np
import pytest

from game.core import planes
from tests.cells import random_world
from tests.sweeps import sweep

SHAPES = [(1, 1), (1, 300), (300, 1), (2, 2), (5, 127), (5, 128), (5, 129), (64, 255), (65, 256), (66, 257)]


@pytest.mark.parametrize(("height", "width"), SHAPES)
def test_cells_come_out_of_planes_as_they_went_in(height, width):
    generator = np.random.default_rng(1)
    walls = generator.random((height, width)) < 0.3
    sand = (generator.random((height, width)) < 0.5) & ~walls
    where = planes.layout(height, width)
    packed = planes.pack(sand + 2 * walls.view(np.uint8), where)
    assert (planes.unpack_where(packed, where, {1}) == sand).all()
    assert (planes.unpack_where(packed, where, {planes.WALL}) == walls).all()
    assert planes.count_set(packed[planes.SAND : planes.WALLS], where) == sand.sum()


@pytest.mark.parametrize(("height", "width"), SHAPES)
@sweep("codes", [2, 4, 5, 9, 16], keep=[4, 9])
def test_codes_come_out_of_planes_as_they_went_in_and_are_counted(height, width, codes):
    generator = np.random.default_rng(3)
    cells, outside = generator.integers(0, codes, (height, width), np.uint8), codes // 2
    where = planes.layout(height, width, codes, outside)
    packed = planes.pack(cells, where)
    assert (planes.unpack(packed, where) == cells).all()
    assert planes.count(packed, where, range(codes)) == tuple(np.bincount(cells.ravel(), minlength=codes))
    some = set(range(0, codes, 3))
    assert (planes.unpack_where(packed, where, some) == np.isin(cells, list(some))).all()
    for row in (0, 1, height // 2, height):
        above = planes.count_set(planes.planes_where(packed, where, {0}), where, row)
        assert above == (cells[:row] == 0).sum()
    for quarters in range(4):
        after = planes.layout(*np.rot90(cells, -quarters).shape, codes, outside)
        assert (planes.unpack(planes.turned(packed, where, quarters), after) == np.rot90(cells, -quarters)).all()


@pytest.mark.parametrize(("height", "width"), SHAPES)
def test_bands_are_the_cells_from_top_to_bottom(height, width):
    world = random_world(np.random.default_rng(2), height, width)
    assert (np.concatenate(list(planes.bands(world.planes, world.layout))) == world.materials).all()


def test_planes_of_power_of_two_widths_do_not_start_at_the_same_place_in_a_page():
    length = planes.layout(4096, 4096).length
    starts = {plane * length % planes.PAGE for plane in range(planes.PLANES)}
    assert len(starts) == planes.PLANES


def test_the_largest_lattice_takes_at_most_200_megabytes():
    assert planes.PLANES * planes.layout(16384, 16384).length * 8 <= 200e6
