"""The forecaster: what it tells is the forecast, and nothing ever waits for it."""

import threading

import numpy as np
import pytest

from game import Rule, advance
from game.world.background import forecast_thread
from game.world.background.forecast_thread import ForecastRequest, ForecastThread, standard_error
from game.world.sand.crop import Crop, CropBox, forecast_box
from game.world.sand.ensemble import Cancelled, certain, counts_at, growing_counts
from tests.cells import random_world

PATIENCE_S = 20


@pytest.fixture
def asked():
    """Return a function that makes a ForecastThread, which ends with the test."""
    made = []

    def make(*arguments):
        made.append(ForecastThread(*arguments))
        return made[-1]

    yield make
    for each in made:
        each.close()


def question_of(world, rule=None, ahead=30, runs=3000, about=None):
    height, width = world.shape
    crop = Crop(world, CropBox(0, 0, height, width))
    return ForecastRequest(crop, rule or Rule.with_p(0.5), ahead, runs, about=about)


def later(world, seed, iteration):
    """Return the same world with another seed, so many iterations old."""
    other = world.copy()
    other.seed, other.iteration = seed, iteration
    return other


def wait_for(condition):
    waited = threading.Event()
    for _ in range(PATIENCE_S * 200):
        if condition():
            return
        waited.wait(0.005)
    raise AssertionError("it never came")


