"""The plan of a rule: the gates that say which event a block has, what decides about it and what it changes."""

from functools import lru_cache
from math import fsum
from typing import NamedTuple

import numpy as np

from game.core.compiler.circuit import FALSE, TRUE, Circuit
from game.core.compiler.cover import Covers
from game.core.compiler.effects import Become, Copy, Invert, effect_of, flipped, moves_of
from game.core.compiler.shared_ors import shared_ors
from game.core.rule_table import CERTAIN, state_of

NEVER, CHANCE, ALWAYS = range(3)  # what is known of a threshold without its value
WATCHED = 100  # where events take more gates, it pays to look first for blocks of equal cells


class Group(NamedTuple):
    """The blocks whose outcome, or an earlier one, is accepted where u is below the same threshold."""

    level: int  # number of the outcome, of claims that have so many
    slots: tuple  # whose probabilities add up to the threshold
    blocks: int  # literal


class LayerPlan(NamedTuple):
    """The gates of a layer. Lists are by level, the number of an outcome."""

    event: int  # literal: some claim holds the block
    sure: list  # literals: the claim has such an outcome, and it or an earlier one happens for sure
    groups: list  # of Group
    deltas: list  # {(corner, bit): literal}, what the outcome inverts
    moves: list  # {(corner, source): literal}, whose content a corner takes


class Plan(NamedTuple):
    """The gates of a rule."""

    circuit: Circuit
    bits: int
    fair: int | None  # number of the input that is the fair bit
    layers: tuple  # of LayerPlan
    watch: int | None  # literal, if it pays: false only where no layer has an event, as in a block of four equal cells


class _Piece(NamedTuple):
    """Claims that do the same by the same chance: states, and what follows for each level."""

    parts: tuple  # of arrays of states, one for each claim
    states: np.ndarray  # all of them
    face: int | None
    chances: tuple  # for each outcome the slots whose probabilities add up, of a kind that is not NEVER or ALWAYS
    outcomes: tuple  # (after, effect) of each


def plan(table, kinds):
    """Return the Plan of a RuleTable; kinds: {slots: NEVER, CHANCE or ALWAYS} for all its thresholds."""
    inputs = 4 * table.bits + table.has_fair_bit
    used = np.zeros(table.states, bool)
    used[table.used_states] = True
    circuit = Circuit(inputs, np.tile(used, 2) if table.has_fair_bit else used)
    covers = Covers(circuit, table.bits)
    fair = 4 * table.bits if table.has_fair_bit else None
    layers = tuple(_layer(table, layer, kinds, covers, used, fair) for layer in table.layers)
    many = len(circuit.cone([layer.event for layer in layers])) > WATCHED
    return Plan(circuit, table.bits, fair, layers, _watch(table, covers, used) if many else None)


def _watch(table, covers, used):
    """Return a literal that is true for all states with an event, and false for blocks of four equal cells without."""
    wanted, unwanted = (np.zeros(table.states, bool) for _ in range(2))
    unwanted[[state_of([code] * 4, table.bits) for code in range(table.codes)]] = True
    unwanted &= used
    for layer in table.layers:
        for claim in layer:
            wanted[claim.states] = True
    return covers.cover(wanted, unwanted & ~wanted)


def thresholds_of(claim):
    """Return the slots whose probabilities add up to each threshold of a claim."""
    slots = [outcome.slot for outcome in claim.outcomes]
    return [tuple(slots[: level + 1]) for level in range(len(slots))]


def _layer(table, claims, kinds, covers, used, fair):
    circuit = covers.circuit
    pieces = _pieces(table, claims, kinds)
    levels = max((len(piece.outcomes) for piece in pieces), default=0)
    literals, event = _claimed(table, pieces, covers, used, fair)
    everywhere = np.zeros(table.states, bool)
    for piece in pieces:
        everywhere[piece.states] = True
    sure, groups, deltas, moves = [], [], [], []
    for level in range(levels):
        sets = {("sure",): []}
        for piece, literal in zip(pieces, literals, strict=True):
            for key in _keys(piece, level, kinds, table.bits):
                sets.setdefault(key, []).append(literal)
        made = shared_ors(circuit, sets)
        sure.append(made.pop(("sure",)))
        groups += [Group(level, key[1], made[key]) for key in sorted(made) if key[0] == "group"]
        moves.append({key[1:]: made[key] for key in sorted(made) if key[0] == "move"})
        deltas.append(_deltas(covers, made, _odd(table, pieces, literals, level, covers)))
    return LayerPlan(event, sure, groups, deltas, moves)


def _keys(piece, level, kinds, bits):
    """Yield what a piece belongs to at a level: by chance, by what it changes, by what moves."""
    if level >= len(piece.outcomes):
        return
    slots, (after, effect) = piece.chances[level], piece.outcomes[level]
    if kinds[slots] == ALWAYS:
        yield ("sure",)
    elif kinds[slots] == CHANCE:
        yield "group", slots
    for part in effect.parts:
        if isinstance(part, Invert):
            yield from (("flip", part.corner, number) for number in range(bits) if part.bits >> number & 1)
        else:
            yield type(part).__name__, *part
    yield from (("move", *move) for move in moves_of(piece.states, after, effect, bits))


