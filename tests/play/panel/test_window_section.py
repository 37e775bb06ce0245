"""How the window looks: themes, and motion that can be left out."""

import pygame
import pytest

from game.core.draw.looks import GRAIN
from game.world.files.settings import Settings
from game.world.looks.themes import THEMES
from tests.play.player import Player


def corner(player):
    return tuple(player.parts.window.surface.get_at((1, 1)))[:3]


@pytest.mark.parametrize("name", THEMES)
def test_a_theme_colours_the_sand_and_the_panel_at_once(glass, name):
    glass.hold_time()
    glass.parts.settings["theme"] = name
    glass.wait(2)
    colours, surface, ui = THEMES[name], glass.parts.window.surface, glass.parts.panel.ui
    assert corner(glass) == colours.ground
    column, row = glass.world.shape[1] // 2, 80
    assert glass.world.sand[row, column]
    dark, light = colours.sand[GRAIN]
    assert dark <= tuple(surface.get_at(glass.pixel(column, row)))[:3] <= light
    assert tuple(surface.get_at((glass.parts.display.layout.panel.right - 1, 99)))[:3] == colours.panel["ground"]
    assert ui.theme.colours is glass.parts.display.theme.colours is colours
    assert not glass.frame(), "and then it rests"


def test_the_theme_is_chosen_in_the_panel_and_remembered(glass):
    before = corner(glass)
    while glass.parts.panel.ui.focus.name != "Theme":
        glass.key(pygame.K_TAB)
    for key in (pygame.K_RETURN, pygame.K_HOME, pygame.K_RETURN):
        glass.key(key)
    assert glass.parts.settings["theme"] == "day"
    assert corner(glass) == THEMES["day"].ground != before


def test_reduced_motion_turns_the_glass_over_at_once():
    settings = Settings()
    settings["reduced_motion"] = True
    glass = Player("hourglass", settings=settings)
    sand = glass.world.sand
    glass.hold_time()
    glass.key(pygame.K_f)
    assert glass.parts.display.sand_view.turn is None
    assert (glass.world.sand == sand[::-1, ::-1]).all()
    glass.wait(1)
    assert not glass.frame(), "nothing is animated"
    pygame.display.quit()
