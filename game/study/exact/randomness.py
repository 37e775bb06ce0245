"""Part 1, randomness: the bits beneath the probabilities are uncorrelated, and no probability is bent."""

from itertools import combinations

import numpy as np

from game import Rule
from game.core.chance import CERTAIN, threshold
from game.study.exact.chi_square import poisson_p_value, smallest_of
from game.study.exact.topple_fields import (
    count_standing,
    count_toppled,
    count_toppled_replicas,
    field,
    fractions,
    posts,
    toppled,
)
from game.study.report import report
from game.world.sand.ensemble import states_at
from game.world.sand.world import World

SEED = 20
LATERS = 1, 2, 4, 2**32, 2**63  # iterations between two draws at the same place
FAIR = "independent fair bits"
BINOMIAL = "binomial distribution"


def run(study):
    """Yield the rows on random bits, then those on probabilities."""
    yield from _bits(study)
    yield from _replica_bits(study.either(10**5, 10**6))
    yield from _probabilities(study)
    yield from _replica_probabilities(study.either(10**4, 10**5))
    yield _thresholds()


def _correlation(first, second):
    """Return (correlation, its standard error if there is none) of two bool arrays."""
    return float(np.corrcoef(first.ravel(), second.ravel())[0, 1]), first.size**-0.5


def _row(words, first, second):
    return report.close(f"correlation of random bits: {words}", *_correlation(first, second), 0.0, FAIR)


def _bits(study):
    start = field()
    here = toppled(start, 0.5, SEED, 0)
    words = start.layout.words
    yield _row("block and its right-hand neighbour", here[:, 1:], here[:, :-1])
    yield _row("block and the one below", here[1:], here[:-1])
    yield _row("neighbouring bits of a word", here[:, words:], here[:, :-words])
    for later in LATERS:
        yield _row(f"same block, {later:,} iterations later", here, toppled(start, 0.5, SEED, later))
    for seed in (SEED + 1, SEED + 2**63):
        yield _row(f"same block, seeds {seed - SEED:,} apart", here, toppled(start, 0.5, seed, 0))
    digits = study.either(3, 4)
    number = fractions(start, digits, SEED, 0)
    draws = [number >> digit & 1 == 1 for digit in reversed(range(digits))]
    for (i, first), (j, second) in combinations(enumerate(draws, 1), 2):
        yield _row(f"draws {i} and {j} of a block", first, second)
        yield _row(f"draw {i} of a block, draw {j} of the next", first[:, 1:], second[:, :-1])


def _replica_bits(runs):
    blocks = 15
    sand = np.zeros((2, 2 * blocks), bool)
    sand[:, 0::2] = True
    states = states_at(World.from_cells(sand, np.zeros_like(sand), SEED), Rule.with_p(0.5), [1], runs)[0]
    lands = np.arange(2 * blocks + 1, 4 * blocks, 2, dtype=np.uint64)  # bits of the cells the grains topple to
    here = (states[:, None] >> lands) & np.uint64(1) == 1
    yield _row("ensemble, runs side by side", here[1:], here[:-1])
    yield _row("ensemble, runs a word apart", here[64:], here[:-64])
    yield _row("ensemble, block and its right-hand neighbour", here[:, 1:], here[:, :-1])


def _probabilities(study):
    """Yield rows on p = 2**-k and 1 - 2**-k: how often the rare thing happens."""
    start = posts()
    exponents = study.either((1, 4, 8, 16, 20, 24, 28, 32), tuple(range(1, 33)))
    for words, count, sign in (("2^−k", count_toppled, 1), ("1 − 2^−k", count_standing, -1)):
        p_values = []
        for k in study.track(exponents, f"p = {words}"):
            p = 2.0**-k if sign > 0 else 1.0 - 2.0**-k
            trials = study.either(10**8, 10**9 if k < 30 else 2 * 10**10)
            seen, expected, trials = count(start, p, trials, SEED + k)
            p_values.append(poisson_p_value(seen, expected))
            if k in (8, 16, 24, 32):
                error = max(expected, 1.0) ** 0.5
                quantity = f"p = {words.replace('k', str(k))}: rare outcomes in {trials:,} trials"
                yield report.close(quantity, seen, error, expected, BINOMIAL)
        quantity = f"p = {words}, k = {exponents[0]} … {exponents[-1]}: smallest p-value of {len(exponents)}"
        yield report.likely(quantity, smallest_of(p_values), BINOMIAL)


def _replica_probabilities(runs):
    """Yield rows on p = 2**-k in replicas, of which whole groups have nothing happen in them at a time."""
    for k in (8, 16, 20):
        seen, expected, trials = count_toppled_replicas(2.0**-k, runs, 100, SEED + k)
        quantity = f"p = 2^−{k}: rare outcomes in {trials:,} trials of an ensemble"
        yield report.close(quantity, seen, max(expected, 1.0) ** 0.5, expected, BINOMIAL)


def _thresholds():
    generator = np.random.default_rng(SEED)
    p = np.concatenate([generator.random(10**4), generator.random(10**4) * 2.0**-20, 2.0 ** -np.arange(1, 33)])
    furthest = max(abs(threshold(each) / CERTAIN - each) for each in np.concatenate([p, 1.0 - p]))
    source = "by construction: rounded to the nearest 2⁻³²"
    return report.within("largest error of a probability, in units of 2⁻³²", furthest * CERTAIN, None, 0.0, 0.5, source)
