"""Laws of the hiss: off unless chosen, louder with more sand in motion, silent when it rests."""

import numpy as np
import pygame
import pytest

from game.play.window import hiss
from game.play.window.audio import RATE
from tests.sweeps import sweep


@pytest.fixture
def heard(glass):
    """Return a Player of the hourglass with sound."""
    glass.parts.settings["sound"] = True
    glass.frame()
    glass.settle()
    glass.settle()
    yield glass
    glass.parts.audio.close()


def test_nothing_is_looked_at_or_opened_unless_sound_is_chosen(glass, monkeypatch):
    monkeypatch.setattr(hiss.MotionMeter, "look", lambda self, world: pytest.fail("looked"))
    glass.wait(30)
    assert not glass.parts.audio.asked


def test_flowing_sand_is_heard_and_held_sand_is_not(heard):
    heard.wait(90)
    flowing = heard.parts.hiss.level
    assert flowing > 0.1 and pygame.mixer.get_busy()
    heard.hold_time()
    heard.wait(90)
    assert heard.parts.hiss.level < 0.01


def test_m_switches_it_off_and_it_fades_out(heard):
    heard.wait(60)
    heard.key(pygame.K_m)
    assert not heard.parts.settings["sound"] and pygame.mixer.get_busy()
    heard.wait(120)
    assert not pygame.mixer.get_busy()


class Ear:
    """Stands in for a sound that is played, and notes how loud it is on the left and on the right."""

    def play(self, loops):
        return self

    def set_volume(self, left, right):
        self.heard = left, right


@sweep("side", [-1, 0, 1], keep=[-1])
def test_the_volume_is_what_was_set_and_comes_from_its_side(glass, monkeypatch, side):
    ear, settings = Ear(), glass.parts.settings
    monkeypatch.setattr(hiss, "sound_of", lambda wave: ear)
    monkeypatch.setattr(hiss.MotionMeter, "look", lambda self, world: (2**hiss.LOUDEST, side))
    settings["sound"] = True
    glass.frame()
    glass.settle()
    glass.settle()
    glass.wait(90)
    left, right = ear.heard
    assert np.hypot(left, right) == pytest.approx(settings["volume"], rel=0.01)
    assert np.sign(round(right - left, 3)) == side and min(left, right) > 0
    settings["volume"] = 0
    glass.frame()
    assert ear.heard == (0, 0)
    glass.parts.audio.close()


def test_without_a_card_the_player_is_told_once_and_plays_on(glass):
    glass.parts.audio.asked, glass.parts.audio.trouble = True, "none"
    glass.key(pygame.K_m)
    assert "No sound card" in glass.parts.notices.text
    at = glass.world.iteration
    glass.wait(20)
    assert glass.world.iteration > at


def test_a_card_that_does_not_open_takes_the_promise_of_sound_back(glass, monkeypatch):
    pygame.mixer.quit()  # the window of a test before may have left the card open
    monkeypatch.setenv("SDL_AUDIODRIVER", "alsa")
    monkeypatch.setenv("ALSA_CONFIG_PATH", "/dev/null")
    glass.key(pygame.K_m)
    glass.settle()
    glass.wait(2)
    assert "No sound card" in glass.parts.notices.text


def test_the_loop_has_no_seam_no_clipping_and_no_hum():
    wave = hiss.loop()
    assert wave.shape[1] == 2 and np.abs(wave).max() < 1
    steps = np.abs(np.diff(wave, axis=0))
    assert (np.abs(wave[0] - wave[-1]) <= steps.max(axis=0)).all()
    power = np.abs(np.fft.rfft(wave[:, 0])) ** 2
    frequencies = np.fft.rfftfreq(len(wave), 1 / RATE)
    assert power[frequencies < 200].sum() < 0.01 * power.sum()
    assert abs(np.corrcoef(wave.T)[0, 1]) < 0.3
