"""Machine code lives as long as whatever holds its address, whether or not a cache still knows it."""

import gc
import weakref

import numpy as np
import pytest

from game.core.draw import cells, downscaled, motion_blur
from game.core.draw.looks import SAND

CACHES = cells._compiled, cells._mean_pass, downscaled._compiled, downscaled._sums, motion_blur._compiled


@pytest.fixture
def made(monkeypatch):
    """A list of weak references to the passes that are made, with nothing in the caches before and after."""
    found = []
    for module in (cells, downscaled, motion_blur):

        def word_pass(*arguments, make=module.word_pass, **named):
            code, *rest = make(*arguments, **named)
            found.append(weakref.ref(code))
            return code, *rest

        monkeypatch.setattr(module, "word_pass", word_pass)
    forget()
    yield found
    forget()


def forget():
    for each in CACHES:
        each.cache_clear()
    gc.collect()


@pytest.mark.parametrize(("kind", "passes"), [(cells.CellPass, 2), (downscaled.CountPass, 5)])
def test_what_draws_keeps_its_passes(kind, passes, made):
    drawing = kind(SAND, 4, False, 0)
    forget()
    assert len(made) == passes and all(each() for each in made)
    del drawing
    gc.collect()
    assert not any(each() for each in made)


def test_a_sample_is_taken_by_a_pass_that_lives_until_it_is_done(made, monkeypatch):
    alive = []

    def take(address, *_):
        forget()
        alive.extend(each() and each().address == address for each in made)

    monkeypatch.setattr(motion_blur, "_take", take)
    planes = np.zeros((8, 64), np.uint64)
    motion_blur.take_sample(SAND, planes, np.zeros((motion_blur.PLANES, 64), np.uint64), planes[:0])
    assert alive == [True]
