"""Repetitions of a law over more scenes, rules or builds than a quick run needs: `pytest -m sweep` runs them."""

import pytest


def sweep(cases, keep=()):
    """Return cases to parametrise a test with: those in `keep` are always run, all others in a sweep alone."""
    cases = list(cases)
    assert set(keep) <= set(cases), f"found {set(keep) - set(cases)} to keep, wanted cases"
    return [case if case in keep else _swept(case) for case in cases]


def _swept(case):
    return pytest.param(*(case if isinstance(case, tuple) else (case,)), marks=pytest.mark.sweep)
