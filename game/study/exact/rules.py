"""Part 1, rules: ensembles of the rules of several materials against the Markov chain of their pictures."""

import os
from concurrent.futures import ThreadPoolExecutor

from game.study.exact.chi_square import smallest_of
from game.study.exact.rule_lattices import LATTICES
from game.study.exact.rule_trials import trials
from game.study.report import report
from game.study.report.table import Table

RUNS, QUICK_RUNS = 10**6, 100_000
PICTURES = "exact Markov chain of the rule file's pictures"
ABOUT = (
    "The same for rules of several materials, with the chances of the file and with others. The chain reads the "
    "pictures by itself, block by block. Compared are the density of every material in every cell, and over all runs "
    "where a material lies, cells together."
)


def run(study):
    """Yield the rows on each rule."""
    planned, runs = trials(not study.quick), study.either(QUICK_RUNS, RUNS)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        work = pool.map(lambda trial: trial.run(runs), planned)
        outcomes = list(study.track(work, "rules against their pictures", len(planned)))
    yield ABOUT
    yield _lattices(outcomes)
    for name in LATTICES:
        yield from _rows(name, [each for each in outcomes if each.trial.rule == name], runs)


def _lattices(outcomes):
    """Return a table of the lattices of each rule, and what they show."""
    rows = []
    for rule, drawn in LATTICES.items():
        for lattice, drawing in drawn.items():
            here = [each for each in outcomes if (each.trial.rule, each.trial.lattice) == (rule, lattice)]
            states, events = max(each.states for each in here), set().union(*(each.claimed for each in here))
            rows.append((rule, lattice, sum(map(len, drawing)), len(here), states, len(events)))
    heads = ("rule", "lattice", "cells", "ensembles", "states, at most", "events that come up")
    return Table.of("The lattices of each rule.", heads, rows)


def _rows(name, outcomes, runs):
    """Yield the rows on one rule."""
    held = [each for outcome in outcomes for each in outcome.materials.values()]
    joint = [each.joint for each in held if each.joint]
    outside, where = sum(each.outside for each in joint), f"{len(outcomes)} ensembles of {runs:,} runs"
    yield report.same(f"{name}: runs with a material where no picture puts it, in {where}", outside, 0, PICTURES)
    cells = [p for each in held for p in each.cells]
    yield report.likely(f"{name}: smallest p-value of a density, of {len(cells):,}", smallest_of(cells), PICTURES)
    uncertain = [each for each in joint if each.degrees]
    values = [each.p_value for each in uncertain]
    yield report.likely(f"{name}: smallest p-value of chi-square, of {len(values)}", smallest_of(values), PICTURES)
    degrees = sum(each.degrees for each in uncertain)
    chi_square = sum(each.chi_square for each in uncertain) / degrees
    yield report.close(f"{name}: chi-square per degree of freedom", chi_square, (2 / degrees) ** 0.5, 1.0, PICTURES)
    seen = set().union(*(each.claimed for each in outcomes))
    yield report.noted(f"{name}: events of its pictures that these lattices come to", len(seen))
