"""Laws of the splash: it moves, its sand is kept, and it tells truly how much is done."""

import numpy as np
import pygame
import pytest

from game.play.ui.theme import Theme
from game.play.view.splash import LIGHT, SAND, Progress, Splash


@pytest.fixture(scope="module")
def splash():
    return Splash(Theme(1.0))


def sand(cells):
    return np.isin(cells, (SAND, LIGHT))


def test_as_much_sand_is_below_as_is_done_and_the_rest_above(splash):
    whole = sand(splash.cells(1.0, 0.0)).sum()
    before = -1
    for done in np.linspace(0.0, 1.0, 11):
        cells = sand(splash.cells(done, 0.0))
        above = cells[: len(cells) // 2].sum()
        assert above == pytest.approx((1 - done) * whole, abs=1)
        below = cells[len(cells) // 2 :].sum()
        assert below >= done * whole - 1 and below > before
        before = below


def test_the_stream_moves_while_nothing_gets_done_and_ends_with_the_sand(splash):
    pictures = [splash.cells(0.5, 10.0 + frame / 30).tobytes() for frame in range(8)]
    assert len(set(pictures)) > 4
    assert (splash.cells(1.0, 0.0) == splash.cells(1.0, 0.1)).all()


def test_a_long_step_goes_on_and_never_beyond_its_share():
    progress = Progress(4)
    shares = [progress.at(1, second) for second in range(0, 300, 10)]
    assert shares == sorted(shares) and shares[0] == pytest.approx(0.25) and shares[-1] <= 0.5
    assert progress.at(2, 300) == pytest.approx(0.5)


@pytest.mark.parametrize("size", [(320, 240), (624, 416), (1904, 1016), (3072, 1728)])
def test_title_glass_and_words_have_room(splash, size):
    surface = pygame.Surface(size)
    splash.draw(surface, "Compiling the layout of the cells … (1 of 3, once on this machine)", 0.3, 1.0)
    pixels = pygame.surfarray.array2d(surface)
    lit = np.argwhere(pixels != pixels[0, 0])
    (left, top), (right, bottom) = lit.min(axis=0), lit.max(axis=0)
    assert min(left, top) > 0 and right < size[0] - 1 and bottom < size[1] - 1
