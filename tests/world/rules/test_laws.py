"""The laws are checked on every block state, and a rule that breaks one is found out."""

from itertools import product

import numpy as np
import pytest

from game import load_rule, rule_names
from game.core.rule_table import corners, state_of
from game.world.rules.laws import Changes, laws, overlaps, reacting_pairs
from tests.sweeps import sweep
from tests.world.rules.small_rule import small_rule

WIDER = '[[event]]\nname = "hidden"\npicture = "wl -> wk"'
NO_NUMBERS = [(', flow = "slow"', ""), (", flow = 0.5", "")]
STAY = (
    "left is as right",
    "no motion lifts weight",
    "solids stay where they are",
    "heavy over light fluid sinks in time",
)


def broken(rule):
    """Return {law: what was found} of the laws that a rule does not keep."""
    return {law.name: law.found for law in laws(rule.definition, rule.values) if not law.holds}


@pytest.mark.parametrize("name", rule_names())
def test_shipped_rules_keep_their_laws(name):
    known = {"no motion lifts weight": "lifted by: brine mixes"} if name == "alchemy" else {}
    assert broken(load_rule(name)) == known


@sweep("name", rule_names(), keep=["sand", "alchemy"])
def test_books_balance_in_every_block_but_for_the_events_named(name):
    """Summed up anew, from the outcomes of blocks."""
    rule = load_rule(name)
    blocks = list(product(range(len(rule.materials)), repeat=4))
    for block in blocks if len(blocks) < 1000 else blocks[:: len(blocks) // 1000]:
        for book in rule.definition.books:
            if not book.but:
                count = sum(code in book.codes for code in block)
                assert all(sum(code in book.codes for code in after) == count for _, after in rule.outcomes(block))


def test_the_small_rule_keeps_its_laws(tmp_path):
    rule = small_rule(tmp_path)
    assert broken(rule) == {}
    assert {law.name for law in laws(rule.definition, rule.values)} >= {*STAY, "wall is kept", "water is kept"}


@pytest.mark.parametrize(
    ("changes", "law", "found"),
    [
        ([('chance = "M.flow"', 'chance = "M.flow"\nways = "as drawn"')], "left is as right", "not so: flow"),
        ([("M.    .M\n## -> ##", "#.    #M\nM# -> .#")], "no motion lifts weight", "lifted by: flow"),
        (
            [("M sinks in X", "l sinks in w"), ("M?    X?\nX? -> M?", "l?    w?\nw? -> l?")],
            "heavy over light fluid sinks in time",
            "for ever: 177 block states, such as l./..",
        ),
        (
            [("chance = [", 'where = ["l rests on w"]\nchance = ['), ('\nbut = ["lava and water"]', "")],
            "'lava and water' happens",
            "never: it matches no block",
        ),
        (
            [('picture = "lw -> k. | kw"', f'picture = "lw -> kw | kw"\n{WIDER}'), ('\nbut = ["lava and water"]', "")],
            "'hidden' happens",
            "never: earlier events always come first",
        ),
        (
            [('"powder", density = 60', '"solid"'), ("M.    .M", "k.    .k"), ('"M.flow"', "0.5"), *NO_NUMBERS],
            "solids stay where they are",
            "moved by: flow",
        ),
    ],
)
def test_a_broken_law_is_found(changes, law, found, tmp_path):
    told = broken(small_rule(tmp_path, *changes))
    assert list(told) == [law] and told[law].startswith(found)


def test_what_meets_and_what_reacts_is_told(tmp_path):
    assert ("fall in a pair", "fall") in [
        (first, second) for first, second, _ in overlaps(load_rule("water-and-oil").definition)
    ]
    rule = small_rule(tmp_path)
    assert reacting_pairs(Changes(rule.definition, rule.values)) == [("lava", "water")]


@pytest.mark.parametrize("name", rule_names())
def test_no_two_claims_of_a_layer_share_a_state_on_one_face(name):
    table = load_rule(name).table
    for layer in table.layers:
        held = np.zeros((2, table.states), int)
        for claim in layer:
            for face in (0, 1) if claim.face is None else (claim.face,):
                held[face, claim.states] += 1
        assert held.max() <= 1


@pytest.mark.parametrize("name", rule_names())
def test_wall_never_changes(name):
    table = load_rule(name).table
    for claim in (claim for layer in table.layers for claim in layer):
        for outcome in claim.outcomes:
            for before, after in zip(
                corners(claim.states, table.bits), corners(outcome.after, table.bits), strict=True
            ):
                assert ((before == table.outside) == (after == table.outside)).all()
        assert state_of([table.outside] * 4, table.bits) not in claim.states
