"""Each call of an exported header does what the header says."""

import ctypes
from fractions import Fraction

import numpy as np
import pytest

from game import load_rule
from game.core.compiler.plan import threshold_of
from game.export.files import files
from game.export.start_scene import small_start
from tests.export.library import builds, compiled, library
from tests.world.rules.small_rule import written

SHAPES = ((1, 1), (7, 129), (33, 300))


@pytest.fixture
def sand():
    return library("sand", builds()[0])


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    """Return the Library of a rule in which an event has two outcomes, of chances 0.5 and 0.25."""
    folder = tmp_path_factory.mktemp("small")
    return compiled(files(small_start(load_rule(written(folder))))["sandglass.h"], builds()[0], folder)


def random_world(calls, shape=(7, 129), materials=3, seed=5):
    cells = np.random.default_rng(92).integers(0, materials, shape).astype(np.uint8)
    return calls.world(cells, seed), cells


@pytest.mark.parametrize(("width", "height"), [(0, 5), (5, 0), (-1, 5), (16385, 1), (1, 16385), (2**31 - 1, 2**31 - 1)])
def test_a_world_of_a_wrong_size_takes_no_bytes_and_is_not_made(sand, width, height):
    room = np.zeros(64, np.uint64)
    assert sand.bytes(width, height) == 0 and sand.init(room.ctypes.data, width, height, 1) is None
    assert not room.any()


