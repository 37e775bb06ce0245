"""Densities: what many runs do on average, and what a single world does 2,000 times."""

import threading
import time

import numpy as np
import pytest

from game import Rule, World, advance, density, load_rule
from game.world.rules.rule import SCHEDULES
from game.world.sand import ensemble as forecast
from game.world.sand.ensemble import Cancelled, counts_at, states_at
from game.world.sand.fixtures import Fixture
from tests.cells import random_world, strewn, world_of
from tests.sweeps import sweep

SEVEN = Rule(0.9, 0.2, 0.7, 0.55, 0.35, 0.618, 0.15, "balanced")
PILE = world_of(["..oooo...", "..oooo...", "#.oooo..#", "#.oo#....", ".........", "....#...."])


def seeded(world, seed, start=0):
    """Return the same world with another seed, so many iterations old."""
    other = world.copy()
    other.seed, other.iteration = seed, start
    return other


@pytest.mark.parametrize("schedule", SCHEDULES)
def test_without_chance_the_density_is_the_single_world(schedule):
    generator = np.random.default_rng(50)
    for height, width in [(1, 1), (1, 6), (5, 1), (9, 14), (61, 61), (17, 130)]:
        world = random_world(generator, height, width)
        start, begun = world.copy(), world.copy()
        counts = counts_at(begun, Rule(schedule=schedule), range(20), runs=777)
        for moment in range(20):
            assert (counts[moment] == 777 * start.sand).all()
            advance(start, Rule(schedule=schedule), 1)
        advance(world, Rule(schedule=schedule), 33)
        assert (density(begun, Rule(schedule=schedule), 33, runs=1000) == world.sand).all()


@sweep("rule", [Rule.with_p(0.3), Rule(0.75, 0.25, schedule="balanced"), SEVEN], keep=[SEVEN])
def test_the_single_world_run_2000_times_agrees_within_error_bars(rule):
    world = random_world(np.random.default_rng(51), 14, 17, sand=0.5, walls=0.1)
    runs, moment = 2000, 9
    total = np.zeros(world.shape, np.int64)
    for seed in range(runs):
        one = world.copy()
        one.seed = seed
        advance(one, rule, moment)
        total += one.sand
    ensemble = density(seeded(world, 51), rule, moment, runs=40_000)
    variance = ensemble * (1 - ensemble) * (1 / runs + 1 / 40_000)
    open_cells = variance > 20 / runs**2
    pulls = (total[open_cells] / runs - ensemble[open_cells]) ** 2 / variance[open_cells]
    assert open_cells.sum() > 40 and pulls.max() < 25
    assert abs(pulls.mean() - 1) < 0.5
    assert (total[ensemble == 0] == 0).all() and (total[ensemble == 1] == runs).all()


@pytest.mark.parametrize("runs", [1, 7, 511, 513, 1000, 4097])
def test_exactly_the_runs_asked_for_are_counted(runs):
    moments = [0, 1, 5, 5, 40]
    counts = counts_at(seeded(PILE, 52), SEVEN, moments, runs=runs)
    assert counts.dtype == np.int64 and (counts.sum(axis=(1, 2)) == runs * PILE.grains).all()
    assert (counts[0] == runs * PILE.sand).all() and (counts[2] == counts[3]).all()
    assert counts.min() >= 0 and counts.max() <= runs
    assert (density(seeded(PILE, 52), SEVEN, 40, runs=runs) == counts[-1] / runs).all()


def test_a_million_runs_are_summed_without_loss():
    counts = counts_at(seeded(PILE, 53), Rule.with_p(0.5), [12], runs=10**6)
    assert counts.sum() == 10**6 * PILE.grains


def test_states_and_counts_are_two_views_of_the_same_runs():
    moments = [0, 3, 30]
    for rule in (SEVEN, Rule()):
        states = states_at(seeded(PILE, 54), rule, moments, runs=5000.0)
        bits = (states[:, :, None] >> np.arange(PILE.sand.size, dtype=np.uint64)) & np.uint64(1)
        assert (bits.sum(axis=2) == PILE.grains).all()
        counts = counts_at(seeded(PILE, 54), rule, moments, runs=5000)
        assert (bits.sum(axis=1).reshape(3, *PILE.shape) == counts).all()


def test_fewer_runs_are_the_first_of_more():
    few, many = (states_at(seeded(PILE, 55), SEVEN, [20], runs=runs)[0] for runs in (100, 5000))
    assert (many[:100] == few).all()
    assert len(np.unique(many)) > 100


