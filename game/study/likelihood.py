"""Likelihood: how often chance alone would do at least so much. Plain Python, good to some 1e-10 of the value."""

from math import erfc, exp, expm1, lgamma, log, log1p, pi, sqrt

HAIR = 1e-15  # relative size of the last term or factor taken into a sum or product
TINY = 1e-300  # keeps a continued fraction from dividing by zero


def chi_square_tail(chi_square, degrees):
    """Return the probability of a larger chi-square with so many degrees of freedom."""
    return gamma_tail(degrees / 2, chi_square / 2)


def normal_tails(deviation):
    """Return the probability of being further off than so many standard errors, to either side."""
    return erfc(abs(deviation) / sqrt(2))


def poisson_tails(count, mean):
    """Return twice the probability of a count at least as far off `mean` on its side, at most 1."""
    if mean <= 0.0:
        return 1.0 if count == 0 else 0.0
    more = 1.0 - gamma_tail(count, mean) if count else 1.0
    return min(1.0, 2 * min(more, gamma_tail(count + 1, mean)))


def gamma_tail(a, x):
    """Return the regularised upper incomplete gamma function Q(a, x), a > 0 (Press et al. 2007, section 6.2)."""
    if x <= 0.0:
        return 1.0
    scale = exp(a * log(x) - x - lgamma(a))
    return 1.0 - scale * _series(a, x) if x < a + 1.0 else scale * _fraction(a, x)


def _series(a, x):
    term = total = 1.0 / a
    while term > HAIR * total:
        a += 1.0
        term *= x / a
        total += term
    return total


def _fraction(a, x):
    """Return the continued fraction of Q(a, x), by Lentz's method."""
    b = x + 1.0 - a
    c, d = 1.0 / TINY, 1.0 / b
    total, n, factor = d, 0, 0.0
    while abs(factor - 1.0) > HAIR:
        n += 1
        b += 2.0
        d = n * (a - n) * d + b
        c = b + n * (a - n) / c
        d = 1.0 / (d if abs(d) > TINY else TINY)
        c = c if abs(c) > TINY else TINY
        factor = c * d
        total *= factor
    return total


def smallest_of(p_values):
    """Return how likely it is that the smallest of so many independent p-values is as small as this one (Šidák)."""
    smallest = min(p_values)
    return 1.0 if smallest >= 1.0 else -expm1(len(p_values) * log1p(-smallest))


def uniform_tail(p_values):
    """Return the Kolmogorov-Smirnov probability that so many uniform numbers lie as unevenly as these.

    Stephens 1970: good to 1 % from 5 numbers on.
    """
    n, ordered = len(p_values), sorted(p_values)
    distance = max(max((i + 1) / n - p, p - i / n) for i, p in enumerate(ordered))
    return kolmogorov_tail((sqrt(n) + 0.12 + 0.11 / sqrt(n)) * distance)


def kolmogorov_tail(x):
    """Return the probability that Kolmogorov's statistic exceeds x."""
    if x < 0.2:
        return 1.0  # to 1e-12
    if x < 1.0:  # the other series of the same function, which is quicker here
        return 1.0 - sqrt(2 * pi) / x * sum(exp(-((2 * k - 1) ** 2) * pi**2 / (8 * x**2)) for k in range(1, 8))
    return 2 * sum((-1) ** (k - 1) * exp(-2 * k**2 * x**2) for k in range(1, 8))
