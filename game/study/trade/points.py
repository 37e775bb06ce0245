"""Points of the trade: what a setting costs, and how large an error it makes in the density map."""

from dataclasses import dataclass

import numpy as np

PERCENT = 100.0


@dataclass(frozen=True)
class Point:
    """One setting of a series."""

    series: str
    setting: str
    rms: float  # error of the density map over all cells, in percentage points of chance
    most: float  # the same in the worst cell
    misplaced: float  # grains that are, on average, somewhere else
    floor: float  # rms that chance alone would give
    cost: float  # time, as a multiple of the default's
    is_default: bool = False


def point(series, setting, density, reference, floor, cost, is_default=False):
    """Return the Point of a density map held against a reference, both (H, W) in [0, 1]."""
    error = density - reference
    rms, most = PERCENT * np.sqrt((error**2).mean()), PERCENT * abs(error).max()
    return Point(series, setting, float(rms), float(most), float(abs(error).sum() / 2), floor, cost, is_default)


def floor_of(reference, runs, reference_runs):
    """Return the rms, in percentage points, between density maps of so many runs that differ by chance alone."""
    variance = (reference * (1.0 - reference)).mean()
    return float(PERCENT * np.sqrt(variance * (1.0 / runs + 1.0 / reference_runs)))
