"""Chances beside their sliders."""

import pytest

from game.play.view.chance_sliders import spelled


@pytest.mark.parametrize(
    ("chance", "words"),
    [
        (0.0, "0"),
        (1, "1"),
        (0.7, "0.7"),
        (0.123456, "0.123"),
        (0.0005, "0.0005"),
        (1e-5, "0.00001"),
        (2e-9, "0.000000002"),
    ],
)
def test_a_chance_is_written_in_plain_figures_and_only_none_as_zero(chance, words):
    assert spelled(chance) == words
