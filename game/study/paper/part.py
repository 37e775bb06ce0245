"""Part 2, the paper: its figures made again from its text, and its claims as rows with numbers."""

from itertools import pairwise

import numpy as np

from game import Rule, advance, load_scene
from game.study.paper import settling, sticking
from game.study.report import report
from game.study.report.drawing import densities, lattices
from game.study.report.report import Picture
from game.study.report.statistics import Sample, shape_of
from game.study.report.table import Table
from game.world.sand.ensemble import density

TITLE = "2. The paper"
SEED = 2
TIMES = (50, 200, 350, 500)  # iterations; the paper prints "t = 50 to t = 500, (a)-(d)"
PROBABILITIES = (0.25, 0.5, 0.75, 1.0)
MOMENT = 200  # iterations, of the paper's density maps
RUNS = 10_000  # of each density map, as in the paper
BATCHES = 10  # of runs, whose scatter gives the standard errors
CLAIM = "the paper: smaller p gives taller, thinner piles"


CONCLUSION = (
    "What does not hold as the paper says it. Piles grow taller at every step down in p, but not thinner at once: from "
    "p = 1 to 0.75 the contour gets a little wider. There is no change of kind at p = 0.5: at p = 1, too, more than "
    "half of the time in which a column settles goes with 1/p, and all piles end alike (part 6), so p is a viscosity "
    "and no friction. The standard neighbourhood sticks to one slope, but which one depends on the parity of the "
    "glass's column; and the paper's own neighbourhood builds one side first as well, with two thirds of the surplus."
)


def run(study):
    """Yield the rows and pictures of this part."""
    yield (
        "The paper does not print its glass; the scene `paper` draws one of its size, 61×61 cells with a neck of one "
        "cell. The schedule is the paper's. 'Differs' marks a claim that this model, made from the paper's text, does "
        "not bear out."
    )
    scene = load_scene("paper")
    yield from _deterministic(scene)
    yield from _maps(study, scene)
    yield from settling.rows(study)
    yield from sticking.rows()
    yield CONCLUSION


def _deterministic(scene):
    worlds, views = [scene.world(seed) for seed in range(5)], []
    for time in TIMES:
        for world in worlds:
            advance(world, Rule.with_p(1.0), time - world.iteration)
        views.append((f"t = {time}", worlds[0].sand))
    yield Picture(
        "deterministic",
        lattices(views, scene.walls, 4),
        "The deterministic hourglass, p = 1 (the paper's third figure).",
    )
    differing = sum(int((world.sand != worlds[0].sand).sum()) for world in worlds)
    yield report.same(
        f"cells that differ between 5 seeds at p = 1, t = {TIMES[-1]}", differing, 0, "the paper: p = 1 repeats exactly"
    )
    chance = [scene.world(seed) for seed in range(2)]
    for world in chance:
        advance(world, Rule.with_p(0.75), MOMENT)
    differing = int((chance[0].sand != chance[1].sand).sum())
    quantity = f"cells that differ between 2 seeds at p = 0.75, t = {MOMENT}"
    yield report.within(quantity, differing, None, 1, np.inf, "chance decides")


def _maps(study, scene):
    maps, shapes = {}, {}
    for p in study.track(PROBABILITIES, "density maps"):
        batches = [_density(scene, p, seed) for seed in range(BATCHES)]
        maps[p] = np.mean(batches, axis=0)
        shapes[p] = Sample.of([shape_of(each, scene.walls) for each in batches])
    views = [(f"p = {p:g}", each) for p, each in maps.items()]
    caption = f"Where sand is after {MOMENT} iterations: {RUNS:,} runs for each p (the paper's fourth figure)."
    yield Picture("density", densities(views, scene.walls, 4, "chance of sand in a cell"), caption)
    yield from _shape_rows(shapes)


def _density(scene, p, seed):
    return density(scene.world((SEED << 32) + seed), Rule.with_p(p), MOMENT, RUNS // BATCHES)


def _shape_rows(shapes):
    heads = "p", "contour's height", "contour's width", "mean height of a grain", "spread of grains sideways"
    rows = [(f"{p:g}", *shape.mean) for p, shape in shapes.items()]
    yield Table.of(
        f"The pile after {MOMENT} iterations, in cells; the contour is where the density is one half.", heads, rows
    )
    for low, high in pairwise(PROBABILITIES):
        change, error = shapes[low].minus(shapes[high])
        where = f"from p = {high:g} to {low:g}, cells"
        yield report.claimed(f"pile's contour grows in height {where}", change[0], error[0], 0, np.inf, CLAIM)
        yield report.claimed(f"pile's contour grows in width {where}", change[1], error[1], -np.inf, 0, CLAIM)
        yield report.claimed(f"grains lie higher on average {where}", change[2], error[2], 0, np.inf, CLAIM)
        yield report.claimed(f"grains spread wider sideways {where}", change[3], error[3], -np.inf, 0, CLAIM)
