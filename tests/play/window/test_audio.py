"""Laws of the mixer: it opens once, beside the frames, and a missing card is no trouble to anyone."""

import numpy as np
import pygame
import pytest

WAVE = np.zeros((4410, 2))


@pytest.fixture(autouse=True)
def no_card():
    """Begin with the sound card closed."""
    pygame.mixer.quit()


@pytest.fixture
def mixer(player):
    yield player.parts.audio
    player.parts.audio.close()


def test_nothing_is_opened_until_somebody_wants_to_be_heard(player):
    player.wait(10)
    assert pygame.mixer.get_init() is None


def test_a_sound_waits_for_the_card(player, mixer):
    mixer.play(WAVE)
    player.settle()
    assert mixer.ready and pygame.mixer.get_busy()


def test_without_a_card_all_is_silent_and_the_terminal_too(player, mixer, monkeypatch, capfd):
    monkeypatch.setenv("SDL_AUDIODRIVER", "alsa")
    monkeypatch.setenv("ALSA_CONFIG_PATH", "/dev/null")
    mixer.play(WAVE)
    player.settle()
    mixer.play(WAVE)
    assert not mixer.ready and mixer.trouble
    assert capfd.readouterr() == ("", "")
