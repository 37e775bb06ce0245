"""Numbers as text: a measurement has as many digits as its standard error allows."""

from math import floor, isfinite, log10
from numbers import Integral, Real

DIGITS = 4  # significant digits of a number whose error is not known
MANY = 1e15  # floats below this are exact when they are whole


def number(value):
    """Return a number, or any other value, as text."""
    if isinstance(value, bool) or not isinstance(value, Real):
        return str(value)
    if isinstance(value, Integral) or (abs(value) < MANY and value == int(value)):
        return f"{int(value):,}"
    if 10**DIGITS <= abs(value) < MANY:
        return f"{value:,.0f}"
    return f"{value:.{DIGITS}g}"


def measurement(value, error):
    """Return 'value ± error', the error with two significant digits and the value with as many decimals."""
    if error is None:
        return number(value)
    if not (error > 0 and isfinite(error) and isfinite(value)):
        return f"{number(value)} ± {number(error)}"
    decimals = 1 - floor(log10(error))
    if not -3 <= decimals <= 8:
        return f"{value:.6g} ± {error:.2g}"
    decimals = max(decimals, 0)
    return f"{value:,.{decimals}f} ± {error:,.{decimals}f}"
