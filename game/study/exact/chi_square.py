"""Comparison of an ensemble with the chain: state by state and cell by cell."""

from dataclasses import dataclass

import numpy as np

from game.study.likelihood import chi_square_tail, normal_tails, poisson_tails

FEWEST = 10  # runs expected in a state that stands for itself in chi-square; rarer states are put together
MANY = 1000  # variance of a count from which it is taken as normal; below, its rarer side is a Poisson count


@dataclass(frozen=True)
class Comparison:
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
    p_value = chi_square_tail(chi_square, degrees) if degrees else 1.0
    places = (chain.states[:, None] >> np.arange(cells, dtype=np.uint64)) & np.uint64(1)
    found = [_cell(*each, runs) for each in zip(counts @ places.astype(int), chances @ places, strict=True)]
    return Comparison(
        runs, outside, chi_square, degrees, p_value, rest, rest_expected, [p for p in found if p is not None]
    )


def _count(states, known):
    """Return (how many of `states` are each of the known ones, how many are none of them)."""
    order = np.argsort(known)
    index = np.minimum(np.searchsorted(known[order], states), len(known) - 1)
    right = known[order][index] == states
    counts = np.zeros(len(known), int)
    counts[order] = np.bincount(index[right], minlength=len(known))
    return counts, int((~right).sum())


def _cell(count, density, runs):
    """Return the p-value of a cell's count, or None where the chain leaves it no choice and it is right."""
    if density > 0.5:
        count, density = runs - count, 1.0 - density
    mean = runs * density
    if mean < 1e-6:  # what the chain's own rounding could make of 0
        return None if count == 0 else 0.0
    variance = mean * (1.0 - density)
    if variance < MANY:
        return poisson_tails(count, mean)
    return normal_tails((count - mean) / np.sqrt(variance))
