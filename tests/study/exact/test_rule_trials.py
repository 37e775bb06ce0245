"""Trials of rules: an ensemble agrees with the chain of its pictures, and one whose chance is a little off does not."""

from dataclasses import replace

import numpy as np
import pytest

from game import rule_names
from game.study.exact import rule_trials
from game.study.exact.picture_chain import PictureChain
from game.study.exact.picture_rule import PictureRule
from game.study.exact.rule_lattices import LATTICES
from game.study.exact.rule_trials import RuleTrial, most_uncertain, told_materials, trials
from game.world.files.paths import asset

RUNS = 50_000
TRIAL = RuleTrial("water-and-oil", "oil below water", "balanced", "as in the file", 1)


def p_values(result):
    joint = [each.joint.p_value for each in result.materials.values() if each.joint and each.joint.degrees]
    return joint + [p for each in result.materials.values() for p in each.cells]


@pytest.mark.parametrize("chances", rule_trials.CHANCES)
def test_an_ensemble_of_several_materials_agrees_with_its_pictures(chances):
    found = replace(TRIAL, chances=chances).run(RUNS)
    assert found.states > 10 and set(found.materials) == {"air", "sand", "wall", "water", "oil"}
    assert found.materials["wall"] == ([], None)
    assert all(found.materials[name].joint.outside == 0 for name in ("air", "water", "oil"))
    assert min(values := p_values(found)) > 1e-4 / len(values)


def test_one_chance_a_twentieth_off_does_not_agree(monkeypatch):
    monkeypatch.setattr(rule_trials.PictureRule, "__init__", read_a_little_off)
    rule_trials.pictures_of.cache_clear()
    assert min(p_values(TRIAL.run(RUNS))) < 1e-9
    rule_trials.pictures_of.cache_clear()


def read_a_little_off(rule, path, chances=None, read=PictureRule.__init__):
    read(rule, path, chances)
    for each in rule.materials.values():
        if each["name"] == "water":
            each["sink"] *= 0.95


def test_forms_of_a_material_are_counted_as_it():
    assert told_materials(PictureRule(asset("rules", "rolling-sand.toml"))) == {
        "air": ["."],
        "sand": ["o", "r"],
        "wall": ["#"],
    }


def test_the_moment_is_that_of_the_most_uncertainty_with_few_enough_states():
    chain = PictureChain(
        LATTICES["water-and-oil"]["all three"], PictureRule(asset("rules", "water-and-oil.toml")), ((0, 0), (1, 1))
    )
    iterations, now = most_uncertain(chain)
    entropies = [-(each.chances * np.log(each.chances)).sum() for each in chain.distributions(rule_trials.LAST, 10**6)]
    assert entropies[iterations - 1] == max(entropies) == pytest.approx(-(now.chances * np.log(now.chances)).sum())


@pytest.mark.parametrize("everything", [False, True])
def test_every_rule_lattice_schedule_and_choice_of_chances_is_tried(everything):
    planned = trials(everything)
    assert {(each.rule, each.lattice) for each in planned} == {
        (rule, name) for rule in LATTICES for name in LATTICES[rule]
    }
    assert set(LATTICES) == set(rule_names()) - {"sand"}, "which has lattices of its own"
    for rule in LATTICES:
        here = [each for each in planned if each.rule == rule]
        assert {each.schedule for each in here} == set(rule_trials.SCHEDULES)
        assert {each.chances for each in here} == set(rule_trials.CHANCES)
    assert len({each.number for each in planned}) == len(planned)
