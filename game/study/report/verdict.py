"""Verdicts: each function compares a measurement with what was expected, in its own way, and returns the Row."""

from dataclasses import replace
from math import hypot, isfinite

from game.study.report.report import AGREES, DIFFERS, DISAGREES, NOTED, Row

SIGMAS = 4.0  # standard errors between measured and expected that still agree: 1 in 16,000 comparisons is further off
UNLIKELY = 1e-4  # a p-value below this disagrees, its looks already counted: about as far off as SIGMAS


def _row(quantity, measured, error, expected, source, holds):
    return Row(quantity, measured, error, expected, source, AGREES if holds else DISAGREES)


def close(quantity, measured, error, expected, source, expected_error=0.0):
    """Agree if measured and expected differ by at most SIGMAS of their standard errors, taken together."""
    apart = abs(measured - expected)
    return _row(quantity, measured, error, expected, source, apart <= SIGMAS * hypot(error, expected_error))


def same(quantity, measured, expected, source):
    """Agree if measured is exactly what was expected."""
    return _row(quantity, measured, None, expected, source, measured == expected)


def within(quantity, measured, error, low, high, source):
    """Agree if measured lies in [low, high] (either may be infinite), give or take SIGMAS standard errors, if any."""
    give = SIGMAS * (error or 0.0)
    return _row(quantity, measured, error, _range(low, high), source, low - give <= measured <= high + give)


def claimed(quantity, measured, error, low, high, source):
    """Hold a measurement against a claim about the paper's sand or real sand, which this model need not bear out.

    Agree as in `within`; a measurement outside of [low, high] differs, and that is a finding and no fault.
    """
    row = within(quantity, measured, error, low, high, source)
    return row if row.verdict == AGREES else replace(row, verdict=DIFFERS)


def likely(quantity, p_value, source):
    """Agree if a p-value, corrected for the number of looks, is not below UNLIKELY."""
    return _row(quantity, p_value, None, f"p ≥ {UNLIKELY:g}", source, p_value >= UNLIKELY)


def noted(quantity, measured, error=None, expected="", source=""):
    """Report a measurement that nothing is to be compared with, or that is only to be looked at."""
    return Row(quantity, measured, error, expected, source, NOTED)


def _range(low, high):
    if isfinite(low) and isfinite(high):
        return f"{low:g} … {high:g}"
    return f"≥ {low:g}" if isfinite(low) else f"≤ {high:g}"
