"""Rules of several materials in the bench: twin and loops do what the pictures say, and nothing wrong is timed."""

from dataclasses import replace
from random import Random

import numpy as np
import pytest

from game import load_rule, rule_names
from game.study.bench import checks, materials, worlds
from game.study.peers import Peer, cpp_blocks, exported_header, table_blocks, table_loop
from game.study.peers.block_table import block_table, loop_chances
from game.world.files.paths import asset
from game.world.rules.rule import SCHEDULES
from tests import reference
from tests.study.bench.test_bench import TINY
from tests.sweeps import sweep

SHAPES = [(1, 1), (1, 7), (9, 1), (8, 128), (7, 129), (40, 61)]


def loops():
    try:
        return [table_loop.TABLE_LOOP, cpp_blocks.compiled_table()]
    except cpp_blocks.NoCompilerError:
        return [table_loop.TABLE_LOOP]


def strewn_lattice(rule, shape):
    generator = np.random.default_rng(9)
    cells = generator.integers(0, len(rule.materials), shape, np.uint8) * (generator.random(shape) < 0.7)
    return np.pad(cells.astype(np.uint8), 1, constant_values=rule.codes.wall)


@sweep("name", rule_names(), keep=["sand", "water-and-oil"])
def test_the_twin_of_any_rule_is_the_plain_twin_of_its_pictures(name):
    rule, pictures = load_rule(name), reference.Pictures(asset("rules", f"{name}.toml"))
    letters = np.array([each.letter for each in rule.definition.materials])
    layers = table_blocks.layers_of(rule)
    for shape in ((7, 9), (6, 131)):
        cells = strewn_lattice(rule, shape)
        rows = reference.run(letters[cells[1:-1, 1:-1]].tolist(), pictures, rule.schedule, 5, 3)
        table_blocks.advance(cells, rule, 0, 3, layers, table_blocks.product_chances(5, shape[1]))
        assert letters[cells[1:-1, 1:-1]].tolist() == rows, shape


@pytest.mark.parametrize("name", rule_names())
def test_a_table_of_block_states_has_the_outcomes_of_the_pictures(name):
    rule, pictures = load_rule(name), reference.Pictures(asset("rules", f"{name}.toml"))
    letters = [each.letter for each in rule.definition.materials]
    table, draw = block_table(rule), Random(name)
    for _ in range(150):
        codes = [draw.randrange(len(letters)) for _ in range(4)]
        state = sum(code << table.bits * corner for corner, code in enumerate(codes))
        found, before = {}, 0
        for at in range(table.first[state], table.first[state + 1]):
            after = tuple(
                letters[int(table.after[at]) >> table.bits * corner & 2**table.bits - 1] for corner in range(4)
            )
            found[after] = (int(table.last[at]) + 1 - before) / 2**32
            before = int(table.last[at]) + 1
        assert found == pytest.approx(pictures.outcomes([letters[code] for code in codes]), abs=1e-8), codes


@sweep(
    ("name", "schedule"),
    [("alchemy", "paper"), *((name, each) for name in ("sand", "three-sands") for each in SCHEDULES)],
    keep=[("three-sands", "balanced")],
)
def test_the_loops_are_the_twin_with_their_table_and_their_numbers(name, schedule):
    rule = load_rule(name).with_schedule(schedule)
    layer = block_table(rule).as_layer()
    for shape in SHAPES:
        start = strewn_lattice(rule, shape)
        twin = start.copy()
        table_blocks.advance(twin, rule, 3, 7, [layer], loop_chances(shape[1]))
        assert min(shape) < 7 or (twin != start).any()
        for peer in loops():
            cells = start.copy()
            peer.advance(cells, rule, 3, 3)
            peer.advance(cells, rule, 6, 4)
            assert (cells == twin).all(), (peer.key, shape)


def test_half_of_a_strewn_lattice_is_empty_and_none_of_it_wall():
    rule = load_rule("alchemy")
    counts = np.bincount(worlds.strewn((300, 200), rule).materials.ravel(), minlength=16)
    assert counts[rule.codes.wall] == 0 and abs(counts[0] - 30_000) < 5 * 60_000**0.5 / 2
    assert all(abs(counts[code] - 30_000 / 14) < 5 * (30_000 / 14) ** 0.5 for code in rule.codes.filled)


def test_a_loop_that_loses_a_cell_is_refused_before_any_time_is_taken(monkeypatch):
    def mutant(cells, rule, start, iterations):
        table_loop.advance(cells, rule, start, iterations)
        cells[tuple(np.argwhere(cells[1:-1, 1:-1] == 1)[0] + 1)] = 0

    monkeypatch.setattr(cpp_blocks, "compiled_table", lambda: Peer("cpp_table", "a mutant", mutant))
    monkeypatch.setattr(materials, "take_turns", None)
    with pytest.raises(checks.WrongCellsError, match="a mutant differs from the plain twin in 1 cells"):
        materials.rule_peer_table(TINY)


@pytest.mark.parametrize("measure", [materials.rule_peer_table, materials.material_table])
def test_kernels_that_move_otherwise_are_refused_before_any_time_is_taken(measure, monkeypatch):
    monkeypatch.setattr(checks, "advance", lambda world, rule, iterations: None)
    monkeypatch.setattr(materials, "take_turns", None)
    with pytest.raises(checks.WrongCellsError, match="advance differs from the plain twin"):
        measure(TINY)


def test_a_header_that_moves_otherwise_is_refused_before_any_time_is_taken(monkeypatch):
    if not exported_header.is_there("gcc"):
        pytest.skip("no gcc found")
    monkeypatch.setattr(exported_header.ExportedHeader, "advance", lambda self, memory, iterations: None)
    monkeypatch.setattr(materials, "take_turns", None)
    with pytest.raises(checks.WrongCellsError, match="exported as a C header"):
        materials.rule_peer_table(replace(TINY, headers=("gcc",)))


def test_without_a_compiler_a_row_says_so(monkeypatch):
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CXX", raising=False)
    monkeypatch.setattr(materials, "rules", lambda rules=materials.rules: {materials.SAND: rules()[materials.SAND]})
    rows = materials.rule_peer_table(TINY).tables[0].rows
    assert [row["key"] for row in rows] == ["cpp_table", "table_loop", "ours"]
    assert rows[0]["name"] == "C++ left out: no compiler found (looked for c++, g++, clang++)"
