"""The rule: how materials move and change each other, a number for each chance, and the schedule of partitions."""

from collections import defaultdict
from dataclasses import dataclass, replace
from functools import lru_cache
from types import MappingProxyType

import numpy as np

from game.core.rule_table import CERTAIN, corners, state_of
from game.world.files.paths import asset
from game.world.rules.definition import Definition, load_definition
from game.world.rules.laws import check_sums
from game.world.rules.rule_text import RuleError
from game.world.sand import parameters
from game.world.sand.material_codes import SAND_CODES
from game.world.sand.schedules import SCHEDULES

CHANCES = (
    *("topple_left", "topple_right", "fall_pair"),
    *("fall_low_left", "fall_low_right", "fall_full_left", "fall_full_right"),
)


def _load_sand():
    """Return the sand's definition; raise RuleError where its file lacks what worlds, scenes and sliders ask for."""
    sand = load_definition("sand")
    for key, found, wanted in (("materials", sand.materials, SAND_CODES.names), ("chances", sand.chances, CHANCES)):
        names = tuple(each.name for each in found)
        if names != wanted:
            raise RuleError(asset("rules", "sand.toml"), 0, key, ", ".join(names) or "none", ", ".join(wanted))
    return sand


SAND = _load_sand()
PROBABILITIES = SAND.chances  # the knobs of the sand's seven probabilities
FIELDS = (*(each.name for each in PROBABILITIES), "schedule")

_USUAL = object()  # the schedule that the rule's file names


