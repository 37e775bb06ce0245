"""The blocks in sight: what they are said to do is what they do."""

import numpy as np
import pytest

from game import Rule, advance
from game.world.rules.rule import SCHEDULES
from game.world.sand.block_events import MOVES, coming_events, happened, offset
from game.world.sand.crop import CropBox
from tests import reference
from tests.cells import NAMES, random_world, rows_of

CORNERS = ((0, 0), (0, 1), (1, 0), (1, 1))


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


@pytest.mark.parametrize("schedule", SCHEDULES)
@pytest.mark.parametrize("shape", [(1, 1), (2, 3), (9, 14), (31, 130)])
def test_every_block_is_said_to_do_what_the_twin_does(schedule, shape):
    generator = np.random.default_rng(1)
    for iteration in range(4):
        rule = Rule(*generator.choice([0.0, 0.25, 0.6, 1.0], len(NAMES)), schedule)
        world = random_world(generator, *shape)
        advance(world, rule, iteration)
        cells, wanted = rows_of(world), twins_events(world, rule)
        events = coming_events(world, rule, CropBox(0, 0, *shape))
        for row, column, move, chance in zip(*(each.tolist() for each in events), strict=True):
            block = {
                place: cells[row + place[0]][column + place[1]]
                for place in CORNERS
                if _is_in(row, column, place, shape)
            }
            for start, end in MOVES[move]:
                block[start], block[end] = ".", "o"
            corners, p = wanted.pop((row, column))
            assert all(corners[CORNERS.index(place)] == cell for place, cell in block.items()) and chance == p
        assert not wanted


def _is_in(row, column, place, shape):
    return 0 <= row + place[0] < shape[0] and 0 <= column + place[1] < shape[1]


def test_where_nothing_is_left_to_chance_the_step_does_what_was_said():
    world = random_world(np.random.default_rng(2), 41, 66)
    for _ in range(12):
        sand = world.sand
        events = coming_events(world, Rule(), CropBox(0, 0, *world.shape))
        for row, column, move in zip(events.rows, events.columns, events.moves, strict=True):
            for start, end in MOVES[move]:
                sand[row + start[0], column + start[1]], sand[row + end[0], column + end[1]] = False, True
        advance(world, Rule(), 1)
        assert (world.sand == sand).all() and happened(events, world, CropBox(0, 0, *world.shape)).all()


def test_what_chance_refused_has_not_happened():
    world, rule = random_world(np.random.default_rng(3), 60, 60), Rule.with_p(0.5)
    part = CropBox(0, 0, *world.shape)
    before, events = world.sand, coming_events(world, rule, part)
    advance(world, rule, 1)
    done = happened(events, world, part)
    assert (events.chances[~done] < 1).all() and 0 < (~done).sum() < (events.chances < 1).sum()
    for row, column, move in zip(*events.only(done)[:3], strict=True):
        for start, end in MOVES[move]:
            before[row + start[0], column + start[1]], before[row + end[0], column + end[1]] = False, True
    assert (before == world.sand).all()


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
