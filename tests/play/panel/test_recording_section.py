"""Recording by mouse alone and by keyboard alone: the format is chosen, the film begins, ends and is there."""

import pygame
import pytest
from PIL import Image

from game.play.storage.films import mp4
from game.world.files.paths import folder_of
from tests.play.player import Player


@pytest.fixture
def recorded():
    """Return a function that returns the one recording as (format, number of frames)."""

    def found():
        (path,) = folder_of("pictures").iterdir()
        with Image.open(path) as image:
            return image.format, image.n_frames

    return found


def walk(player, name):
    """Go by Tab to a control of the panel."""
    ui = player.parts.panel.ui
    for _ in range(len(ui.focus.slots)):
        if ui.focus.name == name:
            return
        player.key(pygame.K_TAB)
    raise AssertionError(f"no Tab leads to {name}")


def test_by_mouse_alone_a_recording_of_another_format_is_made(glass, recorded):
    glass.unfold("Recording and past")
    glass.click(glass.parts_of("Format")[1].center)
    assert glass.parts.settings["recording"] == "webp"
    glass.click(glass.control("Record"))
    glass.wait(30)
    assert "kB" in glass.parts.recorder.said
    glass.click(glass.control("Record"))
    glass.settle()
    kind, frames = recorded()
    assert kind == "WEBP" and frames > 5


def test_by_keyboard_alone_a_recording_of_another_format_is_made(glass, recorded):
    for _ in range(4):
        glass.key(pygame.K_PAGEDOWN, mod=pygame.KMOD_LCTRL)
    walk(glass, "Recording and past")
    glass.key(pygame.K_RETURN)
    walk(glass, "Format")
    glass.key(pygame.K_RIGHT)
    assert glass.parts.settings["recording"] == "webp"
    walk(glass, "Last 10 s")
    glass.wait(30)
    glass.key(pygame.K_RETURN)
    glass.settle()
    kind, frames = recorded()
    assert kind == "WEBP" and frames > 5


@pytest.mark.parametrize("is_there", [True, False])
def test_mp4_is_offered_where_an_ffmpeg_is_found(monkeypatch, is_there):
    monkeypatch.setattr(mp4.shutil, "which", lambda name: name if is_there else None)
    player = Player("hourglass")
    player.unfold("Recording and past")
    player.frame()
    assert len(player.parts_of("Format")) == 2 + is_there
    assert [text for _, text, _ in player.written() if text in ("GIF", "WebP", "MP4")] == ["GIF", "WebP", "MP4"][
        : 2 + is_there
    ]
    player.parts.close()
    pygame.display.quit()
