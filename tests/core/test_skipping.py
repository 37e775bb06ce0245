"""What is skipped, skewed or drawn in crowds changes the pace and never the result."""

import numpy as np
import pytest

from game import Rule, World, advance
from game.core.step import CYCLE
from game.world.sessions.action import Clear, Flip, Paint, SetRule, apply
from tests.cells import random_world
from tests.sweeps import sweep

RULES = {
    "certain": Rule(schedule="balanced"),
    "topples": Rule.with_p(0.7, "paper", bias=0.2),
    "rare topples": Rule.with_p(2.0**-9, "margolus"),
    "seven": Rule(0.9, 0.2, 0.7, 0.55, 0.35, 0.6180339887, 0.15, "balanced"),
}


def creep(world, rule, iterations):
    """Run iterations one by one with every band awake: nothing is skipped, nothing skewed."""
    for _ in range(iterations):
        world.activity.wake()
        advance(world, rule, 1)


@sweep("rule", RULES.values(), keep=[RULES["topples"], RULES["seven"]])
@sweep("shape", [(1300, 300), (300, 1700), (70, 8000), (2100, 130)], keep=[(1300, 300), (70, 8000)])
def test_skipping_and_skewing_change_no_bit(rule, shape):
    world = random_world(np.random.default_rng(30), *shape, seed=3, sand=0.3, walls=0.05)
    twin = world.copy()
    assert len(world.activity.quiet) > 1
    for some in (1, 37, 120):
        advance(world, rule, some)
        creep(twin, rule, some)
        assert world.digest() == twin.digest()


@pytest.mark.parametrize("density", [0.002, 0.05, 0.4])
@sweep("rule", RULES.values(), keep=[RULES["rare topples"], RULES["seven"]])
def test_few_and_many_candidates_are_drawn_alike(rule, density):
    world = random_world(np.random.default_rng(31), 260, 700, seed=4, sand=density, walls=0.02)
    twin = World.from_cells(world.sand, world.walls, seed=4)
    advance(world, rule, 60)
    creep(twin, rule, 60)
    assert world.digest() == twin.digest()


def acts_at_band_borders(world, generator):
    """Return acts that touch the rows where bands meet, and some elsewhere."""
    height, width = world.shape
    border = 2 * world.activity.band_rows
    rows = [0, border - 1, border, border + 1, 2 * border - 1, 2 * border, height - 1, int(generator.integers(height))]
    for row in rows:
        column = float(generator.integers(width))
        material = ("sand", "wall", "erase")[int(generator.integers(3))]
        yield Paint(material, (column, row + 0.5), (column + 20, row + 0.5), int(generator.integers(1, 4)))
    yield from (Flip(), SetRule(RULES["seven"]), SetRule(RULES["certain"]), SetRule(RULES["rare topples"]), Clear())


@sweep("rule", RULES.values(), keep=[RULES["rare topples"]])
def test_strokes_flips_and_rule_changes_wake_what_they_touch(rule):
    generator = np.random.default_rng(32)
    world = random_world(generator, 2100, 150, seed=5, sand=0.1, walls=0.02)
    advance(world, rule, 3000)
    twin = world.copy()
    for act in [*acts_at_band_borders(world, generator), *acts_at_band_borders(world, generator)]:
        for each in (world, twin):
            _, rule_after = apply(act, each, rule)
        rule = rule_after
        some = int(generator.integers(1, 40))
        advance(world, rule, some)
        creep(twin, rule, some)
        assert world.digest() == twin.digest(), act


def test_settled_sand_is_left_alone_and_wakes_where_it_is_touched():
    world = random_world(np.random.default_rng(34), 1300, 300, sand=0.1, walls=0)
    rule = Rule.with_p(0.9, "balanced")
    advance(world, rule, 12_000)
    assert world.activity.settled and (world.activity.quiet >= CYCLE).all()
    before = world.sand
    advance(world, rule, 1000)
    assert (world.sand == before).all()
    apply(Paint("sand", (150.5, 3.5), (150.5, 3.5), 1), world, rule)
    assert not world.activity.settled and world.activity.quiet[-1] >= CYCLE
    advance(world, rule, 50)
    assert not world.sand[3, 150] and world.grains == before.sum() + 1


def test_another_schedule_or_iteration_forgets_what_was_quiet():
    world = random_world(np.random.default_rng(33), 300, 300, sand=0.2, walls=0)
    advance(world, Rule(schedule="margolus"), 2000)
    twin = world.copy()
    advance(world, Rule(schedule="paper"), 50)
    creep(twin, Rule(schedule="paper"), 50)
    assert world.digest() == twin.digest()
    world.iteration += 1
    twin.iteration += 1
    advance(world, Rule(schedule="paper"), 50)
    creep(twin, Rule(schedule="paper"), 50)
    assert world.digest() == twin.digest()


def test_a_change_is_stamped_on_its_band_and_on_no_quiet_one():
    world = World.from_cells(np.zeros((2000, 150), bool), np.zeros((2000, 150), bool))
    advance(world, Rule(), 10)
    apply(Paint("sand", (50.5, 5.5), (50.5, 5.5), 1), world, Rule())
    seen = world.activity.stamp
    advance(world, Rule(), 5)
    changed = np.nonzero(world.activity.changed > seen)[0]
    assert changed.tolist() == [0]
