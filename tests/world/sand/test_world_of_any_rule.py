"""Worlds of every shipped rule: what was put in is what is read, turned, counted, painted and cleared."""

import copy
import pickle
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import Rule, World, advance, load_rule
from game.world.rules.definition import rule_names
from game.world.sand.fixtures import Fixture
from game.world.sand.material_codes import MaterialCodes
from game.world.sand.sand_colours import COLOURS
from game.world.sessions.action import FIGURES, SHAPES, Draw, Fill, Paint, perform
from tests.cells import joined_to, strewn
from tests.sweeps import swept

HEIGHT, WIDTH = 23, 147
places = st.tuples(st.floats(-6, WIDTH + 6), st.floats(-6, HEIGHT + 6))


@pytest.fixture(params=swept(rule_names(), keep=["sand", "water-and-oil", "alchemy"]))
def rule(request):
    return load_rule(request.param)


def amounts_of(cells, codes):
    """Return what `World.amounts` must be for cells, by counting."""
    if codes.is_sand:
        return ((cells == 1).sum(), *[0] * (len(COLOURS) - 1))
    return tuple((cells == code).sum() * (code in codes.filled) for code in range(len(codes.names)))


@pytest.mark.parametrize("shape", [(1, 1), (1, 9), (7, 1), (61, 61), (64, 128), (33, 257)])
def test_the_cells_of_a_world_are_those_it_was_made_of(rule, shape):
    generator = np.random.default_rng(shape)
    cells = generator.integers(0, len(rule.materials), (shape[0], 2 * shape[1]), np.uint8)[:, ::-2]
    cells.flags.writeable = False
    world = World.from_materials(cells, rule, seed=7)
    assert (world.materials == cells).all() and world.materials.dtype == np.uint8 and world.shape == shape
    assert (world.codes, world.seed, world.iteration) == (rule.codes, 7, 0)
    forms = [each.form_of or each.name for each in rule.definition.materials]
    for name in set(forms):
        assert (world.where(name) == np.isin(cells, [code for code, form in enumerate(forms) if form == name])).all()
    assert (world.walls == (cells == rule.materials.index("wall"))).all()
    assert [world.code_at(column, 0) for column in range(shape[1])] == cells[0].tolist()
    assert world.code_at(-1, 0) is world.code_at(0, shape[0]) is None


def test_amounts_are_what_counting_finds(rule):
    world = strewn(rule, 1, HEIGHT, WIDTH)
    assert world.amounts == amounts_of(world.materials, rule.codes)
    assert world.grains == sum(world.amounts)


@pytest.mark.parametrize(
    "copied", [World.copy, copy.copy, copy.deepcopy, lambda each: pickle.loads(pickle.dumps(each))]
)
def test_a_copy_is_the_same_world_and_goes_its_own_way(rule, copied):
    world = strewn(rule, 2, HEIGHT, WIDTH)
    world.fixtures = (Fixture("tap", 3, 4, 2, material=rule.materials[-1]), Fixture("drain", 8, 9, 30))
    advance(world, rule, 3)
    before, twin = world.digest(), copied(world)
    assert twin.digest() == before and twin.codes == world.codes
    advance(twin, rule, 5)
    assert world.digest() == before
    advance(world, rule, 5)
    assert world.digest() == twin.digest() != before


@pytest.mark.parametrize("shape", [(1, 1), (5, 2), (HEIGHT, WIDTH)])
def test_turns_turn_the_cells_and_a_whole_turn_is_the_identity(rule, shape):
    world = strewn(rule, 3, *shape)
    world.fixtures = (Fixture("tap", 1, 0, 3, material="water"), Fixture("drain", -2, 3, 5, 2, 4))
    cells, digest = world.materials, world.digest()
    for quarters in (1, 2, 3, 4):
        turned = world.turned(quarters)
        assert (turned.materials == np.rot90(cells, -quarters)).all() and turned.codes == world.codes
        assert turned.fixtures == tuple(each.turned(quarters, shape) for each in world.fixtures)
    assert turned.digest() == world.turned(1).turned(3).digest() == digest
    world.flip()
    assert (world.materials == cells[::-1, ::-1]).all() and world.digest() == world.turned(2).turned(2).digest()
    world.flip()
    assert world.digest() == digest


