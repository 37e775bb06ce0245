"""Cheap randomness: the plain kernel is the toy's rule, and each source shares what it says it shares."""

import numpy as np
import pytest

from game import Rule, density, load_scene
from game.study.trade.cheap_random import FRESH, FROZEN, LATTICE, ROW, SOURCES, run_cheaply
from game.study.trade.points import floor_of, point
from game.world.rules.rule import SCHEDULES

RUNS = 600
ONE_ROUND = ((0, 0),)


def posts(rows, columns):
    """Return a lattice of posts two grains high, each of which can topple to the right and then stays."""
    sand = np.zeros((4 * rows, 2 * columns), bool)
    walls = np.zeros_like(sand)
    sand[0::4, 0::2] = sand[1::4, 0::2] = True
    walls[2::4] = walls[3::4] = True
    return sand, walls


def toppled(source, iterations, seed=1, p=0.5):
    sand, walls = posts(16, 32)
    counts, _ = run_cheaply(sand, walls, p, ONE_ROUND, iterations, 1, source, seed)
    return counts[1::4, 1::2].astype(bool)


@pytest.mark.parametrize("source", SOURCES.values())
@pytest.mark.parametrize("schedule", SCHEDULES)
def test_without_chance_the_plain_kernel_moves_sand_as_the_toy_does(source, schedule):
    scene = load_scene("paper")
    counts, _ = run_cheaply(scene.sand, scene.walls, 1.0, SCHEDULES[schedule], 200, 1, source, 1)
    assert (counts == density(scene.world(), Rule(schedule=schedule), 200, 1)).all()


def test_with_fresh_draws_it_agrees_with_the_toy_and_with_fixed_noise_it_does_not():
    scene, many = load_scene("paper"), 2**14
    reference = density(scene.world(), Rule.with_p(0.7, "balanced"), 200, many)
    floor = floor_of(reference, RUNS, many)
    rms = {}
    for source in (FRESH, FROZEN):
        counts, _ = run_cheaply(scene.sand, scene.walls, 0.7, SCHEDULES["balanced"], 200, RUNS, source, 1)
        rms[source] = point("", "", counts / RUNS, reference, floor, 1.0).rms
    assert rms[FRESH] < 1.5 * floor < 5 * floor < rms[FROZEN]


def test_fresh_draws_differ_from_block_to_block_and_are_as_likely_as_p():
    fell = toppled(FRESH, 1)
    assert 200 < fell.sum() < 312 and not (fell == fell[0]).all()


def test_a_row_that_shares_a_draw_topples_as_one():
    fell = toppled(ROW, 1)
    assert (fell == fell[:, :1]).all() and 0 < fell[:, 0].sum() < 16


def test_a_lattice_that_shares_a_draw_topples_as_one():
    outcomes = {toppled(LATTICE, 1, seed).mean() for seed in range(12)}
    assert outcomes == {0.0, 1.0}


def test_where_noise_is_fixed_a_post_that_stood_once_stands_for_ever():
    assert (toppled(FROZEN, 1) == toppled(FROZEN, 40)).all()
    assert toppled(FRESH, 40).all()


def test_the_surplus_is_grains_on_the_right_less_grains_on_the_left():
    sand = np.zeros((8, 7), bool)
    sand[7, [0, 3, 4, 5, 6]] = True
    _, surplus = run_cheaply(sand, np.zeros_like(sand), 1.0, ONE_ROUND, 1, 2, FRESH, 1)
    assert surplus.tolist() == [2, 2]
