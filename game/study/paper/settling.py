"""Settling: how long a column of sand takes to become a pile, and whether p is a friction or a viscosity."""

import numpy as np

from game import Rule, World, advance
from game.study.report import report
from game.study.report.statistics import Sample
from game.study.report.table import Table
from game.world.sand.measure import pile_heights, slope_degrees

GRAINS = 120  # in the column
STEP = 4  # iterations between two looks: one round of a schedule
PROBABILITIES = (0.0625, 0.125, 0.25, 0.5, 0.75, 1.0)
LOW, MIDDLE, HIGH = 0.25, 0.5, 1.0
HALF = -0.5  # exponent at which half of the time goes with 1/p
FLUID = "the paper: p ≤ 0.5 flows like a viscous fluid; below −½ most of the time goes with 1/p"
GRAINY = "the paper: p > 0.5 gives granular flow; above −½ most of the time is free fall"


def rows(study):
    """Yield rows on the paper's viscous fluid."""
    found = {p: _settled(p, study.either(16, 64)) for p in study.track(PROBABILITIES, "settling")}
    heads = "p", "iterations to rest", "standard error", "iterations × p", "final slope, degrees"
    table = [(f"{p:g}", each.mean[0], each.error[0], each.mean[0] * p, each.mean[1]) for p, each in found.items()]
    yield (
        "Viscosity is measured by how long a column of sand, one cell wide, takes to come to rest. If p is a friction, "
        "the angle of the pile at rest depends on p; if it is a viscosity, only the time does: a part for the fall, "
        "and a part that goes with 1/p."
    )
    yield Table.of(f"A column of {GRAINS} grains on a floor, the paper's schedule.", heads, table)
    for low, high in ((LOW, MIDDLE), (MIDDLE, HIGH)):
        exponent, error = _exponent(found, low, high)
        quantity = f"exponent of the settling time in p, from {low:g} to {high:g}"
        claim = (-1.0, HALF, FLUID) if high == MIDDLE else (HALF, 0.0, GRAINY)
        yield report.claimed(quantity, exponent, error, *claim)


def _exponent(found, low, high):
    slow, fast = found[low], found[high]
    error = np.hypot(slow.error[0] / slow.mean[0], fast.error[0] / fast.mean[0])
    return np.log(slow.mean[0] / fast.mean[0]) / np.log(low / high), error / np.log(high / low)


def _settled(p, runs):
    """Return the Sample of (iterations to rest, final slope) over runs that differ in seed and parity of place."""
    found = []
    for seed in range(runs):
        world, rule = column(GRAINS, seed % 2, seed), Rule.with_p(p)
        moved = 0
        while not world.activity.settled:
            before = world.sand
            advance(world, rule, STEP)
            moved = world.iteration if (before != world.sand).any() else moved
        found.append((moved, slope_degrees(pile_heights(world))))
    return Sample.of(found)


def column(grains, shift, seed):
    """Return a World with one column of so many grains on the floor of a wide lattice."""
    sand = np.zeros((grains + 2, grains), bool)
    sand[2:, grains // 2 + shift] = True
    return World.from_cells(sand, np.zeros_like(sand), seed)
