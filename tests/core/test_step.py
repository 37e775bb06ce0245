"""The kernels against the plain twin, bit for bit, and what holds for every batch of iterations."""

from itertools import product

import numpy as np
import pytest

from game import Rule, World, advance
from game.world.sessions.action import Draw, apply
from tests import reference
from tests.cells import NAMES, coloured, random_world, rows_of
from tests.sweeps import sweep

TELLING = [
    ("certain", "paper"),
    ("all seven", "balanced"),
    ("one topple never", "margolus"),
    ("some of seven certain", "paper"),
]  # (kind, schedule)
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


@sweep(("kind", "schedule"), product(KINDS, reference.SCHEDULES), keep=TELLING)
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


@sweep(("kind", "schedule"), product(KINDS, reference.SCHEDULES), keep=TELLING)
def test_the_future_does_not_depend_on_how_iterations_are_split_into_calls(kind, schedule):
    generator = np.random.default_rng(22)
    rule = Rule(*KINDS[kind], schedule=schedule)
    whole = random_world(generator, 120, 150, seed=9)
    split = whole.copy()
    advance(whole, rule, 40)
    for some in (1, 2, 3, 5, 8, 0, 13, 8):
        advance(split, rule, some)
    assert whole.digest() == split.digest()


@sweep(("kind", "schedule"), product(KINDS, reference.SCHEDULES), keep=TELLING)
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


def mirrored(world):
    """Return the world with left and right exchanged."""
    return World.from_cells(world.sand[:, ::-1], world.walls[:, ::-1], world.seed, world.colours[:, ::-1])


@pytest.mark.parametrize("colours", [False, True])
@sweep("schedule", reference.SCHEDULES, keep=["balanced"])
@sweep("shape", [(40, 2), (41, 30), (64, 128), (30, 254), (33, 256)], keep=[(41, 30), (64, 128)])
def test_without_chance_the_mirrored_world_evolves_into_the_mirrored_one(shape, schedule, colours):
    generator = np.random.default_rng(27)
    for _ in range(3):
        world = random_world(generator, *shape, walls=0.1)
        world = coloured(world, generator) if colours else world
        twin = mirrored(world)
        for _ in range(30):
            advance(world, Rule(schedule=schedule), 1)
            advance(twin, Rule(schedule=schedule), 1)
            assert (twin.sand[:, ::-1] == world.sand).all()
            assert (twin.colours[:, ::-1] == world.colours).all()


@sweep("schedule", reference.SCHEDULES, keep=["balanced"])
@sweep("width", [1, 2, 7, 64, 127, 128, 129, 256], keep=[1, 7, 129])
def test_a_grain_in_any_column_of_an_empty_world_falls_at_the_same_pace(width, schedule):
    height, rule = 21, Rule(schedule=schedule)
    sand = np.zeros((height, width), bool)
    sand[0] = True  # a whole row: each grain falls in its own column
    world, landed = World.from_cells(sand, np.zeros_like(sand)), np.zeros(width, int)
    for iteration in range(1, 4 * height):
        advance(world, rule, 1)
        landed[world.sand[-1] & (landed == 0)] = iteration
    for column in {0, width // 2, width - 1}:
        alone = np.zeros_like(sand)
        alone[0, column] = True
        single, taken = World.from_cells(alone, np.zeros_like(sand)), 0
        while not single.sand[-1, column]:
            advance(single, rule, 1)
            taken += 1
        assert taken == landed[column]
    assert landed.min() > 0 and landed.max() - landed.min() <= 1


# The lattice has a border of walls: what is outside of it then changes nothing, whatever it may be.
@pytest.mark.parametrize(
    ("rule", "golden"),
    [
        (Rule(), "7f27e5602b710288e4bb434cc32b6fae"),
        (Rule.with_p(0.75, "balanced"), "0ed47dde6900d4de49fb48b2b3dc3176"),
        (Rule(0.9, 0.2, 0.7, 0.55, 0.35, 0.625, 0.15, "margolus"), "805baef56ee4ec30f7e91752cee19a28"),
    ],
)
def test_the_bits_are_the_same_on_every_machine(rule, golden):
    y, x = np.mgrid[0:200, 0:300]
    walls = ((x * 5 + y * 11) % 13 == 2) | (x % 299 == 0) | (y % 199 == 0)
    world = World.from_cells(((x * 7 + y * 3) % 5 < 2) & ~walls, walls, seed=2020)
    advance(world, rule, 200)
    assert world.digest() == golden


def test_what_rests_on_a_band_that_stirs_again_falls():
    walls = np.zeros((1300, 6), bool)
    walls[:, [0, 2, 3, 5]] = walls[800, :] = walls[-1, :] = True  # two shafts, half way down a floor
    sand = np.zeros_like(walls)
    sand[300:800, [1, 4]] = True
    world = World.from_cells(sand, walls, seed=3)
    band = 2 * world.activity.band_rows
    assert 300 < band < 700, "the sand lies in the first band and in the second, which has the floor"
    advance(world, Rule(), 40)
    assert world.activity.settled
    apply(Draw("rectangle", "erase", (1.0, 800.0), (4.0, 800.0), over_walls=True), world, Rule())
    advance(world, Rule(), 3000)
    assert world.sand[-501:-1, [1, 4]].all() and world.grains == 1000
