"""Sand of many colours in the window: swatches, keys, picking, and what is told of it."""

import pygame
import pytest

from game.world.sand.sand_colours import COLOURS, DYES, RAINBOW
from game.world.sessions.recording import parse
from game.world.sessions.session import Session
from tests.saved import recording_of, to_bytes
from tests.sweeps import sweep


@pytest.fixture
def still(player):
    """Return a player of the blank scene for whom time stands still."""
    player.hold_time()
    return player


def stroke(player, row=20):
    player.drag(player.pixel(20, row), player.pixel(90, row))


@sweep("colour", DYES, keep=[DYES[0], DYES[-1]])
def test_sand_is_painted_in_the_colour_chosen(still, colour):
    still.parts.brush.dip(colour)
    stroke(still)
    counts = still.world.amounts
    found = {number for number, grains in enumerate(counts) if grains}
    assert len(found) > 5 if colour == RAINBOW else found == {COLOURS.index(colour)}
    assert still.world.coloured == (colour != "amber")


def test_the_comma_walks_the_colours_and_takes_sand_in_hand(still):
    still.parts.brush.material = "wall"
    for colour in (*DYES[1:], DYES[0]):
        still.key(pygame.K_COMMA, ",")
        assert (still.parts.brush.colour, still.parts.brush.material) == (colour, "sand")
    still.key(pygame.K_COMMA, ",", mod=pygame.KMOD_SHIFT)
    assert still.parts.brush.colour == RAINBOW


def test_walls_and_the_eraser_have_no_colour(still):
    still.parts.brush.dip("plum")
    still.parts.brush.material = "wall"
    stroke(still)
    assert not still.world.coloured and still.world.walls.any()


def test_picking_a_grain_takes_its_colour(still):
    still.parts.brush.dip("teal")
    stroke(still)
    still.parts.brush.dip("amber")
    still.parts.brush.choose("pick")
    still.drag(still.pixel(50, 20), still.pixel(50, 20))
    assert (still.parts.brush.colour, still.parts.brush.tool) == ("teal", "brush")


def test_painting_over_sand_dyes_it_and_the_books_say_so(still):
    stroke(still)
    grains = still.world.grains
    still.parts.brush.dip("rose")
    stroke(still)
    assert still.world.grains == grains == still.world.amounts[2]
    account = still.session.account
    assert account.balanced(still.world) and account.erased_by_kind[0] == grains
    still.key(pygame.K_z, mod=pygame.KMOD_CTRL)
    assert still.world.amounts[0] == grains
    still.key(pygame.K_c, "c")
    assert not still.world.coloured


def test_a_replay_has_the_rainbow_again(player):
    player.parts.brush.dip(RAINBOW)
    for row in (20, 40):
        stroke(player, row)
        player.wait(4)
    recording, _ = parse(to_bytes(recording_of(player.session)), "file")
    told = Session.retold(recording)
    told.seek(recording.end)
    assert told.world.digest() == player.world.digest() and told.account == player.session.account
