"""Trials: an ensemble for each lattice, schedule, rule and path through the kernels, held against the chain."""

from dataclasses import dataclass
from functools import cache
from itertools import product
from typing import NamedTuple

import numpy as np

from game import Rule
from game.study.exact.chi_square import Agreement, compare
from game.study.exact.lattices import LATTICES
from game.study.exact.markov_chain import SCHEDULES, explore
from game.study.exact.tiled_worlds import sand_and_walls, stacked_states, tiled_states
from game.world.sand.ensemble import states_at
from game.world.sand.world import World

PROBABILITIES = {  # topple_left, topple_right and the five falls
    "p = 0.25": (0.25,) * 2 + (1.0,) * 5,
    "p = 0.5": (0.5,) * 2 + (1.0,) * 5,
    "p = 0.75": (0.75,) * 2 + (1.0,) * 5,
    "p = 1": (1.0,) * 7,
    "p = 0.03": (0.03,) * 2 + (1.0,) * 5,
    "p = 1 − 2⁻²⁰": (1 - 2.0**-20,) * 2 + (1.0,) * 5,
    "p = 0.618… (golden ratio)": ((5**0.5 - 1) / 2,) * 2 + (1.0,) * 5,
    "seven different": (0.35, 0.8, 0.9, 0.55, 0.15, 0.7, 0.45),
}
STRIDE = 17  # a quick study takes every so many combinations: no lattice is passed over, nor does any name come in step
LAST = 40  # iterations within which a moment is chosen


def _replica_states(rows, rule, iterations, runs, seed):
    return states_at(World.from_cells(*sand_and_walls(rows), seed), rule, [iterations], runs)[0]


@dataclass(frozen=True)
class KernelPath:
    """A way through the kernels from a lattice to the states of an ensemble."""

    words: str
    states: object  # (rows, rule, iterations, runs, seed) -> (runs,) uint64
    runs: int  # in a full study


PATHS = {
    "replicas": KernelPath("ensemble kernel", _replica_states, 10**6),
    "tiled": KernelPath("kernel of the toy, copies side by side in wide worlds", tiled_states, 10**6),
    "stacked": KernelPath("kernel of the toy, copies in single stacks", stacked_states, 250_000),
}


@dataclass(frozen=True)
class Trial:
    """One ensemble to run: names of a lattice, a schedule, probabilities and a path, and its number."""

    lattice: str
    schedule: str
    probabilities: str
    path: str
    number: int  # seeds the ensemble

    @property
    def chain_name(self):
        """What `chain_of` takes for the chain that the ensemble is held against."""
        return self.lattice, self.schedule

    @property
    def chain(self):
        """The chain that the ensemble is held against."""
        return chain_of(*self.chain_name)

    def run(self, runs):
        """Run the ensemble and return its TrialResult at the moment of most uncertainty."""
        rule = Rule(*PROBABILITIES[self.probabilities], schedule=self.schedule)
        rows = LATTICES[self.lattice]
        iterations, chances = most_uncertain(self.chain, rule.probabilities)
        states = PATHS[self.path].states(rows, rule, iterations, runs, self.number << 32)
        return TrialResult(self, iterations, compare(states, self.chain, chances, len(rows) * len(rows[0])))


class TrialResult(NamedTuple):
    """What became of a trial."""

    trial: Trial
    iterations: int  # after which they were compared
    agreement: Agreement


def trials(everything):
    """Return the list of Trials: every combination, or a few in which each name occurs."""
    combinations = list(product(LATTICES, SCHEDULES, PROBABILITIES))[:: 1 if everything else STRIDE]
    numbered = enumerate(product(combinations, PATHS))
    return [Trial(*names, path, number) for number, (names, path) in numbered]


@cache
def chain_of(lattice, schedule):
    """Return the chain of a named lattice and schedule."""
    return explore(LATTICES[lattice], SCHEDULES[schedule])


def most_uncertain(chain, probabilities):
    """Return (iterations, distribution) where the distribution's entropy is largest, among the first LAST."""
    found = list(chain.distributions(probabilities, LAST))
    entropies = [-(each[each > 0] * np.log(each[each > 0])).sum() for each in found]
    moment = int(np.argmax(entropies))
    return moment + 1, found[moment]