def test_neither_groups_nor_bites_nor_progress_change_a_bit(monkeypatch):
    expected = counts_at(seeded(PILE, 56), SEVEN, [3, 25], runs=3000)
    monkeypatch.setattr(forecast, "BITE", 3)
    monkeypatch.setattr(forecast, "GROUP_WORDS", 5 * PILE.sand.size)
    told = []
    again = counts_at(seeded(PILE, 56), SEVEN, [3, 25], 3000, progress=told.append, cancelled=lambda: False)
    assert (again == expected).all()
    assert told == sorted(told) and told[0] >= 0 and told[-1] == 3000 and len(set(told)) > 10


def test_a_forecast_starts_in_the_middle_of_the_schedule():
    for start in (1, 2, 3, 2**64 + 2):
        world = random_world(np.random.default_rng(57), 12, 13)
        world.iteration = start
        found = density(world, Rule(), 3)
        advance(world, Rule(), 3)
        assert (found == world.sand).all()


def test_different_seeds_and_starts_are_different_runs():
    forecasts = [
        density(seeded(PILE, seed, start), Rule.with_p(0.5), 20, 1000)
        for seed, start in [(0, 0), (1, 0), (2**64 - 1, 0), (0, 4)]
    ]
    assert len({each.tobytes() for each in forecasts}) == len(forecasts)


def test_a_run_is_not_the_world_of_the_same_seed():
    world = random_world(np.random.default_rng(58), 40, 40, seed=58)
    first = density(world, Rule.with_p(0.5), 20, runs=1)
    advance(world, Rule.with_p(0.5), 20)
    assert (first != world.sand).any()


@pytest.mark.parametrize(("p", "moved"), [(0.0, 0), (5e-324, 0), (2.0**-34, 0), (1 - 2.0**-34, 1), (1.0, 1)])
def test_a_probability_within_half_of_2_to_the_minus_32_of_certainty_is_certain(p, moved):
    tower = world_of(["o.", "o."])
    counts = counts_at(tower, Rule(topple_right=p), [1], runs=100_000)[0]
    assert counts[1, 1] == moved * 100_000


@pytest.mark.parametrize("p", [2.0**-32, 1 - 2.0**-32])
def test_a_probability_of_2_to_the_minus_32_is_still_a_chance(p):
    tower = world_of(["o.", "o."])
    rule = Rule(topple_right=p)
    counts = counts_at(tower, rule, [1], runs=100_000)[0]
    assert abs(counts[1, 1] - p * 100_000) < 1
    assert forecast.Ensemble(tower, tower.materials, (1,), rule, 5).weight == 1


def test_a_grain_that_did_not_topple_keeps_its_chance():
    tower = world_of(["o.", "o."])
    rule = Rule(topple_right=0.01, schedule="margolus")  # one chance in two iterations
    toppled = sum(counts_at(seeded(tower, seed), rule, [200], runs=10)[0, 1, 1] for seed in range(300))
    expected = 1 - 0.99**100
    assert abs(toppled - 3000 * expected) < 5 * np.sqrt(3000 * expected * (1 - expected))


def test_a_forecast_in_a_thread_stops_soon_after_it_is_cancelled():
    world = random_world(np.random.default_rng(59), 300, 300, walls=0.0)
    density(world, SEVEN, 1, runs=1)  # compiled
    stop, caught = threading.Event(), []

    def work():
        try:
            density(world, SEVEN, 10**6, cancelled=stop.is_set)
        except Cancelled as wish:
            caught.append(wish)

    thread = threading.Thread(target=work)
    thread.start()
    time.sleep(0.3)
    assert thread.is_alive()
    begin = time.process_time()
    stop.set()
    thread.join(60)
    assert caught and time.process_time() - begin < 0.25  # a few ms of work


def test_no_time_at_all_is_no_work():
    told = []
    assert (density(PILE, SEVEN, 0, progress=told.append) == PILE.sand).all()
    assert told == [10_000]
    assert counts_at(PILE, SEVEN, []).shape == (0, *PILE.shape)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"runs": 0}, "runs must be a whole number in [1, 1000000000], got 0"),
        ({"runs": 2.5}, "runs must be a whole number in"),
        ({"runs": True}, "runs must be a whole number in"),
        ({"runs": float("nan")}, "runs must be a whole number in"),
        ({"iterations": -1}, "iterations must be a whole number in"),
        ({"of": "gold"}, "a material must be one of air, sand, wall, got 'gold'"),
        (
            {"rule": load_rule("alchemy")},
            "the world holds air, sand, wall; the rule alchemy is of air, sand, ",
        ),
    ],
)
def test_bad_input_is_named(change, words):
    good = {"world": world_of(["..", ".."]), "rule": Rule(), "iterations": 1}
    with pytest.raises(ValueError) as caught:
        density(**(good | change))
    assert words in str(caught.value) and "\n" not in str(caught.value)


