"""The self-check sees whatever a pass does otherwise than its table says, be it in one block state of all."""

import re
from dataclasses import replace

import numpy as np
import pytest

from game.core.compiler import machine_code, self_check
from game.core.compiler.plan import kinds_of, plan
from game.core.compiler.vector_ir import NAME, source
from game.core.rule_table import CERTAIN
from game.world.rules.rule import SAND
from tests.core.compiler.rules import random_table
from tests.sweeps import sweep

CHANCES = (0.5, 0.25, 0.7, 0.3, 0.125, 0.0)


@pytest.fixture(scope="module")
def made():
    """What is made of a table."""
    return compiled(random_table(np.random.default_rng(92), 2))


def compiled(table, change_plan=lambda gates: gates, change_text=lambda text: text, payload=2):
    """Return a table, its plan, its kinds, its code, which may be made wrong on the way, and the bits of payload."""
    kinds = kinds_of(table, (*CHANCES, 1.0)[: len(table.slots)])
    gates = plan(table, kinds)
    code = machine_code.compiled(change_text(source(change_plan(gates), machine_code.lanes(), payload)))
    return table, gates, kinds, machine_code.MachineCode(code, NAME), payload


def agrees(made, table=None):
    """Return whether the code agrees with another table than the one it was made from, or with that."""
    own, gates, kinds, code, payload = made
    return self_check.agrees(code.address, table or own, gates, kinds, payload, machine_code.lanes())


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
                still[moving[-1]] = claim.states[moving[-1]]
                other = replace(claim, outcomes=(replace(outcome, after=still), *claim.outcomes[1:]))
                yield "stays as it is", with_claim(table, number, at, [other])
            if len(free) and len(claim.states) > 1:
                rest = [replace(each, after=np.delete(each.after, free[-1])) for each in claim.outcomes]
                other = replace(claim, states=np.delete(claim.states, free[-1]), outcomes=tuple(rest))
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


def test_states_with_the_highest_numbers_are_looked_at_as_well():
    of_three_bits = compiled(random_table(np.random.default_rng(92), 3), payload=0)
    table = of_three_bits[0]
    claim = max(table.layers[0], key=lambda claim: CHANCES[claim.outcomes[0].slot] and claim.states[-1])
    low = claim.states < np.median(claim.states)
    kept = tuple(replace(each, after=each.after[low]) for each in claim.outcomes)
    at = table.layers[0].index(claim)
    other = with_claim(table, 0, at, [replace(claim, states=claim.states[low], outcomes=kept)])
    assert claim.states[~low].min() > table.states // 4 and not agrees(of_three_bits, other)


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


def test_each_state_is_looked_at_on_each_face():
    of_three_bits = compiled(random_table(np.random.default_rng(93), 3), payload=0)
    table, checked = of_three_bits[0], 0
    for at, claim in enumerate(table.layers[0]):
        after = claim.outcomes[0].after
        if claim.face is None or not CHANCES[claim.outcomes[0].slot]:
            continue
        for state in np.flatnonzero(after != claim.states)[::24]:
            still = np.where(np.arange(len(after)) == state, claim.states, after)
            other = replace(claim, outcomes=(replace(claim.outcomes[0], after=still), *claim.outcomes[1:]))
            assert not agrees(of_three_bits, with_claim(table, 0, at, [other]))
            checked += 1
    assert checked > 10


def test_what_belongs_to_a_cell_and_does_not_follow_it_is_seen():
    def staying(gates):
        still = [layer._replace(moves=[{} for _ in layer.moves]) for layer in gates.layers]
        return gates._replace(layers=tuple(still))

    assert agrees(compiled(SAND.table)) and not agrees(compiled(SAND.table, change_plan=staying))


@sweep("number", range(4), keep=[0, 3])
def test_what_is_told_wrongly_is_seen(made, number):
    wrong = compiled(made[0], change_text=lambda text: re.sub(r"ret i64 %v\d+", f"ret i64 {number}", text))
    assert agrees(wrong) == (number == 3), "all states together have events, and some happen"


def test_blocks_that_are_to_take_no_part_and_do_are_seen(made):
    load = r"(%v\d+) = getelementptr i64, ptr %may, i64 %i\n +(%v\d+) = load (<\d+ x i64>), ptr .*"
    ones = f"<{', '.join(['i64 -1'] * machine_code.lanes())}>"
    wrong = compiled(made[0], change_text=lambda text: re.sub(load, rf"\2 = xor \3 zeroinitializer, {ones}", text))
    assert not agrees(wrong)