class Counting:
    """Stands in for the runs: says what it is told to, when it is told to."""

    def __init__(self):
        self.go, self.started, self.asked, self.dropped = threading.Semaphore(0), threading.Semaphore(0), [], 0

    def __call__(self, world, rule, ahead, runs, of, cancelled):
        self.asked.append(ahead)
        self.started.release()
        for so_far in (runs // 2, runs):
            while not self.go.acquire(timeout=0.005):
                if cancelled():
                    self.dropped += 1
                    raise Cancelled
            yield so_far, np.full(world.shape, so_far // 2, np.int64)


def test_growing_counts_are_at_each_step_those_of_so_many_runs():
    world = random_world(np.random.default_rng(71), 12, 15)
    for rule in (Rule.with_p(0.4), Rule()):
        told = [(n, counts.copy()) for n, counts in growing_counts(later(world, 3, 2), rule, 20, 9000)]
        assert told[-1][0] == 9000 and (len(told) > 3) != certain(rule)
        for runs, counts in told:
            assert (counts == counts_at(later(world, 3, 2), rule, [20], runs)[0]).all()


def test_the_answer_counts_the_runs_that_a_forecast_counts(asked):
    world = random_world(np.random.default_rng(72), 21, 30, seed=72)
    advance(world, Rule.with_p(0.5), 3)
    one = asked()
    one.ask(question_of(world))
    wait_for(lambda: one.answer and one.answer.runs == 3000)
    expected = counts_at(later(world, world.seed, 3), Rule.with_p(0.5), [30], 3000)[0]
    assert (one.answer.counts == expected).all() and (one.answer.levels[world.walls] == 255).all()


def test_the_error_told_is_the_largest_that_a_share_can_have():
    shares = np.linspace(0, 1, 101)
    for runs in (64, 10_000):
        errors = [standard_error(share, runs) for share in shares]
        assert errors == pytest.approx(np.sqrt(shares * (1 - shares) / runs))
        assert max(errors) == pytest.approx(0.5 / np.sqrt(runs)) and errors[0] == errors[-1] == 0


def test_shares_scatter_by_their_standard_error():
    world = random_world(np.random.default_rng(73), 10, 12, sand=0.5, walls=0.0)
    many = [counts_at(later(world, seed, 0), Rule.with_p(0.5), [8], 500)[0] / 500 for seed in range(60)]
    mean, spread = np.mean(many, axis=0), np.std(many, axis=0, ddof=1)
    chancy = (mean > 0.1) & (mean < 0.9)
    assert chancy.any()
    assert np.mean(spread[chancy] / standard_error(mean[chancy], 500)) == pytest.approx(1, abs=0.1)


def test_a_question_that_hurries_pushes_the_others_aside(asked):
    world, counting = random_world(np.random.default_rng(74), 6, 6), Counting()
    one = asked(counting)
    one.ask(question_of(world, ahead=1), hurry=True)
    assert counting.started.acquire(timeout=PATIENCE_S)
    for ahead in (2, 3, 4):
        one.ask(question_of(world, ahead=ahead), hurry=True)
    assert one.answer is None and one.working
    counting.go.release()  # the first tells something, then gives way to the last
    wait_for(lambda: len(counting.asked) == 2)
    counting.go.release(2)
    wait_for(lambda: not one.working)
    assert counting.asked == [1, 4] and one.answer.request.ahead == 4 and one.answer.runs == 3000


def test_a_question_that_had_its_time_gives_way_to_a_newer_one(asked, monkeypatch):
    monkeypatch.setattr(forecast_thread, "PATIENCE_S", -1.0)
    world, counting = random_world(np.random.default_rng(81), 6, 6), Counting()
    one = asked(counting)
    one.ask(question_of(world, ahead=1))
    assert counting.started.acquire(timeout=PATIENCE_S)
    one.ask(question_of(world, ahead=2))
    counting.go.release()
    assert counting.started.acquire(timeout=PATIENCE_S)
    assert one.answer.request.ahead == 1 and one.answer.runs == 1500


def test_a_question_that_nobody_asks_any_more_is_dropped(asked, monkeypatch):
    monkeypatch.setattr(forecast_thread, "LONG_S", 0.0)
    world, counting = random_world(np.random.default_rng(75), 6, 6), Counting()
    one = asked(counting)
    one.ask(question_of(world, ahead=1), hurry=True)
    assert counting.started.acquire(timeout=PATIENCE_S)
    one.ask(question_of(world, ahead=2), hurry=True)
    assert counting.started.acquire(timeout=PATIENCE_S)
    assert counting.dropped == 1 and one.answer is None


def test_a_forecast_that_does_not_fit_in_memory_keeps_none_from_the_next(asked):
    world, rooms = random_world(np.random.default_rng(80), 6, 6), [MemoryError]

    def counting(*arguments, **named):
        if rooms:
            raise rooms.pop()
        yield from growing_counts(*arguments, **named)

    one = asked(counting)
    one.ask(question_of(world))
    wait_for(lambda: not one.working)
    one.ask(question_of(world, ahead=7))
    wait_for(lambda: one.answer and one.answer.request.ahead == 7)


def test_closing_ends_the_thread_in_the_middle_of_a_run(asked):
    world, one = random_world(np.random.default_rng(76), 40, 40, walls=0.0), asked()
    one.ask(question_of(world, ahead=10_000, runs=10**9))
    before = threading.active_count()
    one.close()
    assert threading.active_count() == before - 1 and one.answer is None
    one.ask(question_of(world, runs=64))
    wait_for(lambda: one.answer)


def test_a_crop_keeps_what_the_world_was():
    generator = np.random.default_rng(77)
    for height, width in ((1, 1), (9, 13), (40, 300)):
        world = random_world(generator, height, width)
        for _ in range(20):
            top, left = int(generator.integers(height)), int(generator.integers(width))
            part = CropBox.within(world.shape, top, left, top + 7, left + 150)
            crop, sand, walls = Crop(world, part), world.sand, world.walls
            advance(world, Rule(), 1)
            box = slice(part.top, part.top + part.height), slice(part.left, part.left + part.width)
            assert (crop.world().sand == sand[box]).all() and (crop.world().walls == walls[box]).all()
            assert part.top % 2 == part.left % 2 == 0 and sand[box].size == part.cells


@pytest.mark.parametrize("schedule", ["margolus", "paper", "balanced"])
def test_nothing_from_beyond_the_reach_comes_into_sight(schedule):
    world = random_world(np.random.default_rng(78), 80, 90, sand=0.5, walls=0.05)
    rule, ahead, sight = Rule(schedule=schedule), 9, CropBox.within((80, 90), 31, 35, 52, 60)
    part, exact = forecast_box(world.shape, sight, ahead, most=3000)
    assert exact and part.cells < 80 * 90
    counts = counts_at(Crop(world, part).world(), rule, [ahead], 1)[0]
    advance(world, rule, ahead)
    box = slice(sight.top, sight.top + sight.height), slice(sight.left, sight.left + sight.width)
    inner = tuple(slice(each.start - corner, each.stop - corner) for each, corner in zip(box, part[:2], strict=True))
    assert (counts[inner] == world.sand[box]).all()


def test_a_forecast_never_takes_more_cells_than_it_may():
    for shape, sight in (((16384, 16384), (0, 0, 16384, 16384)), ((16384, 300), (5000, 11, 9001, 300))):
        part, exact = forecast_box(shape, CropBox.within(shape, *sight), 1000, 10**6)
        assert not exact and 0.9e6 < part.cells <= 10**6 and part.top % 2 == part.left % 2 == 0
    assert forecast_box((50, 60), CropBox.within((50, 60), 3, 3, 5, 5), 10, 3000) == (CropBox(0, 0, 50, 60), True)


def test_without_a_newer_question_the_runs_go_on_to_the_last(asked, monkeypatch):
    monkeypatch.setattr(forecast_thread, "PATIENCE_S", -1.0)
    one = asked()
    one.ask(question_of(random_world(np.random.default_rng(79), 9, 9)))
    wait_for(lambda: not one.working)
    assert one.answer.runs == 3000
