"""Trials: copies are the lattice they copy, and an ensemble is told from one whose rule is a little off."""

from dataclasses import replace
from math import exp, factorial

import numpy as np
import pytest

from game import Rule, World, advance
from game.study.exact.chi_square import FEWEST, compare, poisson_p_value, smallest_of
from game.study.exact.lattices import LATTICES
from game.study.exact.tiled_worlds import sand_and_walls, stacked_states, tiled_states
from game.study.exact.trials import PATHS, PROBABILITIES, SCHEDULES, Trial, chain_of, most_uncertain, trials
from tests.sweeps import sweep

RUNS = 3000


def state_of(cells):
    return sum(1 << int(place) for place in np.flatnonzero(cells))


@sweep("name", LATTICES, keep=["neck of two cells", "checkerboard"])
@sweep("schedule", SCHEDULES, keep=["balanced"])
def test_certain_copies_in_stacks_are_the_lattice_by_itself(name, schedule):
    sand, walls = sand_and_walls(LATTICES[name])
    for iterations in (0, 1, 6):
        world = World.from_cells(sand, walls)
        advance(world, Rule(schedule=schedule), iterations)
        states = stacked_states(LATTICES[name], Rule(schedule=schedule), iterations, RUNS, 1)
        assert len(states) == RUNS and (states == state_of(world.sand)).all()


@sweep("name", LATTICES, keep=["neck of two cells", "checkerboard", "walls in every role"])
@sweep("schedule", SCHEDULES, keep=["balanced"])
def test_certain_copies_side_by_side_are_the_lattice_by_itself(name, schedule):
    sand, walls = (
        np.pad(cells, 2, constant_values=solid)
        for cells, solid in zip(sand_and_walls(LATTICES[name]), (False, True), strict=True)
    )
    for iterations in (0, 1, 6):
        world = World.from_cells(sand, walls)
        advance(world, Rule(schedule=schedule), iterations)
        states = tiled_states(LATTICES[name], Rule(schedule=schedule), iterations, RUNS, 1)
        assert len(states) == RUNS and (states == state_of(world.sand[2:-2, 2:-2])).all()


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize("probabilities", ["p = 0.25", "seven different"])
def test_an_ensemble_agrees_with_the_chain(path, probabilities):
    found = Trial("walls in every role", "paper", probabilities, path, 1).run(50_000).agreement
    assert found.outside == 0 and found.degrees > 3
    assert found.p_value > 1e-4 and min(found.cells) > 1e-4 / len(found.cells)


@pytest.mark.parametrize("path", PATHS)
def test_p_one_percent_off_does_not_agree(path):
    trial = Trial("tower", "balanced", "p = 0.5", path, 2)
    chain = trial.chain
    moment, chances = most_uncertain(chain, PROBABILITIES["p = 0.5"])
    rule = Rule.with_p(0.505, "balanced")
    states = PATHS[path].states(LATTICES["tower"], rule, moment, 200_000, 3)
    assert compare(states, chain, chances, 42).p_value < 1e-6


def test_a_run_out_of_the_chains_reach_is_seen():
    chain = chain_of("tower", "paper")
    chances = np.zeros(len(chain.states))
    chances[0] = 1.0
    found = compare(np.array([*[chain.states[0]] * 30, 1, 2], np.uint64), chain, chances, 42)
    assert found.outside == 2 and found.degrees == 0 and min(found.cells) == 0.0


def test_chi_square_of_right_chances_is_uniform_and_counts_rare_states_together():
    chain = chain_of("twin towers", "paper")
    _, chances = most_uncertain(chain, PROBABILITIES["p = 0.5"])
    generator = np.random.default_rng(7)
    found = [compare(generator.choice(chain.states, 2000, p=chances), chain, chances, 30) for _ in range(200)]
    assert abs(np.mean([each.p_value for each in found]) - 0.5) < 5 * (1 / 12 / len(found)) ** 0.5
    assert all(each.rare_expected < FEWEST for each in found)
    assert sum(each.rare for each in found) == pytest.approx(sum(each.rare_expected for each in found), abs=300)


@pytest.mark.parametrize(("count", "mean"), [(0, 3.0), (1, 3.0), (3, 3.0), (9, 3.0), (40, 20.0)])
def test_the_p_value_of_a_count_is_a_sum_of_poissons_terms(count, mean):
    terms = [exp(-mean) * mean**k / factorial(k) for k in range(100)]
    expected = min(1.0, 2 * min(sum(terms[count:]), sum(terms[: count + 1])))
    assert poisson_p_value(count, mean) == pytest.approx(expected, rel=1e-9)


def test_what_cannot_happen_has_p_value_zero():
    assert poisson_p_value(0, 0.0) == 1.0 and poisson_p_value(1, 0.0) == 0.0


def test_the_smallest_of_many_p_values_is_often_small():
    assert smallest_of([0.5]) == pytest.approx(0.5)
    assert smallest_of([0.01] + [1.0] * 99) == pytest.approx(1 - 0.99**100)
    assert smallest_of([0.0, 0.3]) == 0.0 and smallest_of([1.0, 1.0]) == 1.0


@pytest.mark.parametrize("everything", [False, True])
def test_every_lattice_schedule_rule_and_path_is_tried(everything):
    planned = trials(everything)
    for field, names in (
        ("lattice", LATTICES),
        ("schedule", SCHEDULES),
        ("probabilities", PROBABILITIES),
        ("path", PATHS),
    ):
        assert {getattr(trial, field) for trial in planned} == set(names)
    assert (
        len({trial.number for trial in planned}) == len({replace(trial, number=0) for trial in planned}) == len(planned)
    )
