"""Scaling: the time of an iteration against the number of cells, at the paper's five resolutions."""

import time

import numpy as np

from game import Rule, World, advance
from game.study.report import verdict
from game.study.report.report import Table

PAPER = {(640, 480): 1.0, (800, 600): 1.45, (1920, 1080): 6.98, (2560, 1440): 12.61, (3840, 2160): 27.88}
ROUNDS = 9
ITERATIONS = 100  # in a round; a row of the smallest lattice falls 50 cells meanwhile
FOLLOWS = "the paper: time follows the cells"


def rows(study):
    """Yield the paper's table of times again, as ratios, on lattices where everything falls."""
    sizes = list(PAPER)
    worlds = {size: _stirred(*size) for size in sizes}
    taken = {size: [] for size in sizes}
    for _ in study.track(range(ROUNDS), "time against cells"):
        for size in sizes:
            taken[size].append(_time(worlds[size], ITERATIONS))
    median = {size: float(np.median(each)) for size, each in taken.items()}
    base, cells = median[sizes[0]], sizes[0][0] * sizes[0][1]
    table = [(f"{w}×{h}", w * h / cells, median[w, h] / base, PAPER[w, h]) for w, h in sizes]
    heads = "lattice", "cells", "time, measured", "time, the paper's"
    yield Table("Time of one iteration against cells, each as a multiple of 640×480.", heads, table)
    sizes_log = np.log([w * h for w, h in sizes])
    for words, times in (("measured", list(median.values())), ("of the paper's table", list(PAPER.values()))):
        exponent = float(np.polyfit(sizes_log, np.log(times), 1)[0])
        yield verdict.claimed(f"exponent of time in cells, {words}", exponent, None, 0.9, 1.1, FOLLOWS)


def _stirred(width, height):
    """Return a World half full of sand at random, its upper half empty below: most of it moves for long."""
    sand = np.random.default_rng(1).random((height, width)) < 0.5
    sand[height // 2 :] = False
    return World.from_cells(sand, np.zeros_like(sand), 1)


def _time(start, iterations):
    world = start.copy()
    begin = time.perf_counter()
    advance(world, Rule.with_p(0.75), iterations)
    return (time.perf_counter() - begin) / iterations
