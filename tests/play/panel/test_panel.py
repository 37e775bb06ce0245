"""Laws of the layout: nothing overlaps, nothing is cut, everything says what it does and can be done by keyboard alone.

They hold in small and large windows, at every size of the panel, with all folds open and with none.
"""

import itertools

import pygame
import pytest
from PIL import Image

from game import load_rule
from game.play.ui import sliders
from game.play.ui.input import key_name
from game.play.ui.widgets import Ui
from game.world.scenes.scene import load_scene, scene_names
from game.world.sessions.action import SetRule
from tests.play.player import Player
from tests.sweeps import sweep

SIZES = (640, 480), (1280, 720), (3840, 2160)
SCALES = 0.75, 1, 1.5, 3
TINY = (1, 1), (60, 300), (640, 20), (200, 60), (321, 241), (3000, 100)
ESSENTIALS = "Scene", "Gallery", "Tool", "Paint", "Colour", "Size", "p", "Speed", "Pause", "Flip", "Undo", "Restart"
OF_SAND = "Colour", "p"  # what other rules have not


@pytest.fixture
def unfolded(monkeypatch):
    """Let every fold be open."""
    fold = Ui.fold
    monkeypatch.setattr(Ui, "fold", lambda ui, label, is_open, **how: fold(ui, label, True, **how) or True)


def seen(player, size, scale):
    """Show the window in a size and at a scale, with all there is in its panel."""
    parts = player.parts
    parts.settings["sound"] = True
    parts.settings.override("ui_scale", scale)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    player.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
    player.frame()
    return parts.panel.ui


def overlapping(rects):
    """Return the first two of {name: rect} that share a pixel, or None."""
    pairs = itertools.combinations(rects.items(), 2)
    return next(((one, other) for (one, a), (other, b) in pairs if a.colliderect(b)), None)


def check(player, size, scale):
    ui = seen(player, size, scale)
    panel = player.parts.display.layout.panel
    assert overlapping(ui.rects) is None
    assert all(slot.ring.left >= 0 and slot.ring.right <= panel.width for slot in ui.focus.slots.values())
    column = pygame.Rect(panel.x, -(10**6), panel.width, 2 * 10**6)
    written = [each for each in player.written() if column.colliderect(each[0])]
    assert len(written) >= len(ui.rects)
    assert [text for rect, text, kind in written if ui.theme.width(text, kind) > rect.width] == []
    assert [text for rect, text, _ in written if not column.contains(rect)] == []


@pytest.mark.parametrize("scene", ["hourglass", "aquarium"])
def test_the_ends_of_every_slider_have_names(unfolded, monkeypatch, scene):
    player, knobs, draw = Player(scene, (900, 700)), [], sliders._draw_track
    monkeypatch.setattr(sliders, "_draw_track", lambda *how: knobs.append(how[2].knob) or draw(*how))
    player.parts.brush.choose("tap")
    player.key(pygame.K_h, "h")
    player.key(pygame.K_l, "l")
    seen(player, (900, 700), 1)
    words = player.words()
    assert len(knobs) > 9
    for each in knobs:
        assert len(each.ends) == 2 and f"{each.ends[0]} {each.ends[1]}" in words
    player.parts.close()
    pygame.display.quit()


@sweep(("size", "scale"), itertools.product(SIZES, SCALES), keep=[(SIZES[0], 3), (SIZES[1], 0.75)])
def test_no_control_overlaps_another_and_no_word_is_cut(glass, size, scale):
    check(glass, size, scale)


@sweep(("size", "scale"), itertools.product(SIZES, SCALES), keep=[(SIZES[0], 3), (SIZES[1], 0.75)])
def test_nor_with_all_folds_open(glass, size, scale, unfolded):
    check(glass, size, scale)


@sweep("scale", SCALES, keep=[0.75, 3])
@sweep("size", SIZES, keep=SIZES[:2])
def test_the_parts_of_the_window_share_it_without_a_gap(glass, size, scale):
    seen(glass, size, scale)
    layout = glass.parts.display.layout
    parts = {name: getattr(layout, name) for name in ("panel", "sand", "bar", "buttons", "status_line")}
    assert overlapping(parts) is None
    assert sum(rect.width * rect.height for rect in parts.values()) == size[0] * size[1]
    assert layout.sand.width >= size[0] // 2 - 1 and layout.sand.height > size[1] // 2


@sweep("scale", (0.75, 3), keep=[3])
@sweep("size", TINY, keep=[(1, 1), (60, 300)])
def test_no_window_is_too_small_for_what_is_drawn_in_it(glass, tmp_path, size, scale):
    Image.new("RGB", (64, 48), "gold").save(tmp_path / "photo.png")
    seen(glass, size, scale)
    glass.drop(tmp_path / "photo.png")
    for command in ("sand.turn 1", "view.zoom 1", "files.show_scenes", "files.show_scenes", "view.toggle_help"):
        glass.parts.commands.give(command)
        glass.wait(2)
        sand_view, layout, pixels = (
            glass.parts.display.sand_view,
            glass.parts.display.layout,
            glass.parts.window.surface.get_rect(),
        )
        left, top, right, bottom = sand_view.view.seen
        shown = (
            layout.panel,
            layout.sand,
            layout.bar,
            layout.status_line,
            pygame.Rect(left, top, right - left, bottom - top),
        )
        assert all(pixels.contains(rect) and rect.width > 0 < rect.height for rect in shown)
    assert glass.parts.photo_import.shown and glass.parts.help.shown


