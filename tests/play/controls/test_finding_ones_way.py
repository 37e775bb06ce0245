"""Laws of finding one's way: the buttons at the sand's edge do what their keys do; the map shows and moves the view."""

import numpy as np
import pygame
import pytest

from game.play.controls import keymap
from game.play.controls.view_buttons import BUTTONS
from tests.play.panel.test_panel import seen
from tests.play.player import Player, words_of
from tests.sweeps import sweep

WINDOWS = ((640, 480), 1), ((1280, 720), 1), ((1280, 720), 2), ((3840, 2160), 1.5)
ZOOM_OUT, ZOOM_IN, ALL, SCREEN = range(4)


@pytest.fixture
def still(glass):
    glass.hold_time()
    return glass


def press(player, number):
    player.click(player.parts.view_buttons.places[number].center)
    player.frame()


def view(player):
    return player.parts.display.sand_view.view


def zoomed(player, levels=4):
    for _ in range(levels):
        press(player, ZOOM_IN)
    return player.parts.minimap.rect


def middle(player):
    """Return the place of the lattice in the middle of the sand."""
    return view(player).place(*player.parts.display.sand_view.area.center)


@sweep(("size", "scale"), WINDOWS, keep=[WINDOWS[0], WINDOWS[-1]])
def test_the_buttons_zoom_about_the_middle_and_show_all_again(still, size, scale):
    seen(still, size, scale)
    whole, before = view(still).cell, middle(still)
    press(still, ZOOM_IN)
    press(still, ZOOM_IN)
    larger = view(still).cell
    assert larger > whole and middle(still) == pytest.approx(before, abs=2)
    press(still, ZOOM_OUT)
    assert whole < view(still).cell < larger
    press(still, ALL)
    assert view(still) == still.parts.display.sand_view.whole


def test_the_button_of_the_screen_fills_it_and_leaves_it(player):
    size = player.parts.window.size
    press(player, SCREEN)
    player.wait(2)
    assert player.parts.window.fullscreen and player.parts.window.size == pygame.display.get_desktop_sizes()[0]
    press(player, SCREEN)
    player.wait(2)
    assert player.parts.window.size == size


def test_no_button_paints_or_moves_time(still):
    grains, now = still.world.grains, still.session.now
    for place in still.parts.view_buttons.places[:3]:
        still.click(place.center)
        still.drag(place.center, button=3)
    assert (still.world.grains, still.session.now) == (grains, now)


def test_every_button_says_what_it_does_and_the_key_that_does_it_too(still):
    commands = {key.command for key in keymap.KEYS}
    for number, (command, meaning, key, _) in enumerate(BUTTONS):
        assert command in commands
        still.move(still.parts.view_buttons.places[number].center)
        still.frame()
        said = [text for _, text, _ in still.written()]
        assert f"{meaning}  ({key})" in said
    still.move((5, 5))
    still.frame()
    assert not still.parts.view_buttons.words


@sweep(("size", "scale"), WINDOWS, keep=[WINDOWS[0], WINDOWS[-1]])
def test_the_map_is_there_only_while_a_part_is_in_sight_and_leaves_most_of_the_sand_free(still, size, scale):
    seen(still, size, scale)
    assert not still.parts.minimap.shown
    rect, area = zoomed(still), still.parts.display.sand_view.area
    assert still.parts.minimap.shown and area.contains(rect)
    assert rect.width * rect.height < area.width * area.height / 9
    assert rect.height / rect.width == pytest.approx(240 / 180, rel=0.05)
    press(still, ALL)
    assert not still.parts.minimap.shown


def test_the_map_shows_the_world_as_it_is(still):
    still.parts.commands.sand.clear()
    rect = zoomed(still)
    dark = pygame.surfarray.array3d(still.parts.window.surface.subsurface(rect)).astype(int)
    still.parts.commands.time.undo()
    still.wait(1)
    lit = pygame.surfarray.array3d(still.parts.window.surface.subsurface(rect)).astype(int)
    changed = np.abs(lit - dark).sum(axis=2).T > 60
    height = len(changed)
    assert changed[: height // 2].mean() > 0.2 and changed[height // 2 + 3 :].mean() < 0.02


def test_a_press_on_the_map_shows_that_place_and_a_drag_goes_on_from_there(still):
    rect, grains = zoomed(still), still.world.grains
    for share in ((0.5, 0.5), (0.4, 0.7), (0.6, 0.3)):
        pos = int(rect.x + share[0] * rect.width), int(rect.y + share[1] * rect.height)
        still.click(pos)
        still.frame()
        assert middle(still) == pytest.approx((share[0] * 180, share[1] * 240), abs=3)
    start = rect.center
    still.drag(start, (start[0] + 5, start[1] + 20), (start[0], rect.top + 20))
    assert middle(still)[1] == pytest.approx(20 / rect.height * 240, abs=25)
    assert still.world.grains == grains and view(still).cell > 5


def test_a_drag_that_leaves_the_map_stays_with_it_and_lets_go(still):
    rect = zoomed(still)
    still.drag(rect.center, (rect.x - 100, rect.y - 100))
    corner = view(still)
    assert corner.place(*still.parts.display.sand_view.area.topleft) == pytest.approx((0, 0), abs=1)
    still.move(rect.center)
    assert view(still) == corner


def test_the_keys_move_what_the_map_outlines(still):
    zoomed(still)
    before = still.parts.minimap._in_sight(still.parts.minimap.rect)
    still.key(pygame.K_DOWN, mod=pygame.KMOD_LCTRL)
    after = still.parts.minimap._in_sight(still.parts.minimap.rect)
    assert after.y > before.y and after.x == before.x


def test_on_the_map_there_is_no_brush(still):
    rect = zoomed(still)
    still.move(rect.center)
    still.frame()
    assert still.app._marks(view(still)) == ()


def test_the_map_of_a_comparison_moves_all_its_worlds():
    player = Player("hourglass", (1600, 900))
    player.hold_time()
    player.key(pygame.K_h, mod=pygame.KMOD_LSHIFT)
    player.wait(3)
    rect = zoomed(player)
    player.click((rect.centerx, rect.bottom - 5))
    player.frame()
    assert middle(player)[1] > 150
    player.parts.close()
    pygame.display.quit()


def test_the_size_of_a_cell_is_said_for_a_moment(still):
    zoomed(still, 2)
    still.move((5, 5))
    still.frame()
    assert any("px per cell" in text for _, text, _ in words_of(still.drawn()))
    still.wait(90)
    assert not still.parts.camera.badge.words
