"""The first window: as large as suits the screen, its cells whole pixels, and never larger than the desktop."""

import pytest

from game.play import loop
from game.play.ui.theme import Theme
from game.play.window.layout import LARGEST, MARGIN, SHARE, Layout, first_scale, first_size, window_size
from game.world.files.settings import Settings
from game.world.looks.view import View
from game.world.scenes.scene import load_scene, scene_names

DESKTOPS = (1280, 800), (1920, 1080), (2560, 1440), (3840, 2160)
SCENES = [name for name in scene_names() if name != "fullhd"]


def cell_in(size, scene, theme):
    """Return the pixels to a cell in a window of that size."""
    sand = Layout(theme, size, panel_shown=True).sand.inflate(-2 * theme.px(MARGIN), -2 * theme.px(MARGIN))
    return View.fit(scene.shape, *sand).cell


@pytest.mark.parametrize("desktop", DESKTOPS)
@pytest.mark.parametrize("name", SCENES)
def test_it_grows_in_whole_cells_to_what_the_screen_has_room_for(name, desktop):
    scene, theme = load_scene(name), Theme(1.0)
    size = first_size(scene, theme, desktop)
    cell = cell_in(size, scene, theme)
    assert cell == int(cell) >= scene.cell
    assert size == window_size(scene, int(cell), theme)
    larger = window_size(scene, int(cell) + 1, theme)
    too_much = larger[0] * larger[1] > SHARE * desktop[0] * desktop[1]
    assert too_much or larger[0] > min(desktop[0] - 24, LARGEST[0]) or larger[1] > min(desktop[1] - 80, LARGEST[1])


@pytest.mark.parametrize("desktop", DESKTOPS[1:])
@pytest.mark.parametrize("name", SCENES)
def test_it_is_never_larger_than_the_desktop_nor_than_frames_can_bear(name, desktop):
    size = first_size(load_scene(name), Theme(1.0), desktop)
    assert all(side < most and side <= largest for side, most, largest in zip(size, desktop, LARGEST, strict=True))


def test_a_scene_that_needs_more_gets_what_it_asks_for():
    scene = load_scene("fullhd")
    assert first_size(scene, Theme(1.0), (3840, 2160)) == window_size(scene, 1, Theme(1.0))


def test_a_large_screen_gets_a_larger_window():
    scene = load_scene("hourglass")
    assert cell_in(first_size(scene, Theme(1.0), (2560, 1440)), scene, Theme(1.0)) == 5 > scene.cell


def test_what_was_remembered_or_asked_for_goes_first(monkeypatch):
    monkeypatch.setattr(loop, "desktop_size", lambda: (2560, 1440))
    scene, settings, theme = load_scene("hourglass"), Settings(), Theme(1.0)
    assert loop._size(scene, settings, None, theme) == first_size(scene, theme, (2560, 1440))
    settings["window_width"], settings["window_height"] = 777, 666
    assert loop._size(scene, settings, None, theme) == (777, 666)
    assert loop._size(scene, settings, 2, theme) == window_size(scene, 2, theme)


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
