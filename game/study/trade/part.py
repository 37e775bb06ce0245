"""Part 3, speed against error: what a scene can save, and what that does to the density map."""

import time

import numpy as np

from game import Rule, advance, load_scene
from game.study.report import report
from game.study.report.drawing import figure
from game.study.report.report import Picture
from game.study.report.table import Table
from game.study.trade.cell_sizes import CELLS, SERIES, drains, pixel_points, pixel_table
from game.study.trade.chance_settings import (
    BITS,
    BITS_SERIES,
    MOMENT,
    RUN_SERIES,
    SOURCE_SERIES,
    P,
    Reference,
    bits_points,
    ratio,
    run_points,
    shortened,
    source_points,
)
from game.world.sand.ensemble import counts_at
from game.world.sand.world import World

TITLE = "3. Speed against error"
# Standard deviation, over 100 seeds, of an rms that is chance alone, in floors: the few uncertain cells hang together.
SCATTER = 0.12
BELOW = "an error of p of 2⁻¹⁷ or less is far below the floor"
ALIKE = "two kernels of one rule, apart by chance alone"
FALLEN = "as many grains per iteration at any size (part 6), so −1"
COLOURS = {BITS_SERIES: "#b5761f", SOURCE_SERIES: "#a33d3d", RUN_SERIES: "#2f6f8f", SERIES: "#4f8a4b"}
SPANS = {BITS_SERIES: (0.4, 6), SOURCE_SERIES: (0.4, 6), RUN_SERIES: (0.005, 80), SERIES: (0.005, 80)}
TICKS = {0.4: (0.5, 1, 2, 5), 0.005: (0.01, 0.1, 1, 10)}  # by the lower end of a span
GREY = "#8a7f70"
TOTAL = 960  # iterations, played in …
BATCHES = (1, 4, 16, 960)  # … so many to a frame
DEFAULT_BATCH = 4  # at 240 iterations per second and 60 frames
ROUNDS = 9
PLACE_AND_TIME = "chance depends on place and time alone"
MANY_RUNS = 2**24 + 1000  # more than float32 can count
HEADS = "setting", "value", "rms error", "largest error", "grains misplaced", "floor of the rms", "cost"


CONCLUSION = (
    "The defaults, and why. 32 bits of p: a draw stops as soon as its candidates are decided, so that fewer bits save "
    "nothing, and fewer than 8 show in a forecast of 10,000 runs. A fresh draw for each candidate: 64 blocks share the "
    "work of three or four random words already, and even block by block sharing saves a percent or two, because "
    "candidates are few, while it pulls the map off; a draw for a whole row is the only one that hardly does, in a "
    "glass this narrow. 10,000 runs: many more runs take many times the time, for an error that is below a shade of "
    "the map already. 3 pixels to a cell: every size is on the frontier, as error falls and time rises throughout, and "
    "none is right for all, because the flow is so many grains per iteration at any size and larger cells drain a "
    "glass sooner. Iterations to a frame change nothing but the overhead of calls. Counts are whole numbers: float32 "
    "stops counting at 2²⁴ runs."
)


def run(study):
    """Yield the rows, tables and the picture of this part."""
    reference = Reference(study)
    yield (
        f"The map is the chance of sand in each cell of the paper's glass (528 grains) at t = {MOMENT}, p = {P:g}, "
        f"balanced; errors are in percentage points of that chance, against {reference.runs:,} runs of the exact "
        "kernel. For pixels to a cell it is the share of sand in squares of 16×16 pixels when half has run through, "
        "against one pixel to a cell. The floor is what chance alone gives. Cost is time as a multiple of the default "
        "(*), measured in this run."
    )
    bits, certain = bits_points(study, reference)
    sources, scatter = source_points(study, reference)
    found = drains(study)
    points = [*bits, *sources, *run_points(study, reference), *pixel_points(found)]
    yield Table.of("Error and cost of each setting.", HEADS, [_cells(each) for each in points])
    caption = "Error of the density map against cost; ringed: the defaults. Dashed: the statistical floor of a series."
    yield Picture("trade", drawn(points), caption)
    yield from _bits_rows(bits, certain)
    yield from _source_rows(sources, scatter)
    yield from _pixel_rows(found)
    yield from _batches()
    yield _exact_count()
    yield CONCLUSION


def _cells(each):
    mark = " *" if each.is_default else ""
    return each.series, each.setting + mark, each.rms, each.most, each.misplaced, each.floor, each.cost


