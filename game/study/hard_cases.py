"""Part 5, hard cases: what could break in a long run, at a border, with an extreme number or with a clock."""

import numpy as np

from game import Rule, World, advance, load_rule, load_scene, rule_names
from game.study import books
from game.study.exact.lattices import LATTICES
from game.study.exact.tiled_worlds import sand_and_walls
from game.study.report import report
from game.world.rules.rule import SCHEDULES
from game.world.sand.clock import NS_PER_S, Clock
from game.world.sand.ensemble import density, states_at
from game.world.scenes.hourglass import hourglass

TITLE = "5. Hard cases"
SEED = 5
FLIP_AFTER = 1003  # iterations: odd and no multiple of any cycle, so that flips meet every phase
SEVEN = Rule(0.5, 0.3, 0.9, 0.8, 0.7, 0.6, 0.95)
KINDS = {"certain": Rule(), "p = 0.5": Rule.with_p(0.5), "seven probabilities": SEVEN}
ABOUT = (
    "Quick cases are tests, in tests/world/sand/test_hard_cases.py and test_clock.py: full lattices, single cells, "
    "checkerboards, flips at every phase of the cycle, strokes at the borders of words, bands and seams."
)
CONSERVED = "grains are neither made nor lost"
ARITHMETIC = "whole-number arithmetic"
WALL = "walls are closed"


def run(study):
    """Yield the rows of this part."""
    yield ABOUT
    yield from _long_runs(study)
    yield from _books(study)
    yield from _leaks(study.either(2_000, 200_000))
    yield from _necks()
    yield from _counters()
    yield from _extremes()
    yield from _ensembles()
    yield from _clocks()


