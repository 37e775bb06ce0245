"""Laws of the window's glass: it becomes finer with the window, while nobody has touched it, and never else."""

import pygame
import pytest

from game import cli, process
from game.play import loop
from game.play.storage.window_glass import REST_S
from game.world.scenes.scene import load_scene
from tests.play.player import Player
from tests.sweeps import sweep

SMALL, LARGE = (900, 700), (1600, 1000)


@pytest.fixture
def player():
    player = Player("hourglass", SMALL)
    player.parts.window_glass.follow(load_scene("hourglass"), brush_too=False)
    yield player
    player.parts.close()
    pygame.display.quit()


def grow(player, size=LARGE):
    """Give the window another size, and wait until that has been seen to."""
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    player.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
    player.wait(int(60 * REST_S) + 3)


def test_an_untouched_glass_becomes_finer_when_the_window_grows_and_begins_anew(player):
    player.wait(60)
    shape, speed = player.world.shape, player.session.clock.speed
    grow(player)
    assert player.world.shape[0] > shape[0] and player.session.clock.speed > speed
    assert player.session.now < 0.3 * player.session.clock.speed and not player.session.timeline.history.line.before
    assert not player.parts.sessions.can_leave and "finer" in player.parts.notices.text
    view = player.parts.display.sand_view.view
    assert view.cell == 2


def test_it_follows_a_window_that_goes_on_growing_and_not_one_that_shrinks(player):
    shapes = []
    for size in ((1500, 850), LARGE, SMALL):
        grow(player, size)
        shapes.append(player.world.shape[0])
    assert shapes[0] < shapes[1] == shapes[2]


TOUCHES = {
    "paint": lambda player: player.drag(player.pixel(90, 20), player.pixel(100, 30)),
    "flip": lambda player: player.key(pygame.K_f),
    "faster": lambda player: player.key(pygame.K_PLUS),
    "pause": lambda player: player.key(pygame.K_SPACE),
    "timer": lambda player: player.parts.timer.start(),
    "record": lambda player: player.key(pygame.K_g),
    "scene": lambda player: player.parts.sessions.load("funnel"),
}


@sweep("touch", TOUCHES, keep=["paint", "flip", "timer"])
def test_a_glass_that_was_touched_stays(player, touch):
    TOUCHES[touch](player)
    player.wait(2)
    shape, session = player.world.shape, player.session
    grow(player)
    assert player.world.shape == shape and player.session is session


def test_without_being_asked_to_no_glass_follows_the_window(glass):
    shape = glass.world.shape
    grow(glass)
    assert glass.world.shape == shape


def test_the_first_scene_and_a_glass_for_a_time_are_opened_in_cells_that_suit_the_window(player):
    player.parts.sessions.load("funnel")
    grow(player)
    player.parts.sessions.load("hourglass")
    assert player.world.shape[0] > 240
    player.key(pygame.K_z, mod=pygame.KMOD_LCTRL)
    assert player.session.scene.name == "funnel"


def test_the_brush_of_a_first_start_is_as_wide_in_a_fine_glass(player):
    player.parts.sessions.load("funnel")
    grow(player)
    player.parts.sessions.load("hourglass")
    player.parts.window_glass.follow(load_scene("hourglass"), brush_too=True)
    assert player.parts.brush.diameter == round(6 * player.world.shape[0] / 240)


@pytest.mark.parametrize(
    ("words", "suits"),
    [
        ([], True),
        (["--scene", "hourglass", "--p", "0.5"], True),
        (["--timer", "3m"], True),
        (["--size", "90x120"], False),
        (["--cell", "3"], False),
        (["--scene", "paper"], False),
    ],
)
def test_who_asks_for_a_lattice_gets_no_other(monkeypatch, words, suits):
    asked = []
    monkeypatch.setattr(loop, "play", lambda *what, suits: asked.append(suits))
    monkeypatch.setattr(process, "leave_threads", lambda status: status)
    assert cli.main(words) == 0 and asked == [suits]
