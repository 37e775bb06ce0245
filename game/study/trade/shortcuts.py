"""Shortcuts: what a user might be tempted by, iterations in larger batches and float32 counts."""

import time

import numpy as np

from game import Rule, advance, load_scene
from game.study.report import verdict
from game.study.report.report import Table
from game.study.trade.chance_settings import ratio
from game.world.sand.ensemble import counts_at

TOTAL = 960  # iterations
BATCHES = (1, 4, 16, 960)  # iterations to a frame
DEFAULT = 4  # at 240 iterations per second and 60 frames
LARGEST = 2**24  # the last whole number that float32 can count up to
BEYOND = 1000
ROUNDS = 9
PLACE_AND_TIME = "chance depends on place and time alone"


def rows():
    """Yield rows and a table on both."""
    digests, times = {}, {batch: [] for batch in BATCHES}
    scene = load_scene("hourglass")
    for batch in BATCHES * ROUNDS:
        world = scene.world(1)
        begin = time.perf_counter()
        for _ in range(TOTAL // batch):
            advance(world, scene.rule, batch)
        times[batch].append(time.perf_counter() - begin)
        digests[batch] = world.digest()
    quantity = f"different outcomes of {TOTAL} iterations, {', '.join(map(str, BATCHES))} to a frame"
    yield verdict.same(quantity, len(set(digests.values())) - 1, 0, PLACE_AND_TIME)
    table = [(batch, ratio(times[batch], times[DEFAULT])) for batch in BATCHES]
    heads = "iterations to a frame", "time for the same iterations"
    yield Table(f"Time of `advance` alone, as a multiple of that at {DEFAULT} to a frame.", heads, table)
    ones = np.ones(LARGEST + BEYOND, np.float32)
    quantity = f"runs that a float32 sum misses of {LARGEST + BEYOND:,}"
    yield verdict.same(quantity, len(ones) - int(np.cumsum(ones)[-1]), BEYOND, "24 bits of significand")
    yield verdict.same(f"runs that the exact count misses of {LARGEST + BEYOND:,}", _missed(), 0, "int64")


def _missed():
    """Return how many runs of a world that stands still the forecast does not count."""
    sand = np.ones((1, 2), bool)
    counts = counts_at(sand, np.zeros_like(sand), Rule.with_p(0.5), [1], LARGEST + BEYOND)
    return LARGEST + BEYOND - int(counts.min())
