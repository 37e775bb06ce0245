"""Narrower passes: for the materials that are there, with the bits of the pass for all; made where it pays."""

import sys
from itertools import combinations, product

import numpy as np
import pytest

from game import World, advance, load_rule
from game.core import jit
from game.core.compiler import dispatch, narrowing, rule_pass
from game.core.compiler.beside import SHORT_S
from game.core.compiler.rule_pass import pass_of
from game.core.rule_table import corners
from game.world.sand.ensemble import counts_at
from tests.core.compiler.rules import random_table
from tests.core.compiler.test_rule_pass import CHANCES, Lattice
from tests.sweeps import sweep

SHAPES = [(2, 3), (9, 12), (40, 129), (30, 2100)]


@pytest.fixture
def every_rule_is_large(monkeypatch):
    monkeypatch.setattr(rule_pass, "LEAST_GATES", 1)
    rule_pass._compiled.cache_clear()
    rule_pass._passes.cache_clear()
    yield
    rule_pass._compiled.cache_clear()
    rule_pass._passes.cache_clear()


def narrow(table, probabilities, codes, most_lanes=None):
    """Let a rule have the pass for some codes, as if it had paid."""
    passes = rule_pass._passes(table, probabilities, 0, most_lanes).narrow
    passes._add(codes, passes._make(codes))


