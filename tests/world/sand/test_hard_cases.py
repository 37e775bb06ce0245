"""Hard cases: extreme lattices, walls, strokes, flips and numbers that should change nothing about the sand."""

import numpy as np
import pytest

from game import Rule, World, advance
from game.core.planes import PLANES
from game.world.rules.rule import SCHEDULES
from game.world.sessions.action import Paint, apply
from tests import reference
from tests.cells import NAMES, random_world, rows_of
from tests.sweeps import sweep

SEVEN = (0.5, 0.3, 0.9, 0.8, 0.7, 0.6, 0.95)
RULES = [Rule(*probabilities, schedule=name) for probabilities in ((1.0,) * 7, SEVEN) for name in SCHEDULES]
BORDERS = (0, 1, 2, 63, 64, 126, 127, 128, 129, 253, 254, 255, 256, 257, 258)  # columns where bits, words or seams meet


@pytest.fixture(params=RULES, ids=lambda rule: f"{rule.schedule}-{rule.fall_pair:g}")
def rule(request):
    return request.param


@pytest.mark.parametrize("shape", [(1, 1), (2, 2), (3, 5), (61, 61), (64, 128), (66, 257)])
def test_a_lattice_full_of_sand_never_moves(rule, shape):
    world = World.from_cells(np.ones(shape, bool), np.zeros(shape, bool))
    advance(world, rule, 50)
    assert world.sand.all() and world.grains == shape[0] * shape[1]


@pytest.mark.parametrize(("sand", "wall"), [(False, False), (True, False), (False, True)])
def test_a_single_cell_stays_what_it_is(rule, sand, wall):
    world = World.from_cells(np.array([[sand]]), np.array([[wall]]))
    for _ in range(5):
        advance(world, rule, 1)
        world.flip()
    assert (world.sand[0, 0], world.walls[0, 0]) == (sand, wall)


@pytest.mark.parametrize("odd", [0, 1])
def test_a_checkerboard_of_walls_holds_its_sand_fast(rule, odd):
    black = np.indices((33, 130)).sum(axis=0) % 2 == odd
    world = World.from_cells(~black, black)
    advance(world, rule, 200)
    assert (world.sand == ~black).all()


@pytest.mark.parametrize("odd", [0, 1])
def test_a_checkerboard_of_sand_settles_without_loss(rule, odd):
    sand = np.indices((33, 130)).sum(axis=0) % 2 == odd
    world = World.from_cells(sand, np.zeros_like(sand))
    advance(world, rule, 2000)
    resting = world.sand
    assert resting.sum() == sand.sum() and not (resting[:-1, 1:] & ~resting[1:, 1:]).any()


@pytest.mark.parametrize("flips", [0, 1])
@pytest.mark.parametrize("shape", ["diamond", "box"])
def test_walls_one_cell_thick_do_not_leak(rule, shape, flips):
    y, x = np.mgrid[:43, :139] - 21
    x -= 48  # the middle is near a seam of the lattice
    distance = abs(x) + abs(y) if shape == "diamond" else np.maximum(abs(x), abs(y))
    world = World.from_cells((distance < 18) & (y < 4), distance == 18)
    grains = world.grains
    for _ in range(4):
        advance(world, rule, 151)
        if flips:
            world.flip()
    assert world.grains == grains == world.sand[distance < 18].sum()


def test_a_neck_of_one_cell_lets_grains_through_one_by_one(rule):
    walls = np.zeros((12, 9), bool)
    walls[6] = True
    walls[6, 4] = False
    sand = np.zeros_like(walls)
    sand[:6, 2:7] = True
    world = World.from_cells(sand, walls)
    before = 0
    for _ in range(200):
        advance(world, rule, 1)
        through = int(world.sand[6:].sum())
        assert before <= through <= before + 1 and world.grains == 30
        before = through
    assert through > 10


@sweep("iteration", range(8), keep=[0, 3])
def test_a_flip_at_any_phase_and_in_mid_fall_is_only_a_turn(rule, iteration):
    world = random_world(np.random.default_rng(31), 21, 131, seed=6)
    advance(world, rule, iteration)
    turned = [row[::-1] for row in rows_of(world)[::-1]]
    world.flip()
    assert rows_of(world) == turned
    chances = dict(zip(NAMES, rule.probabilities, strict=True))
    twin = reference.run(turned, chances, rule.schedule, 6, 5, start=iteration)
    advance(world, rule, 5)
    assert rows_of(world) == ["".join(row) for row in twin]


@sweep("width", [126, 128, 130, 255, 256, 257, 300], keep=[128, 257])
@pytest.mark.parametrize("material", ["sand", "wall", "erase"])
def test_strokes_at_word_and_seam_borders_leave_planes_as_if_made_so(material, width):
    world = random_world(np.random.default_rng(32), 70, width, seed=3)
    for column in BORDERS:
        for row in (0, 31, 32, 63, 64, 69):
            apply(Paint(material, (column, row), (column + 3, row + 1), 2), world, Rule())
    made = World.from_cells(world.sand, world.walls, seed=3)
    for plane in range(PLANES):
        assert (used(made, plane) == used(world, plane)).all(), plane
    for each in (world, made):
        advance(each, Rule(*SEVEN), 12)
    assert (world.sand == made.sand).all() and world.grains == made.grains


def used(world, plane):
    """Return the words of a plane that hold cells: not the seam, which is made anew each time."""
    where = world.layout
    return world.planes[plane, : where.rows * where.stride].reshape(where.rows, where.stride)[:, : where.words]


@pytest.mark.parametrize("iteration", [2**32 - 6, 2**63 - 6, 2**64 - 6, 2**100 - 6])
def test_an_iteration_counter_past_a_words_end_goes_on(rule, iteration):
    whole = random_world(np.random.default_rng(33), 30, 140, seed=1)
    whole.iteration = iteration
    parts = whole.copy()
    advance(whole, rule, 12)
    for _ in range(12):
        advance(parts, rule, 1)
    assert whole.iteration == parts.iteration == iteration + 12
    assert whole.digest() == parts.digest()


@pytest.mark.parametrize(
    ("p", "toppled"), [(0.0, 0), (-0.0, 0), (5e-324, 0), (2.0**-34, 0), (1 - 2.0**-34, 64), (1.0, 64)]
)
@pytest.mark.parametrize("others", [1.0, 0.5])
def test_probabilities_next_to_0_and_1_are_never_and_always(p, toppled, others):
    sand = np.zeros((16, 16), bool)
    sand[:, 0::2] = True
    world = World.from_cells(sand, np.zeros_like(sand), seed=4)
    advance(world, Rule(p, p, fall_pair=others), 1)
    assert world.sand[:, 1::2].sum() == toppled
