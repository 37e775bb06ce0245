"""From pictures to a table: what every block state does.

Arrays over all block states have the axes d, c, b, a, so that a state's place in the flat array is its number.
"""

from dataclasses import dataclass

import numpy as np

from game.core.rule_table import CERTAIN, Claim, Outcome, RuleTable
from game.world.rules.events import OwnNumber
from game.world.rules.materials import sinks
from game.world.rules.rule_text import RuleError
from game.world.sand.material_codes import WALL_NAME

_AXES = (3, 2, 1, 0)  # of the corners a b c d


@dataclass(frozen=True)
class Slots:
    """The probabilities of a table: those of the chances, and then the numbers that the file spells out."""

    names: tuple  # of the chances, and the numbers as text
    numbers: tuple  # spelt out, in the order of the names after the chances

    def index(self, chance):
        """Return the slot of the name of a chance, or of a probability."""
        if chance == 1.0:
            return CERTAIN
        return self.names.index(chance if isinstance(chance, str) else repr(chance))


def slots_of(definition):
    """Return the Slots of a definition."""
    chances = tuple(each.name for each in definition.chances)
    told = [each for event in definition.events for each in event.chances]
    told += [value for material in definition.materials for _, value in material.numbers]
    numbers = tuple(dict.fromkeys(each for each in told if isinstance(each, float) and each != 1.0))
    return Slots((*chances, *map(repr, numbers)), numbers)


def bits_of(definition):
    """Return how many bits a cell takes."""
    return max(2, (len(definition.materials) - 1).bit_length())


def compiled(definition):
    """Return the RuleTable of a definition."""
    compiler = _Compiler(definition)
    return RuleTable(
        bits=compiler.bits,
        codes=len(definition.materials),
        outside=definition.code(WALL_NAME),
        slots=compiler.slots.names,
        layers=tuple(compiler.layer(layer) for layer in definition.layers),
    )


def matches_of(definition, event):
    """Return which block states an event matches, whatever comes before it: a bool array of all of them."""
    compiler = _Compiler(definition)
    found = np.zeros((compiler.side,) * 4, bool)
    for placement in event.orders()[0]:
        found |= compiler.matches(placement, event)
    return found & compiler.used


