"""Groups of replicas: a second path to the law of the single world, many runs at a time."""

from collections import Counter
from itertools import pairwise

import numpy as np
import pytest

from game import Rule, World, advance
from game.core.compiler.rule_pass import pass_of
from game.core.ensemble import runs as core
from game.core.ensemble.runs import advance_replicas, count_replicas, read_states
from game.world.rules.rule import SCHEDULES
from game.world.sand.material_codes import SAND, WALL
from tests import reference
from tests.cells import NAMES, random_world, world_of
from tests.sweeps import sweep

SHAPES = [(1, 1), (1, 2), (1, 9), (2, 1), (7, 1), (2, 2), (3, 2), (5, 3), (16, 16), (13, 65), (9, 128), (31, 20)]
SEVEN = Rule(0.9, 0.2, 0.7, 0.55, 0.35, 0.618, 0.15, "balanced")


def replicate(sand, walls, seed, first, runs, lanes=None):
    """Return `runs` replicas, their words a multiple of what a pass takes at a time."""
    moving = pass_of(SEVEN.table, SEVEN.values, most_lanes=lanes)
    return core.replicate(sand * np.uint8(SAND) + walls * np.uint8(WALL), moving, seed, first, runs)


def run(group, rule, iterations, start=0, budget=10**9, lanes=None):
    """Move a group in place."""
    offsets = np.roll(np.array(rule.offsets), -start, axis=0)
    moving = pass_of(rule.table, rule.values, most_lanes=lanes)
    done = row = 0
    while done < iterations:
        told = (moving.code.address, moving.chances), offsets, np.uint64(start), iterations
        done, row = advance_replicas(group, *told, done, row, budget)
    return group


