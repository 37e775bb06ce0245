"""Measures: what is read off a world is what a reader of it would count."""

import math

import numpy as np
import pytest

from game import Rule, World, advance
from game.world.sand.measure import flow, grains_above, pile_heights, slope_degrees


def world_of(*rows):
    cells = np.array([list(row) for row in rows])
    return World.from_cells(cells == "o", cells == "#")


def test_grains_above_a_row_are_those_in_the_rows_over_it():
    world = world_of("o..", ".oo", "ooo")
    assert [grains_above(world, row) for row in range(4)] == [0, 1, 3, 6]


def test_flow_counts_the_grains_that_pass():
    world = world_of(*["#oo"] * 4, *["#.."] * 20)
    assert flow(world, Rule(schedule="balanced"), 8, 4) == 1.0
    assert grains_above(world, 4) == 0


def test_what_falls_is_not_part_of_the_pile():
    world = world_of(".o...", ".....", ".oo..", "ooo.#", "#####")
    assert pile_heights(world).tolist() == [1, 2, 2, 0, 0]


def test_the_pile_below_a_row_knows_nothing_of_the_sand_above_it():
    world = world_of("ooo", "ooo", ".o.")
    assert pile_heights(world).tolist() == [0, 3, 0]
    assert pile_heights(world, 2).tolist() == [0, 1, 0]


@pytest.mark.parametrize("step", [1, 2, 5])
def test_the_slope_of_a_regular_cone_is_that_of_its_steps(step):
    heights = step * np.minimum(np.arange(41), np.arange(41)[::-1])
    assert slope_degrees(heights) == pytest.approx(math.degrees(math.atan(step)))


def test_a_post_has_no_slope():
    assert math.isnan(slope_degrees([0, 0, 9, 0, 0]))


def test_a_column_of_sand_comes_to_rest_as_a_cone_of_45_degrees():
    sand = np.zeros((102, 100), bool)
    sand[2:, 50] = True
    world = World.from_cells(sand, np.zeros_like(sand), 1)
    advance(world, Rule.with_p(0.5, "balanced"), 4000)
    heights = pile_heights(world)
    assert heights.sum() == 100 and abs(np.diff(heights)).max() == 1
    assert slope_degrees(heights) == pytest.approx(45, abs=4)
