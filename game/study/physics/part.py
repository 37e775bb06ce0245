"""Part 6, sand as physics: what the model gets right about real sand, and what it does not."""

import numpy as np

from game import Rule, World, advance
from game.study.paper.settling import column
from game.study.physics.hopper import Hopper
from game.study.report import report
from game.study.report.drawing import figure
from game.study.report.report import Picture
from game.study.report.statistics import Sample
from game.study.report.table import Table
from game.world.sand.measure import pile_heights, slope_degrees

TITLE = "6. Sand as physics"
WIDTH, HEIGHT = 96, 200  # cells, of the hopper
GRAINS = 900  # in a column that becomes a pile: 30 cells high
LOOK = 200  # iterations between two looks at it
NECKS = (2, 4, 6, 8, 12, 16, 24)  # cells
PROBABILITIES = (1.0, 0.75, 0.5, 0.25)
ROUNDED = 9  # decimals of a fitted exponent; what lies beyond is the rounding of the fit
PER_COLUMN = {"balanced": 0.5, "paper": 0.25}  # grains per iteration
PLUG = "a full column of sand loses a grain every second iteration (paper: every fourth)"
SURFACES = "two free surfaces feed the neck, each as fast as one column falls, however wide it is"
BEVERLOO = "real sand: flow ∝ width^3/2 in two dimensions (Beverloo, Leniger & van de Velde 1961)"
CONSTANT = "real sand: the flow of an hourglass hardly depends on the height above (Janssen 1895; Beverloo 1961)"
REPOSE = "real dry sand: 30-35° (textbook angle of repose)"
STEPS = "a grain on a step of two cells can topple, whatever p > 0"
CONCLUSION = (
    "Right: sand is conserved and heaps into cones with straight flanks, and at p ≥ 0.75 a glass runs out at a rate "
    "that does not depend on how much is left. Not right: at p ≤ 0.5 the flow dwindles with the sand above; the slope "
    "is close to 45° for every p, because the lattice sets it and p only says how long it takes to get there (cells "
    "drawn 1.5 times as wide as high would show 33°); grains fall at one speed instead of faster and faster; and once "
    "the plug above a neck has fallen, the flow does not depend on the neck's width, because only the free surface "
    "moves: a wide neck empties a glass hardly sooner than one of two cells. There is no jamming, no inertia and no "
    "pressure."
)


def run(study):
    """Yield the rows, tables and pictures of this part."""
    yield from _necks(study)
    yield from _heights(study)
    yield from _slopes(study)
    yield _free_fall()
    yield CONCLUSION


def _necks(study):
    flows = {}
    for schedule in PER_COLUMN:
        for neck in study.track(NECKS, f"necks, {schedule}"):
            hopper = Hopper(WIDTH, HEIGHT, neck, 0.75, schedule)
            hopper.run(4)
            plug = hopper.run(4)
            hopper.run(40)
            flows[schedule, neck] = plug, hopper.run(20)
    heads = "schedule", "neck, cells", "flow at first, grains per iteration", "flow later"
    yield Table.of("Flow out of a full hopper, p = 0.75.", heads, [(*each, *rates) for each, rates in flows.items()])
    yield Picture(
        "neck", _neck_figure(flows), "Flow against the width of the neck, beside Beverloo's law for real sand."
    )
    for schedule, rate in PER_COLUMN.items():
        plug, steady = np.transpose([flows[schedule, neck] for neck in NECKS])
        furthest = float(abs(plug / NECKS - rate).max())
        yield report.same(f"largest error of the first flow per column of the neck, {schedule}", furthest, 0.0, PLUG)
        furthest = float(abs(steady - 2 * rate).max())
        yield report.same(f"largest error of the later flow as two columns' worth, {schedule}", furthest, 0.0, SURFACES)
        for words, rates in (("first", plug), ("later", steady)):
            exponent, error = _exponent(NECKS, rates)
            quantity = f"exponent of the {words} flow in the neck's width, {schedule}"
            yield report.claimed(quantity, exponent, error, 1.4, 1.6, BEVERLOO)


