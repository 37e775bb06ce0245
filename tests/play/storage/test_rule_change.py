"""Laws of changing the rule while it runs: the sand never waits, and what is wanted last is what is done, once."""

import threading

import pygame
import pytest

from game.play.storage import rule_change
from game.world.rules.rule import load_rule
from tests.play.player import Player


@pytest.fixture
def player():
    """Return a player of the aquarium."""
    yield Player("aquarium")
    pygame.display.quit()


@pytest.fixture
def gate(monkeypatch):
    """Return an event that compiling waits for."""
    gate, made = threading.Event(), rule_change.make_ready

    def waiting(*arguments):
        assert gate.wait(60)
        made(*arguments)

    monkeypatch.setattr(rule_change, "make_ready", waiting)
    return gate


def acts(player):
    return len(player.session.timeline.history.story())


def test_the_sand_goes_on_while_a_rule_is_compiled_and_says_so(player, gate):
    change, before = player.parts.rule_change, player.session.rule
    change.turn("oil.pour", 0.875)
    start = player.world.iteration
    player.wait(5)
    assert change.busy and player.world.iteration > start and player.session.rule is before
    assert "Compiling the rule" in player.words()
    gate.set()
    player.settle()
    assert not change.busy and player.session.rule == before.with_chances(**{"oil.pour": 0.875})


def test_a_drag_shows_what_is_wanted_at_once_and_is_one_act_at_its_end(player, gate):
    player.hold_time()
    change, before = player.parts.rule_change, player.session.rule
    for number, value in enumerate((0.25, 0.5, 0.75)):
        change.turn("water.sink", value, join=number > 0)
        player.frame(elapsed_ns=0)
        assert change.value("water.sink") == value
    gate.set()
    player.settle()
    change.turn("water.sink", 0.875, join=True)
    player.frame(elapsed_ns=0)
    assert player.session.rule.number("water.sink") == 0.875
    player.session.undo()
    assert player.session.rule == before and not player.session.undo()


def test_what_is_wanted_last_takes_the_place_of_what_was_on_its_way(player, gate):
    change = player.parts.rule_change
    change.make(lambda: load_rule("three-sands"))
    change.make(lambda: load_rule("rolling-sand"))
    gate.set()
    player.settle()
    assert player.session.rule == load_rule("rolling-sand") and acts(player) == 1


def test_a_rule_on_its_way_is_dropped_with_the_scene_that_it_was_for(player, gate):
    change = player.parts.rule_change
    change.make(lambda: load_rule("three-sands"))
    player.parts.sessions.load("blank")
    gate.set()
    player.settle()
    assert player.session.rule.is_sand and not change.busy