def test_a_world_is_not_made_where_memory_is_missing_or_not_aligned(sand):
    room = np.zeros(sand.bytes(9, 9) // 8 + 1, np.uint64)
    assert sand.init(None, 9, 9, 1) is None and sand.init(room.ctypes.data + 4, 9, 9, 1) is None


def test_the_largest_world_fits_in_what_is_said(sand):
    assert 2 * 16384**2 / 8 < sand.bytes(16384, 16384) < 2.2 * 16384**2 / 8


def test_a_new_world_is_all_air(sand):
    world = sand.world(np.zeros((3, 5), np.uint8), 7)
    assert (world.materials == 0).all() and world.iteration() == 0 and world.count(0) == 15 and world.count(2) == 0


@pytest.mark.parametrize("shape", SHAPES)
def test_cells_are_what_was_set(sand, shape):
    world, cells = random_world(sand, shape)
    assert (world.materials == cells).all()
    assert all(world.get(x, y) == cells[y, x] for y, x in np.ndindex(shape))
    assert [world.count(code) for code in range(-1, 4)] == [0, *np.bincount(cells.ravel(), minlength=3), 0]


def test_outside_of_the_lattice_is_wall_and_nothing_can_be_set(sand):
    world, cells = random_world(sand)
    for x, y in ((-1, 0), (0, -1), (129, 0), (0, 7), (-(2**31), 2**31 - 1)):
        assert world.get(x, y) == 2 and world.set(x, y, 1) == 0
    assert world.set(0, 0, 3) == 0 and world.set(0, 0, -1) == 0 and (world.materials == cells).all()


@pytest.mark.parametrize(
    ("x", "y", "diameter"), [(5, 3, 1), (5, 3, 2), (0, 0, 9), (60, 3, 300), (-4, 9, 11), (5, 5, 2**31 - 1)]
)
def test_a_disc_covers_the_cells_whose_middles_it_reaches(sand, x, y, diameter):
    world, cells = random_world(sand)
    rows, columns = np.mgrid[0:7, 0:129]
    reached = 4 * ((columns - x) ** 2 + (rows - y) ** 2) <= diameter**2
    assert world.disc(x, y, diameter, 1) == np.count_nonzero(reached & (cells != 1))
    assert (world.materials == np.where(reached, 1, cells)).all()


def test_a_disc_of_no_cells_or_no_material_changes_nothing(sand):
    world, cells = random_world(sand)
    far = (2**31 - 1, -(2**31))
    assert world.disc(5, 3, 0, 1) == world.disc(5, 3, -7, 1) == world.disc(5, 3, 9, 3) == world.disc(*far, 9, 1) == 0
    assert (world.materials == cells).all()


@pytest.mark.parametrize("shape", SHAPES)
def test_a_flip_turns_by_half_a_turn(sand, shape):
    world, cells = random_world(sand, shape)
    world.flip()
    assert (world.materials == cells[::-1, ::-1]).all()


@pytest.mark.parametrize("shape", SHAPES)
def test_colours_are_those_of_the_palette(sand, shape):
    world, cells = random_world(sand, shape)
    height, width = shape
    palette = np.array([7, 2**32 - 1, 12345], np.uint32)
    for given, colours in ((palette, palette), (None, own_palette())):
        pixels = np.full((height, width + 2), 99, np.uint32)
        assert world.colours(None if given is None else given.ctypes.data, pixels.ctypes.data, width + 2)
        assert (pixels[:, :width] == colours[cells]).all() and (pixels[:, width:] == 99).all()


def own_palette():
    """Return the colours of sand as RGBA bytes, in one number each."""
    rgba = [(*each.colour, 255) for each in load_rule("sand").definition.materials]
    return np.array(rgba, np.uint8).view("<u4").ravel()


def test_nothing_is_written_where_rows_would_overlap(sand):
    world, _ = random_world(sand)
    pixels = np.full(7 * 129, 99, np.uint32)
    assert world.cells(pixels.ctypes.data, 128) == 0 and world.colours(None, pixels.ctypes.data, 128) == 0
    assert (pixels == 99).all()


def test_the_bytes_of_a_world_are_a_snapshot_wherever_they_are_put(sand):
    world, _ = random_world(sand)
    world.step(3)
    kept = np.concatenate([np.zeros(3, np.uint64), world.memory])
    world.step(9)
    digest = ctypes.create_string_buffer(33)
    sand.step(kept[3:].ctypes.data, 9)
    sand.digest(kept[3:].ctypes.data, digest)
    assert digest.value.decode() == world.name()


def test_a_step_tells_when_nothing_can_happen_any_more(sand):
    cells = np.zeros((9, 9), np.uint8)
    cells[0, 4] = 1
    world = sand.world(cells, 1)
    assert world.step(1) == 1
    assert world.step(60) == 0 and world.get(4, 8) == 1
    world.set(4, 0, 1)
    assert world.step(1) == 1
    assert world.iteration() == 62


def test_a_chance_outside_its_range_or_of_no_name_is_refused(sand):
    world, _ = random_world(sand)
    for p in (-0.1, 1.0000001, float("nan"), float("inf"), -float("inf"), -5e-324):
        assert world.set_chance(b"fall_pair", p) == 0 and world.chance(b"fall_pair") == 1.0
    for name in (b"", b"fall", b"fall_pairs", b"none"):
        assert world.set_chance(name, 0.5) == 0 and world.chance(name) == -1.0
    for p in (0.0, -0.0, 1.0, 5e-324, 0.1):
        assert world.set_chance(b"fall_pair", p) == 1 and world.chance(b"fall_pair") == p


def test_outcomes_of_one_event_have_at_most_certainty_between_them(small):
    world, _ = random_world(small)
    assert world.set_chance(b"boil", 0.7501) == 0 and world.chance(b"boil") == 0.5
    assert world.set_chance(b"boil", 0.75) == 1


def test_a_schedule_that_is_none_is_refused(sand):
    world, _ = random_world(sand)
    assert [world.set_schedule(number) for number in (-1, 0, 1, 2, 3)] == [0, 1, 1, 1, 0]


def test_names_are_those_of_the_rule(sand):
    rule = load_rule("sand")
    assert [sand.material_name(code) for code in range(-1, 4)] == [
        None,
        *(name.encode() for name in rule.materials),
        None,
    ]
    assert [sand.chance_name(number) for number in range(-1, 8)] == [
        None,
        *(name.encode() for name in rule.chances),
        None,
    ]


def test_the_scene_is_painted_as_far_as_it_fits(sand):
    scene = small_start(load_rule("sand")).cells
    for height, width in ((44, 40), (50, 60), (20, 30)):
        world = sand.world(np.zeros((height, width), np.uint8), 1)
        world.scene()
        wanted = np.zeros((height, width), np.uint8)
        part = scene[:height, :width]
        wanted[: part.shape[0], : part.shape[1]] = part
        assert (world.materials == wanted).all()


@pytest.mark.parametrize("exponent", [0, -8, -31, -33, -53, -54, -86, -130, -1074])
def test_sums_of_chances_are_rounded_as_in_python(small, exponent):
    generator = np.random.default_rng(93)
    for _ in range(200):
        halves = int(generator.integers(2**32)) * 2 + int(generator.integers(2))  # of what thresholds can tell apart
        first, second = halves / 2**33, float(generator.integers(1, 2**53)) * 2.0**-53 * 2.0**exponent
        total = Fraction(first) + Fraction(second)
        found = small.sum(first, second)
        assert found == threshold_of((0, 1), (first, second)) if total <= 1 else found >= 2**32
        assert small.sum(second, 0.0) == threshold_of((0,), (second,))
        assert small.sum(first, 0.0) == threshold_of((0,), (first,))
