"""A glass made for a time runs for about that time at a good pace."""

import pytest

from game.world.ending import find_ending
from game.world.maker import SLOWEST, Glass, good_pace
from game.world.session import Session


@pytest.mark.parametrize("seconds", [1, 10, 30, 60, 180])
def test_a_glass_made_for_a_time_suits_it(seconds):
    scene = Glass.for_time(seconds).scene()
    pace = find_ending(Session(scene).timeline.course()).iterations / seconds
    assert good_pace(seconds) / 1.35 < pace < 1.35 * good_pace(seconds)
    assert SLOWEST <= good_pace(seconds) <= 240


@pytest.mark.parametrize("seconds", [86_400, 36_000, 1500])
def test_even_a_long_time_gets_a_glass_that_a_screen_can_show(seconds):
    glass = Glass.for_time(seconds)
    assert glass.height <= 1200 and glass.scene().sand.any()


def test_a_glass_fits_the_lattice_it_is_asked_for():
    assert Glass.for_time(60, (37, 90)).scene().shape == (90, 37)
    with pytest.raises(ValueError, match="at least 5×5"):
        Glass.for_time(60, (4, 90))
