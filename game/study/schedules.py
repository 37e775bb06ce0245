"""Part 4, the three schedules: fall speed, lean to one side, what gets stuck, and how long a glass takes to drain."""

from itertools import product

import numpy as np

from game import Rule, World, advance, load_scene, scene_names
from game.study.paper.sticking import ALL_FOUR, LONG, MIRRORED, SIDE, glass, stuck
from game.study.report import report
from game.study.report.statistics import Sample
from game.study.report.table import Table
from game.world.rules.rule import SCHEDULES
from game.world.sand.ensemble import counts_at
from game.world.sand.measure import grains_above
from game.world.scenes.hourglass import hourglass

TITLE = "4. The three schedules"
SEED = 4
FALL = 400  # iterations a grain falls for
SPEEDS = {"margolus": 1.0, "paper": 0.5, "balanced": 1.0}  # cells per iteration
TWICE = "an iteration moves a grain down by a cell; paper uses each row offset twice running, the second time in vain"
ITSELF = "an even width: the mirror image of every partition is itself"
PROBABILITIES = (1.0, 0.75, 0.5)
MOMENT = 300  # iterations: half of the glass has run through
BATCHES = 16  # of runs, whose scatter gives the standard errors
LOOK = 4  # iterations between two looks at a draining glass
SHIPPED = "balanced"
APART = "the mirror image of each schedule is the schedule moved by a column"
LEAN = (
    f"Lean of the pile after {MOMENT} iterations: grains on the right less grains on the left of the axis, in percent "
    "of both; mean over starts at iterations 0 and 2 of the schedule."
)


def run(study):
    """Yield the rows and tables of this part."""
    yield from _speeds()
    yield from _symmetries()
    yield from _leans(study)
    yield from _stuck()
    yield from _drains(study)
    yield from _decision()


def _decision():
    rules = {name: load_scene(name).rule for name in scene_names() if name != "paper"}
    others = [name for name, rule in rules.items() if rule.codes.is_sand and rule.schedule != SHIPPED]
    quantity = f"shipped scenes of sand, but for the paper's, that do not use {SHIPPED}"
    yield report.same(quantity, ", ".join(others) or "none", "none", "this section")
    yield (
        f"So the shipped scenes use {SHIPPED}: it falls as fast as margolus, drains to the last grain as the paper's "
        "does, in half to nine tenths of the time, and is the only one without a lean wherever the sand comes from. "
        "The lean of the others comes and goes with the parity of the source's column, and is gone where the axis "
        "lies between two columns."
    )


def _speeds():
    for name, expected in SPEEDS.items():
        found = {_speed(name, column, row) for column, row in product((0, 1), (0, 1))}
        measured = found.pop() if len(found) == 1 else str(sorted(found))
        yield report.same(f"speed of a free grain, {name}, cells per iteration", measured, expected, TWICE)


def _speed(schedule, column, row):
    sand = np.zeros((FALL + 50, 4), bool)
    sand[row, 1 + column] = True
    world, rule, places = World.from_cells(sand, np.zeros_like(sand)), Rule(schedule=schedule), []
    for iterations in (LOOK, FALL):  # the first few depend on where the grain starts in its round
        advance(world, rule, iterations)
        places.append(int(np.flatnonzero(world.sand.any(axis=1))[0]))
    return (places[1] - places[0]) / FALL


def _symmetries():
    """Yield rows on mirror images, cell by cell at p = 1."""
    sand, walls = hourglass(SIDE + 1, SIDE + 1, 2, 0.0, 1, 0.8)
    for name in SCHEDULES:
        world = World.from_cells(sand, walls)
        differing = _unlike(world, world.copy(), name)
        yield report.same(f"cells unlike their mirror image, even width, {name}", differing, 0, ITSELF)
    sand, walls, _ = glass(0)
    for name in SCHEDULES:
        later = World.from_cells(sand, walls)
        later.iteration = 2
        differing = _unlike(World.from_cells(sand, walls), later, name)
        quantity = f"cells unlike the mirror image started two iterations later, odd width, {name}"
        if name == SHIPPED:
            yield report.same(quantity, differing, 0, MIRRORED)
        else:
            yield report.noted(quantity, differing)


