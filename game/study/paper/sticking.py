"""Sticking: what sticks to slopes, and which side of a pile is built first, schedule by schedule."""

import numpy as np

from game import Rule, World, advance
from game.study.report import report
from game.study.report.table import Table
from game.world.rules.rule import SCHEDULES
from game.world.scenes.hourglass import hourglass

SIDE = 61  # cells, the paper's lattice
LONG = 8000  # iterations after which whatever is left in the upper bulb is stuck
LOOK, LOOKS = 10, 60  # iterations between two looks at the growing pile, and how many
CLEAR = 10  # grains: a surplus of a fifth of the pile that is seen at t = 200
PARITY = "corners of blocks have an even x + y under margolus: on a slope, a grain of one parity topples one way only"
ALL_FOUR = "four partitions: each corner of a block comes to every cell"
MIRRORED = "mirrored, its schedule is itself two iterations later"
SLOPES = "the paper: the standard neighbourhood sticks to left slopes"
CLAIMS = {
    "margolus": "the paper: the standard neighbourhood builds one side to the top first",
    "paper": "the paper: at p = 1 one slope fills before the other",
}


def glass(right, down=0):
    """Return (sand, walls, axis) of the paper's glass, moved right and down by so many cells of wall."""
    shift = (down, 0), (right, 0)
    sand, walls = hourglass(SIDE, SIDE, 1, 0.0, 1, 0.8)
    return np.pad(sand, shift), np.pad(walls, shift, constant_values=True), right + SIDE // 2


def stuck(schedule, p, right, down=0, seed=1):
    """Return how many grains stay on the left and on the right slope of the upper bulb."""
    sand, walls, axis = glass(right, down)
    world = World.from_cells(sand, walls, seed)
    advance(world, Rule.with_p(p, schedule), LONG)
    upper = world.sand[: down + SIDE // 2]
    return int(upper[:, :axis].sum()), int(upper[:, axis + 1 :].sum())


def lopsided(schedule, p, right=0, seed=1):
    """Return the largest surplus of grains on one side of the pile while it is built, right counted positive."""
    sand, walls, axis = glass(right)
    world, surplus = World.from_cells(sand, walls, seed), 0
    for _ in range(LOOKS):
        advance(world, Rule.with_p(p, schedule), LOOK)
        lower = world.sand[SIDE // 2 + 1 :]
        now = int(lower[:, axis + 1 :].sum()) - int(lower[:, :axis].sum())
        surplus = max(surplus, now, key=abs)
    return surplus


def rows():
    """Yield rows on the paper's reasons for its own neighbourhood."""
    found = {(name, right): stuck(name, 1.0, right) for name in SCHEDULES for right in (0, 1)}
    surplus = {(name, right): lopsided(name, 1.0, right) for name in SCHEDULES for right in (0, 1)}
    heads = "schedule", "glass moved right by", "stuck left", "stuck right", "largest surplus on one side (right +)"
    table = [(name, right, *found[name, right], surplus[name, right]) for name, right in found]
    yield Table.of(
        f"The paper's glass at p = 1: what is left in the upper bulb after {LONG:,} iterations.", heads, table
    )
    yield from _sticking(found)
    for name in SCHEDULES:
        most = max(abs(surplus[name, right]) for right in (0, 1))
        quantity = f"largest surplus of grains on one side of the pile, {name}, p = 1"
        if name in CLAIMS:
            yield report.claimed(quantity, most, None, CLEAR, np.inf, CLAIMS[name])
        else:
            yield report.within(quantity, most, None, 0, 1, MIRRORED)


def _sticking(found):
    for right in (0, 1):
        left_slope, right_slope = found["margolus", right]
        where = f"margolus, glass moved right by {right}"
        yield report.claimed(f"grains stuck on the left slope, {where}", left_slope, None, 1, np.inf, SLOPES)
        holds = min(left_slope, right_slope) == 0 < max(left_slope, right_slope)
        yield report.same(f"grains stick on one of the two slopes only, {where}", holds, True, PARITY)
    for name in ("paper", "balanced"):
        left = sum(sum(found[name, right]) for right in (0, 1))
        yield report.same(f"grains stuck on either slope, {name}", left, 0, ALL_FOUR)
