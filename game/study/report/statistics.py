"""Means of batches with their standard errors, and the shape of a pile in a density map."""

from dataclasses import dataclass

import numpy as np

CONTOUR = 0.5  # density at the edge of a pile


@dataclass(frozen=True)
class Sample:
    """Means of several quantities over batches, and their standard errors."""

    mean: np.ndarray
    error: np.ndarray

    @classmethod
    def of(cls, batches):
        """Return the Sample of (batches, quantities) numbers."""
        batches = np.asarray(batches, float)
        return cls(batches.mean(axis=0), batches.std(axis=0, ddof=1) / np.sqrt(len(batches)))

    def minus(self, other):
        """Return (differences of the means, their standard errors)."""
        return self.mean - other.mean, np.hypot(self.error, other.error)


def shape_of(density, walls):
    """Return (height, width, mean height, spread) in cells of the pile in the lower half of an (H, W) density map.

    height, width: of the contour, on the axis and along the ground. mean height: of the sand above the ground. spread:
    standard deviation of the sand's columns.
    """
    height, width = density.shape
    lower = density[height // 2 + 1 :][::-1]  # from the ground up, without the neck
    ground = int(np.argmin(walls[::-1, width // 2]))  # rows of walls under the pile
    lower = lower[ground:]
    y, x = np.mgrid[: lower.shape[0], :width]
    columns = np.average(x, weights=lower)
    spread = np.sqrt(np.average((x - columns) ** 2, weights=lower))
    across = lower[0]
    middle = round(columns)
    reach = _crossing(across[middle:]) + _crossing(across[middle::-1])
    return _crossing(lower[:, middle]) + 0.5, reach, np.average(y + 0.5, weights=lower), spread


def _crossing(profile):
    """Return how far from its first cell's centre a profile falls below CONTOUR, between the centres of two cells."""
    below = np.flatnonzero(profile < CONTOUR)
    if not len(below):
        return float(len(profile))
    if below[0] == 0:
        return 0.0
    outer = below[0]
    return outer - 1 + (profile[outer - 1] - CONTOUR) / (profile[outer - 1] - profile[outer])
