"""Laws of taps, drains and turns of the table."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import Rule, World, advance, load_scene
from game.world.sand.advance import NO_TRAFFIC
from game.world.sand.fixtures import DRAIN, TAP, Fixture
from game.world.sand.sand_colours import COLOURS
from game.world.sand.world import RAINBOW_PACE
from game.world.scenes.picture_file import save_picture
from game.world.scenes.scene import SceneError
from game.world.sessions.action import Clear, Draw, Flip, Paint, SetFixtures, Turn, apply, perform
from game.world.sessions.session import Session
from game.world.sessions.snapshots import Snapshot
from tests.cells import random_world, rows_of, world_of
from tests.saved import load_picture
from tests.sweeps import sweep
from tests.world.random_sessions import fixtures

RULE = Rule.with_p(0.6, "balanced")


def furnished(number, *fittings):
    world = random_world(np.random.default_rng(number), 24, 30, seed=number)
    world.fixtures = tuple(fittings)
    return world


def test_a_drain_has_neither_colour_nor_material():
    assert Fixture(DRAIN, 1, 2, colour="teal", material="oil") == Fixture(DRAIN, 1, 2)


def test_a_tap_pours_into_its_empty_cells_and_a_drain_swallows_sand_alone():
    world = world_of(["o.#.o", ".....", "o.#oo"])
    world.fixtures = Fixture(TAP, 0, 0, 4), Fixture(DRAIN, 1, 2, 9)
    assert advance(world, RULE, 0) == NO_TRAFFIC and rows_of(world) == ["o.#.o", ".....", "o.#oo"]
    assert tuple(map(sum, advance(world, RULE, 1))) == (2, 2)
    assert world.grains == 5 + 2 - 2 and world.walls.sum() == 2


@pytest.mark.parametrize("every", [1, 3, 10])
def test_a_tap_pours_once_in_so_many_iterations_if_its_cell_is_empty_then(every):
    world = World.from_cells(np.zeros((200, 4), bool), np.zeros((200, 4), bool))
    world.fixtures = (Fixture(TAP, 1, 0, 1, 1, every),)
    twin, empty = world.copy(), 0
    for at in range(60):
        empty += at % every == 0 and not twin.sand[0, 1]
        advance(twin, RULE, 1)
    poured, swallowed = map(sum, advance(world, RULE, 60))
    assert (poured, swallowed) == (empty, 0) and poured == world.grains
    assert empty == {1: 31, 3: 20, 10: 6}[every]


@given(st.integers(0, 40), st.lists(fixtures, min_size=1, max_size=4), st.lists(st.integers(0, 12), max_size=9))
def test_what_fixtures_do_does_not_depend_on_how_iterations_are_split(number, fittings, parts):
    whole, split = (furnished(number, *fittings) for _ in range(2))
    traffic = advance(whole, RULE, sum(parts))
    passed = [advance(split, RULE, part) for part in parts]
    assert split.digest() == whole.digest()
    assert [sum(each) for each in traffic] == [sum(sum(part[k]) for part in passed) for k in range(2)]


@sweep("rule", [Rule(schedule="balanced"), RULE], keep=[RULE])
@pytest.mark.parametrize("kind", [TAP, DRAIN])
@pytest.mark.parametrize("offset", [-1, 0])
def test_sand_at_rest_moves_where_a_fixture_acts_at_the_border_of_a_band(rule, kind, offset):
    sand, walls = np.zeros((2, 600, 2000), bool)
    border = 4 * 2 * World.from_cells(sand, walls).activity.band_rows
    assert border < 500  # far from the first band
    walls[border + 4 :] = True
    if kind == DRAIN:
        sand[border - 8 : border + 4] = True
    world = World.from_cells(sand, walls, 3)
    advance(world, rule, 40)  # all is at rest, and known to be
    world.fixtures = (Fixture(kind, 5, border + offset, every=50),)
    advance(world, rule, 10)
    for _ in range(12):
        twin = world.copy()  # knows of no rest
        advance(twin, rule, 1)
        advance(world, rule, 1)
        assert world.digest() == twin.digest()


@given(st.integers(0, 40), st.lists(fixtures, max_size=4), st.integers(0, 60))
def test_grains_that_came_less_those_that_went_are_those_there_now(number, fittings, iterations):
    world = furnished(number, *fittings)
    before, walls = world.grains, world.walls
    poured, swallowed = map(sum, advance(world, RULE, iterations))
    assert world.grains == before + poured - swallowed and (world.walls == walls).all()


@given(st.integers(0, 40), st.lists(fixtures, max_size=4))
def test_four_quarter_turns_are_none_and_two_are_a_flip(number, fittings):
    worlds = [furnished(number, *fittings)]
    for _ in range(4):
        worlds.append(apply(Turn(1), worlds[-1], RULE)[0])
    assert worlds[4].digest() == worlds[0].digest() and worlds[4].fixtures == worlds[0].fixtures
    assert worlds[1].shape == (30, 24) and worlds[1].fixtures == apply(Turn(3), worlds[2], RULE)[0].fixtures
    flipped = worlds[0].copy()
    flipped.flip()
    assert worlds[2].digest() == flipped.digest() and worlds[2].fixtures == flipped.fixtures
    assert len({world.grains for world in worlds}) == len({int(world.walls.sum()) for world in worlds}) == 1


@given(fixtures, st.integers(1, 3))
def test_a_fixture_turns_with_the_cells_under_it(each, quarters):
    cells = np.zeros((24, 30), bool)
    left, top, right, bottom = each.box
    cells[max(top, 0) : max(bottom, 0), max(left, 0) : max(right, 0)] = True
    left, top, right, bottom = each.turned(quarters, cells.shape).box
    turned = np.zeros(cells.shape if quarters == 2 else cells.shape[::-1], bool)
    turned[max(top, 0) : max(bottom, 0), max(left, 0) : max(right, 0)] = True
    assert (turned == np.rot90(cells, -quarters)).all()


def test_a_quarter_turn_takes_the_left_side_to_the_top():
    world = world_of(["o#..", "....", "#..."])
    assert rows_of(world.turned(1)) == ["#.o", "..#", "...", "..."]


@pytest.mark.parametrize("colour", ["amber", "plum", "ivory"])
def test_a_tap_pours_sand_of_its_colour_and_the_books_tell_of_it(colour):
    session = Session(load_scene("blank", (40, 30)))
    session.do(SetFixtures((Fixture(TAP, 3, 3, 2, 1, 2, colour), Fixture(DRAIN, 0, 29, 40))))
    session.timeline.run(120)
    world, account = session.world, session.account
    number = COLOURS.index(colour)
    assert world.coloured == (colour != "amber") and set(world.colours[world.sand].tolist()) == {number}
    assert account.poured_by_kind[number] == account.poured > account.swallowed_by_kind[number] > 0
    assert account.balanced(world)


def test_a_rainbow_tap_pours_all_colours_in_turn():
    world = world_of(["." * 9] * 60)
    world.fixtures = (Fixture(TAP, 4, 0, colour="rainbow"), Fixture(DRAIN, 0, 59, 9))
    poured = advance(world, RULE, 8 * RAINBOW_PACE).poured
    assert min(poured) > 0 and max(poured) < 2 * min(poured)


def test_amber_goes_without_saying_so_that_older_sessions_keep_their_names():
    assert str(Fixture(TAP, 1, 2)) == "Fixture(kind='tap', x=1, y=2, width=1, height=1, every=1)"
    assert (
        "colour" not in Fixture(TAP, 1, 2).as_dict() and Fixture(TAP, 1, 2, colour="rose").as_dict()["colour"] == "rose"
    )
    assert furnished(1, Fixture(TAP, 1, 1)).digest() != furnished(1, Fixture(TAP, 1, 1, colour="rose")).digest()


def test_the_eraser_takes_the_fixtures_it_comes_over():
    kept, gone = Fixture(TAP, 2, 2, 5), Fixture(DRAIN, 2, 12, 9)
    for act in (Paint("erase", (9.0, 9.0), (9.0, 14.0), 3), Draw("ellipse", "erase", (8.5, 9.5), (14.5, 14.5))):
        world, _, change, _ = perform(act, furnished(1, kept, gone), RULE)
        assert world.fixtures == (kept,) and sum(change) < 0
    places = (9.0, 9.0), (9.0, 14.0)
    for act in (Paint("sand", *places, 3), Clear(), Paint("erase", *places, 3, only="wall")):
        assert perform(act, furnished(1, kept, gone), RULE)[0].fixtures == (kept, gone)


def test_a_world_without_fixtures_keeps_its_name_and_one_with_them_has_another():
    bare, tapped = furnished(1), furnished(1, Fixture(TAP, 1, 1))
    assert bare.digest() == random_world(np.random.default_rng(1), 24, 30, seed=1).digest() != tapped.digest()
    assert tapped.digest() == tapped.copy().digest() != furnished(1, Fixture(TAP, 1, 2)).digest()


def test_a_snapshot_keeps_the_fixtures():
    session = Session(load_scene("blank", (40, 30)))
    session.do(SetFixtures((Fixture(TAP, 3, 3, 2, 1, 2), Fixture(DRAIN, 0, 29, 40))))
    session.timeline.run(50)
    kept = Snapshot(session.timeline.moment, None).moment()
    session.timeline.run(50)
    kept.run(50)
    assert kept.world.digest() == session.world.digest() and kept.account == session.account
    assert session.account.poured > session.account.swallowed > 0 and session.account.balanced(session.world)


def test_a_picture_keeps_the_fixtures(tmp_path):
    session = Session(load_scene("blank", (40, 30)))
    fittings = Fixture(TAP, 3, 3, 2, 1, 2, "teal"), Fixture(DRAIN, 0, 29, 40)
    session.do(SetFixtures(fittings))
    session.do(Flip())
    save_picture(tmp_path / "taps.png", session)
    assert load_picture(tmp_path / "taps.png").scene.fixtures == session.world.fixtures != fittings


def test_a_scene_file_places_taps_and_drains_and_says_what_is_wrong(tmp_path):
    path = tmp_path / "well.toml"
    tap = '[[tap]]\nx = 8\ny = 2\nwidth = 4\nevery = 6\ncolour = "moss"\n'
    text = f"width = 40\nheight = 20\n{tap}[[drain]]\nx = 0\ny = 19\nwidth = 40\n"
    path.write_text(text, encoding="utf-8")
    assert load_scene(path).fixtures == (Fixture(TAP, 8, 2, 4, 1, 6, "moss"), Fixture(DRAIN, 0, 19, 40))
    assert load_scene(path, (80, 40)).fixtures == (Fixture(TAP, 16, 4, 8, 2, 6, "moss"), Fixture(DRAIN, 0, 38, 80, 2))
    wrongs = (
        ("x = 1\ny = 1\nevery = 0", "tap 1.every"),
        ("hight = 3", "height"),
        ("x = 1.5", "tap 1.x"),
        ('x = 1\ny = 1\ncolour = "mauve"', "tap 1.colour"),
        ("x = 1\ny = 1\n[[drain]]\ncolour = 'rose'", "drain 1"),
    )
    for wrong, told in wrongs:
        path.write_text(f"width = 40\nheight = 20\n[[tap]]\n{wrong}\n", encoding="utf-8")
        with pytest.raises(SceneError, match=told):
            load_scene(path)
    assert json.dumps(Fixture(TAP, 1, 2).as_dict())


def test_a_drain_as_wide_as_its_scene_is_so_on_any_lattice():
    scene = load_scene("fountain", (1800, 1700))
    drain = next(each for each in scene.fixtures if each.kind == DRAIN)
    assert (drain.x, drain.width) == (60, 1680)


@pytest.mark.parametrize("act", [Paint("erase", (30, 6), (34, 6.5), 3), Draw("ellipse", "erase", (20, 2), (28, 9))])
def test_the_eraser_takes_the_fixtures_that_it_comes_over(act):
    fixtures = [Fixture(TAP, x, y) for y in range(12) for x in range(40)]
    world = World.from_cells(np.zeros((12, 40), bool), np.ones((12, 40), bool))
    perform(act, world, Rule())
    erased = ~world.walls
    world.fixtures = tuple(fixtures)
    perform(act, world, Rule())
    assert {(each.x, each.y) for each in fixtures} - {(each.x, each.y) for each in world.fixtures} == {
        (x, y) for y, x in np.argwhere(erased).tolist()
    }
    world.fixtures = (Fixture(DRAIN, -500, 5, 16_384, 2),)
    perform(act, world, Rule())
    assert not world.fixtures
