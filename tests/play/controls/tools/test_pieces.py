"""Pieces of the world in a player's hands: selected, moved, copied, stamped, mirrored and turned."""

import numpy as np
import pygame
import pytest

from game.world.sand.fixtures import Fixture
from game.world.sand.stamp import cut_out
from game.world.scenes.scene import load_scene
from game.world.sessions.action import Load, Paint, SetFixtures
from game.world.sessions.recording import parse
from game.world.sessions.session import Session
from tests.saved import recording_of, to_bytes

CTRL, SHIFT = pygame.KMOD_LCTRL, pygame.KMOD_LSHIFT
BOX = (20, 10, 50, 24)  # of what `drawn` draws, and a little around it


@pytest.fixture
def drawn(player):
    """Return a player of the blank scene, with coloured sand, a wall and a tap in BOX, for whom time stands still."""
    player.hold_time()
    player.session.do(Paint("sand", (24, 14), (40, 15), 5, colour="teal"))
    player.session.do(Paint("wall", (30, 21), (47, 21), 3))
    player.session.do(SetFixtures((Fixture("tap", 22, 19, 2),)))
    return player


def select(player, box=BOX):
    player.key(pygame.K_s, mod=SHIFT)
    player.drag(player.pixel(*box[:2]), player.pixel(box[2] - 1, box[3] - 1))
    assert player.parts.brush.selection.box == box


def select_by_cursor(player, box=BOX):
    """Select by the keyboard alone."""
    player.key(pygame.K_k)
    player.key(pygame.K_s, mod=SHIFT)
    go(player, box[:2])
    player.press(pygame.K_RETURN)
    go(player, (box[2] - 1, box[3] - 1))
    player.release(pygame.K_RETURN)
    assert player.parts.brush.selection.box == box


def go(player, place):
    """Lead the keyboard cursor to a cell."""
    while True:
        here = tuple(int(part) for part in player.parts.cursor.place)
        away = place[0] - here[0], place[1] - here[1]
        if away == (0, 0):
            return
        axis = 0 if away[0] else 1
        code = ((pygame.K_LEFT, pygame.K_RIGHT), (pygame.K_UP, pygame.K_DOWN))[axis][away[axis] > 0]
        player.press(code, mod=SHIFT if abs(away[axis]) >= 10 else 0)
        player.release(code)


def piece(player, box=BOX):
    return cut_out(player.world, box)


def is_empty(stamp):
    return not stamp.cells.any() and not stamp.fixtures


def moved(box, right, down):
    return box[0] + right, box[1] + down, box[2] + right, box[3] + down


def is_told(player):
    """Return whether the session is the same once more from its file, with books that balance."""
    recording, _ = parse(to_bytes(recording_of(player.session)), "file")
    told = Session.retold(recording)
    told.seek(recording.end)
    assert recording.problem is None
    return told.world.digest() == player.world.digest() and told.account.balanced(told.world)


@pytest.mark.parametrize("by", ["mouse", "keyboard"])
def test_what_is_selected_is_dragged_along(drawn, by):
    before, world = piece(drawn), drawn.world.digest()
    if by == "mouse":
        select(drawn)
        drawn.drag(drawn.pixel(30, 15), drawn.pixel(60, 30), drawn.pixel(65, 45))
    else:
        select_by_cursor(drawn)
        go(drawn, (30, 15))
        drawn.press(pygame.K_RETURN)
        go(drawn, (65, 45))
        drawn.release(pygame.K_RETURN)
    assert piece(drawn, moved(BOX, 35, 30)) == before and is_empty(piece(drawn))
    assert drawn.parts.brush.selection.box == moved(BOX, 35, 30)
    assert is_told(drawn)
    drawn.key(pygame.K_z, mod=CTRL)
    assert drawn.world.digest() == world


