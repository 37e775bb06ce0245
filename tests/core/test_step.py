"""The kernels against the plain twin, bit for bit, and what holds for every batch of iterations."""

import numpy as np
import pytest

from game import Rule, World, advance
from tests import reference
from tests.cells import NAMES, random_world, rows_of

SHAPES = [
    (1, 1),
    (1, 7),
    (9, 1),
    (2, 2),
    (3, 2),
    (61, 61),
    (8, 126),
    (9, 127),
    (8, 128),
    (7, 129),
    (6, 255),
    (7, 256),
    (6, 257),
    (5, 385),
]
KINDS = {
    "certain": [1.0] * 7,
    "two topples": [0.3, 0.8, 1.0, 1.0, 1.0, 1.0, 1.0],
    "one topple never": [0.0, 0.5, 1.0, 1.0, 1.0, 1.0, 1.0],
    "all seven": [0.9, 0.2, 0.7, 0.55, 0.35, 0.61803398875, 0.15],
    "some of seven certain": [1.0, 0.25, 1.0, 2.0**-3, 1.0, 0.0, 1.0],
}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("schedule", reference.SCHEDULES)
def test_kernels_agree_with_the_plain_twin_bit_for_bit(kind, schedule):
    generator = np.random.default_rng(20)
    rule = Rule(*KINDS[kind], schedule=schedule)
    for height, width in SHAPES:
        seed = int(generator.integers(2**64, dtype=np.uint64))
        world = random_world(generator, height, width, seed)
        iterations = 5 if height * width > 2000 else 9
        twin = reference.run(
            rows_of(world), dict(zip(NAMES, rule.probabilities, strict=True)), schedule, seed, iterations
        )
        advance(world, rule, iterations)
        assert rows_of(world) == ["".join(row) for row in twin], f"{height} x {width} cells"


@pytest.mark.parametrize("iteration", [2**32 - 2, 2**63 - 2, 2**64 - 2, 2**70 + 3])
def test_any_iteration_count_follows_the_twin(iteration):
    generator = np.random.default_rng(21)
    world = random_world(generator, 12, 20, seed=5)
    world.iteration = iteration
    rule = Rule.with_p(0.5, "paper")
    twin = reference.run(
        rows_of(world), dict(zip(NAMES, rule.probabilities, strict=True)), "paper", 5, 6, start=iteration
    )
    advance(world, rule, 6)
    assert rows_of(world) == ["".join(row) for row in twin]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("schedule", reference.SCHEDULES)
def test_the_future_does_not_depend_on_how_iterations_are_split_into_calls(kind, schedule):
    generator = np.random.default_rng(22)
    rule = Rule(*KINDS[kind], schedule=schedule)
    whole = random_world(generator, 120, 150, seed=9)
    split = whole.copy()
    advance(whole, rule, 40)
    for some in (1, 2, 3, 5, 8, 0, 13, 8):
        advance(split, rule, some)
    assert whole.digest() == split.digest()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("schedule", reference.SCHEDULES)
def test_no_grain_is_made_or_lost_and_no_wall_moves(kind, schedule):
    generator = np.random.default_rng(23)
    world = random_world(generator, 101, 261)
    grains, walls = world.grains, world.walls
    for _ in range(10):
        advance(world, Rule(*KINDS[kind], schedule=schedule), 37)
        assert world.grains == grains == world.sand.sum()
    assert (world.walls == walls).all()
    assert not (world.sand & world.walls).any()


def test_sand_never_rises():
    generator = np.random.default_rng(24)
    world = random_world(generator, 60, 140)
    for _ in range(50):
        lowest_first = np.cumsum(world.sand.sum(axis=1)[::-1])
        advance(world, Rule(*[0.5] * 7), 1)
        assert (np.cumsum(world.sand.sum(axis=1)[::-1]) >= lowest_first).all()


def test_everything_falls_to_the_floor_of_an_open_box():
    generator = np.random.default_rng(25)
    sand = generator.random((40, 64)) < 0.3
    sand[:, 0] = False  # the first column falls at half the pace
    world = World.from_cells(sand, np.zeros_like(sand))
    advance(world, Rule(schedule="balanced"), 400)
    heights = world.sand.sum(axis=0)
    resting = np.arange(40)[:, None] >= 40 - heights[None, :]
    assert (world.sand == resting).all()


def test_the_seed_decides_and_nothing_else():
    generator = np.random.default_rng(26)
    first = random_world(generator, 80, 80, seed=1)
    again, other = first.copy(), World.from_cells(first.sand, first.walls, seed=2)
    for world in (first, again, other):
        advance(world, Rule.with_p(0.5), 30)
    assert first.digest() == again.digest()
    assert (first.sand != other.sand).any()


@pytest.mark.parametrize(
    ("rule", "golden"),
    [
        (Rule(), "8b8dc2b4cc2cc33b0674658201db8a5d"),
        (Rule.with_p(0.75, "balanced"), "0408662bfe388cf96d58f07868d4ad9a"),
        (Rule(0.9, 0.2, 0.7, 0.55, 0.35, 0.625, 0.15, "margolus"), "f10b9e9c9feb1dbbf341592ac1f5d126"),
    ],
)
def test_the_bits_are_the_same_on_every_machine(rule, golden):
    y, x = np.mgrid[0:200, 0:300]
    walls = (x * 5 + y * 11) % 13 == 2
    world = World.from_cells(((x * 7 + y * 3) % 5 < 2) & ~walls, walls, seed=2020)
    advance(world, rule, 200)
    assert world.digest() == golden