def test_a_world_runs_on_after_a_turn_like_one_made_so(rule):
    world = strewn(rule, 4, HEIGHT, WIDTH)
    advance(world, rule, 7)
    for turned in (world.turned(1), world.turned(2)):
        twin = World.from_materials(turned.materials, rule, world.seed)
        twin.iteration = turned.iteration
        for each in (turned, twin):
            advance(each, rule, 9)
        assert turned.digest() == twin.digest()


@pytest.mark.parametrize("other", rule_names())
def test_for_another_rule_cells_are_what_is_called_the_same_there(rule, other):
    world, codes = strewn(rule, 5, HEIGHT, WIDTH), load_rule(other).codes
    world.iteration, world.fixtures = 9, (Fixture("drain", 1, 2, 3),)
    made = world.of(codes)
    assert (made is world) == (codes == rule.codes)
    names, wanted = np.array(rule.materials)[world.materials], np.array(codes.names)[made.materials]
    assert (wanted == np.where(np.isin(names, codes.names), names, "air")).all()
    assert (made.codes, made.seed, made.iteration, made.fixtures) == (codes, world.seed, 9, world.fixtures)


def test_clearing_leaves_the_walls_alone(rule):
    world = strewn(rule, 6, HEIGHT, WIDTH)
    walls = world.walls
    world.clear()
    assert (world.materials == walls * np.uint8(rule.codes.wall)).all() and not any(world.amounts)


def test_digests_differ_by_cells_names_fixtures_seed_and_time(rule):
    world = strewn(rule, 7, 9, 14)
    digests = {world.digest()}
    for code in range(len(rule.materials)):
        cells = world.materials
        cells[4, 5] = code
        digests.add(World.from_materials(cells, rule, world.seed).digest())
    assert len(digests) == len(rule.materials)
    renamed = tuple(name if name in ("air", "wall") else f"{name} too" for name in rule.materials)
    digests.add(World.of_codes(world.materials, MaterialCodes(renamed), world.seed).digest())
    digests.add(World.from_materials(world.materials, rule, world.seed + 1).digest())
    tap = Fixture("tap", 1, 2)
    for fittings in ((tap,), (tap, tap), (replace(tap, material="water"),), (replace(tap, every=2),)):
        other = world.copy()
        other.fixtures = fittings
        digests.add(other.digest())
    world.iteration += 1
    digests.add(world.digest())
    assert len(digests) == len(rule.materials) + 7


def painted_by(act, world):
    """Return what an act of a material must leave of a world's cells: a plain model by names.

    Which cells a brush or a figure reaches is read off a world of sand, where all of them are painted over.
    """
    names, cells = np.array(world.codes.names), world.materials
    blank = World.from_cells(*np.zeros((2, *world.shape), bool))
    reaching = replace(act, material="wall", **({"only": ""} if isinstance(act, Paint) else {}))
    perform(reaching, blank, Rule())
    given = "air" if act.material == "erase" else act.material
    if getattr(act, "only", ""):
        taken = names[cells] == act.only.replace("empty", "air")
    else:
        taken = (names[cells] != "wall") | act.over_walls | (act.material in ("erase", "wall"))
    return np.where(blank.walls & taken, world.codes.names.index(given), cells)


def check_act(act, world, rule, wanted):
    """Assert that an act leaves the cells wanted, tells what it changed, and leaves a sound world."""
    before, digest = world.amounts, world.digest()
    after, _, grains, changed = perform(act, world, rule)
    assert after is world and (world.materials == wanted).all() and changed == (world.digest() != digest)
    assert world.amounts == amounts_of(wanted, world.codes)
    grains = grains or (0,) * len(before)
    assert grains == tuple(now - then for now, then in zip(world.amounts, before, strict=True))
    twin = World.from_materials(wanted, rule, world.seed)
    for each in (world, twin):
        advance(each, rule, 2)
    assert world.digest() == twin.digest()


