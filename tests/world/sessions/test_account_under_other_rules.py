"""The account goes on under another rule: start + painted - erased ± events = now, as if there had been one rule."""

from functools import cache

import numpy as np

from game import Rule, load_rule, load_scene
from game.core.paint.ink import Ink
from game.core.paint.strokes import ROUND
from game.world.rules.definition import definition_of_texts
from game.world.sand.material_codes import EMPTY
from game.world.sessions.action import Paint, SetRule
from game.world.sessions.session import Session
from tests.sweeps import sweep

ALCHEMY = load_rule("alchemy")


@cache
def edited():
    """Return alchemy in which acid eats no sand, which is kept."""
    text, *others = ALCHEMY.definition.texts
    parts = text.replace('sum = "sand"\nbut = ["acid eats"]', 'sum = "sand"').split("[[event]]")
    text = "[[event]]".join(each for each in parts if 'name = "acid eats"\n' not in each)
    text = text.replace('sum = "stone + lava"\nbut = ["acid eats"]', 'sum = "stone + lava"')
    text = text.replace('but = ["acid eats", ', "but = [")
    return Rule(definition=definition_of_texts("mine", (text, *others)))


def a_grain(session):
    """Return the middle of a cell of sand, as (column, row)."""
    row, column = np.argwhere(session.world.sand)[0]
    return column + 0.5, row + 0.5


def amount(session, name):
    return session.world.amounts[session.world.codes.code(name)]


def balance(session, name):
    """Return what the account says that there is of a material."""
    account = session.account.met(session.world.amounts)
    assert account.balanced(session.world)
    return account.expected_by_kind[session.world.codes.code(name)]


def with_acid_on_sand():
    session = Session(load_scene("blank", (60, 40)), seed=3)
    session.do(SetRule(ALCHEMY))
    session.do(Paint("sand", (10.0, 35.0), (50.0, 35.0), 8))
    session.timeline.run(200)
    session.do(Paint("acid", (10.0, 10.0), (50.0, 10.0), 8))
    session.timeline.run(600)
    return session


def test_what_an_earlier_rule_ate_stays_in_the_account_and_nothing_is_missing_under_the_next():
    session = with_acid_on_sand()
    painted, there = session.account.painted_by_kind, amount(session, "sand")
    assert there < painted[session.world.codes.code("sand")]
    session.do(SetRule(edited()))
    session.timeline.run(300)
    assert session.account.painted_by_kind == painted and session.account.start == 0
    assert balance(session, "sand") == amount(session, "sand") == there
    assert any(session.account.used_before_by_kind)
    session.do(Paint("erase", (30.0, 35.0), (30.0, 35.0), 6))
    assert balance(session, "sand") == amount(session, "sand") < there


def test_undoing_the_change_gives_the_account_back():
    session = with_acid_on_sand()
    before = session.account
    session.do(SetRule(edited()))
    assert session.account != before
    session.undo()
    assert session.account == before


def sand_of(tally, world):
    return sum(tally[:8]) if world.codes.is_sand else tally[world.codes.code("sand")]


@sweep("name", ["sand", "water-and-oil", "rolling-sand"], keep=["sand", "water-and-oil"])
def test_what_both_rules_have_is_told_from_the_start_on(name):
    session = with_acid_on_sand()
    painted, there = sand_of(session.account.painted_by_kind, session.world), amount(session, "sand")
    for rule in (load_rule(name), ALCHEMY):
        session.do(SetRule(rule))
        session.do(Paint("erase", a_grain(session), a_grain(session), 1))
        account = session.account.met(session.world.amounts)
        assert account.balanced(session.world)
        assert sand_of(account.painted_by_kind, session.world) == painted
        assert sand_of(account.expected_by_kind, session.world) == sand_of(session.world.amounts, session.world)
    assert amount(session, "sand") == there - 2


def test_a_cell_that_vanishes_under_the_next_rule_is_missed():
    session = with_acid_on_sand()
    session.do(SetRule(edited()))
    assert session.account.balanced(session.world)
    session.world.stroke(a_grain(session), a_grain(session), 1, ROUND, Ink(EMPTY))
    assert not session.account.balanced(session.world)
