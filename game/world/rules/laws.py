"""Laws: what holds in every block state that there is."""

import math
from dataclasses import dataclass

import numpy as np

from game.core.rule_table import CERTAIN, corners, state_of
from game.world.rules.block_states import matches_of
from game.world.rules.materials import sinks
from game.world.rules.rule_text import RuleError
from game.world.sand.material_codes import WALL_NAME


@dataclass(frozen=True)
class Law:
    """A law and whether the rule keeps it; `found` says in words what was found."""

    name: str
    holds: bool
    found: str


class Changes:
    """All that can happen in any block state, as arrays of one length: before, after, event, layer and probability.

    The probability is that of the outcome where its claim has its turn, halved where a fair bit decides.
    """

    def __init__(self, definition, values):
        table = definition.table
        rows = [
            (claim.states, outcome.after, claim.event, layer, _p(outcome, values) / (1 if claim.face is None else 2))
            for layer, claims in enumerate(table.layers)
            for claim in claims
            for outcome in claim.outcomes
        ]
        lengths = [len(row[0]) for row in rows]
        self.definition, self.bits = definition, table.bits
        self.before, self.after = (np.concatenate([row[n] for row in rows]).astype(np.int64) for n in (0, 1))
        self.cells_before, self.cells_after = self.cells(self.before), self.cells(self.after)
        self.event, self.layer, self.p = (np.repeat([row[n] for row in rows], lengths) for n in (2, 3, 4))

    def names(self, chosen):
        """Return the names of the events of the chosen rows, in the order of the file."""
        return [self.definition.events[number].name for number in np.unique(self.event[chosen])]

    def cells(self, states):
        """Return the codes at the corners of states, (4, n) uint8."""
        return np.array(corners(states, self.bits)).astype(np.uint8)

    def shown(self, state):
        """Return a block state in letters, upper row / lower row."""
        letters = [self.definition.materials[code].letter for code in corners(state, self.bits)]
        return "".join(letters[:2]) + "/" + "".join(letters[2:])


def _p(outcome, values):
    return 1.0 if outcome.slot == CERTAIN else values[outcome.slot]


def check(definition):
    """Raise RuleError where nothing can happen, outcomes have more than certainty between them, or books are broken."""
    if not any(definition.table.layers):
        raise RuleError(definition.events[0].line, 0, "event", "none that can happen", "one that matches a block")
    values = definition.usual_values
    check_sums(definition, values)
    changes = Changes(definition, values)
    for book in definition.books:
        _check_book(changes, book)


def check_sums(definition, values):
    """Raise RuleError for the first event whose outcomes have more than certainty between them."""
    for layer in definition.table.layers:
        for claim in layer:
            total = math.fsum(_p(outcome, values) for outcome in claim.outcomes)
            if total > 1.0 + 1e-9:
                event = definition.events[claim.event]
                raise RuleError(event.line, 0, f"event {event.name!r}: chance", f"{total:g} in all", "at most 1 in all")


def _check_book(changes, book):
    broken = _broken(changes, book)
    for event in np.unique(changes.event[broken]):
        each = changes.definition.events[event]
        if each.name not in book.but:
            rows = np.flatnonzero(broken & (changes.event == event))
            row = rows[changes.before[rows].argmin()]
            found = f"{changes.shown(changes.before[row])} -> {changes.shown(changes.after[row])}"
            wanted = f"{book.words} to be kept, or its name in `but`"
            raise RuleError(each.line, 0, f"event {each.name!r}", found, wanted)
    idle = [name for name in book.but if name not in changes.names(broken)]
    if idle:
        raise RuleError(book.line, 0, "conserve: but", repr(idle[0]), f"only events that change {book.words}")


def _broken(changes, book):
    """Return which rows change the sum of a book."""
    counted = np.isin(np.arange(2**changes.bits), list(book.codes))
    return counted[changes.cells_after].sum(0) != counted[changes.cells_before].sum(0)


def laws(definition, values):
    """Return the Laws of a rule with these probabilities, one for each slot."""
    changes = Changes(definition, values)
    return [
        *(_book_kept(changes, book) for book in definition.books),
        _outside_kept(),
        _left_is_right(changes),
        _no_weight_lifted(changes),
        _solids_stay(changes),
        _none_stuck(changes),
        *_all_happen(changes, definition),
    ]


def _book_kept(changes, book):
    names = changes.names(_broken(changes, book))
    return Law(f"{book.words} is kept", True, f"but for: {', '.join(names)}" if names else "by every event")


def _outside_kept():
    return Law(f"{WALL_NAME} is kept", True, "by every event")