def _pieces(table, claims, kinds):
    """Return the claims as pieces, those joined that do the same by the same chance; the place is that of the last."""
    joined = {}
    for claim in claims:
        chances = tuple(thresholds_of(claim))
        sure = tuple(kinds[slots] if kinds[slots] != CHANCE else slots for slots in chances)
        effects = tuple(effect_of(claim.states, outcome.after, table.bits) for outcome in claim.outcomes)
        key = claim.face, sure, effects, claim.event if any(effect.odd for effect in effects) else None
        before = joined.pop(key, [])
        joined[key] = [*before, (claim, chances, effects)]
    return [_joined(same) for same in joined.values()]


def _joined(same):
    claim, chances, effects = same[0]
    parts = tuple(each.states.astype(np.int64) for each, _, _ in same)
    afters = [
        np.concatenate([each.outcomes[level].after for each, _, _ in same]).astype(np.int64)
        for level in range(len(claim.outcomes))
    ]
    return _Piece(parts, np.concatenate(parts), claim.face, chances, tuple(zip(afters, effects, strict=True)))


def _claimed(table, pieces, covers, used, fair):
    """Return the literal of the blocks that each piece holds, and that of the blocks with an event."""
    circuit = covers.circuit
    held = np.zeros((2, table.states), bool)
    literals, before, event = [], FALSE, FALSE
    for piece in pieces:
        free = held[piece.face] if piece.face is not None else held.all(axis=0)
        here = _covered(covers, piece, used & ~free)
        event = circuit.or_(event, here)
        if piece.face is not None:
            bit = circuit.input(fair)
            here = circuit.and_(here, bit if piece.face else bit ^ 1)
        literals.append(circuit.and_(here, before ^ 1) if circuit.meet(here, before) else here)
        before = circuit.or_(before, here)
        for face in (0, 1) if piece.face is None else (piece.face,):
            held[face, piece.states] = True
    return literals, event


def _covered(covers, piece, mattering):
    """Return a literal that is true for the states of a piece, and false for others that matter, (states,) bool."""
    unwanted = mattering.copy()
    unwanted[piece.states] = False
    found = []
    for states in piece.parts:
        wanted = np.zeros_like(unwanted)
        wanted[states] = True
        found.append(covers.cover(wanted, unwanted))
    return covers.circuit.any(found)


def _odd(table, pieces, literals, level, covers):
    """Return {(corner, bit): literals} of what no part of an effect says."""
    found = {}
    for piece, literal in zip(pieces, literals, strict=True):
        after, effect = piece.outcomes[level] if level < len(piece.outcomes) else (None, None)
        for corner in effect.odd if effect else ():
            for number in range(table.bits):
                changes = flipped(piece.states, after, table.bits, corner, number)
                wanted, unwanted = (np.zeros(table.states, bool) for _ in range(2))
                wanted[piece.states[changes]], unwanted[piece.states[~changes]] = True, True
                here = covers.circuit.and_(literal, covers.cover(wanted, unwanted))
                found.setdefault((corner, number), []).append(here)
    return found


def _deltas(covers, made, odd):
    """Return {(corner, bit): literal} of what is inverted, from the literals of parts of effects."""
    circuit, found = covers.circuit, {}
    for key, literal in made.items():
        for number in range(covers.bits):
            if key[0] == "flip" and key[2] == number:
                changes = TRUE
            elif key[0] == Copy.__name__:
                changes = circuit.xor(covers.bit(key[1], number), covers.bit(key[2], number))
            elif key[0] == Become.__name__:
                changes = covers.bit(key[1], number) ^ (key[2] >> number & 1)
            else:
                continue
            found.setdefault((key[1], number), []).append(circuit.and_(literal, changes))
    for key, literals in odd.items():
        found.setdefault(key, []).extend(literals)
    return {key: literal for key in sorted(found) if (literal := circuit.any(found[key])) != FALSE}


def gate_count(made):
    """Return how many gates a Plan has."""
    literals = [made.watch or FALSE]
    for layer in made.layers:
        literals += [layer.event, *layer.sure, *(group.blocks for group in layer.groups)]
        literals += [literal for level in (*layer.deltas, *layer.moves) for literal in level.values()]
    return len(made.circuit.cone(literals))


def kinds_of(table, probabilities):
    """Return {slots: NEVER, CHANCE or ALWAYS} for all thresholds of a RuleTable."""
    found = {}
    for slots in thresholds_in(table):
        bound = threshold_of(slots, probabilities)
        found[slots] = NEVER if bound == 0 else ALWAYS if bound == 2**32 else CHANCE
    return found


@lru_cache(maxsize=64)
def thresholds_in(table):
    """Return the slots of all thresholds of a RuleTable, in order."""
    claims = (claim for layer in table.layers for claim in layer)
    return tuple(dict.fromkeys(slots for claim in claims for slots in thresholds_of(claim)))


def threshold_of(slots, probabilities):
    """Return the sum of probabilities in units of 2**-32, at most 2**32."""
    if CERTAIN in slots:
        return 2**32
    return min(2**32, round(2**32 * fsum(probabilities[slot] for slot in slots)))
