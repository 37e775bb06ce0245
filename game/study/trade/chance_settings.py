"""Settings of chance: bits of p, sources of random bits and numbers of runs, each a series of Points."""

import time

import numpy as np

from game import Rule, advance, load_scene
from game.study.trade.cheap_random import FRESH, SOURCES, run_cheaply
from game.study.trade.points import floor_of, point
from game.world.sand.ensemble import density
from game.world.sand.parameters import RUNS
from game.world.sand.world import World

P = 0.7  # no short binary fraction
MOMENT = 200  # iterations, as in the paper's density maps
BITS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32)
RUN_NUMBERS = (100, 1_000, 10_000, 100_000)
ROUNDS = 21
CHUNK = 20  # runs with one source before the next has its turn
BITS_SERIES, SOURCE_SERIES, RUN_SERIES = "bits of p", "source of random bits", "runs of a forecast"


class Reference:
    """The paper's glass under balanced, and its density map from very many runs of the exact kernel."""

    def __init__(self, study):
        scene = load_scene("paper")
        self.sand, self.walls = scene.sand, scene.walls
        self.runs_compared, self.runs = study.either(2**16, 2**21), study.either(2**18, 2**23)
        self.cheap_runs = study.either(500, 30_000)
        self.rule = Rule.with_p(P, "balanced")
        self.map = self.density(P, self.runs, seed=1)

    def density(self, p, runs, seed):
        """Return the density map at probability p."""
        return density(World.from_cells(self.sand, self.walls, seed), Rule.with_p(p, "balanced"), MOMENT, runs)

    def floor(self, runs):
        """Return the statistical floor of a map of so many runs held against the reference."""
        return floor_of(self.map, runs, self.runs)


def shortened(p, bits):
    """Return p rounded to so many binary digits."""
    return round(p * 2**bits) / 2**bits


def bits_points(study, reference):
    """Return the Points of p rounded to fewer bits, the largest number of bits being the default."""
    costs = _costs_of_bits()
    points = []
    for bits in study.track(BITS, "bits of p"):
        found = reference.density(shortened(P, bits), reference.runs_compared, seed=100 + bits)
        setting = f"{bits} (p = {shortened(P, bits):.6g})" if bits < 24 else str(bits)
        floor, cost = reference.floor(reference.runs_compared), costs[bits]
        points.append(point(BITS_SERIES, setting, found, reference.map, floor, cost, bits == BITS[-1]))
    return points, costs[None]


def _costs_of_bits():
    """Return the cost of a large draining glass at each number of bits, and at p = 1 (None)."""
    scene = load_scene("fullhd")
    start, times = scene.world(1), {bits: [] for bits in (*BITS, None)}
    advance(start, Rule.with_p(P, "balanced"), 300)
    for _ in range(ROUNDS):
        for bits in times:
            rule, world = Rule.with_p(shortened(P, bits) if bits else 1.0, "balanced"), start.copy()
            begin = time.perf_counter()
            advance(world, rule, 60)
            times[bits].append(time.perf_counter() - begin)
    return {bits: ratio(each, times[BITS[-1]]) for bits, each in times.items()}


def ratio(times, others):
    """Return the median ratio of times to others taken in the same turns: a busy machine slows both."""
    return float(np.median(np.divide(times, others)))


def source_points(study, reference):
    """Return (Points of the sources, {source: scatter of the surplus of grains on one side, in grains})."""
    chunks = reference.cheap_runs // CHUNK
    times, found = {words: [] for words in SOURCES}, {words: [] for words in SOURCES}
    glass = reference.sand, reference.walls, P, reference.rule.offsets
    run_cheaply(*glass, 1, 1, FRESH, 0)  # compiles
    for number in study.track(range(chunks), "sources of random bits"):
        for words, source in SOURCES.items():
            begin = time.perf_counter()
            found[words].append(run_cheaply(*glass, MOMENT, CHUNK, source, 300 + number))
            times[words].append(time.perf_counter() - begin)
    fresh = next(iter(SOURCES))
    points, scatter, floor = [], {}, reference.floor(reference.cheap_runs)
    for words, each in found.items():
        density = sum(counts for counts, _ in each) / reference.cheap_runs
        cost, scatter[words] = ratio(times[words], times[fresh]), float(np.concatenate([s for _, s in each]).std())
        points.append(point(SOURCE_SERIES, words, density, reference.map, floor, cost, words == fresh))
    return points, scatter


def run_points(study, reference):
    """Return the Points of forecasts from fewer and more runs than the default."""
    times, maps = dict.fromkeys(RUN_NUMBERS, np.inf), {}
    for runs in study.track(RUN_NUMBERS * 3, "runs"):
        begin = time.perf_counter()
        maps[runs] = reference.density(P, runs, seed=4)
        times[runs] = min(times[runs], time.perf_counter() - begin)
    default = RUNS.default
    return [
        point(
            RUN_SERIES,
            f"{runs:,}",
            found,
            reference.map,
            reference.floor(runs),
            times[runs] / times[default],
            runs == default,
        )
        for runs, found in maps.items()
    ]
