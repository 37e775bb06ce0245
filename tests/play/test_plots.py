"""The plots: beside the sand, never over anything, and nothing at all when closed."""

import csv

import numpy as np
import pygame
import pytest

from game.play.layout import Layout
from game.play.ui.theme import Theme
from game.world.action import Clear, Paint
from game.world.watch import COLUMNS
from tests.play.player import Player


@pytest.mark.parametrize("panel_shown", [True, False])
@pytest.mark.parametrize("shape", [(240, 180), (90, 400), (1, 1)])
@pytest.mark.parametrize(("size", "scale"), [((640, 480), 1), ((1280, 720), 1), ((1280, 720), 2), ((3840, 2160), 3)])
def test_the_plots_take_room_from_the_sand_alone(size, scale, shape, panel_shown):
    with_plots = Layout(Theme(scale), size, panel_shown, shape)
    without = Layout(Theme(scale), size, panel_shown)
    parts = [with_plots.sand, with_plots.bar, with_plots.hud, *[with_plots.panel] * panel_shown]
    assert (with_plots.bar, with_plots.hud, with_plots.panel) == (without.bar, without.hud, without.panel)
    if with_plots.plots is None:
        assert with_plots.sand == without.sand
        return
    assert not any(with_plots.plots.colliderect(each) for each in parts)
    assert with_plots.plots.union(with_plots.sand) == without.sand


def test_l_shows_them_and_takes_them_away(glass):
    before = glass.toy.layout.sand
    glass.key(pygame.K_l, "l")
    glass.wait(20)
    assert glass.toy.layout.plots and glass.toy.layout.sand.width < before.width
    glass.key(pygame.K_l, "l")
    glass.wait(1)
    assert glass.toy.layout.plots is None and glass.toy.layout.sand == before


def test_closed_they_measure_nothing(glass, monkeypatch):
    monkeypatch.setattr("game.play.plots.Watch.follow", None)  # would not be called in vain
    glass.wait(40)


def test_still_plots_of_a_still_world_are_not_drawn_again(glass):
    glass.key(pygame.K_l, "l")
    glass.hold_time()
    glass.wait(40)
    area = glass.toy.layout.plots
    assert glass.toy.plots.draw(glass.toy.window.surface) == []
    glass.toy.screen.forget()
    assert glass.toy.plots.draw(glass.toy.window.surface) == [area]


def test_a_window_without_room_says_so():
    player = Player("hourglass", (640, 480))
    player.key(pygame.K_l, "l")
    assert player.toy.layout.plots is None and "too small" in player.toy.notices.text
    pygame.display.quit()


def test_the_tables_are_saved_with_a_header(glass, own_folder):
    glass.key(pygame.K_l, "l")
    glass.wait(60)
    glass.hold_time()
    glass.key(pygame.K_l, "L", pygame.KMOD_SHIFT)
    glass.settle()
    story, profile = sorted((own_folder / "measures").glob("*.csv"), key=lambda path: len(path.name))
    rows = list(csv.reader(story.open(newline="")))
    assert tuple(rows[0]) == COLUMNS and len(rows) > 3
    assert all(int(row[2]) + int(row[3]) == glass.world.grains for row in rows[1:])
    assert len(list(csv.reader(profile.open(newline="")))) == glass.world.shape[1] + 1


def test_the_row_is_the_neck_unless_the_player_sets_another(glass):
    plots = glass.toy.plots
    assert plots.measured_row == 120
    plots.measured_row = 77
    glass.key(pygame.K_l, "l")
    glass.wait(2)
    assert plots._watch.row == 77
    glass.toy.load("paper")
    glass.wait(2)
    assert plots._watch.row == 30


def test_the_audit_balances_after_whatever_is_done(player):
    generator = np.random.default_rng(90)
    for number in range(60):
        material = ["sand", "erase", "wall"][generator.integers(3)]
        places = [tuple(map(float, generator.integers(0, 90, 2))) for _ in range(2)]
        player.session.do(Clear() if number == 40 else Paint(material, *places, int(generator.integers(1, 20))))
        player.frame()
        lines = player.session.account.lines
        total = sum({"": 1, "+": 1, "-": -1, "=": 0}[sign] * grains for sign, _, grains in lines)
        assert lines[-1] == ("=", "now", total) and total == player.world.grains
