"""Someone at the window: with a blank scene, or with the hourglass."""

import pygame
import pytest

from tests.play.player import MADE, Player


def _close():
    """Close the window and end all sounds; the sound card stays open, for opening and closing it takes long."""
    if pygame.mixer.get_init():
        pygame.mixer.stop()
    pygame.display.quit()


@pytest.fixture(autouse=True)
def end_forecasts():
    """End what works on forecasts and densities for players of a test when it is over."""
    yield
    while MADE:
        parts = MADE.pop().parts
        parts.forecasting.close()
        parts.density.close()


@pytest.fixture
def player():
    """Return a Player of the blank scene."""
    yield Player()
    _close()


@pytest.fixture
def glass():
    """Return a Player of the hourglass."""
    yield Player("hourglass")
    _close()
