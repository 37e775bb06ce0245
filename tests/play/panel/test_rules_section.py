"""The friction in the panel: a slider or a switch that is put back in one gesture leaves no step to undo."""

import pygame
import pytest

from tests.play.player import Player


@pytest.fixture
def player():
    """Return a player of the hourglass, with time held at its start."""
    player = Player("hourglass", size=(900, 1400))
    player.hold_time()
    player.wait(1)
    yield player
    pygame.display.quit()


def story(player):
    return player.session.timeline.history.story()


@pytest.mark.parametrize(("fold", "slider"), [(None, "p"), ("Bias, schedule and file", "Bias"), ("Glass", "Fill")])
def test_a_slider_put_back_in_one_drag_is_no_step_and_redo_stays(player, fold, slider):
    if fold:
        player.unfold(fold)
    places = [player.control(slider, share) for share in (0.5, 0.6, 0.8)]
    player.drag(places[0])
    set_there, once = player.world.digest(), story(player)
    player.drag(places[2])
    assert len(story(player)) > len(once)
    player.session.undo()
    player.drag(places[0], places[1], places[2], places[0])
    assert story(player) == once and player.world.digest() == set_there
    assert player.session.redo() and len(story(player)) > len(once)


def test_starting_again_at_the_start_is_no_step(player):
    player.session.seek(0)
    player.drag(player.control("p", 0.5))
    once, rule = story(player), player.session.rule
    player.key(pygame.K_r, "r")
    assert story(player) == once and player.session.rule == rule
