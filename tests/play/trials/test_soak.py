"""A short soak: the window under random input; and the soak finds what is wrong."""

import subprocess
import sys

import pygame
import pytest

from game.play.trials.random_input import Hand
from game.play.trials.soak import MEMORY_MB, Soak, SoakError

AT_PLAY = """
import pygame
from game.core.jit import ready
from game.play.trials.soak import Soak

pygame.font.init()
soak = Soak(seed=5)
parts, known = soak.app.parts, ready()
soak.run(0.02, print)
for name in ("rainbow", "fountain"):
    parts.sessions.load(name)
    soak.run(0.02, print)
    shown = "view.toggle_forecast", "view.toggle_plots", "view.toggle_differences", "view.toggle_density"
    for command in ("sand.flip", "sand.compare", "time.undo", "sand.compare", *shown, "time.redo"):
        parts.commands.give(command)
        soak.run(0.02, print)
    parts.sessions.now.world.digest()
assert ready() == known, ready() - known
"""


@pytest.fixture
def soak():
    soak = Soak(seed=7)
    yield soak
    soak.app.parts.close()
    pygame.display.quit()


def test_nothing_goes_wrong_in_some_seconds_of_random_input(soak):
    soak.run(1.0, say=print)
    assert soak.frames > 30 and soak.acts > 12


def test_no_kernel_is_compiled_in_mid_play():
    subprocess.run([sys.executable, "-c", AT_PLAY], check=True, timeout=100)


def test_a_grain_that_is_lost_is_found_out(soak):
    soak.run(0.2, say=print)
    soak.app.parts.sessions.now.world.planes[0] = 0
    with pytest.raises(SoakError, match="grains, wanted"):
        soak.run(1.0, say=print)


def test_the_same_seed_gives_the_same_input():
    pygame.display.init()
    first, second = Hand(3), Hand(3)
    pairs = [(str(first.events((640, 480), 1)), str(second.events((640, 480), 1))) for _ in range(300)]
    assert all(a == b for a, b in pairs)
    pygame.display.quit()


def test_the_hand_does_not_raise_the_limit_of_memory(soak):
    soak.app.parts.sessions.now.limit_memory(8 * MEMORY_MB)
    soak.run(0.1, say=print)
    assert soak.app.parts.sessions.now.memory_mb <= MEMORY_MB