def _left_is_right(changes):
    """Compare each layer with its mirror image."""
    a, b, c, d = changes.cells_before.astype(np.int64)
    e, f, g, h = changes.cells_after.astype(np.int64)
    mirrored = [state_of(each, changes.bits) for each in ((b, a, d, c), (f, e, h, g))]
    states = 2 ** (4 * changes.bits)
    keys = (changes.layer * states + changes.before) * states + changes.after
    images = (changes.layer * states + mirrored[0]) * states + mirrored[1]
    found, place = np.unique(keys, return_inverse=True)
    total = np.bincount(place, changes.p)
    at = np.minimum(np.searchsorted(found, images), len(found) - 1)
    leaning = np.abs(np.where(found[at] == images, total[at], 0.0) - total[place]) > 1e-12
    names = changes.names(leaning)
    return Law("left is as right", not names, f"not so: {', '.join(names)}" if names else "in every state")


def _motions(changes):
    """Return which rows only move what is there; a form of a material is that material."""
    materials = changes.definition.materials
    same = [
        code if each.form_of is None else changes.definition.code(each.form_of) for code, each in enumerate(materials)
    ]
    before, after = (np.sort(np.array(same)[each], 0) for each in (changes.cells_before, changes.cells_after))
    return (before == after).all(0) & (changes.before != changes.after)


def _no_weight_lifted(changes):
    density = np.array([each.density * (each.kind != "solid") for each in changes.definition.materials])
    lifted = density[changes.cells_after[:2]].sum(0) > density[changes.cells_before[:2]].sum(0)
    names = changes.names(lifted & _motions(changes))
    return Law("no motion lifts weight", not names, f"lifted by: {', '.join(names)}" if names else "none does")


def _solids_stay(changes):
    solid = np.array([each.kind == "solid" for each in changes.definition.materials])
    before, after = changes.cells_before, changes.cells_after
    names = changes.names((solid[before] & (before != after)).any(0) & _motions(changes))
    return Law("solids stay where they are", not names, f"moved by: {', '.join(names)}" if names else "in every state")


def _none_stuck(changes):
    """Look for block states that hold heavy over light fluid and in which nothing can change."""
    materials = changes.definition.materials
    heavier = np.array([[sinks(upper, lower) for lower in materials] for upper in materials])
    states = np.arange(2 ** (4 * changes.bits))
    cells = changes.cells(states)
    states = states[(cells < len(materials)).all(0)]
    a, b, c, d = changes.cells(states)
    stuck = states[(heavier[a, c] | heavier[b, d]) & ~np.isin(states, changes.before[_can_happen(changes)])]
    found = f"for ever: {len(stuck)} block states, such as {changes.shown(stuck[0])}" if len(stuck) else "in no state"
    return Law("heavy over light fluid sinks in time", not len(stuck), found)


def _can_happen(changes):
    """Return which rows change their state with some probability, as no layer before always comes first."""
    table = changes.definition.table
    happened = np.zeros((len(table.layers) + 1, table.states))
    np.add.at(happened, (changes.layer + 1, changes.before), changes.p)
    reached = np.cumprod(1.0 - np.minimum(happened, 1.0), axis=0)
    return (changes.p > 0) & (changes.before != changes.after) & (reached[changes.layer, changes.before] > 1e-9)


def _all_happen(changes, definition):
    claimed = set(changes.event.tolist())
    for number, event in enumerate(definition.events):
        if number not in claimed:
            hidden = matches_of(definition, event).any()
            if hidden or not event.included:
                found = "never: earlier events always come first" if hidden else "never: it matches no block"
                yield Law(f"{event.name!r} happens", False, found)


def overlaps(definition):
    """Return (earlier, later, states in common) for the events of one layer whose pictures match one block."""
    matched = [(each, matches_of(definition, each)) for each in definition.events]
    found = []
    for number, (event, mine) in enumerate(matched):
        for other, theirs in matched[number + 1 :]:
            if other.layer == event.layer:
                common = int((mine & theirs).sum())
                if common:
                    found.append((event.name, other.name, common))
    return found


def reacting_pairs(changes):
    """Return the pairs of names of materials that change each other: by an event that needs both."""
    names = [each.name for each in changes.definition.materials]
    rows = np.flatnonzero(~_motions(changes) & (changes.before != changes.after))
    present = np.sort(changes.cells_before[:, rows], 0)
    kinds = 1 + (np.diff(present, axis=0) != 0).sum(0)
    few = np.stack([present[0], present[3], changes.event[rows]], 1)[kinds <= 2]
    found = set(map(tuple, few.tolist()))
    return sorted(
        {(names[x], names[y]) for x, y, event in found if x != y and not {(x, x, event), (y, y, event)} & found}
    )
