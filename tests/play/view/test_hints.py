"""Laws of hints: at the right moment, once, and not for those who know."""

import pygame
import pytest

from game.play.controls.keymap import CTRL
from game.play.storage.files import demos
from game.play.view.hints import APART_S, HINTS
from game.world.files.settings import Settings
from tests.play.player import Player
from tests.sweeps import sweep

PAINT, FLIP, P, MATERIAL = (hint.words for hint in HINTS)


def said(player, seconds):
    """Return the hints that are shown within so many seconds, in order."""
    heard = []
    for _ in range(int(seconds * 2)):
        player.frame(elapsed_ns=500_000_000)
        text = player.parts.notices.text
        if text in (PAINT, FLIP, P, MATERIAL) and heard[-1:] != [text]:
            heard.append(text)
    return heard


def test_every_hint_comes_at_its_moment_and_never_again(glass):
    assert said(glass, HINTS[0].after_s - 1) == []
    assert said(glass, 160) == [PAINT, P, FLIP]
    glass.parts.commands.sand.restart()
    assert said(glass, 100) == []


def test_hints_seen_are_remembered_at_the_next_start():
    settings = Settings()
    said(Player("hourglass", settings=settings), 30)
    assert settings["hints_seen"] == ("paint",)
    assert said(Player("hourglass", settings=settings), 30) == []
    pygame.display.quit()


def test_who_knows_is_not_told(glass):
    glass.click(glass.pixel(110, 170))
    glass.key(pygame.K_f)
    glass.click(glass.control("p", 0.3))
    assert said(glass, 120) == []
    assert set(glass.parts.settings["hints_seen"]) == {hint.name for hint in HINTS if hint.of_sand is not False}


def test_under_a_rule_of_many_materials_the_hint_is_of_them_and_not_of_p():
    player = Player("aquarium")
    assert set(said(player, 60)) >= {PAINT, MATERIAL} and P not in said(player, 60)
    pygame.display.quit()


@sweep("elsewhere", ["gallery", "help", "stage"], keep=["gallery", "stage"])
def test_a_hint_goes_with_the_window_that_it_is_about(glass, elsewhere):
    assert said(glass, HINTS[0].after_s + 1) == [PAINT]
    go = {
        "gallery": lambda: glass.parts.gallery.toggle(0),
        "help": glass.parts.help.toggle,
        "stage": glass.parts.stage.toggle,
    }
    go[elsewhere]()
    glass.wait(2)
    assert glass.parts.notices.text != PAINT


def test_what_is_done_in_a_replay_is_not_known_to_who_looks_on(glass):
    for name in demos():
        glass.parts.files.play_demo(name)
        glass.settle()
        glass.wait(3)
    assert glass.parts.settings["hints_seen"] == ()
    glass.key(pygame.K_f)
    assert glass.parts.settings["hints_seen"] == ("flip",)


@sweep("code", [pygame.K_F1, pygame.K_F2], keep=[pygame.K_F1])
def test_no_hint_is_shown_behind_a_page(glass, code):
    glass.key(code)
    assert said(glass, 20) == []
    glass.key(code)
    assert said(glass, 2) == [PAINT]


def test_who_has_seen_the_page_of_a_material_is_not_told_of_it():
    player = Player("kitchen")
    player.parts.material_page.toggle()
    player.frame()
    assert player.parts.settings["hints_seen"] == ("material",)
    player.parts.close()
    pygame.display.quit()


def test_hints_keep_their_distance(glass):
    glass.parts.settings["hints_seen"] = ("flip",)
    glass.frame(elapsed_ns=0)
    glass.now_s += 60
    assert said(glass, APART_S - 1) == [PAINT] and said(glass, 3) == [P]


def test_an_empty_lattice_that_rests_needs_no_flip(player):
    player.parts.settings["hints_seen"] = ("paint", "p")
    assert said(player, 20) == []
    player.key(pygame.K_z, mod=CTRL)
    assert player.parts.settings["hints_seen"] == ("paint", "p")


@pytest.mark.parametrize(("size", "scale", "cramped"), [((1280, 720), 2, True), ((1920, 1080), 1, False)])
def test_where_worlds_have_little_room_the_key_that_makes_some_is_named_once(size, scale, cramped):
    player = Player("hourglass", (900, 700))
    player.parts.settings["hints_seen"] = tuple(hint.name for hint in HINTS)
    player.parts.settings.override("ui_scale", scale)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    player.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
    player.key(pygame.K_h, "H", pygame.KMOD_SHIFT)
    player.now_s += 60
    player.wait(3)
    assert ("P hides the panel" in (player.parts.notices.text or "")) == cramped
    player.now_s += 60
    player.wait(3)
    assert player.parts.notices.text is None
    player.parts.close()
    pygame.display.quit()
