"""Laws of keeping: what is set in the window is found again at the next start, and no frame waits for it."""

import pygame
import pytest

from game.world.files.paths import config_file
from game.world.files.settings import Settings
from tests.play.player import Player


@pytest.fixture
def remembering():
    """Return a function that starts a Player with the user's settings."""
    yield lambda: Player(settings=Settings.of_user())
    pygame.display.quit()


def test_a_change_is_saved_a_moment_later(remembering):
    player = remembering()
    player.parts.brush.resize(5)
    player.parts.settings["theme"] = "night"
    player.wait(30)
    assert not config_file().exists()
    player.wait(40)
    player.settle()
    again = remembering()
    assert again.parts.brush.diameter == player.parts.brush.diameter != Settings()["brush"]
    assert again.parts.settings["theme"] == "night"


def test_the_size_of_the_window_is_remembered_once_it_was_changed(remembering):
    player = remembering()
    pygame.display.set_mode((800, 640), pygame.RESIZABLE, 32)
    player.frame()
    player.parts.close()
    assert [Settings.of_user()[f"window_{side}"] for side in ("width", "height")] == [800, 640]


def test_the_size_of_a_screen_that_was_filled_is_not_remembered(remembering):
    player = remembering()
    before = [player.parts.settings[f"window_{side}"] for side in ("width", "height")]
    player.key(pygame.K_F11)
    player.wait(1)
    assert player.parts.window.fullscreen and player.parts.window.size != (900, 700)
    assert [player.parts.settings[f"window_{side}"] for side in ("width", "height")] == before


def test_what_changed_last_is_saved_at_the_end(remembering):
    player = remembering()
    player.parts.sessions.now.timeline.memory_mb = 99
    player.frame()
    player.parts.close()
    assert remembering().session.timeline.memory_mb == 99


def test_a_bad_line_is_shown_in_the_window(remembering):
    config_file().parent.mkdir()
    config_file().write_text("theme = 3\n")
    assert "line 1: theme: found 3" in remembering().parts.notices.text


def test_a_folder_that_cannot_be_made_is_told_once_and_the_sand_goes_on(remembering):
    config_file().parent.write_text("in the way")
    player = remembering()
    player.parts.brush.resize(5)
    player.wait(70)
    player.settle()
    assert "cannot save" in player.parts.notices.text
    before = player.world.iteration
    player.wait(10)
    assert player.world.iteration > before


@pytest.mark.parametrize("ends", [False, True])
def test_what_could_not_be_saved_is_saved_with_the_next_change_or_at_the_end(remembering, ends):
    config_file().parent.write_text("in the way")
    player = remembering()
    player.parts.settings["theme"] = "day"
    player.wait(70)
    player.settle()
    config_file().parent.unlink()
    if ends:
        player.parts.close()
    else:
        player.parts.settings["volume"] = 0.25
        player.wait(70)
        player.settle()
    assert Settings.of_user()["theme"] == "day"
