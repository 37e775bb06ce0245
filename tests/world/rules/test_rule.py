"""The rule checks what it is given and keeps to it."""

import copy
import pickle
from dataclasses import FrozenInstanceError

import numpy as np
import pytest

from game import Rule, World, advance, density, load_rule, rule_names
from game.world.files.paths import asset
from game.world.rules.definition import RESERVED
from game.world.rules.rule import FIELDS, PROBABILITIES


@pytest.mark.parametrize("name", [each.name for each in PROBABILITIES])
@pytest.mark.parametrize("value", [-0.001, 1.5, float("nan"), float("inf"), "1", None, True])
def test_a_probability_outside_0_to_1_is_refused(name, value):
    with pytest.raises(ValueError, match=rf"{name} must be in \[0, 1\], got"):
        Rule(**{name: value})


@pytest.mark.parametrize("schedule", ["Paper", "", None, 3, ["paper"]])
def test_an_unknown_schedule_is_refused(schedule):
    with pytest.raises(ValueError, match="schedule must be one of margolus, paper, balanced, got"):
        Rule(schedule=schedule)


def test_a_rule_cannot_be_changed():
    with pytest.raises(FrozenInstanceError):
        Rule().fall_pair = 0.5


def test_the_papers_p_is_both_topples_and_nothing_else():
    assert Rule.with_p(0.25) == Rule(topple_left=0.25, topple_right=0.25)


@pytest.mark.parametrize("p", [0.1, 0.5, 1.0])
@pytest.mark.parametrize("bias", [-1.0, -0.25, 0.0, 0.5, 1.0])
def test_p_and_bias_can_be_read_back(p, bias):
    rule = Rule.with_p(p, bias=bias)
    assert rule.topple_right == p * min(1, 1 + bias) and rule.topple_left == p * min(1, 1 - bias)
    assert rule.p == pytest.approx(p) and rule.bias == pytest.approx(bias)


def test_every_field_is_a_knob_or_the_schedule():
    assert (*(each.name for each in PROBABILITIES), "schedule") == FIELDS


def test_a_rule_is_read_by_name_or_from_a_file(tmp_path):
    mine = tmp_path / "mine.toml"
    mine.write_bytes(asset("rules", "three-sands.toml").read_bytes())
    for rule in (load_rule("three-sands"), load_rule(mine), load_rule(str(mine))):
        assert rule.materials == ("air", "fine", "coarse", "sticky", "wall")
        assert rule.schedule == "balanced" and rule.chances["sticky_topples"] == 0.05


def test_a_file_read_again_is_not_compiled_again(tmp_path):
    mine = tmp_path / "mine.toml"
    mine.write_bytes(asset("rules", "three-sands.toml").read_bytes())
    rule = load_rule(mine)
    assert load_rule(mine).table is rule.table
    mine.write_text(mine.read_text(encoding="utf-8").replace("0.95", "0.5"), encoding="utf-8")
    assert load_rule(mine).chances["fine_topples"] == 0.5 and rule.chances["fine_topples"] == 0.95


def test_the_sand_is_a_rule_like_any_other():
    assert load_rule("sand") == Rule()
    assert Rule.with_p(0.5) == load_rule("sand").with_chances(topple_left=0.5, topple_right=0.5)
    assert Rule().materials == ("air", "sand", "wall")


def test_a_chance_can_be_turned_and_the_rule_stays_as_it_was():
    rule = load_rule("alchemy")
    turned = rule.with_chances(kindle=0.125).with_schedule("balanced")
    assert (rule.chances["kindle"], turned.chances["kindle"], turned.kindle) == (0.5, 0.125, 0.125)
    assert (rule.schedule, turned.schedule) == ("paper", "balanced")
    assert turned != rule and turned.table is rule.table
    assert {name for name in rule.chances if rule.chances[name] != turned.chances[name]} == {"kindle"}


def test_what_a_rule_has_no_chance_for_is_refused():
    with pytest.raises(ValueError, match=r"chances of three-sands are fine_topples, .*, got topple_left"):
        load_rule("three-sands").with_chances(topple_left=0.5)
    with pytest.raises(ValueError, match="kindle must be in"):
        load_rule("alchemy").with_chances(kindle=1.5)


def test_outcomes_share_one_certainty():
    with pytest.raises(
        ValueError, match=r"alchemy\.toml:.*: event 'fire dies': chance: found 1.2 in all, wanted at most 1"
    ):
        load_rule("alchemy").with_chances(smoulder=0.6, die=0.6)


def test_outcomes_are_told_with_their_probability():
    rule = Rule.with_p(0.25)
    assert rule.outcomes((1, 0, 1, 0)) == [(0.25, (0, 0, 1, 1))]
    assert rule.outcomes((0, 0, 1, 1)) == rule.outcomes((2, 2, 2, 2)) == []
    assert load_rule("water-and-oil").outcomes((3, 0, 2, 2)) == [(0.9, (0, 3, 2, 2))]


def test_a_fair_bit_decides_between_a_picture_and_its_mirror_image():
    rule = load_rule("alchemy").with_chances(kindle=1.0)
    fire, seed, wall = (rule.materials.index(name) for name in ("fire", "seed", "wall"))
    lit = rule.outcomes((fire, seed, wall, fire))
    assert lit == [(1.0, (fire, fire, wall, fire))]
    upper = rule.outcomes((seed, seed, fire, fire))
    assert upper == [(0.5, (seed, fire, fire, fire)), (0.5, (fire, seed, fire, fire))]


@pytest.mark.parametrize("block", [(0, 0, 0), (0, 0, 0, 3), (0, 0, 0, -1), (0, 0, 0, "o")])
def test_what_is_no_block_is_refused(block):
    with pytest.raises(ValueError, match=r"a block must be four codes in \[0, 2\], got"):
        Rule().outcomes(block)


@pytest.mark.parametrize("name", rule_names())
def test_a_rule_goes_to_another_process_and_comes_back(name):
    rule = load_rule(name)
    assert pickle.loads(pickle.dumps(rule)) == copy.deepcopy(rule) == rule


def test_no_chance_can_have_the_name_of_what_a_rule_has():
    assert {name for name in dir(Rule) if not name.startswith("_")} <= set(RESERVED)


def test_sixteen_materials_play_in_alchemy():
    told = load_rule("alchemy").definition
    assert len(told.materials) == 16 and len(told.events) >= 30


@pytest.mark.parametrize("name", [name for name in rule_names() if name != "sand"])
def test_what_a_world_cannot_hold_is_refused(name):
    cells, rule = np.zeros((4, 4), bool), load_rule(name)
    world = World.from_cells(cells, cells)
    words = rf"^the world holds air, sand, wall; the rule {name} is of air, [^\n]+$"
    with pytest.raises(ValueError, match=words):
        advance(world, rule, 0)
    with pytest.raises(ValueError, match=words):
        density(world, rule, 0)
