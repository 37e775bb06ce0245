"""Part 1, exact: ensembles of the kernels against the Markov chain of the rule; and the random bits beneath them."""

import os
from concurrent.futures import ThreadPoolExecutor

from game.study import randomness, verdict
from game.study.figures import figure
from game.study.lattices import LATTICES
from game.study.likelihood import smallest_of, uniform_tail
from game.study.report import Picture, Table
from game.study.trials import PATHS, PROBABILITIES, chain_of, trials
from game.world.rule import SCHEDULES

TITLE = "1. Exact"
QUICK_RUNS = 100_000
CHAIN = "exact Markov chain"


def run(study):
    """Yield the rows of this part."""
    planned = trials(not study.quick)
    for trial in study.track(planned, "chains"):
        assert len(trial.chain.states)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        runs = [min(PATHS[trial.path].runs, study.either(QUICK_RUNS, 10**9)) for trial in planned]
        work = pool.map(lambda trial, runs: (trial, *trial.run(runs)), planned, runs)
        found = list(study.track(work, "ensembles against the chains", len(planned)))
    yield (
        "The chance of every state that a small lattice can reach is worked out block by block. Ensembles that go "
        "through the kernels are compared with it at the iteration at which the outcome is least certain. "
        "The smallest of many p-values is given as the chance that any of so many would be as small."
    )
    yield _lattices({(trial.lattice, trial.schedule) for trial in planned})
    for name, path in PATHS.items():
        yield from _path_rows(path.words, [each for each in found if each[0].path == name])
    p_values = [each.p_value for _, _, each in found if each.degrees]
    yield verdict.likely(
        f"evenness of all {len(p_values)} of chi-square (Kolmogorov-Smirnov)", uniform_tail(p_values), CHAIN
    )
    yield from _rule_rows(found)
    yield Table("The least likely ensembles.", _WORST_HEADS, _worst(found))
    yield Picture(
        "exact-p-values", _drawing(found), "p-values of all ensembles, in order; the chain is right on the line."
    )
    yield from randomness.run(study)


def _lattices(used):
    """Return a table of the lattices, with the number of states for the (lattice, schedule) pairs in `used`."""

    def states(name, schedule):
        return len(chain_of(name, schedule, False).states) if (name, schedule) in used else ""

    rows = [
        (name, sum(map(len, drawing)), "".join(drawing).count("o"), *(states(name, schedule) for schedule in SCHEDULES))
        for name, drawing in LATTICES.items()
    ]
    heads = ("lattice", "cells", "grains", *(f"states, {schedule}" for schedule in SCHEDULES))
    return Table("The lattices, and how many states each can reach.", heads, rows)


def _path_rows(words, found):
    comparisons = [comparison for _, _, comparison in found]
    p_values = [each.p_value for each in comparisons if each.degrees]
    cells = [p for each in comparisons for p in each.cells]
    total = f"{sum(each.runs for each in comparisons):,} runs in {len(comparisons)} ensembles"
    yield verdict.same(
        f"{words}: runs out of the chain's reach, of {total}", sum(c.outside for c in comparisons), 0, CHAIN
    )
    yield verdict.likely(f"{words}: smallest p-value of chi-square, of {len(p_values)}", smallest_of(p_values), CHAIN)
    yield verdict.likely(f"{words}: smallest p-value of a cell, of {len(cells):,}", smallest_of(cells), CHAIN)


def _rule_rows(found):
    """Yield chi-square per degree of freedom for each rule, and how many runs went a rare way."""
    for name in PROBABILITIES:
        comparisons = [comparison for trial, _, comparison in found if trial.probabilities == name]
        degrees = sum(each.degrees for each in comparisons)
        if degrees:
            chi_square = sum(each.chi_square for each in comparisons)
            error = (2 / degrees) ** 0.5
            yield verdict.close(f"{name}: chi-square per degree of freedom", chi_square / degrees, error, 1.0, CHAIN)
        rare = sum(each.rare_expected for each in comparisons)
        if rare:
            seen = sum(each.rare for each in comparisons)
            yield verdict.close(f"{name}: runs in the rarest states", seen, rare**0.5, rare, CHAIN)
        if name == "p = 1":
            runs = sum(each.runs for each in comparisons)
            yield verdict.same(
                f"{name}: runs in the one state possible", runs - sum(c.outside for c in comparisons), runs, CHAIN
            )


_WORST_HEADS = ("path", "lattice", "schedule", "rule", "iterations", "chi-square", "degrees of freedom", "p-value")


def _worst(found, most=5):
    judged = sorted((each for each in found if each[2].degrees), key=lambda each: each[2].p_value)
    return [
        (
            trial.path,
            trial.lattice,
            trial.schedule,
            trial.probabilities,
            iterations,
            each.chi_square,
            each.degrees,
            each.p_value,
        )
        for trial, iterations, each in judged[:most]
    ]


def _drawing(found):
    drawing, axes = figure(width=4.6, height=4.2)
    for name, path in PATHS.items():
        p_values = sorted(each.p_value for trial, _, each in found if trial.path == name and each.degrees)
        axes.plot(
            [(i + 0.5) / len(p_values) for i in range(len(p_values))], p_values, ".", label=path.words, markersize=4
        )
    axes.plot([0, 1], [0, 1], color="#8a7f70", linewidth=1)
    axes.set(xlabel="expected", ylabel="p-value of chi-square")
    axes.legend(fontsize=7)
    return drawing
