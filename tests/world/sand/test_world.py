"""The world's public face."""

import copy
import pickle
import subprocess
import sys

import numpy as np
import pytest

import game
from game import Rule, Scene, World, advance, density
from game.world.sand.fixtures import Fixture
from tests.cells import coloured, random_world, rows_of, world_of


def test_importing_game_needs_no_window():
    code = "import sys, game; sys.exit('pygame' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_the_public_face_is_there():
    assert all(hasattr(game, name) for name in game.__all__)


@pytest.mark.parametrize("shape", [(1, 1), (1, 9), (7, 1), (61, 61), (64, 128), (33, 257)])
def test_a_flip_turns_the_lattice_exactly_and_twice_is_the_identity(shape):
    world = random_world(np.random.default_rng(3), *shape)
    sand, walls, digest = world.sand, world.walls, world.digest()
    world.flip()
    assert (world.sand == sand[::-1, ::-1]).all() and (world.walls == walls[::-1, ::-1]).all()
    world.flip()
    assert world.digest() == digest


def test_a_flipped_world_runs_on_like_one_made_so():
    world = random_world(np.random.default_rng(4), 70, 131, seed=8)
    advance(world, Rule.with_p(0.5), 7)
    world.flip()
    twin = World.from_cells(world.sand, world.walls, seed=8)
    twin.iteration = world.iteration
    for each in (world, twin):
        advance(each, Rule.with_p(0.5), 9)
    assert world.digest() == twin.digest()


def test_a_copy_goes_its_own_way():
    world = world_of(["o.", ".."])
    copy = world.copy()
    advance(copy, Rule(), 1)
    assert rows_of(world) == ["o.", ".."] and world.iteration == 0
    assert rows_of(copy) == ["..", "o."] and copy.iteration == 1


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda world: pickle.loads(pickle.dumps(world))])
def test_every_way_to_copy_gives_a_world_that_shares_nothing(copied):
    world = coloured(random_world(np.random.default_rng(1), 30, 140, seed=3), np.random.default_rng(2))
    world.fixtures = (Fixture("tap", 3, 4, 2),)
    advance(world, Rule(), 5)
    before, twin = world.digest(), copied(world)
    assert twin.digest() == before and twin.planes.ctypes.data % 64 == 0
    advance(twin, Rule(), 5)
    assert world.digest() == before and world.iteration == 5
    advance(world, Rule(), 5)
    assert world.digest() == twin.digest()


@pytest.mark.parametrize("true", [2, 128, 255])
@pytest.mark.parametrize("cut", [(slice(None), slice(None)), (slice(None, None, -2), slice(1, None, 3))])
def test_a_true_of_any_byte_is_true(true, cut):
    cells = np.random.default_rng(4).integers(0, 3, (60, 150))
    plain = (cells == 1)[cut], (cells == 2)[cut]
    odd = tuple((each * np.uint8(true)).view(bool)[cut] for each in (cells == 1, cells == 2))
    for each in odd:
        each.flags.writeable = False
    world, wanted = World.from_cells(*odd), World.from_cells(*plain)
    assert world.digest() == wanted.digest() and world.grains == plain[0].sum()
    assert (density(world, Rule(), 3, runs=1) == density(wanted, Rule(), 3, runs=1)).all()


def test_a_scene_keeps_the_cells_it_was_given():
    cells = np.ones((3, 4), np.uint8)
    scene = Scene("own", "Own", "", cells, Rule(), 60.0, 4)
    cells[:] = 0
    assert scene.world().grains == 12 and not scene.cells.flags.writeable


def test_the_digest_names_everything_that_decides_the_future():
    world = world_of(["o.#", "..."], seed=1)
    others = [
        world_of(["o..", "..."], 1),
        world_of([".o#", "..."], 1),
        world_of(["o.#", "..."], 2),
        world_of(["o.", "#.", ".."], 1),
    ]
    later = world.copy()
    later.iteration = 4
    digests = {each.digest() for each in (world, later, *others)}
    assert len(digests) == 2 + len(others)


def test_the_digest_does_not_see_how_the_world_came_about():
    world = random_world(np.random.default_rng(5), 30, 140)
    advance(world, Rule.with_p(0.5, "paper"), 6)
    twin = World.from_cells(world.sand, world.walls)
    twin.iteration = 6
    assert world.digest() == twin.digest()


@pytest.mark.parametrize(
    ("sand", "walls", "seed", "words"),
    [
        (np.zeros((2, 2)), np.zeros((2, 2), bool), 0, "sand must be a bool array of shape (H, W), got float64"),
        (np.zeros(4, bool), np.zeros(4, bool), 0, "sand must be a bool array of shape (H, W)"),
        (np.zeros((2, 2), bool), np.zeros((2, 3), bool), 0, "one shape, got (2, 2) and (2, 3)"),
        (np.ones((2, 2), bool), np.ones((2, 2), bool), 0, "sand or wall, not both: row 0, column 0"),
        (np.zeros((0, 2), bool), np.zeros((0, 2), bool), 0, "size must be a whole number in [1, 16384] cells, got 0"),
        (np.zeros((1, 16385), bool), np.zeros((1, 16385), bool), 0, "got 16385"),
        (np.zeros((2, 2), bool), np.zeros((2, 2), bool), -1, "seed must be a whole number in"),
        (np.zeros((2, 2), bool), np.zeros((2, 2), bool), 1.5, "seed must be a whole number in"),
    ],
)
def test_bad_cells_are_named(sand, walls, seed, words):
    with pytest.raises(ValueError) as caught:
        World.from_cells(sand, walls, seed)
    assert words in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize("iterations", [-1, 1.5, float("nan"), "3", None, True])
def test_only_a_whole_number_of_iterations_is_run(iterations):
    with pytest.raises(ValueError, match="iterations must be a whole number"):
        advance(world_of(["o"]), Rule(), iterations)


def test_numpy_numbers_are_numbers():
    world = World.from_cells(np.zeros((2, 2), bool), np.zeros((2, 2), bool), seed=np.uint64(7))
    advance(world, Rule(), np.int64(3))
    assert world.iteration == 3 and world.seed == 7
