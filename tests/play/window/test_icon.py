"""Laws of the icon and the title."""

import numpy as np
import pygame

from game.play.window.window import icon


def test_the_icon_that_ships_shows_the_glass_that_is_drawn():
    small = [
        pygame.surfarray.array3d(pygame.transform.smoothscale(each, (8, 8))) for each in (icon.load(), icon.draw())
    ]
    assert np.abs(small[0].astype(int) - small[1]).max() < 40


def test_the_corners_of_the_icon_are_round():
    assert icon.load().get_at((0, 0)).a == 0 and icon.load().get_at((icon.SIDE // 2, 3)).a == 255


def test_the_window_has_its_name(player):
    assert pygame.display.get_caption()[0].startswith("Sandglass")
