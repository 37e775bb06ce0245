"""Laws of the gallery: every scene runs in it, can be opened by pointer and by keyboard, and no frame waits for one."""

import threading
import time
from functools import cache

import numpy as np
import pygame
import pytest

from game.play.pages import shipped_scenes
from game.world.scenes.scene import load_scene, scene_names
from game.world.sessions.moment import account_of

kept_scene = cache(load_scene)


@pytest.fixture(autouse=True)
def kept_scenes(monkeypatch):
    """Draw the cells of every shipped scene once, not for every test."""
    monkeypatch.setattr(shipped_scenes, "load_scene", kept_scene)


def looked_at(player):
    """Open the gallery and wait until every small world is made."""
    player.key(pygame.K_F2)
    player.settle()
    return player.parts.gallery


def pictures(player, gallery):
    """Return the pixels of every picture that shows."""
    shown = pygame.surfarray.array3d(player.parts.window.surface)
    rects = {number: gallery._picture_rect(rect) for number, rect in gallery._tiles()}
    return {number: shown[rect.x : rect.right, rect.y : rect.bottom].copy() for number, rect in rects.items()}


def test_every_scene_is_there_with_a_name_and_a_sentence(player):
    gallery = looked_at(player)
    assert len(gallery.shelf) == len(scene_names())
    for number, name in enumerate(scene_names()):
        scene = load_scene(name)
        assert gallery.shelf.name(number) == scene.title and gallery.shelf.about(number) == scene.notice


def test_every_small_world_runs_and_loses_no_grain(player):
    gallery = looked_at(player)
    before = pictures(player, gallery)
    player.wait(60)
    for number, picture in pictures(player, gallery).items():
        name = scene_names()[number]
        life = gallery.shelf._lives[name]
        assert account_of(life.scene.world(), life.scene.rule).balanced(life._world) or life.scene.fixtures
        assert name == "blank" or (picture != before[number]).any(), name


def test_the_sand_goes_on_behind_the_gallery_and_nobody_can_touch_it_there(player):
    gallery = looked_at(player)
    at = player.world.iteration
    for code in (pygame.K_c, pygame.K_s, pygame.K_r, pygame.K_f):
        player.key(code)
    player.click((5, player.parts.window.size[1] - 5))
    assert gallery.shown and player.world.iteration > at and len(player.session.timeline.history.story()) == 0


def test_a_key_held_longer_than_the_page_is_open_does_no_more(player):
    player.key(pygame.K_l)
    gallery = looked_at(player)
    for _ in range(3):
        player.press(pygame.K_ESCAPE)
    assert not gallery.shown and player.parts.plots.shown
    player.release(pygame.K_ESCAPE)
    player.key(pygame.K_ESCAPE)
    assert not player.parts.plots.shown and player.parts.running


def test_the_wheel_scrolls_along_its_own_axis_only(player):
    player.parts.settings.override("ui_scale", 3)
    gallery = looked_at(player)
    gallery._choose(0)
    for right, up, top in ((1, 0, 0), (0, -1, 1), (-1, 0, 1), (0, 1, 0)):
        player.frame(pygame.event.Event(pygame.MOUSEWHEEL, x=right, y=up, flipped=False))
        assert gallery._top == top


@pytest.mark.parametrize("number", [0, 4, len(scene_names()) - 1])
def test_a_scene_is_opened_by_keys_and_by_a_click(player, number):
    gallery = looked_at(player)
    player.key(pygame.K_HOME)
    for _ in range(number):
        player.key(pygame.K_RIGHT)
    player.key(pygame.K_RETURN)
    assert player.session.scene.name == scene_names()[number] and not gallery.shown
    player.parts.sessions.load("paper")
    looked_at(player)
    player.click(gallery.tile(number).center)
    assert player.session.scene.name == scene_names()[number] and not gallery.shown


def test_arrows_reach_every_scene(player):
    gallery = looked_at(player)
    player.key(pygame.K_HOME)
    for number in range(len(scene_names())):
        assert gallery.chosen == number
        player.key(pygame.K_RIGHT)
    player.key(pygame.K_HOME)
    player.key(pygame.K_DOWN)
    below = gallery.chosen
    player.key(pygame.K_UP)
    assert gallery.chosen == 0 and below == gallery._grid()[0]


def test_tab_and_a_click_turn_to_the_saved_scenes(player):
    gallery = looked_at(player)
    player.key(pygame.K_TAB)
    assert gallery.shelf is gallery.shelves[1]
    player.click(gallery.tab(0).center)
    assert gallery.shelf is gallery.shelves[0]
    player.key(pygame.K_ESCAPE)
    assert not gallery.shown and player.parts.running


@pytest.mark.parametrize("size", [(640, 480), (1280, 720), (3840, 2160)])
@pytest.mark.parametrize("scale", [0.75, 1, 1.5, 3])
def test_no_tile_is_cut_or_covered_and_the_chosen_one_is_in_sight(player, size, scale):
    parts = player.parts
    parts.settings.override("ui_scale", scale)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    parts.display.lay_out_anew()
    player.frame()
    gallery = looked_at(player)
    for code in (pygame.K_HOME, pygame.K_END):
        player.key(code)
        tiles = dict(gallery._tiles())
        page = gallery._page()
        assert gallery.chosen in tiles and all(page.contains(rect) for rect in tiles.values())
        rects = list(tiles.values())
        assert all(rect.collidelist(rects[number + 1 :]) == -1 for number, rect in enumerate(rects))
        for stroke, rect, text, kind, *_ in (
            each for each in gallery._strokes(parts.window.surface, []) if len(each) > 4
        ):
            assert parts.window.surface.get_rect().contains(rect), (stroke, text, kind)


def test_a_frame_of_the_gallery_keeps_its_budget(player):
    looked_at(player)
    player.wait(10)
    took = []
    for _ in range(60):
        start = time.thread_time()
        player.frame()
        took.append(time.thread_time() - start)
    assert np.percentile(took, 25) < 0.016


def test_no_world_is_made_for_a_gallery_whose_window_was_closed(player):
    before = set(threading.enumerate())
    player.key(pygame.K_F2)
    player.frame(pygame.event.Event(pygame.QUIT))
    player.parts.close()
    for each in set(threading.enumerate()) - before:
        each.join(timeout=60)  # what reads is left alone, and ends by itself
    assert set(threading.enumerate()) <= before, "and nothing was begun after it"
    assert len(player.parts.gallery.shelf._lives) < len(scene_names())


def test_what_is_said_of_an_empty_shelf_is_all_there_in_a_small_window(player):
    pygame.display.set_mode((640, 480), pygame.RESIZABLE, 32)
    player.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=640, y=480))
    player.key(pygame.K_o, mod=pygame.KMOD_LCTRL)
    player.wait(2)
    gallery, theme = player.parts.gallery, player.parts.display.theme
    said = list(gallery._empty())
    assert " ".join(text for _, _, text, *_ in said) == gallery.shelf.empty
    assert all(theme.width(text, kind) <= rect.width for _, rect, text, kind, *_ in said)
