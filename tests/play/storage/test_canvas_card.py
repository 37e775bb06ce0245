"""A canvas of one's own: made, and given another size, by keys alone and by the mouse alone."""

import numpy as np
import pygame
import pytest

from game.world.sessions.action import ANCHORS, Paint
from game.world.sessions.recording import parse
from game.world.sessions.session import Session
from tests.saved import recording_of, to_bytes
from tests.sweeps import sweep

CTRL = pygame.KMOD_LCTRL


def pick(player, name, number):
    """Open a list of the card and click an option in it, turned to by the wheel."""
    player.click(player.parts.canvas_card.ui.rects[name].center)
    player.frame()
    popup = player.parts.canvas_card.ui.focus.popup
    player.move(part(player, name, 0))
    while not popup.first <= number < popup.first + popup.shown:
        player.frame(pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=popup.first - number))
    player.click(part(player, name, number - popup.first))


@pytest.fixture
def still(player):
    """Return a player of the blank scene, with some sand on it, for whom time stands still."""
    player.hold_time()
    player.session.do(Paint("sand", (20, 20), (90, 60), 9))
    return player


def type_in(player, text):
    for sign in text:
        player.key(ord(sign), sign)


def press(player, name):
    """Press a button of the card with the mouse."""
    player.frame()
    player.click(player.parts.canvas_card.ui.rects[name].center)


def part(player, name, number):
    return player.parts.canvas_card.ui.parts(name)[number].center


def test_a_canvas_is_made_by_keys_alone(still):
    before = still.world.digest()
    still.key(pygame.K_n, mod=CTRL)
    type_in(still, "70")
    still.key(pygame.K_TAB)
    type_in(still, "50")
    still.key(pygame.K_RETURN)
    still.settle()
    assert still.world.shape == (50, 70) and not still.world.materials.any()
    assert still.session.scene.title == "Canvas 70×50" and not still.parts.canvas_card.shown
    still.key(pygame.K_z, mod=CTRL)
    assert still.world.digest() == before


def test_a_canvas_that_fills_the_window_is_made_by_the_mouse_alone(still):
    rule = still.session.rule
    still.click(still.parts_of("New")[0].center)
    still.frame()
    card = still.parts.canvas_card.ui
    track = card.parts("Cell size")[0]
    still.drag(track.center, (track.left, track.centery))
    press(still, "Fill the window")
    press(still, "Walls around")
    press(still, "Create")
    still.settle()
    still.frame()
    view, walls = still.parts.display.sand_view.view, still.world.walls
    assert view.cell == 1 and view.width > 0.9 * still.parts.display.layout.sand.width
    assert walls[0].all() and walls[-1].all() and walls[:, 0].all() and walls[:, -1].all()
    assert not walls[9:-9, 9:-9].any() and still.session.rule == rule


def test_a_canvas_can_be_of_another_rule(still):
    still.click(still.parts_of("New")[0].center)
    still.frame()
    pick(still, "Rule", [*still.parts.rule_files.labels].index("Water and oil"))
    press(still, "Create")
    still.settle()
    assert still.session.rule.definition.name == "water-and-oil" and still.world.shape == (90, 120)


@sweep("typed", ["0", "-3", "99999", "wide", "1e3", ""], keep=["0", "99999", "wide"])
def test_a_size_that_no_lattice_has_costs_one_line(still, typed):
    before = still.world.digest()
    still.key(pygame.K_r, mod=CTRL)
    type_in(still, typed) if typed else still.key(pygame.K_BACKSPACE)
    still.key(pygame.K_RETURN)
    found = int(typed) if typed.lstrip("-").isdigit() else repr(typed)
    assert f"width must be a whole number in [1, 16384] cells, got {found}" in still.words()
    still.key(pygame.K_ESCAPE)
    assert still.world.digest() == before and not still.parts.canvas_card.shown


@pytest.mark.parametrize("by", ["mouse", "keyboard"])
def test_another_size_keeps_what_is_on_the_canvas_and_is_told_by_the_replay(still, by):
    before, cells = still.world.digest(), still.world.materials
    if by == "keyboard":
        still.key(pygame.K_r, mod=CTRL)
        type_in(still, "60")
        for code in (
            *[pygame.K_TAB] * 4,
            pygame.K_RETURN,
            pygame.K_END,
            pygame.K_RETURN,
            pygame.K_TAB,
            pygame.K_RETURN,
        ):
            still.key(code)
    else:
        still.click(still.parts_of("New")[0].center)
        still.frame()
        still.click(part(still, "Canvas", 1))
        still.click(still.parts.canvas_card.ui.rects["Width"].center)
        type_in(still, "60")
        still.frame()
        pick(still, "Keep", list(ANCHORS).index("right"))
        press(still, "Resize")
    assert still.world.shape == (90, 60) and (still.world.materials == cells[:, 60:]).all()
    cut = int((cells[:, :60] == 1).sum())
    assert cut and still.session.account.erased == cut and still.session.account.balanced(still.world)
    assert f"{cut} grains were cut off" in still.parts.notices.text
    recording, _ = parse(to_bytes(recording_of(still.session)), "file")
    told = Session.retold(recording)
    told.seek(recording.end)
    assert told.world.digest() == still.world.digest()
    still.key(pygame.K_z, mod=CTRL)
    assert still.world.digest() == before


def test_what_is_typed_gives_no_command(still):
    still.key(pygame.K_n, mod=CTRL)
    type_in(still, "c .[p")
    assert still.world.grains and still.parts.display.panel_shown and still.parts.canvas_card.shown
    still.key(pygame.K_ESCAPE)
    assert not still.parts.canvas_card.shown and np.any(still.world.sand)
