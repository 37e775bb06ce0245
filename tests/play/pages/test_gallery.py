"""Laws of the gallery: every scene runs in it, can be opened by pointer and by keyboard, and no frame waits for one."""

import threading
import time
from functools import cache
from itertools import product

import numpy as np
import pygame
import pytest

from game.play.pages import shipped_scenes
from game.world.sand.advance import advance
from game.world.scenes.scene import load_scene, scene_names
from game.world.sessions.moment import account_of
from tests.play.player import Player
from tests.sweeps import sweep

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


def tiles(gallery):
    """Return {number: rect} of the tiles that show."""
    rects = {number: gallery.tile(number) for number in range(len(gallery.shelf))}
    return {number: rect for number, rect in rects.items() if rect}


def first_row(gallery):
    """Return the numbers of the tiles in the first row that shows."""
    top = min(rect.y for rect in tiles(gallery).values())
    return [number for number, rect in tiles(gallery).items() if rect.y == top]


def pictures(player, gallery):
    """Return the pixels of every tile that shows, which are the same but for its picture."""
    shown = pygame.surfarray.array3d(player.parts.window.surface)
    return {number: shown[rect.x : rect.right, rect.y : rect.bottom].copy() for number, rect in tiles(gallery).items()}


def test_every_scene_is_there_with_a_name_and_a_sentence(player):
    gallery = looked_at(player)
    assert len(gallery.shelf) == len(scene_names())
    for number, name in enumerate(scene_names()):
        scene = load_scene(name)
        assert gallery.shelf.name(number) == scene.title and gallery.shelf.about(number) == scene.notice


def test_every_small_world_runs_and_loses_no_grain(player, monkeypatch):
    worlds = {}  # as keys' values: the account at the start

    def noted(world, rule, iterations):
        worlds.setdefault(id(world), (world, account_of(world, rule)))
        advance(world, rule, iterations)

    monkeypatch.setattr(shipped_scenes, "advance", noted)
    gallery = looked_at(player)
    before = pictures(player, gallery)
    player.wait(60)
    for number, picture in pictures(player, gallery).items():
        name = scene_names()[number]
        assert name == "blank" or (picture != before[number]).any(), name
    assert len(worlds) == len(scene_names())
    assert all(account.balanced(world) or world.fixtures for world, account in worlds.values())


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
    player.key(pygame.K_HOME)
    assert len(set(first_row(gallery))) < len(tiles(gallery)) or gallery.tile(len(gallery.shelf) - 1) is None
    for right, up, top in ((1, 0, 0), (0, -1, 1), (-1, 0, 1), (0, 1, 0)):
        player.frame(pygame.event.Event(pygame.MOUSEWHEEL, x=right, y=up, flipped=False))
        assert (gallery.tile(0) is None) == top


@sweep("number", [0, 4, len(scene_names()) - 1], keep=[4])
def test_a_scene_is_opened_by_keys_and_by_a_click(player, number):
    gallery = looked_at(player)
    player.key(pygame.K_HOME)
    for _ in range(number):
        player.key(pygame.K_RIGHT)
    player.key(pygame.K_RETURN)
    assert player.session.scene.name == scene_names()[number] and not gallery.shown
    player.parts.sessions.load("paper")
    looked_at(player)
    while gallery.tile(number) is None:  # it is further down
        player.key(pygame.K_RIGHT)
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
    assert gallery.chosen == 0 and below == len(first_row(gallery))


def test_tab_and_a_click_turn_to_the_saved_scenes(player):
    gallery = looked_at(player)
    player.key(pygame.K_TAB)
    assert gallery.shelf is gallery.shelves[1]
    player.click(gallery.tab(0).center)
    assert gallery.shelf is gallery.shelves[0]
    player.key(pygame.K_ESCAPE)
    assert not gallery.shown and player.parts.running


@sweep(
    ("size", "scale"),
    product([(640, 480), (1280, 720), (3840, 2160)], [0.75, 1, 1.5, 3]),
    keep=[((640, 480), 3), ((1280, 720), 0.75)],
)
def test_no_tile_is_cut_or_covered_and_the_chosen_one_is_in_sight(player, size, scale):
    parts = player.parts
    parts.settings.override("ui_scale", scale)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    parts.display.lay_out_anew()
    player.frame()
    gallery = looked_at(player)
    for code in (pygame.K_HOME, pygame.K_END):
        player.key(code)
        window, shown = parts.window.surface.get_rect(), tiles(gallery)
        assert gallery.chosen in shown and all(window.contains(rect) for rect in shown.values())
        rects = list(shown.values())
        assert all(rect.collidelist(rects[number + 1 :]) == -1 for number, rect in enumerate(rects))
        for place, text, _ in player.written():
            assert window.contains(place), text
            assert place.collidelist(rects) < 0 or any(rect.contains(place) for rect in rects), text


def test_a_frame_of_the_gallery_keeps_its_budget(player):
    looked_at(player)
    player.wait(10)
    took = []
    for _ in range(60):
        start = time.thread_time()
        player.frame()
        took.append(time.thread_time() - start)
    assert np.percentile(took, 25) < 0.016


def test_the_scene_that_is_played_is_made_first_and_then_those_around_it(monkeypatch):
    made, life = [], shipped_scenes.Life
    monkeypatch.setattr(shipped_scenes, "Life", lambda name, colours: made.append(name) or life(name, colours))
    player = Player("winter-pond", size=(900, 700))
    gallery = looked_at(player)
    there = scene_names().index("winter-pond")
    assert gallery.chosen == there and len(made) == len(scene_names())
    distances = [abs(scene_names().index(name) - there) for name in made]
    assert distances == sorted(distances)
    pygame.display.quit()


def test_no_world_is_made_for_a_gallery_whose_window_was_closed(player):
    before = set(threading.enumerate())
    player.key(pygame.K_F2)
    player.frame(pygame.event.Event(pygame.QUIT))
    player.parts.close()
    for each in set(threading.enumerate()) - before:
        each.join(timeout=60)  # what reads is left alone, and ends by itself
    assert set(threading.enumerate()) <= before, "and nothing was begun after it"
    shelf = player.parts.gallery.shelf
    assert sum(shelf.about(number) != "" for number in range(len(shelf))) < len(scene_names())


def test_what_is_said_of_an_empty_shelf_is_all_there_in_a_small_window(player):
    pygame.display.set_mode((640, 480), pygame.RESIZABLE, 32)
    player.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=640, y=480))
    player.key(pygame.K_o, mod=pygame.KMOD_LCTRL)
    player.wait(2)
    gallery, theme = player.parts.gallery, player.parts.display.theme
    said = [each for each in player.written() if each[1] and each[1] in gallery.shelf.empty]
    assert " ".join(text for _, text, _ in said) == gallery.shelf.empty
    assert all(theme.width(text, kind) <= rect.width for rect, text, kind in said)