def _unlike(world, other, schedule):
    """Return how many cells differ between a world and the mirror image of another, summed over their way."""
    differing = 0
    for _ in range(100):
        advance(world, Rule(schedule=schedule), 7)
        advance(other, Rule(schedule=schedule), 7)
        differing += int((world.sand != other.sand[:, ::-1]).sum())
    return differing


def _leans(study):
    found = {}
    for name, p, right in study.track(list(product(SCHEDULES, PROBABILITIES, (0, 1))), "leans"):
        found[name, p, right] = _lean(name, p, right, study.either(256, 4096))
    table = [(name, f"{p:g}", right, each.mean[0], each.error[0]) for (name, p, right), each in found.items()]
    heads = "schedule", "p", "glass moved right by", "lean, %", "standard error"
    yield Table.of(LEAN, heads, table)
    for name, p in product(SCHEDULES, PROBABILITIES):
        here, moved = (found[name, p, right] for right in (0, 1))
        error = np.hypot(here.error[0], moved.error[0])
        quantity = f"lean in two glasses a column apart, summed, {name}, p = {p:g}, %"
        yield report.close(quantity, here.mean[0] + moved.mean[0], error, 0.0, APART)
        if name == SHIPPED:
            quantity = f"lean of the pile, {name}, p = {p:g}, %"
            yield report.close(quantity, here.mean[0], here.error[0], 0.0, MIRRORED)
        else:
            yield report.noted(f"lean of the pile, {name}, p = {p:g}, %", here.mean[0], here.error[0])


def _lean(schedule, p, right, runs):
    sand, walls, axis = glass(right)
    leans = []
    for batch in range(BATCHES):
        seeds = ((SEED << 32) + 2 * batch + late for late in (0, 1))
        rule = Rule.with_p(p, schedule)
        counts = sum(
            counts_at(_late(World.from_cells(sand, walls, seed), 2 * late), rule, [MOMENT], runs)[0]
            for late, seed in enumerate(seeds)
        )[SIDE // 2 + 1 :]
        sides = counts[:, axis + 1 :].sum(), counts[:, :axis].sum()
        leans.append([100.0 * (sides[0] - sides[1]) / sum(sides)])
    return Sample.of(leans)


def _late(world, iterations):
    """Return the world, which is at another partition of the schedule after so many iterations."""
    world.iteration += iterations
    return world


def _stuck():
    for name in SCHEDULES:
        cases = product(PROBABILITIES, (0, 1), (0, 1))
        left = sum(sum(stuck(name, p, right, down)) for p, right, down in cases)
        quantity = f"grains left above the neck after {LONG:,} iterations, 12 glasses of all parities and p, {name}"
        if name == "margolus":
            yield report.noted(quantity, left)
        else:
            yield report.same(quantity, left, 0, ALL_FOUR)


def _drains(study):
    table = []
    cases = list(product(SCHEDULES, PROBABILITIES, (SIDE, SIDE + 1)))
    for name, p, width in study.track(cases, "drains"):
        times = [_drain(width, name, p, seed) for seed in range(study.either(4, 40))]
        case = name, f"{p:g}", "odd" if width % 2 else "even"
        if None in times:
            table.append((*case, "never", ""))
        else:
            found = Sample.of([[time] for time in times])
            table.append((*case, found.mean[0], found.error[0]))
    yield Table.of(
        "Iterations until the upper bulb of a symmetric glass is empty, its neck 1 cell (odd width) or 2 cells (even).",
        ("schedule", "p", "width", "iterations", "standard error"),
        table,
    )


def _drain(width, schedule, p, seed):
    """Return the iterations until nothing is left in the upper half of a glass, or None if that takes too long."""
    sand, walls = hourglass(SIDE, width, 2 - width % 2, 0.0, 1, 0.8)
    world, rule = World.from_cells(sand, walls, seed), Rule.with_p(p, schedule)
    while grains_above(world, SIDE // 2):
        if world.iteration > LONG:
            return None
        advance(world, rule, LOOK)
    return world.iteration