@pytest.mark.parametrize("by", ["mouse", "keyboard"])
def test_what_was_copied_is_stamped_as_often_as_asked_for(drawn, by):
    before = piece(drawn)
    if by == "mouse":
        drawn.click(drawn.parts_of("Tool")[10].center)
        drawn.drag(drawn.pixel(*BOX[:2]), drawn.pixel(BOX[2] - 1, BOX[3] - 1))
        drawn.click(drawn.parts_of("Copy")[0].center)
        drawn.click(drawn.parts_of("Tool")[11].center)
        for place in ((30, 50), (80, 70)):
            drawn.click(drawn.pixel(*place))
    else:
        select_by_cursor(drawn)
        drawn.key(pygame.K_c, mod=CTRL)
        drawn.key(pygame.K_v, mod=CTRL)
        for place in ((30, 50), (80, 70)):
            go(drawn, place)
            drawn.key(pygame.K_RETURN)
    assert piece(drawn) == before
    for column, row in ((30, 50), (80, 70)):
        left, top = column - 15, row - 7
        assert piece(drawn, (left, top, left + 30, top + 14)) == before
    assert len(drawn.world.fixtures) == 3 and is_told(drawn)
    drawn.key(pygame.K_z, mod=CTRL)
    assert is_empty(piece(drawn, (65, 63, 95, 77))) and not is_empty(piece(drawn, (15, 43, 45, 57)))


def test_what_is_cut_is_gone_and_can_be_put_back(drawn):
    before, world = piece(drawn), drawn.world.digest()
    select(drawn)
    drawn.key(pygame.K_x, mod=CTRL)
    assert is_empty(piece(drawn)) and not drawn.world.fixtures and drawn.session.account.balanced(drawn.world)
    drawn.key(pygame.K_v, mod=CTRL)
    drawn.click(drawn.pixel(BOX[0] + 15, BOX[1] + 7))
    assert piece(drawn) == before and drawn.world.digest() == world
    drawn.key(pygame.K_s, mod=SHIFT)
    drawn.drag(drawn.pixel(20, 10), drawn.pixel(49, 23))
    drawn.key(pygame.K_DELETE)
    assert is_empty(piece(drawn)) and is_told(drawn)


@pytest.mark.parametrize("by", ["key", "button"])
def test_what_is_selected_is_mirrored_and_turned_where_it_is(drawn, by):
    def give(name, code):
        drawn.key(code, mod=SHIFT) if by == "key" else drawn.click(drawn.parts_of(name)[0].center)

    before, world = piece(drawn), drawn.world.digest()
    select(drawn)
    give("Mirror", pygame.K_x)
    assert piece(drawn) == before.mirrored()
    give("Mirror", pygame.K_x)
    assert piece(drawn) == before
    give("Turn", pygame.K_e)
    assert piece(drawn, drawn.parts.brush.selection.box) == before.turned(1)
    for _ in range(3):
        give("Turn", pygame.K_e)
    assert drawn.parts.brush.selection.box == BOX and drawn.world.digest() == world and is_told(drawn)


def test_a_stamp_in_hand_is_mirrored_and_turned_before_it_is_put_down(drawn):
    before = piece(drawn)
    select(drawn)
    drawn.key(pygame.K_c, mod=CTRL)
    drawn.key(pygame.K_v, mod=CTRL)
    drawn.key(pygame.K_x, mod=SHIFT)
    drawn.click(drawn.parts_of("Turn")[0].center)
    drawn.click(drawn.pixel(80, 60))
    assert piece(drawn, (73, 45, 87, 75)) == before.mirrored().turned(1)


def test_air_is_stamped_only_if_asked_for(drawn):
    select(drawn, (60, 60, 80, 80))
    drawn.key(pygame.K_c, mod=CTRL)
    drawn.key(pygame.K_v, mod=CTRL)
    drawn.click(drawn.pixel(35, 17))
    assert not is_empty(piece(drawn))
    drawn.click(drawn.parts_of("Stamp its air too")[0].center)
    drawn.click(drawn.pixel(35, 17))
    assert not piece(drawn, (25, 7, 45, 27)).cells.any()