class _Compiler:
    def __init__(self, definition):
        self.materials, self.events = definition.materials, definition.events
        self.slots, self.bits = definition.slots, bits_of(definition)
        self.side, self.wall = 2**self.bits, definition.code(WALL_NAME)
        codes = range(self.side)
        known = self.materials
        used = np.arange(self.side) < len(known)
        self.used = np.logical_and.outer(np.logical_and.outer(used, used), np.logical_and.outer(used, used))
        self.used[(self.wall,) * 4] = False  # a block wholly outside has no event
        self.sinks = np.array(
            [[max(x, y) < len(known) and sinks(known[x], known[y]) for y in codes] for x in codes], bool
        )

    def layer(self, name):
        """Return the claims of a layer."""
        free, claims = self.used.copy(), []
        for number, event in enumerate(self.events):
            if event.layer == name:
                found = self._claims(number, event, free)
                claims += found
                for each in found:
                    free.reshape(-1)[each.states] = False
        return tuple(claims)

    def _claims(self, number, event, free):
        """Return the claims of an event to states that are free: placement by placement, the first one wins."""
        known = {}
        faces = [self._first_placements(order, event, free, known) for order in event.orders()]
        drawn, mirrored = (self._results(event, *each) for each in faces)
        self._check_walls(event, faces[0][1], drawn)
        self._check_walls(event, faces[1][1], mirrored)
        same = (drawn == mirrored).all(axis=1)
        claims = []
        if not same.all():
            claims += self._grouped(number, event, faces[0], drawn, ~same, 0)
            claims += self._grouped(number, event, faces[1], mirrored, ~same, 1)
        claims += self._grouped(number, event, faces[0], drawn, same, None)  # what they hold is theirs
        return claims

    def _first_placements(self, order, event, free, known):
        """Return the states that an event claims, and which placement is the first to match each.

        known: {signs before: states that match}, added to.
        """
        left, first = free.copy(), np.full(free.shape, -1, np.int8)
        for which, placement in enumerate(order):
            if placement.before not in known:
                known[placement.before] = self.matches(placement, event)
            here = left & known[placement.before]
            first[here] = which
            left ^= here
        states = np.flatnonzero(first >= 0)
        return order, states, first.reshape(-1)[states]

    def matches(self, placement, event):
        """Return which states a placement of an event matches, an array that broadcasts to all of them."""
        corner = {sign: place for place, sign in reversed(list(enumerate(placement.before)))}
        found = np.ones((1,) * 4, bool)
        for place, sign in enumerate(placement.before):
            if sign != "?":
                codes, allowed = list(event.codes[sign]), np.zeros((self.side, self.side), bool)
                allowed[codes, codes] = True
                found = found & self._pair(allowed, corner[sign], place)
        for each in event.where:
            related = self.sinks if each.sinks else ~self.sinks
            found = found & self._pair(related, corner[each.upper], corner[each.lower])
        return found

    def _pair(self, related, first, second):
        """Return a (side, side) relation between the codes at two corners, as an array over all states."""
        shape = [1] * 4
        shape[_AXES[first]] = self.side
        if first == second:
            return related.diagonal().reshape(shape)
        shape[_AXES[second]] = self.side
        return (related if _AXES[first] < _AXES[second] else related.T).reshape(shape)

    def _results(self, event, order, states, first):
        """Return for each state the slots of its outcomes, and the blocks after: (states, 2·outcomes) int64."""
        outcomes = len(event.chances)
        results = np.zeros((len(states), 2 * outcomes), np.int64)
        cells = [states >> (self.bits * place) & (self.side - 1) for place in range(4)]
        for which, placement in enumerate(order):
            here = first == which
            if here.any():
                mine = [each[here] for each in cells]
                corner = {sign: place for place, sign in enumerate(placement.before)}
                for outcome, (chance, after) in enumerate(zip(event.chances, placement.afters, strict=True)):
                    results[here, outcome] = self._slots(chance, mine, corner)
                    results[here, outcomes + outcome] = sum(
                        self._becomes(sign, place, mine, corner, event) << (self.bits * place)
                        for place, sign in enumerate(after)
                    )
        return results

    def _slots(self, chance, cells, corner):
        """Return the slot of a chance, one number or an array of them."""
        if not isinstance(chance, OwnNumber):
            return self.slots.index(chance)
        own = [self.slots.index(each.number(chance.name)) for each in self.materials]
        return np.array(own)[cells[corner[chance.sign]]]

    @staticmethod
    def _becomes(sign, place, cells, corner, event):
        """Return the codes that a sign of the after picture puts at a corner."""
        if sign == "?":
            return cells[place]
        return cells[corner[sign]] if sign.isupper() else next(iter(event.codes[sign]))

    def _grouped(self, number, event, face, results, chosen, which):
        """Return the claims on the chosen states, one for each placement and each set of slots."""
        _, states, first = face
        claims, outcomes = [], len(event.chances)
        slots, keys = results[:, :outcomes], first.astype(np.int64)
        for column in slots.T:
            keys = keys * (len(self.slots.names) + 1) + column + 1
        for key in np.unique(keys[chosen]):
            mine = np.flatnonzero(chosen & (keys == key))
            afters = np.ascontiguousarray(results[mine, outcomes:].T.astype(np.uint16))
            each = (Outcome(int(slot), after) for slot, after in zip(slots[mine[0]], afters, strict=True))
            claims.append(Claim(number, states[mine].astype(np.uint16), tuple(each), which))
        return claims

    def _check_walls(self, event, states, results):
        """Raise RuleError where an event takes a wall away or makes one."""
        for place in range(4):
            before, after = (
                (each >> (self.bits * place)) & (self.side - 1) == self.wall for each in (states, results.T)
            )
            if (before != after[len(event.chances) :]).any():
                raise RuleError(
                    event.line,
                    0,
                    f"event {event.name!r}",
                    f"a change of {WALL_NAME}",
                    f"{WALL_NAME} to stay {WALL_NAME}",
                )
