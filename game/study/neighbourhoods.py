"""Neighbourhoods: what sticks to slopes, and which side of a pile is built first, schedule by schedule."""

import numpy as np

from game import Rule, World, advance
from game.study import verdict
from game.study.report import Table
from game.world.glass import hourglass
from game.world.rule import SCHEDULES

SIDE = 61  # cells, the paper's lattice
LONG = 8000  # iterations after which whatever is left in the upper bulb is stuck
LOOK = 10  # iterations between two looks at the pile
PARITY = "a block's upper left corner has an even x + y under margolus, so a grain on a slope topples one way only"
ALL_FOUR = "four partitions: each corner of a block comes to every cell"
SLOPES = "the paper: the standard neighbourhood sticks to left slopes"
ONE_SIDE = "the paper: the standard neighbourhood builds one side to the top before the other"


def glass(right, down):
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
    """Return the largest surplus of grains on one side of the pile, while it is built, as a signed number."""
    sand, walls, axis = glass(right, 0)
    world, surplus = World.from_cells(sand, walls, seed), 0
    for _ in range(60):
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
    yield Table(f"The paper's glass at p = 1: what is left in the upper bulb after {LONG:,} iterations.", heads, table)
    for right in (0, 1):
        sides = found["margolus", right]
        yield verdict.within(
            f"grains stuck on one slope, margolus, glass moved by {right}", max(sides), None, 1, np.inf, SLOPES
        )
        yield verdict.same(f"grains stuck on the other slope, margolus, glass moved by {right}", min(sides), 0, PARITY)
    yield verdict.same(
        "side with stuck grains changes when the glass moves by a cell, margolus",
        np.sign(np.subtract(*found["margolus", 0])) == -np.sign(np.subtract(*found["margolus", 1])),
        True,
        PARITY,
    )
    for name in ("paper", "balanced"):
        left = sum(sum(found[name, right]) for right in (0, 1))
        yield verdict.same(f"grains stuck on either slope, {name}", left, 0, ALL_FOUR)
    for name in SCHEDULES:
        most = max(abs(surplus[name, right]) for right in (0, 1))
        quantity = f"largest surplus of grains on one side of the pile, {name}, p = 1"
        if name == "margolus":
            yield verdict.claimed(quantity, most, None, 10, np.inf, ONE_SIDE)
        elif name == "paper":
            yield verdict.claimed(
                quantity, most, None, 10, np.inf, "the paper: at p = 1 one slope fills before the other"
            )
        else:
            yield verdict.within(quantity, most, None, 0, 1, "mirrored, its schedule is itself two iterations later")