def test_moments_rise_and_states_are_of_small_lattices():
    big = World.from_cells(np.zeros((5, 13), bool), np.zeros((5, 13), bool))
    with pytest.raises(ValueError, match="moments must be in rising order, got 2 after 3"):
        counts_at(big, Rule(), [1, 3, 2])
    with pytest.raises(ValueError, match="64 cells at most, got 65"):
        states_at(big, Rule(), [1])


@sweep("rule", [Rule(schedule="balanced"), Rule.with_p(0.6, "balanced")], keep=[Rule.with_p(0.6, "balanced")])
def test_taps_and_drains_act_in_every_run(rule):
    world = random_world(np.random.default_rng(4), 20, 26, sand=0.3, walls=0.1)
    world.fixtures = Fixture("tap", 3, 2, 5, 1, 3), Fixture("drain", -2, 15, 20, 3, 2), Fixture("tap", 24, 0, 9, 1, 5)
    world.iteration = 7
    found = density(world, rule, 40, runs=2000)
    mean, alone = np.zeros(world.shape), 300
    for seed in range(alone):
        single = world.copy()
        single.seed = seed
        advance(single, rule, 40)
        mean += single.sand / alone
    assert np.abs(found - mean).max() < (1e-9 if rule.p == 1.0 else 0.16)
    assert found[:, 3:8].any() and (found[world.walls] == 0).all()


@sweep(
    ("name", "of"),
    [("water-and-oil", "water"), ("alchemy", "water"), ("rolling-sand", "sand")],
    keep=[("water-and-oil", "water")],
)
def test_runs_of_any_rule_agree_with_single_worlds_within_error_bars(name, of):
    rule, alone, runs = load_rule(name), 300, 4000
    world = strewn(rule, 6, 20, 26, lumps=2)
    world.fixtures = Fixture("tap", 3, 2, 5, 1, 3, material=of), Fixture("drain", -2, 15, 20, 3, 2)
    world.iteration = 7
    found, total = density(world, rule, 30, runs, of), np.zeros(world.shape, np.int64)
    for seed in range(alone):
        single = seeded(world, seed, 7)
        advance(single, rule, 30)
        total += single.where(of)
    variance = found * (1 - found) * (1 / alone + 1 / runs)
    open_cells = variance > 20 / alone**2
    pulls = (total[open_cells] / alone - found[open_cells]) ** 2 / variance[open_cells]
    assert open_cells.sum() > 40 and pulls.max() < 25
    assert abs(pulls.mean() - 1) < 0.5
    assert (total[found == 0] < 5).all() and (total[found == 1] > alone - 5).all()


@pytest.mark.parametrize("kind", ["tap", "drain"])
@pytest.mark.parametrize("x", [4, 5])
@pytest.mark.parametrize("y", [10, 11])
def test_runs_at_rest_wake_where_a_fixture_acts(kind, x, y):
    sand, walls = np.zeros((2, 24, 10), bool)
    sand[:, 2:8] = kind == "drain"
    world, rule = World.from_cells(sand, walls), Rule(schedule="balanced")
    world.fixtures = (Fixture(kind, x, y, every=20),)
    world.iteration = 1
    found = counts_at(world, rule, [40], 1)[0]
    advance(world, rule, 40)
    assert world.grains != sand.sum() and (found == world.sand).all()


@pytest.mark.parametrize("rule", [SEVEN, Rule(schedule="balanced")])
def test_runs_that_are_followed_are_those_that_are_counted_at_each_moment(rule):
    moments, runs = [0, 1, 7, 7, 40], forecast.FollowedRuns(PILE, rule, 300)
    counted = counts_at(PILE, rule, moments, runs=300)
    for moment, wanted in zip(moments, counted, strict=True):
        runs.run_to(moment)
        assert runs.now == moment and (runs.counts() == wanted).all()
    assert runs.certain == (rule is not SEVEN)
