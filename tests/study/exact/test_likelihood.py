"""Likelihood: tails of distributions, against tables and exact sums."""

from math import exp, factorial, log10

import numpy as np
import pytest

from game.study.likelihood import (
    chi_square_tail,
    gamma_tail,
    kolmogorov_tail,
    normal_tails,
    poisson_tails,
    smallest_of,
    uniform_tail,
)


@pytest.mark.parametrize(
    ("chi_square", "degrees", "tail"),
    [
        (3.841459, 1, 0.05),
        (18.307038, 10, 0.05),
        (124.342113, 100, 0.05),
        (10.827566, 1, 0.001),
        (149.449253, 100, 0.001),
    ],
)
def test_chi_square_is_as_in_the_tables(chi_square, degrees, tail):
    assert chi_square_tail(chi_square, degrees) == pytest.approx(tail, rel=1e-6)


@pytest.mark.parametrize("a", [1, 2, 7, 40, 3000])
def test_the_gamma_tail_is_a_poisson_sum(a):
    for x in (0.1 * a, 0.9 * a, a + 1.0, 1.1 * a, 1.5 * a):
        terms = np.cumsum([0.0, *np.log(x / np.arange(1, a))])
        assert gamma_tail(a, x) == pytest.approx(np.exp(terms - x).sum(), rel=1e-8, abs=1e-12)


def test_normal_tails_are_as_in_the_tables():
    assert normal_tails(-1.959964) == pytest.approx(0.05, rel=1e-6)
    assert normal_tails(4.0) == pytest.approx(6.334e-5, rel=1e-3)


@pytest.mark.parametrize(("count", "mean"), [(0, 3.0), (1, 3.0), (3, 3.0), (9, 3.0), (40, 20.0)])
def test_poisson_tails_are_sums_of_its_terms(count, mean):
    terms = [exp(-mean) * mean**k / factorial(k) for k in range(100)]
    expected = min(1.0, 2 * min(sum(terms[count:]), sum(terms[: count + 1])))
    assert poisson_tails(count, mean) == pytest.approx(expected, rel=1e-9)


def test_what_cannot_happen_has_no_likelihood():
    assert poisson_tails(0, 0.0) == 1.0 and poisson_tails(1, 0.0) == 0.0


def test_the_smallest_of_many_is_often_small():
    assert smallest_of([0.5]) == pytest.approx(0.5)
    assert smallest_of([0.01] + [1.0] * 99) == pytest.approx(1 - 0.99**100)
    assert smallest_of([0.0, 0.3]) == 1.0 - 1.0 and smallest_of([1.0, 1.0]) == 1.0


@pytest.mark.parametrize(("x", "tail"), [(0.1, 1.0), (0.828, 0.5), (1.224, 0.1), (1.358, 0.05), (1.628, 0.01)])
def test_kolmogorovs_statistic_is_as_in_the_tables(x, tail):
    assert kolmogorov_tail(x) == pytest.approx(tail, rel=5e-3)


def test_uniform_numbers_look_uniform_and_others_do_not():
    numbers = np.random.default_rng(1).random(1000)
    assert uniform_tail(numbers) > 0.01
    assert log10(uniform_tail(numbers**1.5)) < -4
    assert uniform_tail(0.25 + numbers / 2) < 1e-4
