"""Stamps: what is cut out and put elsewhere is the same, lands by name, and is accounted for."""

import numpy as np
import pytest

from game import Rule, World, load_rule
from game.world.sand.fixtures import Fixture
from game.world.sand.stamp import Stamp, cut_out, put
from game.world.sessions.action import ANCHORS, Draw, Move, Paste, Resize, perform
from game.world.sessions.moment import account_of
from tests.cells import coloured, random_world, rows_of, strewn, world_of
from tests.world.random_sessions import stamp_of

RULE = Rule.with_p(1.0, "balanced")


def blank(height=20, width=30):
    return World.from_cells(*np.zeros((2, height, width), bool))


def test_what_is_put_is_what_was_cut_out_colours_and_fixtures_too():
    generator = np.random.default_rng(1)
    world = coloured(random_world(generator, 140, 300), generator)
    world.fixtures = (Fixture("tap", 40, 21, 3, 1, 2, "teal"), Fixture("drain", 1, 1))
    stamp = cut_out(world, (33, 15, 171, 98))
    assert stamp.shape == (83, 138) and [each.kind for each in stamp.fixtures] == ["tap"]
    other = blank(140, 300)
    put(other, stamp, 90, 50)
    assert cut_out(other, (90, 50, 228, 133)) == stamp
    assert other.grains == (stamp.cells == 1).sum() and other.fixtures == (world.fixtures[0].moved(57, 35),)


@pytest.mark.parametrize("height, width, left, top", [(9, 7, -3, -2), (9, 130, 250, 3), (40, 300, 0, -7), (3, 3, 5, 6)])
def test_a_stamp_changes_the_cells_that_it_has_something_for_and_no_others(height, width, left, top):
    generator = np.random.default_rng(height)
    world, stamp = random_world(generator, 31, 290), cut_out(random_world(generator, height, width), (0, 0, 999, 999))
    wanted = world.materials
    for row, column in np.argwhere(stamp.cells):
        if 0 <= row + top < 31 and 0 <= column + left < 290:
            wanted[row + top, column + left] = stamp.cells[row, column]
    put(world, stamp, left, top)
    assert (world.materials == wanted).all()


def test_air_is_see_through_unless_it_is_put_too():
    stamp = cut_out(world_of(["o.", ".#"]), (0, 0, 2, 2))
    for air, wanted in ((False, ["o##", "###"]), (True, ["o.#", ".##"])):
        world = world_of(["###", "###"])
        put(world, stamp, 0, 0, air)
        assert rows_of(world) == wanted


def test_materials_land_by_name_and_those_unknown_are_left_out():
    alchemy, kitchen = load_rule("alchemy"), load_rule("water-and-oil")
    stamp, world = cut_out(strewn(alchemy, 1, 12, 12), (0, 0, 12, 12)), strewn(kitchen, 2, 12, 12)
    before = world.materials
    put(world, stamp, 0, 0)
    for (row, column), code in np.ndenumerate(stamp.cells):
        name = alchemy.materials[code]
        known = name in kitchen.materials and name != "air"
        there = kitchen.materials[world.materials[row, column]]
        assert there == (name if known else kitchen.materials[before[row, column]])


def test_what_is_put_and_what_is_taken_for_it_are_in_the_account():
    generator = np.random.default_rng(3)
    world = coloured(random_world(generator, 40, 50), generator)
    account = account_of(world, RULE)
    for number in range(10):
        *_, grains, _ = perform(Paste(stamp_of(number), (number * 4, 30), bool(number % 2)), world, RULE)
        account = account.booked(grains)
        assert account.balanced(world)
    *_, grains, _ = perform(Draw("rectangle", "erase", (3, 3), (20, 20)), world, RULE)
    assert account.booked(grains).balanced(world)


@pytest.mark.parametrize("place", [(20, 10), (4, 5), (-3, 2), (90, 3)])
def test_a_move_takes_all_along_and_leaves_nothing_behind(place):
    generator = np.random.default_rng(6)
    world, blocks = blank(40, 50), random_world(generator, 9, 7)
    put(world, cut_out(blocks, (0, 0, 7, 9)), 3, 4)
    world.fixtures = (Fixture("tap", 4, 5, 9),)
    account, piece = account_of(world, RULE), cut_out(world, (3, 4, 10, 13))
    *_, grains, changed = perform(Move((3, 4), (9.5, 12), place, 1, True), world, RULE)
    wanted = blank(40, 50)
    put(wanted, piece.mirrored().turned(1), *place)
    assert changed and (world.materials == wanted.materials).all() and world.fixtures == wanted.fixtures
    assert account.booked(grains).balanced(world)


def test_a_stamp_that_changes_nothing_is_no_act():
    world = random_world(np.random.default_rng(4), 20, 30)
    stamp = cut_out(world, (3, 3, 12, 12))
    assert not perform(Paste(stamp, (3, 3), True), world, RULE).changed
    assert not perform(Paste(stamp, (90, 3)), world, RULE).changed and not world.coloured
    assert not perform(Move((3, 3), (11, 11), (3, 3)), world, RULE).changed
    assert not perform(Move((-9, 3), (-2, 11), (3, 3)), world, RULE).changed


def test_four_quarter_turns_and_two_mirrorings_bring_a_stamp_back():
    stamp = stamp_of(4, [Fixture("tap", 1, 2, 3, 1)])
    assert stamp.turned(1).turned(3) == stamp == stamp.mirrored().mirrored()
    assert stamp.turned(1).mirrored() == stamp.mirrored().turned(3) != stamp
    one = Stamp(("air", "sand", "wall"), np.array([[1, 2], [0, 0]], np.uint8), fixtures=(Fixture("drain", 0, 0),))
    assert one.turned(1).cells.tolist() == [[0, 1], [0, 2]] and one.turned(1).fixtures[0].x == 1
    assert one.mirrored().cells.tolist() == [[2, 1], [0, 0]] and one.mirrored().fixtures[0].x == 1


@pytest.mark.parametrize("anchor", ANCHORS)
def test_what_stays_inside_stays_as_it_is_and_what_is_cut_off_is_erased(anchor):
    generator = np.random.default_rng(5)
    world = coloured(random_world(generator, 30, 40), generator)
    world.iteration, world.fixtures = 7, (Fixture("tap", 0, 0), Fixture("drain", 39, 29))
    account, (across, down) = account_of(world, RULE), ANCHORS[anchor]
    larger = perform(Resize(51, 37, anchor), world, RULE)
    place = 11 * across // 2, 7 * down // 2
    assert larger.world.grains == world.grains and larger.world.iteration == 7
    assert account.booked(larger.grains).balanced(larger.world)
    kept = cut_out(larger.world, (*place, place[0] + 40, place[1] + 30))
    assert kept == cut_out(world, (0, 0, 40, 30))
    smaller = perform(Resize(17, 11, anchor), world, RULE)
    left, top = -(-23 * across // 2), -(-19 * down // 2)
    assert account.booked(smaller.grains).balanced(smaller.world) and sum(smaller.grains) < 0
    assert (smaller.world.materials == world.materials[top : top + 11, left : left + 17]).all()
    assert len(smaller.world.fixtures) == (anchor in ("top left", "bottom right"))