def _long_runs(study):
    iterations = study.either(10**6, 10**7)
    for words, rule in KINDS.items():
        world = load_scene("paper").world(SEED)
        grains, walls = world.grains, world.walls
        for _ in study.track(range(iterations // FLIP_AFTER), f"{iterations:,} iterations, {words}"):
            advance(world, rule, FLIP_AFTER)
            world.flip()
        advance(world, rule, iterations % FLIP_AFTER)
        if iterations // FLIP_AFTER % 2:
            world.flip()
        quantity = f"grains after {iterations:,} iterations and {iterations // FLIP_AFTER:,} flips, {words}"
        yield report.same(quantity, world.grains, grains, CONSERVED)
        yield report.same(f"walls that changed meanwhile, {words}", int((world.walls != walls).sum()), 0, WALL)


def _books(study):
    for name in study.track(rule_names(), "books"):
        yield from books.rows(load_rule(name), study.either(20_000, 10**6), SEED)


def _leaks(iterations):
    """Yield rows on grains that escape from a diamond and a box, with walls one cell thick, full of sand."""
    y, x = np.mgrid[:41, :41] - 20
    for words, distance in (("diagonal", abs(x) + abs(y)), ("straight", np.maximum(abs(x), abs(y)))):
        walls, sand = distance == 15, (distance < 15) & (y < 3)
        escaped = 0
        for schedule in SCHEDULES:
            world = World.from_cells(sand, walls, SEED)
            advance(world, Rule(*SEVEN.probabilities, schedule=schedule), iterations)
            escaped += int(world.sand[distance > 15].sum())
        yield report.same(f"grains through {words} walls one cell thick, {iterations:,} iterations", escaped, 0, WALL)


def _necks():
    """Yield rows on what stays in the upper bulb above a neck of one cell."""
    sand, walls = hourglass(61, 61, 1, 0.0, 1, 0.9)
    for p in (1.0, 0.5):
        world = World.from_cells(sand, walls, SEED)
        advance(world, Rule.with_p(p, "balanced"), 10_000)
        quantity = f"grains left above a neck of one cell after 10,000 iterations, p = {p:g}, balanced"
        yield report.same(quantity, int(world.sand[:31].sum()), 0, "no grain can rest on a slope of 45°")
        yield report.same(f"grains in that glass, p = {p:g}", world.grains, int(sand.sum()), CONSERVED)


def _counters():
    """Yield rows on iteration numbers beyond a word: one call across the border against call by call."""
    for exponent in (32, 63, 64, 70):
        whole = load_scene("paper").world(SEED)
        whole.iteration = 2**exponent - 5
        parts = whole.copy()
        advance(whole, SEVEN, 10)
        for _ in range(10):
            advance(parts, SEVEN, 1)
        differing = int((whole.sand != parts.sand).sum())
        yield report.same(
            f"cells that differ across iteration 2^{exponent}, ten at once or one by one", differing, 0, ARITHMETIC
        )
        yield report.same(f"iterations past 2^{exponent}", whole.iteration - 2**exponent, 5, ARITHMETIC)


def _extremes():
    """Yield rows on probabilities at the ends of their range: how many of 256 candidates topple in one iteration."""
    sand = np.zeros((32, 32), bool)
    sand[:, 0::2] = True
    for words, p, expected in (("0", 0.0, 0), ("−0.0", -0.0, 0), ("5e-324", 5e-324, 0), ("1", 1.0, 256)):
        world = World.from_cells(sand, np.zeros_like(sand), SEED)
        advance(world, Rule.with_p(p), 1)
        yield report.same(
            f"topples of 256 at p = {words}", int(world.sand[:, 1::2].sum()), expected, "never and always"
        )
    try:
        Rule.with_p(float("nan"))
        answer = "taken"
    except ValueError:
        answer = "refused"
    yield report.same("p = NaN", answer, "refused", "p is in [0, 1]")


def _ensembles():
    """Yield rows on the sums of a million replicas."""
    runs, (sand, walls) = 10**6, sand_and_walls(LATTICES["wide neck"])
    states = states_at(World.from_cells(sand, walls, SEED), SEVEN, [30], runs)[0]
    wrong = int((np.bitwise_count(states) != sand.sum()).sum())
    yield report.same(f"replicas of {runs:,} with a grain too many or too few", wrong, 0, CONSERVED)
    places = np.arange(sand.size, dtype=np.uint64)
    counts = [int(((states >> place) & np.uint64(1)).sum()) for place in places]
    mean = density(World.from_cells(sand, walls, SEED), SEVEN, 30, runs).ravel()
    wrong = sum(each != count / runs for each, count in zip(mean, counts, strict=True))
    yield report.same(f"cells whose mean over {runs:,} replicas is not the exact quotient", wrong, 0, ARITHMETIC)


def _clocks():
    clock = Clock(1000.0)
    hours = [clock.due(elapsed) for elapsed in (-3600 * NS_PER_S, 0, -1)]
    yield report.same(
        "iterations due in a clock that runs backwards or stops", sum(hours), 0, "time that does not pass"
    )
    quarter = Clock(1000.0).due(NS_PER_S // 4)
    yield report.same(
        "iterations due in a jump by a day, 1000/s", clock.due(86_400 * NS_PER_S), quarter, "a stall is ¼ s"
    )
    for speed in (240.0, 239.7):
        yield _year(speed)


def _year(speed):
    """Return the row on a year of frames at 59.94 Hz, found from how long the clock takes to come round.

    60000/1001 Hz: three frames are 50,050,000 ns. Once the clock's whole state is as it was at the start, it repeats
    itself, so the year is made of such rounds and a rest.
    """
    frames = (16_683_333, 16_683_334, 16_683_333)
    year = round(365.25 * 86_400 * 60_000 / 1001) // 3  # frames, in threes
    clock, start, threes, due = Clock(speed), vars(Clock(speed)), 0, 0
    while not threes or vars(clock) != start:
        due += sum(map(clock.due, frames))
        threes += 1
    rest = sum(sum(map(clock.due, frames)) for _ in range(year % threes))
    expected = year * sum(frames) * round(speed * 1000) // (1000 * NS_PER_S)
    return report.same(
        f"iterations due in a year at 59.94 Hz, {speed:g}/s", year // threes * due + rest, expected, ARITHMETIC
    )