@sweep("name", scene_names(), keep=["hourglass", "kitchen", "galton"])
def test_what_a_newcomer_reaches_for_is_in_sight_without_scrolling(glass, name):
    scene = load_scene(name)
    glass.parts.sessions.open_scene(scene, 0)
    ui = seen(glass, (1280, 720), 1)
    panel = glass.parts.display.layout.panel
    assert ui.focus.scroll.offset == 0
    essentials = [each for each in ESSENTIALS if scene.rule.codes.is_sand or each not in OF_SAND]
    assert [each for each in essentials if not panel.contains(ui.rects[each])] == []
    tops = [ui.rects[each].y for each in essentials]
    assert tops == sorted(tops)


def test_every_button_of_time_and_window_shows_its_key_clear_of_its_label(glass):
    ui = seen(glass, (1280, 720), 1)
    keys = {
        "Pause": "Space",
        "Flip": "F",
        "Turn left": "Ctrl+F",
        "Turn right": "Shift+F",
        "Undo": "Ctrl+Z",
        "Redo": "Ctrl+Y",
        "Restart": "R",
        "Clear": "C",
        "Step": ".",
    }
    keys |= {
        "Fast": "Right",
        "Run to rest": "End",
        "Run to next grain": "Shift+Right",
        "Full screen": "F11",
        "Keys": "F1",
    }
    written = glass.written()
    for name, key in keys.items():
        inside = [each for each in written if ui.rects[name].contains(each[0])]
        (label, text, kind), (hint, word, small) = sorted(inside, key=lambda each: each[2], reverse=True)
        assert (text, word) == (name, key_name(key))
        assert (label.width + ui.theme.width(text, kind)) // 2 + label.x < hint.right - ui.theme.width(word, small)


def test_every_control_says_what_it_does(glass, unfolded):
    ui = seen(glass, (1280, 720), 1)
    for name, slot in ui.focus.slots.items():
        words = slot.tip.partition("  (")[0]
        assert len(words.split()) >= 2 and words != name and words[0].isupper(), (name, slot.tip)


def test_every_control_is_reached_by_tab_and_comes_into_sight(glass, unfolded):
    ui = seen(glass, (640, 480), 1)
    panel = glass.parts.display.layout.panel
    live, reached = {name for name, slot in ui.focus.slots.items() if slot.live}, []
    for _ in live:
        glass.press(pygame.K_TAB)
        reached.append(ui.focus.name)
        assert panel.contains(ui.rects[ui.focus.name]), ui.focus.name
    assert set(reached) == live


def test_every_control_is_worked_by_keyboard(glass, unfolded, monkeypatch):
    ui = seen(glass, (1000, 700), 1)
    heard = []
    claim = Ui.claim

    def noted(self, name, rect, **how):
        me = claim(self, name, rect, **how)
        heard.extend(me.name for event in me.events if event.kind == "key")
        return me

    monkeypatch.setattr(Ui, "claim", noted)
    for name in [name for name, slot in ui.focus.slots.items() if slot.live]:
        if name not in ui.focus.slots:  # an act before this one took it away
            continue
        ui.focus.take(ui.focus.slots[name].rect.top)
        while ui.focus.name != name:
            glass.press(pygame.K_TAB)
        keys = ui.focus.slots[name].keys
        heard.clear()
        glass.key(next(key for key in (pygame.K_RIGHT, pygame.K_RETURN, pygame.K_DOWN) if key in keys))
        assert name in heard, name
        if glass.parts.stage.on:
            glass.key(pygame.K_F5)  # the panel is away there
        if name == "Copy rule":  # the copy is played as soon as it is there, and has other controls
            glass.settle()
        back(glass)


def back(player):
    """Close what a control has opened."""
    for _ in range(3):
        if (
            player.parts.display.page
            or player.parts.panel.ui.focus.popup
            or any(each.shown for each in player.parts.cards)
        ):
            player.key(pygame.K_ESCAPE)
    if player.parts.window.fullscreen:
        player.parts.commands.view.toggle_fullscreen()
        player.frame()


def test_full_screen_and_back_leaves_the_window_as_it_was(player):
    size = player.parts.window.size
    for _ in range(2):
        player.key(pygame.K_F11)
        player.wait(2)
        assert player.parts.window.size == pygame.display.get_desktop_sizes()[0] != size
        player.key(pygame.K_F11)
        player.wait(2)
        assert player.parts.window.size == size


@pytest.mark.parametrize(("rule", "number"), [("water-and-oil", 5), ("sand", 3)])
@pytest.mark.parametrize("pressed", [False, True])
def test_materials_go_from_under_the_pointer_when_the_rule_has_fewer(pressed, rule, number):
    player = Player("kitchen", (1000, 900))
    player.wait(1)
    last = player.parts_of("Paint")[-2]
    player.move(last.center)
    player.frame()
    player.session.do(SetRule(load_rule(rule)))
    if pressed:
        player.button(pygame.MOUSEBUTTONDOWN, last.center)
        player.button(pygame.MOUSEBUTTONUP, last.center)
    player.wait(2)
    assert player.parts.brush.material in player.parts.brush.materials and len(player.parts_of("Paint")) == number
    player.parts.close()
    pygame.display.quit()
