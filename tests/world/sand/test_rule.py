"""The rule checks what it is given and keeps to it."""

from dataclasses import FrozenInstanceError

import pytest

from game import Rule
from game.world.sand import parameters
from game.world.sand.rule import FIELDS


@pytest.mark.parametrize("name", [each.name for each in parameters.PROBABILITIES])
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
    assert (*(each.name for each in parameters.PROBABILITIES), "schedule") == FIELDS