def layered(generator, table, shape, sets):
    """Return cells whose rows hold one set of codes after another, the last ones all codes."""
    rows = [
        generator.choice(
            sets[row * (len(sets) + 1) // shape[0]]
            if row * (len(sets) + 1) // shape[0] < len(sets)
            else range(table.codes),
            shape[1],
        )
        for row in range(shape[0])
    ]
    return np.array(rows)


@sweep(("bits", "number", "lanes"), product((2, 3, 4), range(3), (1, None)), keep=[(2, 1, None), (3, 2, 1)])
def test_narrower_passes_change_no_bit_of_any_rule(bits, number, lanes, every_rule_is_large):
    generator = np.random.default_rng(400 + number)
    table = random_table(generator, bits)
    sets = [
        tuple(sorted(generator.choice(table.codes, size, replace=False).tolist()))
        for size in (1, 2, min(3, table.codes - 1))
    ]
    whole = pass_of(table, CHANCES[number % 2], most_lanes=lanes)
    for codes in sets:
        narrow(table, CHANCES[number % 2], codes, most_lanes=lanes)
    narrowed = pass_of(table, CHANCES[number % 2], most_lanes=lanes)
    assert narrowed.code is whole.code and len(narrowed.chances) == len(whole.chances) + 2 * len(set(sets))
    for shape in SHAPES:
        cells = layered(generator, table, shape, sets)
        before, after = Lattice(cells, table), Lattice(cells, table)
        before.advance(whole, "balanced", 3, 0, 6)
        after.advance(narrowed, "balanced", 3, 0, 6)
        assert (before.codes == after.codes).all() and (before.bands.quiet == after.bands.quiet).all()


@pytest.mark.parametrize("number", range(3))
def test_a_table_for_some_codes_says_of_their_blocks_what_the_whole_one_does(number):
    generator = np.random.default_rng(500 + number)
    table = random_table(generator, 3)
    codes = sorted(generator.choice(table.codes, 4, replace=False).tolist())
    part = table.narrowed(codes)
    assert set(np.unique(corners(part.used_states, 3))) == set(codes) and len(part.used_states) == 4**4
    for layer, some in zip(table.layers, part.layers, strict=True):
        wanted = {
            (claim.event, claim.face, int(state), tuple((each.slot, int(each.after[at])) for each in claim.outcomes))
            for claim in layer
            for at, state in enumerate(claim.states)
            if set(corners(int(state), 3)) <= set(codes)
        }
        found = {
            (claim.event, claim.face, int(state), tuple((each.slot, int(each.after[at])) for each in claim.outcomes))
            for claim in some
            for at, state in enumerate(claim.states)
        }
        assert found == wanted and wanted
    assert part.digest != table.digest != table.narrowed(codes[:-1]).digest


def test_a_set_is_eventful_exactly_where_some_claim_is_of_its_codes_alone():
    table = random_table(np.random.default_rng(600), 2)
    found = dispatch.eventful(table)
    for number in range(2**table.codes):
        codes = [code for code in range(table.codes) if number >> code & 1]
        wanted = any(len(claim.states) for layer in table.narrowed(codes).layers for claim in layer) if codes else False
        assert found[number] == wanted


def test_for_each_set_the_cheapest_pass_is_called_that_knows_all_of_it():
    generator = np.random.default_rng(601)
    sets = [31, *generator.choice(31, 9, replace=False).tolist()]
    costs = [100, *generator.permutation(np.arange(50, 150, 10))[:9].tolist()]
    eventful = generator.random(32) < 0.8
    numbers = dispatch.cheapest(sets, costs, eventful)
    for number in range(32):
        ways = [(cost, at) for at, (known, cost) in enumerate(zip(sets, costs, strict=True)) if number & ~known == 0]
        assert numbers[number] == (min(ways)[1] if eventful[number] else dispatch.NOTHING)


@pytest.fixture
def own_cache(tmp_path, monkeypatch):
    """Keep machine code in a folder of its own, where processes beside this one keep it too."""
    monkeypatch.setattr(jit, "_FOLDER", tmp_path / jit.cache_folder().name)


def asked(rule, times=narrowing.ASKED):
    for _ in range(times):
        pass_of(rule.table, rule.values)
    return rule_pass._passes(rule.table, rule.values, 0, None).narrow


def test_a_narrower_pass_is_made_once_the_whole_one_has_cost_as_much_as_making_it(own_cache, every_rule_is_large):
    rule = load_rule("water-and-oil")
    codes = rule.codes.code("air"), rule.codes.code("sand")
    number = sum(1 << code for code in codes)
    passes = asked(rule)
    assert passes._thread is None and len(passes.known.made) == 1, "nothing was moved, and nothing has cost"
    passes.tally[number] = 10
    asked(rule)
    assert passes._thread is None
    passes.tally[number] = 10**7
    asked(rule, narrowing.ASKED - 1)
    assert passes._thread is None, "most calls only count"
    asked(rule, 1)
    passes.wait()
    made, sets, numbers = passes.known
    assert sets == (2**rule.table.codes - 1, number) and numbers[number] == 1 and made[1].gates < made[0].gates
    asked(rule)
    assert len(passes.known.made) == 2, "it pays once"


def test_a_narrower_pass_that_was_kept_is_taken_without_a_process(own_cache, monkeypatch, every_rule_is_large):
    rule, begun = load_rule("water-and-oil"), []
    asked(rule)._make((0, 1))
    monkeypatch.setattr(narrowing, "run_beside", lambda *what: begun.append(what))
    passes = asked(rule)
    passes.tally[0b11] = 10**9
    asked(rule)
    passes.wait()
    assert passes.known.sets[1:] == (0b11,) and not begun


def test_a_pass_that_was_kept_is_read_while_other_threads_get_the_interpreter_soon(every_rule_is_large):
    passes, intervals = asked(load_rule("water-and-oil")), []
    passes._kept = lambda codes: intervals.append(sys.getswitchinterval())
    passes._take((0, 1))
    assert intervals == [pytest.approx(SHORT_S)]


def test_one_pass_is_made_for_sets_that_are_parts_of_it(own_cache, every_rule_is_large):
    passes = asked(load_rule("water-and-oil"))
    for codes in combinations((0, 1, 3), 2):
        passes.tally[sum(1 << code for code in codes)] = 10**6
    passes.tally[0b01011] = 10**6
    asked(load_rule("water-and-oil"))
    passes.wait()
    assert passes.known.sets[1] == 0b01011


def test_a_narrower_pass_that_could_not_be_made_is_not_used_nor_tried_again(tmp_path, monkeypatch, every_rule_is_large):
    rule, tried = load_rule("water-and-oil"), []
    passes = asked(rule)
    monkeypatch.setattr(jit, "_FOLDER", tmp_path)
    monkeypatch.setattr(narrowing, "run_beside", lambda act, codes: tried.append(codes))
    passes.tally[0b11] = passes.tally[0b1011] = 10**9
    for _ in range(6):
        asked(rule)
        passes.wait()
    assert len(passes.known.made) == 1 and sorted(tried) == [(0, 1), (0, 1, 3)]


@pytest.mark.parametrize("trouble", [{"executable": "/opt/engine/engine"}, {}])
def test_without_processes_or_a_folder_the_whole_pass_goes_on(trouble, monkeypatch, every_rule_is_large):
    passes = asked(load_rule("water-and-oil"))
    for name, value in trouble.items():
        monkeypatch.setattr(sys, name, value)
    if not trouble:
        monkeypatch.setattr(jit, "_FOLDER", None)
    passes.tally[0b11] = 10**9
    asked(load_rule("water-and-oil"), 8)
    passes.wait()
    assert len(passes.known.made) == 1


def test_no_more_passes_are_made_than_there_are_numbers_for(monkeypatch, every_rule_is_large):
    monkeypatch.setattr(narrowing, "MOST", 2)
    passes = asked(load_rule("water-and-oil"))
    for codes in ((0, 1), (0, 3)):
        passes._add(codes, passes._make(codes))
    assert passes.known.sets[1:] == (0b11,)
    passes.tally[:] = 10**8
    asked(load_rule("water-and-oil"))
    assert passes._thread is None


def test_what_runs_hold_is_counted_and_where_nothing_can_happen_nothing_is_called(every_rule_is_large):
    rule = load_rule("water-and-oil")
    passes = asked(rule, 1)
    passes.tally[:] = 0
    cells = np.zeros((64, 64), np.uint8)
    cells[:32] = rule.codes.code("wall")
    world = World.from_materials(cells, rule)
    advance(world, rule, 4)
    wall, air = (1 << rule.codes.code(name) for name in ("wall", "air"))
    seen = set(np.flatnonzero(passes.tally))
    assert seen and seen <= {wall, air, wall | air}
    assert all(passes.known.numbers[number] == dispatch.NOTHING for number in seen)
    assert world.activity.settled


def test_worlds_and_forecasts_are_the_same_with_narrower_passes(every_rule_is_large):
    rule = load_rule("water-and-oil")
    generator = np.random.default_rng(602)
    cells = np.zeros((48, 40), np.uint8)
    for top, names in ((0, ("air", "water")), (16, ("air", "oil", "water")), (32, ("sand", "wall", "air", "oil"))):
        cells[top : top + 16] = generator.choice([rule.codes.code(name) for name in names], (16, 40))
    found = []
    for sets in ((), (("air", "water", "wall"), ("air", "oil", "water", "wall"))):
        for names in sets:
            for lanes in (None, 4):
                narrow(rule.table, rule.values, tuple(map(rule.codes.code, names)), most_lanes=lanes)
        world = World.from_materials(cells, rule, 5)
        counts = counts_at(world, rule, [30], runs=64, of="water")
        advance(world, rule, 60)
        found.append((world.digest(), counts.tobytes()))
    assert found[0] == found[1]
