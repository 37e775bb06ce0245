"""The self-check sees whatever a pass does otherwise than its table says, be it in one block state of all."""

from dataclasses import replace

import numpy as np
import pytest

from game.core.compiler import self_check
from game.core.compiler.machine_code import MachineCode, lanes
from game.core.compiler.plan import kinds_of, plan
from game.core.compiler.vector_ir import NAME, source
from game.core.rule_table import CERTAIN
from tests.core.compiler.rules import random_table

CHANCES = (0.5, 0.25, 0.7, 0.3, 0.125, 0.0)


@pytest.fixture(scope="module")
def made():
    """What is made of a table."""
    return compiled(random_table(np.random.default_rng(92), 2))


def compiled(table):
    """Return a table, its plan, its kinds and its code."""
    kinds = kinds_of(table, CHANCES)
    gates = plan(table, kinds)
    return table, gates, kinds, MachineCode(source(gates, lanes(), 2), NAME)


def agrees(made, table=None):
    """Return whether the code agrees with another table than the one it was made from, or with that."""
    own, gates, kinds, code = made
    return self_check.agrees(code.address, table or own, gates, kinds, 2, lanes())


def with_layers(table, layers):
    return replace(table, layers=tuple(map(tuple, layers)))


def changes(table):
    """Yield (words, table) of tables that differ from one in the fate of one state, which no earlier layer decides."""
    decided = np.zeros(table.states, bool)
    for number, layer in enumerate(table.layers):
        for at, claim in enumerate(layer):
            outcome, free = claim.outcomes[0], np.flatnonzero(~decided[claim.states])
            if outcome.slot == CERTAIN or not CHANCES[outcome.slot]:
                continue
            moving = [place for place in free if outcome.after[place] != claim.states[place]]
            if moving:
                still = outcome.after.copy()
                still[moving[0]] = claim.states[moving[0]]
                other = replace(claim, outcomes=(replace(outcome, after=still), *claim.outcomes[1:]))
                yield "stays as it is", with_claim(table, number, at, [other])
            if len(free) and len(claim.states) > 1:
                rest = [replace(each, after=np.delete(each.after, free[0])) for each in claim.outcomes]
                other = replace(claim, states=np.delete(claim.states, free[0]), outcomes=tuple(rest))
                yield "has no event", with_claim(table, number, at, [other])
        for claim in layer:
            decided[claim.states] |= CERTAIN in [each.slot for each in claim.outcomes]


def with_claim(table, number, at, claims):
    """Return a table with other claims in the place of one."""
    layer = table.layers[number]
    here = [*layer[:at], *claims, *layer[at + 1 :]]
    return with_layers(table, [*table.layers[:number], here, *table.layers[number + 1 :]])


def test_a_pass_agrees_with_its_own_table(made):
    assert agrees(made)


def test_one_block_state_that_goes_otherwise_is_seen(made):
    found = [(words, agrees(made, table)) for words, table in changes(made[0])]
    assert {words for words, _ in found} == {"stays as it is", "has no event"} and len(found) > 7
    assert not any(seen_as_right for _, seen_as_right in found)


def test_layers_in_another_order_are_seen(made):
    layers = [
        [replace(claim, outcomes=(replace(claim.outcomes[0], slot=0),)) for claim in layer] for layer in made[0].layers
    ]
    of_one_chance = compiled(with_layers(made[0], layers))
    assert agrees(of_one_chance)
    assert not agrees(of_one_chance, with_layers(made[0], [layers[1], layers[0], layers[2]]))
    assert not agrees(of_one_chance, with_layers(made[0], [layers[0], layers[2], layers[1]]))


def test_faces_the_other_way_round_are_seen(made):
    layers = [
        [claim if claim.face is None else replace(claim, face=1 - claim.face) for claim in layer]
        for layer in made[0].layers
    ]
    assert not agrees(made, with_layers(made[0], layers))
