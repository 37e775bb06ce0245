"""Laws of rest under any rule: it is there when no block of any partition can change, by whatever chance is left."""

from itertools import product

import numpy as np

from game import World, advance, load_rule, rule_names
from game.world.files.paths import asset
from game.world.rules.rule import SCHEDULES
from game.world.sand.block_events import possible_events
from game.world.sand.fixtures import DRAIN, TAP, Fixture
from game.world.scenes.scene import Scene
from game.world.sessions.run_out import at_rest, find_run_out
from game.world.sessions.session import Session
from tests import reference
from tests.cells import strewn
from tests.sweeps import sweep

EMBERS = """
layers = ["fire"]
[materials]
air  = { letter = ".", class = "empty", colour = "#1b1a1c" }
wood = { letter = "w", class = "solid", colour = "#7a5230" }
fire = { letter = "f", class = "solid", colour = "#ffb52e" }
wall = { letter = "#", class = "solid", colour = "#78828c" }
[chances]
die = 0.0001
[[event]]
name = "fire clings"
chance = 0.9
picture = "fw -> fw"
[[event]]
name = "fire dies"
chance = "die"
picture = "f -> ."
"""


def drawn(rows, rule, seed=1):
    codes = {each.letter: code for code, each in enumerate(rule.definition.materials)}
    return World.from_materials(np.array([[codes[letter] for letter in row] for row in rows], np.uint8), rule, seed)


def some_impossible(rule):
    """Return a rule in which every third chance is 0."""
    return rule.with_chances(**{name: 0.0 if at % 3 == 1 else 0.4 for at, name in enumerate(rule.chances)})


def is_still(world, rule, pictures):
    """Return whether no picture changes a block of any partition, laid on one after the other."""
    letters = [each.letter for each in rule.definition.materials]
    cells = np.pad(world.materials, 2, constant_values=rule.codes.wall)
    height, width = world.shape
    blocks = {
        tuple(letters[code] for code in cells[y : y + 2, x : x + 2].ravel())
        for left, top in rule.offsets
        for y, x in product(range(2 - top, height + 2, 2), range(2 - left, width + 2, 2))
    }
    return not any(pictures.outcomes(block) for block in blocks)


@sweep(
    ("name", "schedule"), product(rule_names(), SCHEDULES), keep=[("sand", "balanced"), ("water-and-oil", "balanced")]
)
def test_rest_is_when_no_picture_changes_any_block(name, schedule):
    rule = some_impossible(load_rule(name).with_schedule(schedule))
    pictures = reference.Pictures(asset("rules", f"{name}.toml"), **rule.chances)
    found = set()
    for number, (height, width) in enumerate([(2, 2), (2, 3), (3, 3), (4, 5), (9, 7)] * 3):
        world = strewn(rule, number, height, width)
        for _ in range(4):
            still = is_still(world, rule, pictures)
            assert at_rest(world, rule) == still, world.materials
            found.add(still)
            advance(world, rule, 30)
    assert found == {True, False}


def test_fire_in_plants_rests_once_it_has_burnt_out():
    rule = some_impossible(load_rule("alchemy"))
    world = drawn(["..f...", "pppppp", "pppppp", "######"], rule)
    assert not at_rest(world, rule) and "plants catch fire" in possible_events(world, rule)
    for _ in range(400):
        advance(world, rule, 50)
        if at_rest(world, rule):
            break
    assert not world.where("fire").any() and not world.where("smoke").any()
    before = world.materials
    advance(world, rule, 1000)
    assert possible_events(world, rule) == [] and (world.materials == before).all()


def test_what_a_chance_of_zero_keeps_from_happening_and_what_changes_nothing_is_at_rest(tmp_path):
    path = tmp_path / "embers.toml"
    path.write_text(EMBERS, encoding="utf-8")
    rule = load_rule(path)
    world = drawn(["fw", ".."], rule)
    assert not at_rest(world, rule) and possible_events(world, rule) == ["fire dies"]
    everlasting = rule.with_chances(die=0.0)
    assert at_rest(world, everlasting) and possible_events(world, everlasting) == []
    advance(world, everlasting, 8)
    assert not world.activity.settled, "fire clings: an event, though it changes nothing"


def test_a_tap_with_room_and_a_drain_with_something_in_it_are_no_rest():
    rule = load_rule("water-and-oil")
    world = drawn(["#.#", "#w#"], rule)
    assert at_rest(world, rule)
    world.fixtures = (Fixture(TAP, 1, 0, every=1000, material="oil"),)
    assert not at_rest(world, rule)
    world.fixtures = (Fixture(DRAIN, 1, 1, every=1000),)
    assert not at_rest(world, rule)
    world.fixtures = (Fixture(TAP, 1, 1, every=1000, material="oil"),)
    assert at_rest(world, rule)


def test_without_a_neck_the_end_is_the_last_change_of_any_material():
    rule = load_rule("water-and-oil")
    world = drawn(["#w#w#", "#o#o#", "#o#o#", "#o#o#"], rule)  # full: nothing moves but by changing places
    session = Session(Scene("full", "Full", "", world.materials, rule, 90.0, 4), seed=2)
    ending = find_run_out(session.timeline.lookahead())
    assert not ending.endless and ending.at > 0
    session.timeline.run(ending.at - 1)
    before = session.world.materials
    session.timeline.run(1)
    assert (session.world.materials != before).any() and at_rest(session.world, rule)
