"""Sweeps: a law repeated over more scenes, rules, sizes, builds or examples than a quick run needs."""

import pytest


def sweep(names, cases, keep=()):
    """Return what runs a test with every case: with those in `keep` always, with all others in a sweep alone."""
    several = not isinstance(names, str)
    return pytest.mark.parametrize(names, swept(cases, keep, several))


def swept(cases, keep=(), several=False):
    """Return the cases, all but those in `keep` marked as a sweep; `several`: each is a tuple of arguments."""
    cases = list(cases)
    assert all(each in cases for each in keep), f"wanted some of {cases} to keep, found {keep}"
    return [
        case if case in keep else pytest.param(*(case if several else [case]), marks=pytest.mark.sweep)
        for case in cases
    ]
