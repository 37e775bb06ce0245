"""Laws of what can be turned in a rule: each chance and own number has its dial, and reactions are as drawn."""

import numpy as np
import pytest

from game.world.files.checked_table import CheckedTable
from game.world.rules.definition import rule_names
from game.world.rules.dials import dials_of
from game.world.rules.reactions import reactions
from game.world.rules.rule import load_rule
from game.world.rules.rule_json import decode_rule, encode_rule
from game.world.sand.advance import advance
from game.world.sand.world import World
from game.world.scenes.scene import load_scene


@pytest.mark.parametrize("name", rule_names())
def test_each_chance_and_each_own_number_has_one_dial_with_the_value_of_the_file(name):
    told = load_rule(name).definition
    dials = [each for of_one in dials_of(told).values() for each in of_one]
    usual = {each.name: each.default for each in told.chances} | told.own_numbers
    assert sorted(each.knob.name for each in dials) == sorted(usual)
    assert {each.knob.name: each.knob.default for each in dials} == usual


@pytest.mark.parametrize("name", rule_names())
def test_a_dial_stands_with_a_material_that_is_in_its_picture(name):
    for code, of_one in dials_of(load_rule(name).definition).items():
        assert all(code in {held for row in each.picture[0] for cell in row for held in cell} for each in of_one)


def test_an_own_number_is_a_chance_only_while_it_is_turned():
    rule = load_rule("water-and-oil")
    turned = rule.with_chances(**{"oil.pour": 0.9})
    assert turned != rule and turned.number("oil.pour") == 0.9 and turned.definition.source == rule.definition.source
    assert turned.with_chances(**{"oil.pour": 0.5}) == rule
    assert turned.with_chances(friction=0.1).number("oil.pour") == 0.9


def test_an_own_number_decides_only_about_its_material():
    rule = load_rule("water-and-oil")
    frozen = rule.with_chances(flow=0.0, **{"water.pour": 0.0, "water.topple": 0.0})
    for name, moves in (("water", False), ("oil", True)):
        cells = np.zeros((8, 32), np.uint8)
        cells[4:, 10:14] = rule.codes.code(name)
        world = World.from_materials(cells, rule)
        advance(world, frozen, 100)
        assert (world.materials.tolist() != cells.tolist()) == moves


def test_turned_own_numbers_are_told_in_files():
    rule = load_rule("water-and-oil").with_chances(creep=0.25, **{"oil.pour": 0.9, "water.sink": 0.125})
    assert decode_rule(CheckedTable("rule", encode_rule(rule))) == rule


def told(name, material):
    rule = load_rule(name)
    return {(each.words, each.chance) for each in reactions(rule, rule.codes.code(material))}


def test_reactions_say_what_the_pictures_draw():
    assert ("with lava becomes stone and steam", 0.8) in told("alchemy", "water")
    assert ("with water becomes stone and steam", 0.8) in told("alchemy", "lava")
    assert ("by itself becomes smoke", 0.03) in told("alchemy", "fire")
    assert ("with sand or stone becomes smoke", 0.03) in told("alchemy", "acid")


def test_reactions_have_the_chances_that_are_turned():
    rule = load_rule("alchemy").with_chances(eat=0.5)
    assert [each.chance for each in reactions(rule, rule.codes.code("sand")) if each.event == "acid eats"] == [0.5]


@pytest.mark.parametrize("name", sorted({*rule_names()} - {"alchemy"}))
def test_where_all_only_moves_there_are_no_reactions(name):
    assert all(not told(name, material) for material in load_rule(name).materials)


def test_a_scene_may_turn_own_numbers(tmp_path):
    path = tmp_path / "slow.toml"
    path.write_text('width = 8\nheight = 8\nrule = { name = "water-and-oil", flow = 0.25, "oil.pour" = 0.125 }\n')
    rule = load_scene(path).rule
    assert rule.number("oil.pour") == 0.125 and rule.number("flow") == 0.25 and rule.number("water.pour") == 0.75