def test_a_stamp_lands_under_another_rule_by_the_names_of_its_materials(drawn):
    select(drawn)
    drawn.key(pygame.K_c, mod=CTRL)
    stamp, scene = drawn.parts.brush.selection.copied.stamp, load_scene("kitchen")
    drawn.session.do(Load(scene, 0))
    drawn.wait(2)
    drawn.hold_time()
    drawn.key(pygame.K_v, mod=CTRL)
    drawn.click(drawn.pixel(60, 40))
    left, top = 60 - 15, 40 - 7
    landed = piece(drawn, (left, top, left + 30, top + 14)).cells
    assert (landed[stamp.cells == 2] == scene.rule.codes.wall).all()
    names = scene.rule.materials
    if "sand" in names:
        assert (landed[stamp.cells == 1] == names.index("sand")).all()
    assert drawn.session.account.balanced(drawn.world)


def test_a_click_and_escape_select_nothing(drawn):
    for end in (lambda: drawn.click(drawn.pixel(90, 80)), lambda: drawn.key(pygame.K_ESCAPE)):
        select(drawn)
        end()
        assert drawn.parts.brush.selection.box is None
    select(drawn)
    drawn.key(pygame.K_c, mod=CTRL)
    drawn.key(pygame.K_v, mod=CTRL)
    drawn.key(pygame.K_ESCAPE)
    assert drawn.parts.brush.tool == "select" and not drawn.parts.brush.selects


def test_without_a_selection_the_keys_say_how_to_get_one(drawn):
    before = drawn.world.digest()
    for code, mod in ((pygame.K_c, CTRL), (pygame.K_x, CTRL), (pygame.K_v, CTRL), (pygame.K_x, SHIFT)):
        drawn.parts.notices.say("")
        drawn.key(code, mod=mod)
        assert "Shift+S" in drawn.parts.notices.text
    drawn.key(pygame.K_DELETE)
    assert drawn.world.digest() == before


def test_all_is_selected_and_what_is_selected_does_not_outlast_its_lattice(drawn):
    drawn.key(pygame.K_a, mod=CTRL)
    height, width = drawn.world.shape
    assert drawn.parts.brush.selection.box == (0, 0, width, height)
    drawn.key(pygame.K_f, mod=SHIFT)
    assert drawn.parts.brush.selection.box is None


def test_a_piece_is_let_go_of_where_another_lattice_comes_meanwhile(drawn):
    drawn.key(pygame.K_f, mod=SHIFT)
    drawn.wait(60)
    select(drawn)
    drawn.button(pygame.MOUSEBUTTONDOWN, drawn.pixel(30, 15))
    drawn.move(drawn.pixel(50, 30))
    drawn.key(pygame.K_z, mod=CTRL)
    before = drawn.world.digest()
    drawn.move(drawn.pixel(60, 40))
    drawn.button(pygame.MOUSEBUTTONUP, drawn.pixel(60, 40))
    assert drawn.world.digest() == before and not drawn.parts.brush.selection.box


def test_the_stamp_is_seen_where_it_would_land(drawn):
    select(drawn)
    drawn.key(pygame.K_c, mod=CTRL)
    drawn.key(pygame.K_v, mod=CTRL)
    drawn.move(drawn.pixel(80, 60))
    surface = drawn.parts.window.surface
    stamp = drawn.parts.brush.selection.copied.stamp
    seen = [surface.get_at(drawn.pixel(65 + column, 53 + row))[:3] for row, column in np.argwhere(stamp.cells)]
    drawn.click(drawn.pixel(80, 60))
    drawn.key(pygame.K_d)
    drawn.pointer = None
    drawn.frame()
    there = [surface.get_at(drawn.pixel(65 + column, 53 + row))[:3] for row, column in np.argwhere(stamp.cells)]
    assert np.abs(np.array(seen) - there).mean() < 12
