"""The card beside the pointer: events of the block under it by name, layer and chance, before and after a step."""

import numpy as np
import pygame
import pytest

from game.world.rules.rule import load_rule
from game.world.sand.advance import advance
from game.world.sand.block_events import block_at, coming_events, happened, told_events
from game.world.sand.crop import CropBox
from game.world.sand.world import World
from game.world.sessions.action import Clear, Paint
from tests.play.player import Player


@pytest.fixture
def player():
    """Return a player who looks from near by at the blocks of sand that falls in an empty aquarium."""
    player = Player("aquarium")
    player.hold_time()
    middle = tuple(side / 2 for side in player.world.shape[::-1])
    player.session.do(Clear())
    player.session.do(Paint("sand", middle, middle, 6))
    player.pointer = player.pixel(*sure(player)[::-1])
    player.frame()
    for _ in range(9):
        player.key(pygame.K_PLUS, "+", pygame.KMOD_LCTRL)
    player.key(pygame.K_b, "b")
    player.frame(elapsed_ns=2 * 10**9)
    yield player
    pygame.display.quit()


def sure(player):
    """Return the (row, column) of a block in which something is certain to happen."""
    events = coming_events(player.world, player.session.rule, CropBox(0, 0, *player.world.shape))
    first = np.flatnonzero(events.chances == 1.0)[0]
    return int(events.rows[first]), int(events.columns[first])


def point_at(player, row, column):
    player.pointer = player.pixel(column, row)
    for _ in range(2):
        player.frame(elapsed_ns=0)
    return [text for text, _ in player.parts.block_card.lines]


def test_the_card_names_what_can_happen_and_then_what_has(player):
    row, column = sure(player)
    before = point_at(player, row, column)
    assert before[0] == "Can happen here" and before[1].endswith("(motion): always")
    player.key(pygame.K_PERIOD, ".")
    after = point_at(player, row, column)
    assert after[after.index("Has just happened") + 1] == before[1].removesuffix(": always")


def test_the_card_goes_with_the_blocks(player):
    assert point_at(player, *sure(player))
    player.key(pygame.K_b, "b")
    player.frame(elapsed_ns=0)
    assert not player.parts.block_card.shown


def test_the_events_of_a_block_have_together_the_chances_of_its_outcomes():
    rule = load_rule("alchemy")
    cells = np.random.default_rng(3).integers(0, 16, (24, 32)).astype(np.uint8)
    world = World.from_materials(cells, rule)
    events = coming_events(world, rule, CropBox(0, 0, *world.shape))
    for state in np.unique(events.before):
        told = told_events(rule, state)
        assert sum(p for _, p in told) == pytest.approx(sum(p for p, _ in rule.outcomes(block(rule, state))))
        assert all(event.layer in rule.definition.layers for event, _ in told)


def test_what_has_happened_in_a_block_is_told_by_an_event_that_can():
    rule = load_rule("alchemy")
    cells = np.random.default_rng(4).integers(0, 16, (24, 32)).astype(np.uint8)
    world, box = World.from_materials(cells, rule), CropBox(0, 0, 24, 32)
    events = coming_events(world, rule, box)
    place = block_at(world, rule, 9, 9)
    advance(world, rule, 1)
    assert block_at(world, rule, 9, 9, before=1) == place
    done = events.only(happened(events, world, box))
    assert len(done.rows) > 10
    assert all(told_events(rule, *pair) for pair in zip(done.before, done.after, strict=True))


def block(rule, state):
    bits = rule.table.bits
    return tuple(int(state) >> (bits * corner) & (2**bits - 1) for corner in range(4))