def _bits_rows(points, certain):
    for each in points[-3:]:
        quantity = f"rms error in floors, bits of p: {each.setting}"
        yield report.close(quantity, each.rms / each.floor, SCATTER, 1.0, BELOW)
    six = points[BITS.index(6)]
    hundredths = 100 * abs(shortened(P, 6) - P)
    quantity = "rms error for a hundredth of p, from 6 bits, percentage points"
    yield report.noted(quantity, six.rms / hundredths, six.floor / hundredths)
    yield report.noted("cost at p = 1, where nothing is drawn: no source of random bits can save more", certain)


def _source_rows(points, scatter):
    fresh, *others = points
    quantity = "rms difference in floors, plain kernel with fresh draws against the toy's"
    yield report.close(quantity, fresh.rms / fresh.floor, SCATTER, 1.0, ALIKE)
    for each in others:
        quantity = f"rms error in floors, draws: {each.setting}"
        yield report.noted(quantity, each.rms / each.floor, SCATTER, 1, "as good as fresh")
        quantity = f"scatter of the pile's left-right surplus, as a multiple of fresh draws', draws: {each.setting}"
        yield report.noted(quantity, scatter[each.setting] / scatter[fresh.setting], None, 1, "as good as fresh")


def _pixel_rows(found):
    yield Table.of("The same glass of 480×624 pixels, p = 0.75, balanced.", *pixel_table(found))
    falls = [np.mean([each.falls for each in found[cell]]) for cell in CELLS]
    exponent = float(np.polyfit(np.log(CELLS), np.log(falls), 1)[0])
    quantity = "exponent of the drain time, in falls through the glass, in the size of a cell"
    yield report.noted(quantity, exponent, None, -1, FALLEN)


def _batches():
    """Yield a row and a table on iterations played in larger batches."""
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
    yield report.same(quantity, len(set(digests.values())) - 1, 0, PLACE_AND_TIME)
    table = [(batch, ratio(times[batch], times[DEFAULT_BATCH])) for batch in BATCHES]
    heads = "iterations to a frame", "time for the same iterations"
    yield Table.of(f"Time of `advance` alone, as a multiple of that at {DEFAULT_BATCH} to a frame.", heads, table)


def _exact_count():
    """Return the row on how many runs of a world that stands still the forecast does not count."""
    sand = np.ones((1, 2), bool)
    counts = counts_at(World.from_cells(sand, np.zeros_like(sand)), Rule.with_p(0.5), [1], MANY_RUNS)
    missed = MANY_RUNS - int(counts.min())
    return report.same(f"runs that the exact count misses of {MANY_RUNS:,}", missed, 0, "int64")


def drawn(points):
    """Return the figure of all Points, a panel for each series."""
    made, axes = figure(2, 2, width=8.0, height=6.0)
    for (series, colour), panel in zip(COLOURS.items(), axes.flat, strict=True):
        mine = [each for each in points if each.series == series and each.rms > 0]
        panel.set_title(series, color=colour, fontweight="bold", fontsize=9)
        panel.loglog([each.cost for each in mine], [each.rms for each in mine], "o", color=colour, markersize=6)
        for each in mine:
            if each.is_default:
                panel.plot(each.cost, each.rms, "o", markersize=13, markerfacecolor="none", color=colour)
            _label(panel, each)
        floors = sorted((each.floor, each.cost) for each in mine)
        if series == RUN_SERIES:
            panel.plot(*zip(*((cost, floor) for floor, cost in floors), strict=True), "--", linewidth=0.9, color=GREY)
        else:
            panel.axhline(floors[0][0], linestyle="--", linewidth=0.9, color=GREY)
        _mark_axes(panel, *SPANS[series])
    made.supxlabel("cost: time as a multiple of the default's (ringed)", fontsize=9)
    made.supylabel("rms error of the map, percentage points; dashed: chance alone", fontsize=9)
    return made


def _mark_axes(panel, low, high):
    panel.set(xlim=(low, high), ylim=(0.002, 30))
    panel.set_xticks(TICKS[low])
    panel.set_xticks([], minor=True)
    panel.xaxis.set_major_formatter("{x:g}")
    panel.yaxis.set_major_formatter("{x:g}")


def _label(panel, each):
    """Write a Point's setting beside it, once where many Points lie together."""
    words = each.setting.split(" (")[0]
    if each.series == BITS_SERIES and words in ("3", "12", "16", "24"):
        return
    words = {"2": "2, 3", "32": "12, 16, 24, 32"}.get(words, words) if each.series == BITS_SERIES else words
    below = each.is_default and each.series in (BITS_SERIES, SOURCE_SERIES)
    panel.annotate(words, (each.cost, each.rms), (10, -11 if below else -2), textcoords="offset points", fontsize=8)
