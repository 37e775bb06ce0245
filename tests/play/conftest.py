"""Someone at the window: with a blank scene, or with the hourglass."""

import pygame
import pytest

from tests.play.player import Player


@pytest.fixture
def player():
    """Return a Player of the blank scene."""
    yield Player()
    pygame.mixer.quit()
    pygame.display.quit()


@pytest.fixture
def glass():
    """Return a Player of the hourglass."""
    yield Player("hourglass")
    pygame.mixer.quit()
    pygame.display.quit()
