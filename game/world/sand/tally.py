"""Tallies: numbers of grains of each colour, tuples of eight."""

from operator import add

NONE = (0,) * 8


def added(one, other):
    """Return the sum of two tallies."""
    return tuple(map(add, one, other))


def split(change):
    """Return the tallies of the grains that came and of those that went."""
    return tuple(max(each, 0) for each in change), tuple(max(-each, 0) for each in change)
