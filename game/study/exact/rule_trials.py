"""Trials of any rule: an ensemble for each small lattice, schedule and choice of chances, held against its pictures."""

from dataclasses import dataclass
from functools import cache
from itertools import cycle, product
from typing import NamedTuple

import numpy as np

from game import World, density, load_rule
from game.study.exact.chi_square import Agreement, cell_p_values, compare
from game.study.exact.markov_chain import SCHEDULES
from game.study.exact.picture_chain import PictureChain
from game.study.exact.picture_rule import PictureRule
from game.study.exact.rule_lattices import LATTICES
from game.world.files.paths import asset
from game.world.sand.ensemble import states_at

LAST = 24  # iterations within which a moment is chosen …
MOST_STATES = 20_000  # … as long as the lattice has no more states within reach
GOLDEN = (5**0.5 - 1) / 2


def _as_in_the_file(chances):
    return chances


def _turned(chances):
    """Return chances between 0.1 and 0.5, no two alike: what is rare in play is seen here."""
    return {name: 0.1 + 0.4 * (number * GOLDEN % 1.0) for number, name in enumerate(chances, 1)}


CHANCES = {"as in the file": _as_in_the_file, "turned": _turned}


@dataclass(frozen=True)
class RuleTrial:
    """One ensemble to run: names of a rule, a lattice of it, a schedule and a choice of chances, and its number."""

    rule: str
    lattice: str
    schedule: str
    chances: str
    number: int  # seeds the ensemble

    def run(self, runs):
        """Run the ensemble and return its RuleTrialResult at the moment of most uncertainty."""
        pictures = pictures_of(self.rule, self.chances)
        rows = LATTICES[self.rule][self.lattice]
        chain = PictureChain(rows, pictures, SCHEDULES[self.schedule])
        iterations, now = most_uncertain(chain)
        rule = load_rule(self.rule).with_chances(**pictures.chances).with_schedule(self.schedule)
        materials = {}
        for number, (name, letters) in enumerate(told_materials(pictures).items()):
            world = _world(rows, rule, (self.number << 32) + (number << 16))
            materials[name] = _held_against(chain.seen(now, letters), world, rule, iterations, runs, name, len(letters))
        return RuleTrialResult(self, iterations, len(now.states), materials, frozenset(chain.claimed))


class Held(NamedTuple):
    """How one material lies in an ensemble, held against the chain."""

    cells: list  # p-value of the density in each cell where it is not certain
    joint: Agreement | None  # of where it lies in each run; None where that is certain, or it has several forms


class RuleTrialResult(NamedTuple):
    """What became of a trial."""

    trial: RuleTrial
    iterations: int  # after which they were compared
    states: int  # that the lattice can then be in
    materials: dict  # {name: Held}
    claimed: frozenset  # the names of the events that had a block to themselves until then


def trials(everything):
    """Return the list of RuleTrials: every combination, or each lattice once, schedules and chances in turns."""
    lattices = [(rule, lattice) for rule, drawn in LATTICES.items() for lattice in drawn]
    if everything:
        names = [(*lattice, *setting) for lattice in lattices for setting in product(SCHEDULES, CHANCES)]
    else:
        turns = zip(lattices, cycle(SCHEDULES), cycle(CHANCES), strict=False)
        names = [(*lattice, *setting) for lattice, *setting in turns]
    return [RuleTrial(*each, number) for number, each in enumerate(names)]


@cache
def pictures_of(rule, chances):
    """Return the PictureRule of a shipped rule, by name, with a choice of CHANCES."""
    path = asset("rules", f"{rule}.toml")
    return PictureRule(path, CHANCES[chances](PictureRule(path).chances))


def told_materials(pictures):
    """Return {material as the player knows it: the letters of its forms}."""
    told = {}
    for letter, each in pictures.materials.items():
        told.setdefault(each.get("form_of", each["name"]), []).append(letter)
    return told


def most_uncertain(chain):
    """Return (iterations, States) where the entropy is largest, among the first LAST with MOST_STATES at most."""
    found = enumerate(chain.distributions(LAST, MOST_STATES), 1)
    return max(found, key=lambda each: -(each[1].chances * np.log(each[1].chances)).sum())


def _world(rows, rule, seed):
    codes = {each.letter: code for code, each in enumerate(rule.definition.materials)}
    return World.from_materials(np.array([[codes[letter] for letter in row] for row in rows], np.uint8), rule, seed)


def _held_against(seen, world, rule, iterations, runs, name, forms):
    """Return how a material lies in an ensemble of a world: Held against its States."""
    places = np.arange(world.layout.height * world.layout.width, dtype=np.uint64)
    expected = seen.chances @ (seen.states[:, None] >> places & np.uint64(1))
    counts = np.rint(density(world, rule, iterations, runs, of=name).ravel() * runs).astype(int)
    cells = cell_p_values(counts, expected, runs)
    if forms > 1 or len(seen.states) == 1:
        return Held(cells, None)
    states = states_at(world, rule, [iterations], runs, of=name)[0]
    return Held(cells, compare(states, seen, seen.chances, len(places)))
