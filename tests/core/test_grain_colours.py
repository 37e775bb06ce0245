"""Colours of grains: they travel with them, and change nothing about where sand goes."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import Rule, advance
from tests import reference
from tests.cells import NAMES, coloured, random_world, rows_of
from tests.core.test_skipping import RULES as SKIPPING_RULES
from tests.core.test_skipping import creep
from tests.core.test_step import KINDS, SHAPES, TELLING
from tests.sweeps import sweep


def follow(rows, colours, rule, seed, iterations, start=0):
    """Return the colours of the cells after so many iterations, moved with the grains one block at a time."""
    cells, colours = [list(row) for row in rows], colours.tolist()
    probabilities = dict(zip(NAMES, rule.probabilities, strict=True))
    for iteration in range(start, start + iterations):
        after = reference.step(cells, probabilities, rule.schedule, seed, iteration)
        left, top = rule.offsets[iteration % len(rule.offsets)]
        for y in range(top, len(cells) - 1, 2):
            for x in range(-left, len(cells[0]), 2):
                take_along(cells, after, colours, y, x)
        cells = after
    return np.array(colours)


def take_along(before, after, colours, y, x):
    """Let the colours in a block go where its grains went: straight down if they can, else across."""
    block = slice(max(x, 0), x + 2)
    if all(before[row][block] == after[row][block] for row in (y, y + 1)):
        return
    columns = [column for column in (x, x + 1) if 0 <= column < len(before[0])]
    gone = [column for column in columns if before[y][column] == "o" and after[y][column] == "."]
    come = [column for column in columns if before[y + 1][column] == "." and after[y + 1][column] == "o"]
    for old, new in zip(gone, come, strict=True):
        colours[y + 1][new], colours[y][old] = colours[y][old], 0


@sweep(("kind", "schedule"), product(KINDS, reference.SCHEDULES), keep=TELLING[:2])
def test_colours_go_where_their_grains_go(kind, schedule):
    generator = np.random.default_rng(50)
    rule = Rule(*KINDS[kind], schedule=schedule)
    for height, width in SHAPES:
        seed = int(generator.integers(2**64, dtype=np.uint64))
        world = coloured(random_world(generator, height, width, seed, sand=0.3), generator)
        wanted = follow(rows_of(world), world.colours, rule, seed, 6)
        advance(world, rule, 6)
        assert (world.colours == wanted).all(), f"{height} x {width} cells"


@sweep("schedule", reference.SCHEDULES, keep=["balanced"])
def test_colours_go_where_their_grains_go_across_bands(schedule):
    generator = np.random.default_rng(55)
    world = coloured(random_world(generator, 600, 130, seed=5, sand=0.3), generator)
    assert len(world.activity.quiet) > 1
    wanted = follow(rows_of(world), world.colours, Rule(schedule=schedule), 5, 5)
    advance(world, Rule(schedule=schedule), 5)
    assert (world.colours == wanted).all()
    assert (world.activity.changed == world.activity.stamp).all()


@sweep(("kind", "schedule"), product(KINDS, reference.SCHEDULES), keep=TELLING)
def test_each_colour_is_conserved_and_the_cells_evolve_as_without(kind, schedule):
    generator = np.random.default_rng(51)
    rule = Rule(*KINDS[kind], schedule=schedule)
    plain = random_world(generator, 150, 261, seed=3, sand=0.3, walls=0.1)
    world = coloured(plain, generator)
    counts = world.amounts
    assert min(counts) > 0 and sum(counts) == plain.grains
    for some in (1, 2, 30, 100):
        advance(plain, rule, some)
        advance(world, rule, some)
        assert (world.planes[: len(plain.planes)] == plain.planes).all()
        assert world.amounts == counts == tuple(np.bincount(world.colours[world.sand], minlength=8))
        assert not world.colours[~world.sand].any()


@sweep("rule", SKIPPING_RULES.values(), keep=[SKIPPING_RULES["topples"], SKIPPING_RULES["seven"]])
@pytest.mark.parametrize("shape", [(1300, 300), (70, 8000)])
@sweep("sand", [0.003, 0.3], keep=[0.3])
def test_skipping_and_skewing_change_no_colour(rule, shape, sand):
    generator = np.random.default_rng(52)
    world = coloured(random_world(generator, *shape, seed=3, sand=sand, walls=0.05), generator)
    twin = world.copy()
    for some in (1, 37, 60):
        advance(world, rule, some)
        creep(twin, rule, some)
        assert world.digest() == twin.digest()


@given(st.integers(0, 2**32), st.integers(1, 40), st.integers(1, 300), st.sampled_from([0, 1, 2, 3]))
def test_a_turn_carries_the_colours_and_four_quarters_are_the_identity(number, height, width, quarters):
    generator = np.random.default_rng(number)
    world = coloured(random_world(generator, height, width), generator)
    advance(world, Rule.with_p(0.5), 5)
    turned = world.turned(quarters)
    assert (turned.colours == np.rot90(world.colours, -quarters)).all()
    assert turned.turned(4 - quarters).digest() == world.digest()
    flipped = world.copy()
    flipped.flip()
    assert (flipped.colours == world.colours[::-1, ::-1]).all() and flipped.digest() == world.turned(2).digest()