@dataclass(frozen=True, init=False, repr=False)
class Rule:
    """How materials move and change each other. The kernels honour each probability to the nearest 2**-32.

    `load_rule` makes one of a file. Rule(topple_left=0.5, schedule="balanced") is the sand's: its seven probabilities
    in the order of PROBABILITIES or by name, 1 where none is given, and its schedule after them or by name. left and
    right are for a fall the column of the falling grain, for a topple the direction of the move. Source: Devlin &
    Schuster 2020, transitions (c)-(j).
    Each chance can be read by its name, as in `rule.topple_left`.
    Raises ValueError for a probability outside [0, 1], an unknown chance or an unknown schedule.
    """

    definition: Definition
    probabilities: tuple  # of the chances, in the order of the file
    schedule: str

    def __init__(self, *values, definition=SAND, probabilities=(), schedule=_USUAL, **named):
        if len(values) == len(definition.chances) + 1:
            *values, schedule = values
        given = dict(zip((each.name for each in definition.chances), values or probabilities, strict=False)) | named
        unknown = [name for name in given if name not in {each.name for each in definition.chances}]
        if unknown or len(values) > len(definition.chances):
            names = ", ".join(each.name for each in definition.chances) or "none"
            raise ValueError(f"chances of {definition.name} are {names}, got {', '.join(unknown) or len(values)}")
        schedule = definition.schedule if schedule is _USUAL else schedule
        if not isinstance(schedule, str) or schedule not in SCHEDULES:
            raise ValueError(f"schedule must be one of {', '.join(SCHEDULES)}, got {schedule!r}")
        numbers = tuple(each.check(given.get(each.name, each.default)) for each in definition.chances)
        for name, value in (("definition", definition), ("probabilities", numbers), ("schedule", schedule)):
            object.__setattr__(self, name, value)
        self.__dict__.update(self.chances)
        if any(len(event.chances) > 1 for event in definition.events):
            check_sums(definition, self.values)

    def __repr__(self):
        return f"Rule({self.definition.name!r}, {self.as_dict()})"

    @classmethod
    def with_p(cls, p, schedule="paper", bias=0.0):
        """Return the paper's rule: grains topple with probability p, leaning by `bias` in [-1, 1], and always fall.

        Topples go right with p·min(1, 1 + bias) and left with p·min(1, 1 - bias).
        """
        p, bias = parameters.P.check(p), parameters.BIAS.check(bias)
        return cls(topple_left=p * min(1.0, 1.0 - bias), topple_right=p * min(1.0, 1.0 + bias), schedule=schedule)

    def with_chances(self, **chances):
        """Return the rule with other probabilities for the chances named; "water.spread" is a material's own number.

        An own number is a chance of the rule as long as it is not what the file says.
        """
        told = self.definition.plain.own_numbers
        own = {name: value for name, value in {**self.chances, **chances}.items() if name in told}
        definition = self.definition.with_turned([name for name, value in own.items() if value != told[name]])
        kept = {each.name for each in definition.chances}
        values = {
            name: value for name, value in {**self.chances, **chances}.items() if name in kept or name not in told
        }
        return Rule(definition=definition, schedule=self.schedule, **values)

    def number(self, name):
        """Return the probability of a chance, or a material's own number, by name."""
        return self.chances[name] if name in self.chances else self.definition.own_numbers[name]

    def with_schedule(self, schedule):
        """Return the rule with another schedule."""
        return replace(self, schedule=schedule)

    def leaning(self, bias):
        """Return the rule with the same p whose topples lean by `bias`."""
        return self.toppling(self.p, bias)

    def toppling(self, p, bias):
        """Return the rule whose topples have p and lean by `bias`; all else is kept."""
        topples = Rule.with_p(p, bias=bias)
        return self.with_chances(topple_left=topples.topple_left, topple_right=topples.topple_right)

    @property
    def materials(self):
        """The names of the materials by code; air is 0."""
        return self.codes.names

    @property
    def codes(self):
        """The MaterialCodes of the worlds that it moves."""
        return self.definition.codes

    @property
    def chances(self):
        """The probability of each chance, by name."""
        return MappingProxyType(
            dict(zip((each.name for each in self.definition.chances), self.probabilities, strict=True))
        )

    @property
    def table(self):
        """What every block state does: a RuleTable, the same object for all rules of one definition."""
        return self.definition.table

    @property
    def values(self):
        """The probability of each slot of the table."""
        return (*self.probabilities, *self.definition.slots.numbers)

    def outcomes(self, block):
        """Return what may become of a block (a, b, c, d) of codes: a list of (probability, block after).

        The likeliest comes first. That the block stays as it is is left out, and has the rest of the probability.
        """
        if len(block) != 4 or not all(code in range(len(self.materials)) for code in block):
            raise ValueError(f"a block must be four codes in [0, {len(self.materials) - 1}], got {block}")
        found = defaultdict(float)
        for _, p, after in self._changes_of(block):
            found[after] += p
        return sorted(((p, after) for after, p in found.items()), key=lambda each: (-each[0], each[1]))

    def events_of(self, block):
        """Return the names of the events that can change a block (a, b, c, d) of codes: a frozenset."""
        return frozenset(self.definition.events[number].name for number, _, _ in self._changes_of(block))

    def happening(self, block, after=None):
        """Return [(event, probability)] of what can change a block of codes, or make just one other of it, as tried.

        That of a layer is what the layers before it leave.
        """
        found = defaultdict(float)
        for number, p, becomes in self._changes_of(block):
            if after is None or becomes == after:
                found[number] += p
        events, layers = self.definition.events, self.definition.layers
        order = sorted(found, key=lambda number: (layers.index(events[number].layer), number))
        return [(events[number], found[number]) for number in order]

    def _changes_of(self, block):
        """Yield (number of the event, probability, block after) of all that can change a block, for either fair bit."""
        state = state_of(block, self.table.bits)
        for face in (0, 1):
            left = 0.5
            for claim in _claims_of(self.table, state, face):
                at, share = claim.states.searchsorted(state), left
                for outcome in claim.outcomes:
                    p = share * (1.0 if outcome.slot == CERTAIN else self.values[outcome.slot])
                    if p > 0.0 and outcome.after[at] != state:
                        yield claim.event, p, tuple(int(code) for code in corners(outcome.after[at], self.table.bits))
                    left -= p

    @property
    def offsets(self):
        """The schedule's offsets (x, y), in order."""
        return SCHEDULES[self.schedule]

    @property
    def is_sand(self):
        """Whether it is the rule of the paper's sand, whatever its chances are."""
        return self.definition.source == SAND.source

    @property
    def leans(self):
        """Whether it tells a topple to the left from one to the right, as the sand's rule does."""
        return set(CHANCES[:2]) <= set(self.chances)

    @property
    def p(self):
        """The larger topple probability: what the p slider shows."""
        return max(self.topple_left, self.topple_right)

    @property
    def bias(self):
        """The lean in [-1, 1] that, with p, gives the two topple probabilities; 0 in a rule that is not the sand's."""
        if not self.leans or self.p == 0.0:
            return 0.0
        if self.topple_right < self.topple_left:
            return self.topple_right / self.p - 1.0
        return 1.0 - self.topple_left / self.p

    def as_dict(self):
        """The chances and the schedule by name, as a scene file spells them; a rule that is not sand by its name."""
        name = {} if self.definition == SAND else {"rule": self.definition.name}
        return {**name, **self.chances, "schedule": self.schedule}


def load_rule(name_or_path):
    """Return the shipped Rule of that name, or the one in a file (a path, or a name that ends in .toml).

    Raises RuleError, with one line to show, for whatever is wrong in the file.
    """
    return Rule(definition=load_definition(name_or_path))


def _claims_of(table, state, face):
    """Yield the claim of each layer on a state, where the fair bit is `face`."""
    claims, states, numbers = _claims_by_state(table)
    first, end = states.searchsorted(state), states.searchsorted(state, "right")
    for number in numbers[first:end].tolist():
        if claims[number].face in (None, face):
            yield claims[number]


@lru_cache(maxsize=8)
def _claims_by_state(table):
    """Return the claims of all layers, every state of theirs in order, and the number of the claim that it is of."""
    claims = [claim for layer in table.layers for claim in layer]
    states = np.concatenate([claim.states for claim in claims] or [np.zeros(0, np.int64)])
    numbers = np.repeat(np.arange(len(claims)), [len(claim.states) for claim in claims])
    order = states.argsort(kind="stable")
    return claims, states[order], numbers[order]