def _exponent(x, y):
    """Return (exponent, standard error) of a power law through the points."""
    (slope, _), covariance = np.polyfit(np.log(x), np.log(y), 1, cov=True)
    return round(float(slope), ROUNDED), round(float(np.sqrt(max(covariance[0, 0], 0.0))), ROUNDED)


def _neck_figure(flows):
    drawn, axes = figure(width=6.0, height=4.0)
    for schedule, colour in zip(PER_COLUMN, ("#b5761f", "#2f6f8f"), strict=True):
        plug, steady = np.transpose([flows[schedule, neck] for neck in NECKS])
        axes.loglog(NECKS, plug, "o-", color=colour, label=f"{schedule}: the plug above the neck falls")
        axes.loglog(NECKS, steady, "s--", color=colour, label=f"{schedule}: later, the surface flows")
    widths = np.array(NECKS, float)
    axes.loglog(widths, 0.5 * (widths / 2) ** 1.5, ":", color="#8a7f70", label="real sand, slope 3/2 (any unit)")
    axes.set_xticks(NECKS, [str(neck) for neck in NECKS])
    axes.set_xticks([], minor=True)
    axes.set_yticks([0.5, 1, 2, 5, 10, 20], ["0.5", "1", "2", "5", "10", "20"])
    axes.set_xlabel("width of the neck, cells")
    axes.set_ylabel("flow, grains per iteration")
    axes.legend(frameon=False, fontsize=8)
    return drawn


def _heights(study):
    """Yield rows on the flow while a hopper runs down from four fifths to two fifths."""
    for p in study.track(PROBABILITIES, "heights"):
        found = []
        for seed in range(study.either(2, 16)):
            hopper = Hopper(WIDTH, HEIGHT, 4, p, seed=seed)
            full = hopper.grains
            flows = [_flow_at(hopper, part * full) for part in (0.8, 0.6, 0.4)]
            found.append([np.log(flows[0] / flows[2]) / np.log(2.0), flows[0], flows[2]])
        sample = Sample.of(found)
        quantity = f"exponent of the flow in the sand left, from 80 % to 40 %, p = {p:g}"
        yield report.claimed(quantity, sample.mean[0], sample.error[0], -0.05, 0.05, CONSTANT)


def _flow_at(hopper, grains):
    while hopper.grains > grains:
        hopper.run(4)
    return hopper.run(10)


def _slopes(study):
    highest, slopes = 0, {}
    for p in study.track(PROBABILITIES, "slopes"):
        found = []
        for seed in range(study.either(4, 16)):
            world = column(GRAINS, seed % 2, seed)
            while not world.activity.settled:
                advance(world, Rule.with_p(p, "balanced"), LOOK)
            heights = pile_heights(world)
            highest = max(highest, int(abs(np.diff(heights)).max()))
            found.append([slope_degrees(heights)])
        slopes[p] = Sample.of(found)
    yield report.same("highest step between neighbouring columns at rest, cells", highest, 1, STEPS)
    for p, slope in slopes.items():
        yield report.claimed(f"final slope, p = {p:g}, degrees", slope.mean[0], slope.error[0], 30.0, 35.0, REPOSE)


def _free_fall():
    times, fallen = (16, 32, 64, 128), []
    sand = np.zeros((200, 4), bool)
    sand[0, 1] = True
    world = World.from_cells(sand, np.zeros_like(sand))
    for time in times:
        advance(world, Rule(schedule="balanced"), time - world.iteration)
        fallen.append(int(np.flatnonzero(world.sand.any(axis=1))[0]))
    exponent, error = _exponent(times, fallen)
    return report.claimed("exponent of the fallen height in time", exponent, error, 1.9, 2.1, "real sand: ½gt²")
