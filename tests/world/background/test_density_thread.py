"""The density thread: what was wished for last, of all worlds at one iteration, and nothing that is wished no more."""

import time

import numpy as np
import pytest

from game import Rule, World
from game.core.draw.heatmap import ALWAYS, NEVER
from game.world.background.density_thread import RUNS, WORDS, DensityStart, DensityThread, runs_of
from game.world.sand.ensemble import counts_at

LONG_S = 30.0


@pytest.fixture
def thread():
    """Return a DensityThread, which ends with the test."""
    thread = DensityThread()
    yield thread
    thread.close()
    assert thread.answer is None and not thread.working


def world_of(seed, shape=(30, 40)):
    sand = np.random.default_rng(seed).random(shape) < 0.3
    return World.from_cells(sand, np.zeros(shape, bool), seed)


def answer_of(thread, about, moment):
    """Wait for the maps at a moment."""
    end = time.monotonic() + LONG_S
    while thread.working:
        assert time.monotonic() < end
        time.sleep(0.005)
    assert thread.answer.about is about and thread.answer.now == moment
    return thread.answer


@pytest.mark.parametrize("moments", [(0,), (5, 40), (40, 7, 8), (3, 3)])
def test_all_worlds_are_told_of_at_the_same_iteration_forwards_and_backwards(thread, moments):
    rules = {"some": Rule.with_p(0.4), "other": Rule.with_p(0.9)}
    starts = {name: DensityStart(world_of(1), rule, "sand") for name, rule in rules.items()}
    about = object()
    for moment in moments:
        thread.follow(about, starts, moment)
        answer = answer_of(thread, about, moment)
        for name, rule in rules.items():
            counts = counts_at(world_of(1), rule, [moment], answer.runs)[0]
            assert ((answer.levels[name] == NEVER) == (counts == 0)).all()
            assert ((answer.levels[name] == ALWAYS) == (counts == answer.runs)).all()


def test_what_is_no_longer_wished_for_is_dropped(thread):
    thread.follow(object(), {"": DensityStart(world_of(2, (400, 400)), Rule.with_p(0.01), "sand")}, 10**9)
    time.sleep(0.1)
    about = object()
    thread.follow(about, {"": DensityStart(world_of(3), Rule.with_p(0.5), "sand")}, 12)
    answer_of(thread, about, 12)


def test_where_nothing_is_left_to_chance_that_is_said(thread):
    about = object()
    thread.follow(about, {"": DensityStart(world_of(4), Rule(), "sand")}, 9)
    assert answer_of(thread, about, 9).certain


def test_the_runs_of_a_world_take_no_more_memory_the_larger_it_is():
    assert runs_of(100) == RUNS[1] and runs_of(2**21) == RUNS[0]
    assert all(runs_of(cells) // 64 * cells <= WORDS for cells in (2**11, 2**16, 2**17 + 1, 2**20, 2**21))
