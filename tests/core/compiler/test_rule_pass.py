"""Passes: machine code does to every lattice what the table of its rule says, block by block."""

import ctypes
from itertools import product

import numpy as np
import pytest

from game.core import planes as bit_planes
from game.core.compiler import machine_code, rule_pass
from game.core.compiler.plan import threshold_of
from game.core.compiler.rule_pass import pass_of
from game.core.rule_table import CERTAIN, state_of
from game.core.step import advance_planes
from game.world.rules.rule import SAND, SCHEDULES
from game.world.sand.active_bands import ActiveBands
from tests.core.compiler import plain
from tests.core.compiler.rules import random_table
from tests.sweeps import sweep

FULL = 2**64 - 1
SHAPES = [(1, 1), (2, 3), (9, 12), (8, 128), (5, 129), (70, 3)]
CHANCES = [(0.5, 0.25, 0.7, 0.3, 0.125, 0.0), (1.0, 0.0, 0.9, 2.0**-9, 0.6, 1.0)]


class Lattice:
    """Cells of a rule's codes as planes."""

    def __init__(self, codes, table):
        self.table, self.where = table, bit_planes.layout(*codes.shape, table.codes, table.outside)
        self.planes = bit_planes.pack(codes.astype(np.uint8), self.where)
        self.bands = ActiveBands(self.where)

    @property
    def codes(self):
        return bit_planes.unpack(self.planes, self.where).astype(int)

    def advance(self, moving, schedule, seed, iteration, iterations):
        offsets = np.roll(np.array(SCHEDULES[schedule]), -iteration, axis=0)
        where, bands = self.where, self.bands
        shape = where.length, where.rows, where.stride, bands.band_rows
        told = (bands.quiet, bands.changed), 1, offsets, np.uint64(seed), np.uint64(iteration), iterations
        advance_planes(self.planes.reshape(-1), shape, moving.run, moving.edges, *told)


@sweep(("bits", "number"), product((2, 3, 4), range(4)), keep=[(2, 0), (3, 1)])
def test_any_rule_agrees_with_its_table_block_by_block(bits, number):
    generator = np.random.default_rng(60 + number)
    table = random_table(generator, bits)
    assert table.has_fair_bit
    layers, schedule, chances = plain.lookups(table), list(SCHEDULES)[number % 3], CHANCES[number % 2]
    moving = pass_of(table, chances)
    for shape in SHAPES:
        codes = generator.integers(0, table.codes, shape)
        lattice, rows = Lattice(codes, table), codes.tolist()
        for iteration in range(6):
            offset = SCHEDULES[schedule][iteration % len(SCHEDULES[schedule])]
            rows = plain.step(table, layers, chances, rows, offset, 7, iteration)
        lattice.advance(moving, schedule, 7, 0, 2)
        lattice.advance(moving, schedule, 7, 2, 4)
        assert (lattice.codes == rows).all(), shape


def test_lanes_change_no_bit():
    generator = np.random.default_rng(70)
    table = random_table(generator, 3)
    codes = generator.integers(0, table.codes, (90, 300))
    found = []
    for lanes in {1, 2, machine_code.lanes()}:
        lattice = Lattice(codes, table)
        lattice.advance(pass_of(table, CHANCES[0], most_lanes=lanes), "balanced", 3, 0, 30)
        found.append(lattice.codes)
    assert all((each == found[0]).all() for each in found)


def test_what_disagrees_with_its_table_is_tried_a_word_at_a_time_and_else_refused(monkeypatch):
    asked = []

    def agrees(address, table, plan, kinds, payload, lanes):
        asked.append(lanes)
        return lanes == 1

    monkeypatch.setattr(rule_pass.self_check, "agrees", agrees)
    assert pass_of(SAND.table, (0.5,) * 7, 5).lanes == 1 and asked[-1] == 1
    monkeypatch.setattr(rule_pass.self_check, "agrees", lambda *told: False)
    with pytest.raises(RuntimeError, match="otherwise than its table says"):
        pass_of(SAND.table, (0.5,) * 7, 6)


@sweep("schedule", SCHEDULES, keep=["balanced"])
def test_skipping_and_skewing_change_no_bit_of_any_rule(schedule):
    generator = np.random.default_rng(71)
    table = random_table(generator, 3)
    moving = pass_of(table, CHANCES[0])
    codes = generator.integers(0, table.codes, (1300, 140)) * (generator.random((1300, 140)) < 0.05)
    whole, creeping = Lattice(codes, table), Lattice(codes, table)
    assert len(whole.bands.quiet) > 1 and moving.edges == (True, True)
    whole.advance(moving, schedule, 5, 0, 60)
    for iteration in range(60):
        creeping.bands.quiet[:] = 0
        creeping.advance(moving, schedule, 5, iteration, 1)
    assert (whole.codes == creeping.codes).all() and (whole.codes != codes).any()


def test_a_pass_tells_of_events_that_could_have_been_and_of_those_that_were_in_blocks_that_take_part_alone():
    tower, pile = state_of((1, 0, 1, 0), 2), state_of((1, 0, 0, 1), 2)
    told = {}
    for p, state, may in product((0.0, 0.5, 1.0), (tower, pile, 0), (FULL, 0)):
        moving = pass_of(SAND.table, (p, p, *[1.0] * 5), most_lanes=1)
        planes = np.array([FULL * (state >> bit & 1) for bit in range(8)], np.uint64)
        arrays = planes, np.arange(8, dtype=np.int64), np.array([may, 0], np.uint64), np.zeros(2, np.uint64)
        call = ctypes.CFUNCTYPE(ctypes.c_int64, *[ctypes.c_uint64] * 7)(moving.code.address)
        told[p, state, may] = call(*(each.ctypes.data for each in arrays), 0, moving.chances.ctypes.data, 1)
    assert told[0.0, tower, FULL] == 1 and told[0.5, tower, FULL] == told[1.0, tower, FULL] == 3
    assert all(told[p, pile, FULL] == 3 for p in (0.0, 0.5, 1.0)), "the upper grain falls in any case"
    assert not any(number for (_, state, may), number in told.items() if state == 0 or may == 0)


def test_a_threshold_is_the_nearest_multiple_of_the_smallest_one_and_those_of_outcomes_add_up():
    assert [threshold_of((0,), (k * 2.0**-34,)) for k in (1, 3, 5, 7)] == [0, 1, 1, 2]
    assert threshold_of((0, 1), (0.75 * 2.0**-32,) * 2) == 2, "the sum is rounded, and not its parts"
    assert threshold_of((0, 1), (0.7, 0.7)) == threshold_of((CERTAIN, 0), (0.1,)) == 2**32
    assert threshold_of((0,), (1 - 2.0**-34,)) == 2**32 and threshold_of((0,), (1 - 2.0**-32,)) == 2**32 - 1
