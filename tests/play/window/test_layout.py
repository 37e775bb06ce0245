"""The layout: every part has a place of its own, and the first window is as large as suits the screen."""

import sys
from functools import cache
from itertools import combinations, product

import pygame
import pytest

from game.play import loop
from game.play.ui.theme import Theme
from game.play.window.layout import LARGEST, WindowLayout, first_scale, first_size, fitting_scale, window_size
from game.play.window.window import Window
from game.world.files.settings import Settings
from game.world.looks.view import View
from game.world.scenes import scene
from game.world.scenes.scene import scene_names
from tests.sweeps import sweep

DESKTOPS = (640, 480), (1280, 720), (1280, 800), (1920, 1080), (2560, 1440), (3840, 2160), (7680, 4320)
load_scene = cache(scene.load_scene)  # which takes longer than to lay one out
SCENES = [name for name in scene_names() if name != "fullhd"]


@pytest.mark.parametrize("desktop", DESKTOPS)
@sweep("name", scene_names(), keep=["hourglass", "fullhd", "city"])
def test_the_window_and_its_decorations_fit_every_desktop(name, desktop):
    width, height = first_size(load_scene(name), Theme(1.0), desktop)
    assert width <= desktop[0] - 16 and height <= desktop[1] - 64


@pytest.mark.parametrize("desktop", [(1920, 1080), (2560, 1440), (3840, 2160)])
@sweep("name", SCENES, keep=["hourglass", "tower", "blank"])
def test_it_takes_four_fifths_of_a_large_desktop(name, desktop):
    width, height = first_size(load_scene(name), Theme(1.0), desktop)
    assert width >= 0.79 * desktop[0] and height >= 0.79 * (desktop[1] - 64)


def test_on_a_small_desktop_the_glass_has_the_height_that_there_is():
    assert first_size(load_scene("hourglass"), Theme(1.0), (1280, 720))[1] == 720 - 64


def test_no_first_window_is_larger_than_frames_can_bear():
    assert first_size(load_scene("hourglass"), Theme(1.0), (7680, 4320)) == LARGEST


def test_the_whole_window_is_on_a_screen_of_480_rows(monkeypatch):
    monkeypatch.setattr(pygame.display, "get_desktop_sizes", lambda: [(640, 480)])
    window = Window((900, 700))
    assert window.size[1] <= 480 - 64
    pygame.display.quit()


def test_what_was_remembered_or_asked_for_goes_first(monkeypatch):
    monkeypatch.setattr(loop, "desktop_size", lambda: (2560, 1440))
    monkeypatch.setattr(loop, "Window", lambda size, fullscreen: sys.exit(size))
    scene, settings, theme = load_scene("hourglass"), Settings(), Theme(1.0)

    def opened(cell=None):
        with pytest.raises(SystemExit) as window:
            loop.play(scene, settings, cell=cell)
        return window.value.code

    assert opened() == first_size(scene, theme, (2560, 1440))
    settings["window_width"], settings["window_height"] = 777, 666
    assert opened() == (777, 666) and opened(cell=2) == window_size(scene, 2, theme)


@pytest.mark.parametrize(("desktop", "scale"), [((1920, 1080), 1.0), ((2560, 1440), 1.0), ((3840, 2160), 1.5)])
def test_a_screen_of_small_pixels_begins_with_a_larger_panel(desktop, scale):
    assert first_scale(desktop) == scale


def test_what_was_set_is_known_from_what_was_not(tmp_path):
    settings = Settings(tmp_path / "settings.toml")
    assert not settings.has("ui_scale")
    settings.override("ui_scale", 1.0)
    assert settings.has("ui_scale")
    kept = Settings(tmp_path / "settings.toml")
    kept["ui_scale"] = 1.25
    kept.take_unsaved()()
    assert Settings(tmp_path / "settings.toml").has("ui_scale")


@pytest.mark.parametrize("size", [(320, 240), (640, 480), (1280, 720), (1366, 768), (1920, 1080), (3840, 2160)])
@sweep("scale", [0.75, 1, 1.5, 2, 3], keep=[0.75, 3])
@pytest.mark.parametrize("shape", [(240, 180), (61, 61), (90, 400), (1080, 1920)])
def test_all_parts_have_a_place_of_their_own(size, scale, shape):
    theme, window = Theme(fitting_scale(scale, size)), pygame.Rect(0, 0, *size)
    for panel, plotted, legend, figures in product((True, False), repeat=4):
        cards = ("legend",) * legend + ("figures",) * figures
        layout = WindowLayout(theme, size, panel, shape, plotted, cards)
        assert set(layout.cards) == set(cards)
        rects = [
            layout.sand,
            layout.bar,
            layout.buttons,
            layout.status_line,
            *layout.cards.values(),
            *[layout.panel] * panel,
        ]
        rects += [layout.plots] if layout.plots else []
        assert all(window.contains(rect) and min(rect.size) > 0 for rect in rects)
        assert not any(one.colliderect(other) for one, other in combinations(rects, 2))


@pytest.mark.parametrize("cards", [("legend",), ("figures",), ("legend", "figures")])
def test_cards_beside_a_glass_leave_it_where_it_is(cards):
    theme, shape = Theme(1.0), (240, 180)
    alone, with_cards = (WindowLayout(theme, (1280, 720), True, shape, cards=each).sand for each in ((), cards))
    assert View.fit(shape, *alone) == View.fit(shape, *with_cards)


def test_plots_stand_where_worlds_side_by_side_are_largest():
    """A single glass is higher than wide; four of them in a row are wider than high."""
    theme, size, shape = Theme(2), (1920, 1080), (240, 180)
    one, four = (
        WindowLayout(theme, size, False, shape, plotted=True, on_stage=True, board=170, worlds=worlds)
        for worlds in (1, 4)
    )
    assert one.plots.height > one.plots.width and four.plots.width > four.plots.height
