"""Piles and falling: the slope of a heap at rest, by friction, and how far a grain falls in a time."""

import numpy as np

from game import Rule, World, advance
from game.study.paper.settling import column
from game.study.physics.power_law import exponent_of
from game.study.report import report
from game.study.report.statistics import Sample
from game.study.report.table import Table
from game.world.sand.fixtures import Fixture
from game.world.sand.measure import pile_heights, slope_degrees

GRAINS = 900  # in a column that becomes a pile: 30 cells high
LOOK = 200  # iterations between two looks at it
PROBABILITIES = (1.0, 0.75, 0.5, 0.25)
STOPS = (1.0, 0.5, 0.2, 0.1, 0.08, 0.07, 0.05)  # chances that a rolling grain stops; one is the file's own
POURED, EVERY = 1500, 4  # grains of a poured pile, and iterations between two of them
FLOOR, TALL = 241, 110  # cells: of the lattice it is poured into
FLATTER = 12  # degrees, at least, between the ends of STOPS
REPOSE = "real dry sand: 30-35° (textbook angle of repose)"
STEPS = "a grain on a step of two cells can topple, whatever p > 0"
FRICTION = "as real sand: the rougher, the steeper"


def slopes_of_sand(study):
    """Yield rows on the slopes of columns that have become piles, by p."""
    highest, slopes = 0, {}
    for p in study.track(PROBABILITIES, "slopes"):
        found = []
        for seed in range(study.either(4, 16)):
            world = _at_rest(column(GRAINS, seed % 2, seed), Rule.with_p(p, "balanced"))
            heights = pile_heights(world)
            highest = max(highest, int(abs(np.diff(heights)).max()))
            found.append([slope_degrees(heights)])
        slopes[p] = Sample.of(found)
    yield report.same("highest step between neighbouring columns at rest, cells", highest, 1, STEPS)
    for p, slope in slopes.items():
        yield report.claimed(f"final slope, p = {p:g}, degrees", slope.mean[0], slope.error[0], 30.0, 35.0, REPOSE)


def slopes_of_rolling_sand(study, rule):
    """Yield the slopes of poured piles of rolling sand by its chance to stop, and rows on them."""
    slopes = {}
    for schedule in ("balanced", "paper"):
        for stop in study.track(STOPS, f"slopes, rolling-sand, {schedule}"):
            moving = rule.with_chances(stop=stop).with_schedule(schedule)
            heaps = (_poured(moving, seed) for seed in range(study.either(4, 32)))
            slopes[schedule, stop] = Sample.of([[slope_degrees(pile_heights(heap))] for heap in heaps])
    heads = "schedule", "stop", "slope, degrees", "standard error"
    rows = [(schedule, f"{stop:g}", each.mean[0], each.error[0]) for (schedule, stop), each in slopes.items()]
    yield Table.of(f"The slope of {POURED:,} poured grains of rolling-sand, by the chance that one stops.", heads, rows)
    for schedule in ("balanced", "paper"):
        slope = slopes[schedule, rule.stop]
        quantity = f"final slope, stop = {rule.stop:g}, {schedule}, degrees, rolling-sand"
        yield report.claimed(quantity, slope.mean[0], slope.error[0], 30.0, 35.0, REPOSE)
        fall, error = slopes[schedule, STOPS[0]].minus(slopes[schedule, STOPS[-1]])
        quantity = f"degrees by which stop = {STOPS[-1]:g} is flatter than {STOPS[0]:g}, {schedule}, rolling-sand"
        yield report.within(quantity, fall[0], error[0], FLATTER, np.inf, FRICTION)


def _poured(rule, seed):
    """Return a World of a heap at rest, that was poured grain by grain."""
    world = World.from_materials(np.zeros((TALL, FLOOR), np.uint8), rule, seed)
    world.fixtures = (Fixture("tap", FLOOR // 2, 0, every=EVERY),)
    advance(world, rule, POURED * EVERY)
    world.fixtures = ()
    return _at_rest(world, rule)


def _at_rest(world, rule):
    while not world.activity.settled:
        advance(world, rule, LOOK)
    return world


def free_fall(kind):
    """Return the row on how far a grain of a Kind falls."""
    times, fallen = (16, 32, 64, 128), []
    sand = np.zeros((200, 4), bool)
    sand[0, 1] = True
    world = World.from_cells(sand, np.zeros_like(sand)).of(kind.rule.codes)
    for time in times:
        advance(world, kind.rule.with_schedule("balanced"), time - world.iteration)
        fallen.append(int(np.flatnonzero(world.sand.any(axis=1))[0]))
    exponent, error = exponent_of(times, fallen)
    quantity = f"exponent of the fallen height in time{kind.suffix}"
    return report.claimed(quantity, exponent, error, 1.9, 2.1, "real sand: ½gt²")
