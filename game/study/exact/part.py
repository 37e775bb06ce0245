"""Part 1, exact: ensembles of the kernels against the Markov chain of the rule; and the random bits beneath them."""

import os
from concurrent.futures import ThreadPoolExecutor

from scipy.stats import kstest

from game.study.exact import randomness, rules
from game.study.exact.chi_square import smallest_of
from game.study.exact.lattices import LATTICES
from game.study.exact.markov_chain import SCHEDULES
from game.study.exact.trials import PATHS, PROBABILITIES, trials
from game.study.report import report
from game.study.report.drawing import figure
from game.study.report.report import Picture
from game.study.report.table import Table

TITLE = "1. Exact"
QUICK_RUNS = 100_000
CHAIN = "exact Markov chain"
ABOUT = (
    "The chance of every state that a small lattice can reach is worked out block by block. Ensembles that go through "
    "the kernels are compared with it at the iteration at which the outcome is least certain. The smallest of many "
    "p-values is given as the chance that any of so many would be as small."
)
WORST = 5  # ensembles listed


def run(study):
    """Yield the rows of this part."""
    planned = trials(not study.quick)
    reach = {each.chain_name: len(each.chain.states) for each in study.track(planned, "chains")}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        work = pool.map(lambda trial: trial.run(study.either(QUICK_RUNS, PATHS[trial.path].runs)), planned)
        outcomes = list(study.track(work, "ensembles against the chains", len(planned)))
    yield ABOUT
    yield _lattices(reach)
    for name in PATHS:
        yield from _path_rows(name, outcomes)
    p_values = _p_values(outcomes)
    quantity = f"evenness of all {len(p_values)} p-values of chi-square (Kolmogorov-Smirnov)"
    yield report.likely(quantity, kstest(p_values, "uniform").pvalue, CHAIN)
    for name in PROBABILITIES:
        yield from _rule_rows(name, [each for each in outcomes if each.trial.probabilities == name])
    yield _least_likely(outcomes)
    yield Picture("exact-p-values", _drawing(outcomes), "p-values of all ensembles, in order; right is on the line.")
    yield from rules.run(study)
    yield from randomness.run(study)


def _uncertain(outcomes):
    """Return the outcomes that chance had a part in."""
    return [each for each in outcomes if each.agreement.degrees]


def _p_values(outcomes):
    """Return the p-values of chi-square."""
    return [each.agreement.p_value for each in _uncertain(outcomes)]


def _lattices(reach):
    """Return a table of the lattices; reach: the number of states by (lattice, schedule, set in walls)."""
    rows = []
    for name, drawing in LATTICES.items():
        cells = "".join(drawing)
        states = (reach.get((name, schedule, False), "") for schedule in SCHEDULES)
        rows.append((name, len(cells), cells.count("o"), *states))
    heads = ("lattice", "cells", "grains", *(f"states, {schedule}" for schedule in SCHEDULES))
    return Table.of("The lattices, and how many states each can reach.", heads, rows)


def _path_rows(name, outcomes):
    """Yield the rows on one path through the kernels."""
    words, outcomes = PATHS[name].words, [each for each in outcomes if each.trial.path == name]
    runs, outside = (sum(getattr(each.agreement, field) for each in outcomes) for field in ("runs", "outside"))
    p_values = _p_values(outcomes)
    cells = [p for each in outcomes for p in each.agreement.cells]
    quantity = f"{words}: runs out of the chain's reach, of {runs:,} in {len(outcomes)} ensembles"
    yield report.same(quantity, outside, 0, CHAIN)
    yield report.likely(f"{words}: smallest p-value of chi-square, of {len(p_values)}", smallest_of(p_values), CHAIN)
    yield report.likely(f"{words}: smallest p-value of a cell, of {len(cells):,}", smallest_of(cells), CHAIN)


def _rule_rows(name, outcomes):
    """Yield chi-square per degree of freedom for one rule, how many runs went a rare way, or that none had a choice."""
    agreements = [each.agreement for each in outcomes]
    degrees = sum(each.degrees for each in agreements)
    if degrees:
        chi_square = sum(each.chi_square for each in agreements)
        error = (2 / degrees) ** 0.5
        yield report.close(f"{name}: chi-square per degree of freedom", chi_square / degrees, error, 1.0, CHAIN)
    rare = sum(each.rare_expected for each in agreements)
    if rare:
        seen = sum(each.rare for each in agreements)
        yield report.close(f"{name}: runs in the rarest states", seen, rare**0.5, rare, CHAIN)
    if not degrees and not rare:
        runs, outside = (sum(getattr(each, field) for each in agreements) for field in ("runs", "outside"))
        yield report.same(f"{name}: runs in the one state possible", runs - outside, runs, CHAIN)


def _least_likely(outcomes):
    rows = []
    for trial, iterations, found in sorted(_uncertain(outcomes), key=lambda each: each.agreement.p_value)[:WORST]:
        names = trial.path, trial.lattice, trial.schedule, trial.probabilities
        rows.append((*names, iterations, found.chi_square, found.degrees, found.p_value))
    heads = ("path", "lattice", "schedule", "rule", "iterations", "chi-square", "degrees of freedom", "p-value")
    return Table.of("The least likely ensembles.", heads, rows)


def _drawing(outcomes):
    drawing, axes = figure(width=4.6, height=4.2)
    for name, path in PATHS.items():
        p_values = sorted(_p_values(each for each in outcomes if each.trial.path == name))
        expected = [(i + 0.5) / len(p_values) for i in range(len(p_values))]
        axes.plot(expected, p_values, ".", label=path.words, markersize=4)
    axes.plot([0, 1], [0, 1], color="#8a7f70", linewidth=1)
    axes.set(xlabel="expected", ylabel="p-value of chi-square")
    axes.legend(fontsize=7)
    return drawing
