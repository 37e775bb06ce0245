"""Measures: what is read off a world is what a reader of it would count."""

import math

import numpy as np
import pytest

from game import Rule, World, advance, load_scene
from game.world.sand.measure import MotionMeter, flow, grains_above, pile, pile_heights, slope_degrees, surface_slope


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


def fallen(columns, shape=(80, 400)):
    """Return what is seen of grains that fall in some columns."""
    sand = np.zeros(shape, bool)
    sand[::4, columns] = True
    world, meter = World.from_cells(sand, np.zeros(shape, bool)), MotionMeter()
    meter.look(world)
    advance(world, Rule(), 6)
    return meter.look(world)


def test_the_first_look_and_sand_at_rest_are_silent():
    sand = np.zeros((20, 300), bool)
    sand[-3:] = True
    world, meter = World.from_cells(sand, np.zeros_like(sand)), MotionMeter()
    assert meter.look(world) == (0, 0)
    advance(world, Rule.with_p(0.5), 20)
    assert meter.look(world) == (0, 0)


@pytest.mark.parametrize("width", [60, 128, 400, 1000])
def test_the_side_is_where_the_sand_moves(width):
    shape = 80, width
    left, middle, right = (fallen([at], shape)[1] for at in (1, width // 2, width - 2))
    assert left < -0.7 and right > 0.7 and abs(middle) < 0.3


def test_more_sand_in_motion_is_more_to_hear():
    one, five, fifty = (fallen(list(range(10, 10 + count)))[0] for count in (1, 5, 50))
    assert 0 < one < five < fifty
    assert five == pytest.approx(5 * one, rel=0.3)


def test_a_sample_of_the_rows_tells_about_as_much_as_all_of_them():
    scene = load_scene("hourglass", (720, 960))
    world, meter = scene.world(), MotionMeter()
    advance(world, scene.rule, 400)
    meter.look(world)
    before = world.sand
    advance(world, scene.rule, 16)
    assert meter.look(world)[0] == pytest.approx((world.sand != before).sum() / 2, rel=0.25)


def test_another_lattice_is_a_first_look():
    meter = MotionMeter()
    for name in ("hourglass", "paper"):
        assert meter.look(load_scene(name).world()) == (0, 0)


@pytest.mark.parametrize("rise", [1, 2, 3])
@pytest.mark.parametrize("bowl", ["flat", "round", "lopsided"])
def test_the_slope_is_that_of_the_surface_whatever_the_ground_is(rise, bowl):
    height, width = 180, 121
    columns = np.arange(width)
    away = np.abs(columns - 60)
    ground = {"flat": 0 * away, "round": away**2 // 120, "lopsided": columns // 3}[bowl]
    surface = np.maximum(170 - rise * away, 0)
    rows = height - np.arange(height)[:, None]  # of each cell's upper edge, from below
    walls, sand = rows <= ground, (rows > ground) & (rows <= surface)
    found = pile(World.from_cells(sand, walls))
    there = sand.any(axis=0)
    assert (found.surface[there] == surface[there]).all() and not found.surface[~there].any()
    assert found.height == 170 - ground[there].min()
    slope, error = surface_slope(found.surface)
    assert slope == pytest.approx(math.degrees(math.atan(rise)), abs=1e-9) and error == pytest.approx(0, abs=1e-9)


def test_the_error_of_a_slope_tells_how_far_it_is_from_the_true_one():
    generator, misses, errors = np.random.default_rng(3), [], []
    for _ in range(200):
        away = np.abs(np.arange(161) - 80)
        rough = np.cumsum(generator.normal(0, 0.5, 161))  # as sand: neighbours hang together
        slope, error = surface_slope(np.maximum(np.rint(200 - away + rough - rough[80]), 1))
        misses.append(slope - 45)
        errors.append(error)
    assert 0.4 < np.std(misses) / np.mean(errors) < 2


@pytest.mark.parametrize("surface", [[0], [0, 0, 9, 0, 0], [5] * 9, [0] * 7])
def test_what_has_no_flanks_has_no_slope(surface):
    assert all(math.isnan(each) or each == 0 for each in surface_slope(surface))


def test_in_the_papers_glass_the_pile_is_taller_and_thinner_the_lower_p_is():
    scene, found = load_scene("paper"), []
    for p in (1.0, 0.75, 0.5, 0.25):
        piles = []
        for seed in range(60):
            world, rule = scene.world(seed), Rule.with_p(p, scene.rule.schedule)
            advance(world, rule, 200)
            rests = pile(world, scene.neck)
            piles.append(
                (rests.height, np.count_nonzero(rests.heights), world.grains - grains_above(world, scene.neck))
            )
        found.append(np.mean(piles, axis=0))
    heights, widths, below = zip(*found, strict=True)
    assert below == (50,) * 4 and list(heights) == sorted(heights)
    assert heights == pytest.approx((6.0, 6.8, 8.0, 9.7), abs=0.6)
    assert widths == pytest.approx((11.0, 11.4, 11.0, 9.3), abs=0.6)
