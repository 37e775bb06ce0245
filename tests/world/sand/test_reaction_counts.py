"""Reactions counted: each block that became of other materials once, under the name of the event that did it."""

from collections import Counter

import numpy as np
import pytest

from game import World, advance, load_rule
from game.core.rule_table import state_of
from game.world.rules.rule import SCHEDULES
from game.world.sand import reaction_counts
from game.world.sand.block_events import offset, told_events
from game.world.sand.fixtures import TAP, Fixture
from game.world.sand.reaction_counts import ReactionMeter
from tests.sweeps import sweep
from tests.world.rules.small_rule import written

ALCHEMY = load_rule("alchemy")


def world_of(*rows, rule=ALCHEMY, seed=0):
    letters = "".join(each.letter for each in rule.definition.materials)
    return World.from_materials(np.array([[letters.index(cell) for cell in row] for row in rows], np.uint8), rule, seed)


def coming_reactions(world, rule):
    """Return what happens in the whole lattice."""
    return ReactionMeter(parts=1).look(world, rule)


def plain_counts(world, rule):
    """Return what that must be, block by block."""
    (x, y), after = offset(world, rule), world.copy()
    advance(after, rule, 1)
    padded = [np.pad(each.materials, 2, constant_values=world.codes.wall) for each in (world, after)]
    found = Counter()
    for row in range(2 - y, world.shape[0] + 2, 2):
        for column in range(2 - x, world.shape[1] + 2, 2):
            blocks = [each[row : row + 2, column : column + 2].ravel().tolist() for each in padded]
            if Counter(blocks[0]) != Counter(blocks[1]):
                events = told_events(rule, *(state_of(each, rule.table.bits) for each in blocks))
                found[" or ".join(event.name for event, _ in events)] += 1
    return found


@sweep("schedule", SCHEDULES, keep=["balanced"])
@sweep("shape", [(1, 1), (2, 3), (9, 14), (31, 129), (20, 128), (70, 140)], keep=[(1, 1), (9, 14), (20, 128)])
def test_every_block_that_reacts_is_counted_once(schedule, shape):
    generator = np.random.default_rng(shape)
    rule = ALCHEMY.with_schedule(schedule)
    world = World.from_materials(generator.integers(0, 16, shape).astype(np.uint8), rule, 5)
    for _ in range(4):
        assert coming_reactions(world, rule) == plain_counts(world, rule)
        advance(world, rule, 1)


@sweep("parts", [2, 3, 4, 99], keep=[2])
def test_the_parts_together_are_the_whole(parts):
    generator = np.random.default_rng(parts)
    world = World.from_materials(generator.integers(0, 16, (1300, 6)).astype(np.uint8), ALCHEMY, 5)
    bands, meter = len(world.activity.quiet), ReactionMeter(parts)
    parts = min(parts, bands)
    assert bands > 2
    for _ in range(3):
        advance(world, ALCHEMY, 1)
        together = sum((meter.look(world, ALCHEMY) for _ in range(parts)), Counter())
        assert {name: n / parts for name, n in together.items()} == plain_counts(world, ALCHEMY)


def test_a_meter_takes_up_another_world():
    worlds = [world_of(*["lwlw.isf" * (3 + 2 * n)] * 9, seed=n) for n in range(2)]
    meter = ReactionMeter()
    for world in (*worlds, worlds[0]):
        assert meter.look(world, ALCHEMY) == plain_counts(world, ALCHEMY)
        advance(world, ALCHEMY, 1)


def test_lava_in_water_is_counted_by_the_name_of_its_event():
    rule = ALCHEMY.with_chances(**{name: 0.0 for name in ALCHEMY.chances})
    world = world_of("lw" * 8, "##" * 8)
    happened, stone = 0, world.codes.code("stone")
    for _ in range(40):
        counted = coming_reactions(world, rule)
        advance(world, rule, 1)
        happened += counted["water quenches lava"]
        assert set(counted) <= {"water quenches lava"} and happened == world.amounts[stone]
    assert happened > 0


def test_what_only_moves_is_no_reaction_and_taps_are_none():
    world = world_of("s.w.o.", "......", "bw..ms")
    world.fixtures = (Fixture(TAP, 1, 0),)
    assert coming_reactions(world, ALCHEMY) == {}


def test_events_that_make_the_same_are_told_together(tmp_path):
    again = '[[event]]\nname = "lava hardens"\nlayer = "motion"\npicture = "lw -> kw"\n'
    path = written(tmp_path)
    path.write_text(path.read_text("utf-8") + again, encoding="utf-8")
    rule = load_rule(path)
    counted = coming_reactions(world_of(*["lw" * 40] * 40, rule=rule), rule)
    assert set(counted) == {"lava and water", "lava and water or lava hardens"}


def test_counting_leaves_the_world_and_what_is_known_of_it_alone():
    world = world_of(*["lwlw.isf"] * 9)
    advance(world, ALCHEMY, 3)
    before = world.digest(), world.activity.quiet.tolist(), world.activity.stamp
    coming_reactions(world, ALCHEMY)
    assert (world.digest(), world.activity.quiet.tolist(), world.activity.stamp) == before


def test_bands_that_are_still_are_left_out_and_nothing_is_missed():
    generator = np.random.default_rng(3)
    cells = np.zeros((2000, 40), np.uint8)
    cells[:60] = generator.integers(0, 16, (60, 40))
    world = World.from_materials(cells, ALCHEMY, 5)
    advance(world, ALCHEMY, 8)
    assert not world.activity.awake(ALCHEMY.schedule, world.iteration).all()
    assert coming_reactions(world, ALCHEMY) == plain_counts(world, ALCHEMY)


def test_more_blocks_than_there_is_room_for_are_counted_in_proportion(monkeypatch):
    world = world_of(*["lw" * 40] * 40)
    whole = coming_reactions(world, ALCHEMY)
    monkeypatch.setattr(reaction_counts, "MOST_BLOCKS", int(whole.total()) // 3)
    assert coming_reactions(world, ALCHEMY).total() == pytest.approx(whole.total())
