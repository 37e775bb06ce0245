"""Flow: how fast sand leaves a hopper, by the width of its neck and by what is left; and whether a glass runs out."""

import numpy as np

from game import Rule, advance, load_scene
from game.study.physics.hopper import Hopper
from game.study.physics.kinds import KINDS, SAND
from game.study.physics.power_law import exponent_of
from game.study.report import report
from game.study.report.drawing import figure
from game.study.report.report import Picture
from game.study.report.statistics import Sample
from game.study.report.table import Table
from game.world.sand.measure import grains_above

WIDTH, HEIGHT = 96, 200  # cells, of the hopper
NECKS = (2, 4, 6, 8, 12, 16, 24)  # cells
PROBABILITIES = (1.0, 0.75, 0.5, 0.25)
STOPS = (1.0, 0.2, 0.05)  # chances that a rolling grain stops, besides the file's own
NECK_ROW = 30  # of the scene `paper`
LONGEST = 20_000  # iterations in which a glass may run out
PER_COLUMN = {"balanced": 0.5, "paper": 0.25}  # grains per iteration
PLUG = "a full column of sand loses a grain every second iteration (paper: every fourth)"
SURFACES = "two free surfaces feed the neck, each as fast as one column falls, however wide it is"
BEVERLOO = "real sand: flow ∝ width^3/2 in two dimensions (Beverloo, Leniger & van de Velde 1961)"
CONSTANT = "real sand: the flow of an hourglass hardly depends on the height above (Janssen 1895; Beverloo 1961)"
DRAINS = "real sand: an hourglass runs out"
SOONER = "a grain that rolls on leaves the neck free for the next"


def necks(study, kind):
    """Yield rows on the flow against the width of the neck, for a Kind; for the paper's sand with a picture."""
    flows = {}
    for schedule in PER_COLUMN:
        for neck in study.track(NECKS, f"necks, {kind.name}, {schedule}"):
            hopper = Hopper(WIDTH, HEIGHT, neck, kind.rule.with_schedule(schedule))
            hopper.run(4)
            plug = hopper.run(4)
            hopper.run(40)
            flows[schedule, neck] = plug, hopper.run(20)
    heads = "schedule", "neck, cells", "flow at first, grains per iteration", "flow later"
    yield Table.of(
        f"Flow out of a full hopper, {kind.name}.", heads, [(*each, *rates) for each, rates in flows.items()]
    )
    if kind is SAND:
        caption = "Flow against the width of the neck, beside Beverloo's law for real sand."
        yield Picture("neck", _neck_figure(flows), caption)
    for schedule, rate in PER_COLUMN.items():
        plug, steady = np.transpose([flows[schedule, neck] for neck in NECKS])
        where = f"{schedule}{kind.suffix}"
        furthest = float(abs(plug / NECKS - rate).max())
        yield report.same(f"largest error of the first flow per column of the neck, {where}", furthest, 0.0, PLUG)
        furthest = float(abs(steady - 2 * rate).max())
        yield report.same(f"largest error of the later flow as two columns' worth, {where}", furthest, 0.0, SURFACES)
        for words, rates in (("first", plug), ("later", steady)):
            exponent, error = exponent_of(NECKS, rates)
            quantity = f"exponent of the {words} flow in the neck's width, {where}"
            yield report.claimed(quantity, exponent, error, 1.4, 1.6, BEVERLOO)


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


def heights(study, rules):
    """Yield rows on the flow while a hopper runs down from four fifths to two fifths; rules: {words: Rule}."""
    for words, rule in study.track(rules.items(), "heights"):
        found = []
        for seed in range(study.either(2, 16)):
            hopper = Hopper(WIDTH, HEIGHT, 4, rule.with_schedule("balanced"), seed)
            full = hopper.grains
            flows = [_flow_at(hopper, part * full) for part in (0.8, 0.6, 0.4)]
            found.append([np.log(flows[0] / flows[2]) / np.log(2.0)])
        sample = Sample.of(found)
        quantity = f"exponent of the flow in the sand left, from 80 % to 40 %, {words}"
        yield report.claimed(quantity, sample.mean[0], sample.error[0], -0.05, 0.05, CONSTANT)


def _flow_at(hopper, grains):
    while hopper.grains > grains:
        hopper.run(4)
    return hopper.run(10)


def of_sand():
    """Return the rules of sand whose flow is measured, by their p."""
    return {f"p = {p:g}": Rule.with_p(p) for p in PROBABILITIES}


def of_rolling_sand(rule):
    """Return the rules of rolling sand whose flow is measured, by their chance to stop."""
    return {f"rolling-sand, stop = {stop:g}": rule.with_chances(stop=stop) for stop in (*STOPS, rule.stop)}


def drains(study):
    """Yield rows on the glass of the paper with each kind of sand: what stays above, and how long it takes."""
    took = {}
    for kind in KINDS:
        left, times = 0, []
        for seed in range(study.either(4, 32)):
            world = load_scene("paper").world(seed).of(kind.rule.codes)
            while grains_above(world, NECK_ROW) and world.iteration < LONGEST:
                advance(world, kind.rule, 4)
            left += grains_above(world, NECK_ROW)
            times.append([world.iteration])
        took[kind] = Sample.of(times)
        yield report.claimed(f"grains that stay in the upper bulb, {kind.name}", left, None, 0, 0, DRAINS)
    slow, fast = (took[kind] for kind in KINDS)
    sooner, error = slow.minus(fast)
    quantity = "iterations by which the glass runs out sooner with rolling-sand than with p = 0.75"
    yield report.within(quantity, sooner[0], error[0], 0, np.inf, SOONER)