@given(data=st.data(), start=places, end=places, diameter=st.integers(1, 12), number=st.integers(0, 9))
def test_a_stroke_gives_a_material_to_the_cells_that_take_it(rule, data, start, end, diameter, number):
    names = st.sampled_from(("erase", *rule.materials[1:]))
    over_walls, shape = data.draw(st.booleans()), data.draw(st.sampled_from(sorted(SHAPES)))
    only = data.draw(st.sampled_from(("", "empty", *rule.materials[1:])))
    act = Paint(data.draw(names), start, end, diameter, over_walls, shape, only, data.draw(st.integers(0, 3)))
    world = strewn(rule, number, HEIGHT, WIDTH)
    check_act(act, world, rule, painted_by(act, world))


@given(data=st.data(), start=places, end=places, edge=st.integers(0, 3), number=st.integers(0, 9))
def test_a_figure_gives_a_material_to_the_cells_that_take_it(rule, data, start, end, edge, number):
    material = data.draw(st.sampled_from(("erase", *rule.materials[1:])))
    act = Draw(data.draw(st.sampled_from(sorted(FIGURES))), material, start, end, edge, data.draw(st.booleans()))
    world = strewn(rule, number, HEIGHT, WIDTH)
    check_act(act, world, rule, painted_by(act, world))


@given(data=st.data(), column=st.integers(0, WIDTH - 1), row=st.integers(0, HEIGHT - 1), number=st.integers(0, 9))
def test_a_fill_gives_a_material_to_what_is_connected_through_cells_of_one_code(rule, data, column, row, number):
    world = strewn(rule, number, HEIGHT, WIDTH, lumps=4)
    cells = world.materials
    reached = joined_to(cells, row, column)
    material = data.draw(st.sampled_from(("erase", *rule.materials[1:])))
    for place in reached:
        cells[place] = 0 if material == "erase" else rule.materials.index(material)
    check_act(Fill(material, (column + 0.5, row + 0.5)), world, rule, cells)


@pytest.mark.parametrize("act", [Paint("glue", (3, 3), (9, 9), 5), Paint("sand", (3, 3), (9, 9), 5, only="glue")])
def test_a_material_that_a_world_has_not_is_neither_painted_nor_painted_over(rule, act):
    world = strewn(rule, 8, HEIGHT, WIDTH)
    check_act(act, world, rule, world.materials)


@pytest.mark.parametrize(
    ("cells", "words"),
    [
        (np.zeros((2, 2)), "cells must be a uint8 array of shape (H, W), got float64 of shape (2, 2)"),
        (np.zeros((2, 2), bool), "cells must be a uint8 array of shape (H, W), got bool"),
        (np.zeros(4, np.uint8), "cells must be a uint8 array of shape (H, W), got uint8 of shape (4,)"),
        (np.zeros((0, 2), np.uint8), "size must be a whole number in [1, 16384] cells, got 0"),
        (np.zeros((1, 16385), np.uint8), "got 16385"),
    ],
)
def test_bad_cells_are_told_in_one_line(rule, cells, words):
    with pytest.raises(ValueError) as caught:
        World.from_materials(cells, rule)
    assert words in str(caught.value) and str(caught.value).isprintable()


def test_a_code_of_no_material_is_told_in_one_line_with_its_place(rule):
    names = rule.materials
    for code in (len(names), 255):
        cells = np.zeros((3, 4), np.uint8)
        cells[1, 2] = code
        with pytest.raises(ValueError) as caught:
            World.from_materials(cells, rule)
        wanted = f"a code must be in [0, {len(names) - 1}], one of {', '.join(names)}"
        assert str(caught.value) == f"{wanted}, got {code} in row 1, column 2"


def test_a_material_that_is_none_is_told_in_one_line(rule):
    with pytest.raises(ValueError, match=r"a material must be one of air, .*, got 'glue'") as caught:
        strewn(rule, 9, 3, 4).where("glue")
    assert str(caught.value).isprintable()
