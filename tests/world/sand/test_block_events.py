"""The blocks in sight: what they are said to do is what they do."""

import numpy as np
import pytest

from game import Rule, World, advance, load_rule
from game.core.rule_table import corners, state_of
from game.world.rules.rule import SCHEDULES
from game.world.sand.block_events import CORNERS, coming_events, happened, moves_between, offset
from game.world.sand.crop import CropBox
from tests import reference
from tests.cells import NAMES, random_world, rows_of
from tests.sweeps import sweep


def twins_events(world, rule):
    """Return {(row, column): (the corners after the event, its probability)} by the plain twin."""
    cells, (x, y) = rows_of(world), offset(world, rule)
    height, width = world.shape
    found = {}
    for row in range(-y, height, 2):
        for column in range(-x, width, 2):
            places = [(row + dy, column + dx) for dy, dx in CORNERS]
            event = reference.event(*(cells[r][c] if 0 <= r < height and 0 <= c < width else "#" for r, c in places))
            if event:
                p = 1.0 if event[1] == reference.ALWAYS else getattr(rule, event[1])
                if p > 0:
                    found[row, column] = event[0], p
    return found


@sweep("schedule", SCHEDULES, keep=["balanced"])
@pytest.mark.parametrize("shape", [(1, 1), (2, 3), (9, 14), (31, 130)])
def test_every_block_is_said_to_do_what_the_twin_does(schedule, shape):
    generator = np.random.default_rng(1)
    for iteration in range(4):
        rule = Rule(*generator.choice([0.0, 0.25, 0.6, 1.0], len(NAMES)), schedule)
        world = random_world(generator, *shape)
        advance(world, rule, iteration)
        wanted = twins_events(world, rule)
        events = coming_events(world, rule, CropBox(0, 0, *shape))
        for row, column, _, after, chance in zip(*(each.tolist() for each in events), strict=True):
            block, p = wanted.pop((row, column))
            assert "".join(".o#"[code] for code in corners(after, 2)) == "".join(block) and chance == p
        assert not wanted


def after(events, world):
    """Return the world after events, each of which happens."""
    cells = np.pad(world.materials, 1)
    for row, column, state in zip(events.rows, events.columns, events.after.tolist(), strict=True):
        for (down, across), code in zip(CORNERS, corners(state, world.layout.bits), strict=True):
            cells[row + down + 1, column + across + 1] = code
    return world.within(np.ascontiguousarray(cells[1:-1, 1:-1]))


def test_what_moves_in_a_block_comes_from_where_it_was_and_what_becomes_is_marked():
    fall, topple, pair = ("o...", "..o."), ("o.o.", "..oo"), ("oo..", "..oo")
    states = [[state_of([".o#".index(cell) for cell in block], 2) for block in each] for each in (fall, topple, pair)]
    told = [moves_between(*each, 2) for each in states]
    assert told[0] == (((0, 0), (1, 0)),) and told[1] == (((0, 0), (1, 1)),)
    assert told[2] == (((0, 0), (1, 0)), ((0, 1), (1, 1)))
    assert moves_between(state_of((1, 2, 0, 0), 2), state_of((2, 2, 0, 0), 2), 2) == (((0, 0), (0, 0)),)


@sweep("name", ["water-and-oil", "alchemy", "three-sands"], keep=["water-and-oil"])
def test_blocks_of_any_rule_do_one_of_the_things_said_or_nothing(name):
    rule, generator = load_rule(name), np.random.default_rng(5)
    world = World.from_materials(generator.integers(0, len(rule.materials), (21, 34), np.uint8), rule)
    for _ in range(8):
        part = CropBox(0, 0, *world.shape)
        before, events = world.copy(), coming_events(world, rule, part)
        advance(world, rule, 1)
        assert (after(events.only(happened(events, world, part)), before).materials == world.materials).all()


def test_where_nothing_is_left_to_chance_the_step_does_what_was_said():
    world = random_world(np.random.default_rng(2), 41, 66)
    for _ in range(12):
        events = coming_events(world, Rule(), CropBox(0, 0, *world.shape))
        sand = after(events, world).sand
        advance(world, Rule(), 1)
        assert (world.sand == sand).all() and happened(events, world, CropBox(0, 0, *world.shape)).all()


def test_what_chance_refused_has_not_happened():
    world, rule = random_world(np.random.default_rng(3), 60, 60), Rule.with_p(0.5)
    part = CropBox(0, 0, *world.shape)
    before, events = world.copy(), coming_events(world, rule, part)
    advance(world, rule, 1)
    done = happened(events, world, part)
    assert (events.chances[~done] < 1).all() and 0 < (~done).sum() < (events.chances < 1).sum()
    assert (after(events.only(done), before).sand == world.sand).all()


def test_a_part_knows_what_the_whole_knows_of_it():
    world, rule = random_world(np.random.default_rng(4), 61, 150), Rule(0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, "balanced")
    whole = coming_events(world, rule, CropBox(0, 0, *world.shape))
    for part in (CropBox(0, 0, 9, 11), CropBox(20, 40, 17, 31), CropBox(20, 40, 18, 32), CropBox(50, 130, 11, 20)):
        events = set(zip(*(each.tolist() for each in coming_events(world, rule, part)), strict=True))
        bottom, right = part.top + part.height, part.left + part.width
        for event in zip(*(each.tolist() for each in whole), strict=True):
            in_sight = part.top - 2 < event[0] < bottom and part.left - 2 < event[1] < right
            assert event in events or not in_sight
        assert events <= set(zip(*(each.tolist() for each in whole), strict=True))
