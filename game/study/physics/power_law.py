"""Power laws through measured points."""

import numpy as np

ROUNDED = 9  # decimals of a fitted exponent; what lies beyond is the rounding of the fit


def exponent_of(x, y):
    """Return (exponent, standard error) of a power law through the points."""
    (slope, _), covariance = np.polyfit(np.log(x), np.log(y), 1, cov=True)
    return round(float(slope), ROUNDED), round(float(np.sqrt(max(covariance[0, 0], 0.0))), ROUNDED)