def sand_of(group, run):
    """Return the (H, W) bool sand of one replica."""
    return (group.cells[1:-1, 1:-1, 0, run // 64] >> np.uint64(run % 64)) & np.uint64(1) != 0


@pytest.mark.parametrize("schedule", SCHEDULES)
def test_without_chance_every_replica_is_the_single_world_at_every_moment(schedule):
    generator = np.random.default_rng(40)
    rule = Rule(schedule=schedule)
    for height, width in SHAPES:
        for start in range(4):
            world = random_world(generator, height, width)
            world.iteration = start
            group = replicate(world.sand, world.walls, 1, 0, 70)
            for moment in range(start, start + 2 * height):
                advance(world, rule, 1)
                run(group, rule, 1, moment)
                expected = np.where(world.sand[..., None], group.full, np.uint64(0))
                assert (group.cells[1:-1, 1:-1, 0] == expected).all(), f"{height} x {width} cells"


@pytest.mark.parametrize("kind", range(7))
@sweep("p", [0.0, 1.0], keep=[0.0])
def test_each_probability_rules_its_own_event(kind, p):
    rule = Rule(*[p if each == kind else 1.0 - p for each in range(7)])
    world = random_world(np.random.default_rng(41), 40, 30, sand=0.5)
    group = replicate(world.sand, world.walls, 1, 0, 1)
    for moment in range(40):
        advance(world, rule, 1)
        run(group, rule, 1, moment)
        assert (sand_of(group, 0) == world.sand).all()


@pytest.mark.parametrize("name", NAMES)
def test_a_candidate_moves_with_its_own_probability(name):
    probabilities = dict.fromkeys(NAMES, 0.0) | {name: 0.3}
    found, moved = 0, 0
    for state in np.ndindex(3, 3, 3, 3):
        corners = [".o#"[each] for each in state]
        event = reference.event(*corners)
        if event is None or event[1] != name:
            continue
        world = world_of(["".join(corners[:2]), "".join(corners[2:])])
        group = run(replicate(world.sand, world.walls, 42 + found, 0, 4096), Rule(**probabilities), 1)
        counts = np.zeros((2, 2), np.int64)
        count_replicas(group, SAND, 1, counts)
        entered = [corner == "." and after == "o" for corner, after in zip(corners, event[0], strict=True)]
        moved += counts.ravel()[entered][0]
        found += 1
    assert found > 0
    assert abs(moved - 0.3 * 4096 * found) < 5 * np.sqrt(0.21 * 4096 * found)


def test_the_states_of_two_columns_follow_the_exact_chain():
    world = world_of(["oo..", "oo#.", ".o..", "...."])
    rule = Rule(0.9, 0.25, 0.75, 0.5, 0.35, 0.6, 0.15, "paper")
    law = Counter({tuple(map(tuple, ["oo..", "oo#.", ".o..", "...."])): 1.0})
    for iteration in range(6):
        law = following(law, dict(zip(NAMES, rule.probabilities, strict=True)), iteration)
    runs = 20_000
    states = np.empty(runs, np.uint64)
    for first in range(0, runs, 4096):
        here = states[first : first + 4096]
        read_states(run(replicate(world.sand, world.walls, 43, first, len(here)), rule, 6), SAND, here)
    seen = Counter(states.tolist())
    expected = {state_number(cells): runs * chance for cells, chance in law.items() if chance > 0}
    assert set(seen) <= set(expected)
    chi_square = sum((seen[state] - mean) ** 2 / mean for state, mean in expected.items() if mean >= 5)
    freedom = sum(mean >= 5 for mean in expected.values())
    assert freedom > 10 and chi_square < freedom + 5 * np.sqrt(2 * freedom)


def following(law, probabilities, iteration):
    """Return the law of the cells after one more iteration of the paper's schedule, block by block."""
    left, top = SCHEDULES["paper"][iteration % 4]
    inside = range(4)
    for y in range(-top, 4, 2):
        for x in range(-left, 4, 2):
            after, places = Counter(), [(y, x), (y, x + 1), (y + 1, x), (y + 1, x + 1)]
            for cells, chance in law.items():
                corners = [cells[r][c] if r in inside and c in inside else "#" for r, c in places]
                found = reference.event(*corners)
                p = 0.0 if found is None else 1.0 if found[1] == reference.ALWAYS else probabilities[found[1]]
                after[cells] += chance * (1 - p)
                if p > 0:
                    moved = [list(row) for row in cells]
                    for (r, c), old, new in zip(places, corners, found[0], strict=True):
                        if new != old:
                            moved[r][c] = new
                    after[tuple(map(tuple, moved))] += chance * p
            law = after
    return law


def state_number(cells):
    """Return the state of cells as `read_states` numbers it."""
    return sum(1 << at for at, cell in enumerate("".join(map("".join, cells))) if cell == "o")


@pytest.mark.parametrize("rule", [Rule.with_p(0.3), SEVEN])
def test_no_replica_makes_or_loses_a_grain_or_enters_a_wall(rule):
    world = random_world(np.random.default_rng(44), 21, 34)
    group = run(replicate(world.sand, world.walls, 44, 0, 300), rule, 50)
    for each in range(300):
        assert sand_of(group, each).sum() == world.grains
    sand = group.cells[:, :, 0]
    assert not sand[1:-1, 1:-1][world.walls].any() and not (sand & ~group.full).any()
    assert not sand[[0, -1]].any() and not sand[:, [0, -1]].any()


@pytest.mark.parametrize("budget", [0, 1, 7, 100])
def test_the_bits_do_not_depend_on_where_the_work_is_interrupted(budget):
    world = random_world(np.random.default_rng(45), 23, 30)
    whole, pieces = (
        run(replicate(world.sand, world.walls, 45, 0, 200), SEVEN, 30, 3, each) for each in (10**9, budget)
    )
    assert (whole.cells == pieces.cells).all()


def test_a_replica_does_not_depend_on_the_size_of_its_group():
    world = random_world(np.random.default_rng(46), 20, 20)
    whole = run(replicate(world.sand, world.walls, 46, 0, 1000), SEVEN, 30)
    for first, last in pairwise([0, 64, 320, 832, 1000]):
        part = run(replicate(world.sand, world.walls, 46, first, last - first), SEVEN, 30)
        words = -(-last // 64) - first // 64
        assert (part.cells[..., :words] == whole.cells[..., first // 64 : first // 64 + words]).all()


def test_a_replica_does_not_depend_on_how_many_words_are_worked_out_at_a_time():
    world = random_world(np.random.default_rng(49), 20, 21)
    whole = run(replicate(world.sand, world.walls, 49, 0, 700), SEVEN, 30)
    for lanes in (1, 2):
        part = run(replicate(world.sand, world.walls, 49, 0, 700, lanes), SEVEN, 30, lanes=lanes)
        assert (part.cells[..., :11] == whole.cells[..., :11]).all()


def test_a_sleeping_block_wakes_when_sand_comes_near():
    sand, walls = np.zeros((40, 3), bool), np.zeros((40, 3), bool)
    sand[0:2, 1] = True  # nothing moves below for many iterations
    world = World.from_cells(sand, walls)
    group = run(replicate(sand, walls, 47, 0, 1), Rule(schedule="balanced"), 100)
    advance(world, Rule(schedule="balanced"), 100)
    assert (sand_of(group, 0) == world.sand).all() and world.sand[38:].sum() == 2
    assert not group.awake[1:-1, 1:-1].any()


def test_neighbouring_replicas_words_and_blocks_are_uncorrelated():
    width = 64
    sand = np.zeros((2, 2 * width), bool)
    sand[:, ::2] = True  # every block has one grain that topples with probability a half
    still = run(replicate(sand, np.zeros_like(sand), 48, 0, 4096), Rule.with_p(0.5), 1).cells[1, 1:-1:2, 0]
    signs = 1.0 - 2.0 * np.unpackbits(still.view(np.uint8), axis=1, bitorder="little")  # (blocks, replicas)
    assert abs(signs.sum()) < 5 * np.sqrt(signs.size)
    for rows, columns in [(0, 1), (0, 63), (0, 64), (0, 512), (1, 0), (1, 1), (2, 0)]:
        product = signs[rows:, columns:] * signs[: width - rows, : 4096 - columns]
        assert abs(product.sum()) < 5 * np.sqrt(product.size), f"{rows} blocks, {columns} replicas apart"
