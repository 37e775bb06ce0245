"""Chance: each probability is honoured, and no two draws have anything to do with each other."""

import numpy as np
import pytest

from game import Rule, World, advance
from game.core.chance import threshold
from game.core.compiler.rule_pass import pass_of


def toppled(p, seed=0, iteration=0, blocks=256):
    """Return (blocks, blocks) bool: which of so many topple candidates toppled in one iteration."""
    sand = np.zeros((2 * blocks, 2 * blocks), bool)
    sand[0::2, 0::2] = sand[1::2, 0::2] = True
    world = World.from_cells(sand, np.zeros_like(sand), seed)
    world.iteration = iteration
    advance(world, Rule.with_p(p, "margolus"), 1)
    return world.sand[1::2, 1::2]


@pytest.mark.parametrize("p", [0.03, 0.25, 0.3, 0.5, 0.61803398875, 0.75, 0.97])
def test_topples_happen_with_their_probability(p):
    blocks, runs = 256, 8
    share = np.mean([toppled(p, seed).mean() for seed in range(runs)])
    standard_error = np.sqrt(p * (1 - p) / (runs * blocks * blocks))
    assert abs(share - p) < 5 * standard_error


@pytest.mark.parametrize(("p", "happens"), [(0.0, False), (-0.0, False), (5e-324, False), (1.0, True)])
def test_never_and_always_are_exact(p, happens):
    assert (toppled(p) == happens).all()


@pytest.mark.parametrize("p", [2.0**-32, 1 - 2.0**-32])
def test_the_rarest_probabilities_are_not_rounded_away(p):
    assert 0 < threshold(p) < 2**32
    rule = Rule.with_p(p)
    moving = pass_of(rule.table, rule.values)
    assert moving.chances[0] == 32


def test_a_bias_leans_the_topples_to_one_side():
    sand = np.zeros((2, 400), bool)
    sand[:, 0::4], sand[:, 3::4] = True, True  # candidates to the right and to the left, in turn
    world = World.from_cells(sand, np.zeros_like(sand))
    advance(world, Rule.with_p(1.0, bias=-1.0), 1)
    assert not world.sand[1, 1::4].any(), "to the right"
    assert world.sand[1, 2::4].all(), "to the left"


def correlation(first, second):
    return np.corrcoef(first.ravel(), second.ravel())[0, 1]


def test_neighbouring_and_successive_draws_are_uncorrelated():
    here = toppled(0.5, seed=3)
    limit = 5 / np.sqrt(here.size)
    assert abs(correlation(here[:, 1:], here[:, :-1])) < limit, "beside"
    assert abs(correlation(here[1:], here[:-1])) < limit, "above"
    assert abs(correlation(here, toppled(0.5, seed=3, iteration=2))) < limit, "later"
    assert abs(correlation(here, toppled(0.5, seed=4))) < limit, "in another history"
