"""What a scene needs: the cost of chance, of motion, and of what is done to a world between iterations."""

import numpy as np

from game.study.bench import goals, worlds
from game.study.bench.checks import same_as_twin, same_with_colours
from game.study.bench.rounds import MICROSECONDS, ours, take_turns
from game.study.report import table
from game.study.report.report import Section
from game.study.report.table import Column, Table
from game.world.rules.rule import Rule

SCHEDULE = worlds.GLASS_RULE.schedule
PAPER_P = 0.5
AT_RANDOM = np.random.default_rng(worlds.SEED).random(7).round(3)
RULES = {
    "p = 1": Rule(schedule=SCHEDULE),
    f"p = {PAPER_P}": Rule.with_p(PAPER_P, SCHEDULE),
    "two topples at random": Rule(*AT_RANDOM[:2], schedule=SCHEDULE),
    "seven at random": Rule(*AT_RANDOM, schedule=SCHEDULE),
}
CERTAIN, _, TWO, SEVEN = RULES
WORLDS = {"all moving": worlds.moving, "hourglass, mid-flow": worlds.flowing, "settled": worlds.settled}
MOVING, FLOWING, SETTLED = WORLDS
IN_COLOURS = "{}, in colours"  # the key of a rule where every grain has a colour
COLUMNS = (
    Column("world", "world"),
    Column("rule", "rule"),
    Column("time", "µs per iteration", MICROSECONDS),
    Column("gcells", "Gcell/s", table.three_digits),
    Column("of_certain", "of p = 1", table.ratio),
    Column("of_moving", "of all moving", table.percent),
    Column("checked", "checked"),
    goals.COLUMN,
)


def scene_table(plan):
    """Return the time of an iteration for each kind of world under each kind of rule."""
    size = plan.scene_size
    measured = {name: _measure(make(size), name != SETTLED, plan) for name, make in WORLDS.items()}
    found = {(name, kind): timing for name, (timings, _) in measured.items() for kind, timing in timings.items()}
    rows = [_row(name, kind, found, measured[name][1][kind], size) for name, kind in found]
    notes = [
        f"{table.size(size)} cells, {plan.batch} iterations in one call, schedule {SCHEDULE}. The hourglass is the "
        f"shipped scene drawn at that size, about {worlds.PASSED:.0%} of its sand below; settled: all of it there.",
        "In colours: each grain has one of eight, in three more bits of its cell; checked to leave the cells as "
        "they are and to keep the number of grains of each colour.",
        "At random: the events left to chance have probabilities "
        f"{', '.join(map(str, RULES[SEVEN].probabilities))}, the topples the first two. p = {PAPER_P} takes one random "
        "bit for a candidate, these take up to 32.",
    ]
    return Section("scene", "3a · What a scene needs: chance and motion", [Table("", COLUMNS, rows), *notes])


def _measure(world, in_colours, plan):
    """Return ({rule: Timing}, {rule: iterations checked}) of a world, with the same sand in colours if `in_colours`."""
    checked = {kind: same_as_twin(world, rule, plan.checked) for kind, rule in RULES.items()}
    timed = [ours(kind, world, rule, plan.batch) for kind, rule in RULES.items()]
    if in_colours:
        coloured = worlds.in_colours(world)
        for kind, rule in RULES.items():
            dyed = IN_COLOURS.format(kind)
            checked[dyed] = same_with_colours(world, coloured, rule, plan.checked)
            timed.append(ours(dyed, coloured, rule, plan.batch))
    return take_turns(timed, plan.rounds, plan.sample_ns), checked


def _row(name, kind, found, checked, size):
    timing, certain, moving = found[name, kind], found[name, CERTAIN], found[MOVING, kind]
    return {
        "world": name,
        "rule": kind,
        "time": timing,
        "gcells": size[0] * size[1] / timing.median,
        "of_certain": timing.times(certain),
        "of_moving": timing.median / moving.median,
        "checked": checked,
        "goal": _goal(name, kind, found, size),
    }


def _goal(name, kind, found, size):
    where = f"{name}, {kind}, {table.size(size)}"
    if name == SETTLED:
        part = 100 * found[name, kind].median / found[MOVING, kind].median
        return goals.at_most(f"{where}: part of all moving", part, 100 * goals.SETTLED, " %")
    for plain in RULES:
        if kind == IN_COLOURS.format(plain):
            return goals.at_most(f"{where}: of {plain}", found[name, kind].times(found[name, plain]), goals.COLOURS)
    if kind == SEVEN:
        return goals.at_most(f"{where}: of {TWO}", found[name, kind].times(found[name, TWO]), goals.SEVEN)
    return None
