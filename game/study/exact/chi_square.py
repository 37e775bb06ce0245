"""How well an ensemble agrees with the chain: state by state and cell by cell."""

from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2, combine_pvalues, norm, poisson

FEWEST = 10  # runs expected in a state that stands for itself in chi-square; rarer states are put together
MANY = 1000  # variance of a count from which it is taken as normal; below, its rarer side is a Poisson count
CERTAIN = 1e-6  # expected runs that rounding in the chain could make of none


@dataclass(frozen=True)
class Agreement:
    """How an ensemble and the chain agree at one moment."""

    runs: int
    outside: int  # runs in states that the chain says cannot be
    chi_square: float
    degrees: int  # of freedom; 0 where all runs are expected in one state
    p_value: float  # of chi-square
    rare: int  # runs in states too rare for chi-square even together
    rare_expected: float
    cells: list  # p-value of each cell's count, where it is not certain


def compare(states, chain, chances, cells):
    """Compare the (runs,) uint64 states of an ensemble with the chain's distribution `chances` over chain.states.

    cells: the number of cells of the lattice.
    """
    counts, unknown = _count(states, chain.states)
    outside = unknown + int(counts[chances == 0.0].sum())
    runs = len(states)
    expected = runs * chances
    common = expected >= FEWEST
    seen, wanted = counts[common], expected[common]
    rest, rest_expected = int(counts[~common].sum()), float(expected[~common].sum())
    if rest_expected >= FEWEST:
        seen, wanted = np.append(seen, rest), np.append(wanted, rest_expected)
        rest, rest_expected = 0, 0.0
    degrees = max(len(seen) - 1, 0)
    chi_square = float(((seen - wanted) ** 2 / wanted).sum()) if degrees else 0.0
    p_value = float(chi2.sf(chi_square, degrees)) if degrees else 1.0
    places = (chain.states[:, None] >> np.arange(cells, dtype=np.uint64)) & np.uint64(1)
    cell_values = cell_p_values(counts @ places.astype(int), chances @ places, runs)
    return Agreement(runs, outside, chi_square, degrees, p_value, rest, rest_expected, cell_values)


def _count(states, known):
    """Return (how many of `states` are each of the known ones, how many are none of them)."""
    order = np.argsort(known)
    index = np.minimum(np.searchsorted(known[order], states), len(known) - 1)
    right = known[order][index] == states
    counts = np.zeros(len(known), int)
    counts[order] = np.bincount(index[right], minlength=len(known))
    return counts, int((~right).sum())


def cell_p_values(counts, densities, runs):
    """Return the p-values of the counts of cells, without those where the chain leaves no choice and they are right."""
    full = densities > 0.5
    counts, densities = np.where(full, runs - counts, counts), np.where(full, 1.0 - densities, densities)
    means = runs * densities
    variances = means * (1.0 - densities)
    deviations = (counts - means) / np.sqrt(np.maximum(variances, MANY))
    p_values = np.where(variances < MANY, poisson_p_value(counts, means), 2 * norm.sf(abs(deviations)))
    certain = means < CERTAIN
    p_values[certain] = 0.0
    return p_values[~certain | (counts > 0)].tolist()


def poisson_p_value(count, mean):
    """Return twice the probability of a Poisson count at least as far off `mean` on its side, at most 1."""
    return np.minimum(1.0, 2 * np.minimum(poisson.sf(count - 1, mean), poisson.cdf(count, mean)))


def smallest_of(p_values):
    """Return how likely it is that the smallest of so many independent p-values is as small as this one (Tippett)."""
    return combine_pvalues(p_values, method="tippett").pvalue
