"""The bench: every peer is the same automaton, nothing wrong is timed, and each table has its rows."""

import json
import sys
from dataclasses import replace
from datetime import date
from functools import cache

import numpy as np
import pytest

from game import Rule, advance, cli
from game.study.bench import (
    checks,
    command,
    frames,
    goals,
    materials,
    peer_table,
    plan,
    processes,
    rounds,
    scale,
    start_up,
    worlds,
)
from game.study.peers import Peer, cpp_blocks, numpy_blocks
from game.study.peers.lattice import WALL, lattice, sand
from tests import reference
from tests.cells import NAMES, random_world, rows_of
from tests.sweeps import sweep

SHAPES = [(1, 1), (1, 7), (9, 1), (2, 2), (61, 61), (9, 127), (8, 128), (7, 129), (300, 20)]
HOURGLASS = plan.FrameCase("hourglass", None, None, 3)
TINY = plan.BenchPlan(
    rounds=2,
    sample_ms=0.01,
    batch=4,
    peer_batch=4,
    checked=8,
    paper_sizes=((16, 12), (20, 15)),
    peer_sizes=((30, 20),),
    scene_size=(61, 61),
    glass_sizes=((61, 61),),
    scale_sizes=((16, 16), (64, 48)),
    headers=(),
    rule_size=(30, 20),
    rule_scale_sizes=((16, 16),),
    frame_cases=(HOURGLASS,),
    frames=4,
    starts=1,
    cold=False,
)
PEERS, LEFT_OUT = peer_table.available()


def twin(world, rule, iterations):
    """Return where the reference in tests/ leaves sand: an (H, W) bool array."""
    probabilities = dict(zip(NAMES, rule.probabilities, strict=True))
    cells = reference.run(rows_of(world), probabilities, rule.schedule, world.seed, iterations)
    return np.array([list(row) for row in cells]) == "o"


@cache
def certain_ends(rule):
    """Return (world, where the twin leaves its sand after nine iterations) for worlds of all shapes."""
    generator = np.random.default_rng(50)
    found = [random_world(generator, *shape) for shape in SHAPES]
    return [(world, twin(world, rule, 9)) for world in found]


# --- peers ---


@pytest.mark.parametrize("peer", PEERS, ids=lambda peer: peer.key)
@sweep("schedule", reference.SCHEDULES, keep=["balanced"])
@sweep(("left", "right"), [(1.0, 1.0), (0.0, 0.0), (1.0, 0.0)], keep=[(1.0, 0.0)])
def test_every_peer_is_the_plain_twin_where_nothing_is_left_to_chance(peer, schedule, left, right):
    rule = Rule(topple_left=left, topple_right=right, schedule=schedule)
    for world, after in certain_ends(rule):
        cells = lattice(world)
        peer.advance(cells, rule, 0, 5)
        peer.advance(cells, rule, 5, 4)
        assert (sand(cells) == after).all(), world.shape


@sweep("schedule", reference.SCHEDULES, keep=["balanced"])
def test_the_bench_has_the_plain_twin_s_chance_for_all_seven_probabilities(schedule):
    generator = np.random.default_rng(51)
    rule = Rule(0.9, 0.2, 0.7, 0.55, 0.35, 0.61803398875, 0.15, schedule)
    for height, width in SHAPES:
        world = random_world(generator, height, width, seed=int(generator.integers(2**64, dtype=np.uint64)))
        cells = lattice(world)
        numpy_blocks.advance(cells, rule, 0, 6, numpy_blocks.product_chance(world.seed, width))
        assert (sand(cells) == twin(world, rule, 6)).all(), (height, width)


@pytest.mark.parametrize("peer", PEERS, ids=lambda peer: peer.key)
def test_peers_lose_no_grain_to_chance_and_topple_as_often_as_they_are_told(peer):
    world = worlds.World.from_cells(
        np.tile([[1, 0], [0, 0]], (500, 500)) > 0, np.tile([[0, 0], [1, 0]], (500, 500)) > 0
    )
    cells = lattice(world)
    peer.advance(cells, Rule.with_p(0.25), 0, 1)  # 250,000 grains on a wall each, free to topple right
    toppled = sand(cells)[1::2, 1::2].sum()
    assert sand(cells).sum() == world.grains and (cells[2:-1:2, 1:-1:2] == WALL).all()
    assert abs(toppled - 62_500) < 5 * (250_000 * 0.25 * 0.75) ** 0.5


def test_without_a_compiler_a_word_stands_in_for_the_peer(monkeypatch):
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CXX", raising=False)
    found, notes = _recompiled(peer_table.available)
    assert [peer.key for peer in found] == ["numpy", "byte_loop"]
    assert notes == ["C++ left out: no compiler found (looked for c++, g++, clang++)"]


def test_a_compiler_that_fails_is_left_out_with_its_own_words(monkeypatch, tmp_path):
    broken = tmp_path / "broken"
    broken.write_text("#!/bin/sh\necho no such flag >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setenv("CXX", str(broken))
    _, notes = _recompiled(peer_table.available)
    assert notes == [f"C++ left out: {broken} failed: no such flag"]


def _recompiled(act):
    cpp_blocks.compiled.cache_clear()
    try:
        return act()
    finally:
        cpp_blocks.compiled.cache_clear()


# --- nothing wrong is timed ---


def _mutant(cells, rule, start, iterations):
    """Move sand as the rule says and lose one grain."""
    numpy_blocks.NUMPY.advance(cells, rule, start, iterations)
    row, column = np.argwhere(sand(cells))[0]
    cells[row + 1, column + 1] = 0


def _no_timing(*_):
    raise AssertionError("something was timed")


def test_a_wrong_peer_is_refused_before_any_time_is_taken(monkeypatch):
    monkeypatch.setattr(peer_table, "available", lambda: ([Peer("mutant", "a mutant", _mutant)], []))
    monkeypatch.setattr(peer_table, "take_turns", _no_timing)
    with pytest.raises(checks.WrongCellsError, match="a mutant differs from the plain twin in 1 cells"):
        peer_table.peer_table(TINY)


def test_wrong_kernels_end_the_bench_with_one_line_and_no_time(monkeypatch, capsys):
    def reckless(world, rule, iterations):
        advance(world, Rule(schedule=rule.schedule, fall_pair=0.0), iterations)

    monkeypatch.setattr(checks, "advance", reckless)
    assert command.run(plan=TINY) == 1
    head, line = filter(None, (line.strip() for line in capsys.readouterr().out.splitlines()))
    assert line.startswith("sandglass bench: advance differs from the plain twin in")
    assert "nothing was timed" in line and "load" in head


def test_a_window_that_shows_another_world_is_refused(monkeypatch):
    monkeypatch.setattr(frames, "timing", lambda *_: {"same_as_without_window": False})
    with pytest.raises(checks.WrongCellsError):
        frames.frame_table(TINY)


# --- tables ---


def in_a_window(*arguments, **changed):
    """Return what the toy says of its frames or of its start, without opening a window."""
    return {
        "marks_s": dict.fromkeys(start_up.MARKS, 0.5),
        "driver": "x11",
        "same_as_without_window": True,
        "cells": [180, 240],
        "window": [640, 480],
        "pixels_per_cell": 2.0,
        "frames": 4,
        "iterations": 32,
        "smooth": True,
        "stage_ms": dict.fromkeys(frames.STAGES, 0.5),
        "frame_ms": {"mean": 3.0, "median": 3.0, "p99": 5.0},
        **changed,
    }


def few_rules(rules=materials.rules):
    """Return rules that are made in no time, under the names of those that are measured."""
    sand, water = (rules()[name] for name in (materials.SAND, materials.WATER))
    return {materials.SAND: sand, materials.WATER: water, materials.ALCHEMY: water}


@pytest.fixture(scope="module")
def tables():
    """Every section of a tiny run, by name."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(frames, "timing", in_a_window)
        patch.setattr(start_up, "timing", in_a_window)
        for module in (materials, scale):
            patch.setattr(module, "rules", few_rules)
        patch.setattr(worlds, "cooking", worlds.strewn)  # there is no kitchen of so few materials
        return {each.name: each for each in (measure(TINY) for measure in command.TABLES)}


def test_each_table_has_its_rows(tables):
    peers_of_each = len(PEERS) + 1
    rows = {name: len(each.tables[0].rows) for name, each in tables.items()}
    assert rows == {
        "paper": 2, "peers": 2 * peers_of_each, "rule peers": 4 * 3, "scene": 20, "glass": 4, "materials": 4, "acts": 7,
        "scale": 3, "frames": 1, "start": 1,
    }, [each.items[1:] for each in tables.values()]  # fmt: skip
    for each in tables.values():
        for row in each.tables[0].rows:
            is_full = "time" in row or each.name not in ("rule peers", "materials")
            assert not is_full or all(column.key in row for column in each.tables[0].columns), each.name


def test_the_stages_of_a_frame_add_up_to_the_frame(monkeypatch, tables):
    reports = []

    def timed(*arguments):
        reports.append(processes.timing(*arguments))
        return reports[-1]

    monkeypatch.setattr(frames, "timing", timed)
    (row,) = frames.frame_table(TINY).tables[0].rows
    assert row.keys() == tables["frames"].tables[0].rows[0].keys()
    assert reports[0]["frames"] == TINY.frames and row["iterations"] <= HOURGLASS.iterations
    assert sum(row[stage] for stage in frames.STAGES) == pytest.approx(reports[0]["frame_ms"]["mean"])


def test_a_start_has_its_marks_in_order(tables):
    (row,) = tables["start"].tables[0].rows
    assert 0 < row["imported"] <= row["window"] <= row["splash"] <= row["playing"]


def test_what_cannot_be_shown_is_left_out_with_a_word():
    with processes.screen() as (environment, _), pytest.raises(processes.NoWindowError, match="no such file"):
        processes.timing(["--scene", "nowhere"], environment)


@pytest.fixture
def measured(monkeypatch, tables):
    """Let the command find what a tiny run measured."""
    monkeypatch.setattr(command, "TABLES", [lambda _, each=each: each for each in tables.values()])


def test_the_command_writes_a_readme_json_and_a_picture(measured, capsys, tmp_path, tables):
    assert cli.main(["bench", "--quick", "--json", "--out", str(tmp_path / "new")]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed == json.loads((tmp_path / "new/bench.json").read_text())
    assert [each["name"] for each in printed["sections"]] == [*tables, "goals"]
    text = (tmp_path / "new/README.md").read_text()
    assert f"Measured on {date.today().isoformat()}, quick run; " in text
    assert "python main.py bench --quick --out" in text and "](speed.png)" in text
    assert (tmp_path / "new/speed.png").read_bytes().startswith(b"\x89PNG")


def test_what_is_shown_is_what_is_written(measured, capsys, tmp_path, tables):
    assert cli.main(["bench", "--quick", "--out", str(tmp_path)]) == 0
    shown, written = capsys.readouterr().out, (tmp_path / "README.md").read_text()
    for section in tables.values():
        cells = [cell for row in section.tables[0].cells() for cell in row]
        assert all(cell in shown and cell in written for cell in cells)


@pytest.mark.parametrize(("missing", "arguments"), [("rich", []), ("matplotlib", ["--out", "x"])])
def test_without_a_package_the_bench_says_so_before_anything_is_measured(missing, arguments, monkeypatch, capsys):
    monkeypatch.setattr(command, "TABLES", [_no_timing])
    monkeypatch.setitem(sys.modules, missing, None)
    assert cli.main(["bench", *arguments]) == 2
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\n") == 1
    assert missing in said.err and "sandglass[study]" in said.err


def test_without_matplotlib_and_scipy_the_bench_still_measures(measured, monkeypatch):
    for name in ("matplotlib", "scipy"):
        monkeypatch.setitem(sys.modules, name, None)
    assert cli.main(["bench", "--quick", "--json"]) == 0


def test_a_folder_that_cannot_be_made_is_named_before_anything_is_measured(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(command, "TABLES", [_no_timing])
    (tmp_path / "file").touch()
    assert cli.main(["bench", "--out", str(tmp_path / "file" / "folder")]) == 2
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\n") == 1 and str(tmp_path / "file") in said.err


# --- how it is measured ---


def test_workloads_take_turns_and_only_their_act_is_timed():
    order = []

    def workload(key):
        def fresh():
            order.append(key)
            return [0]

        def act(state):
            state[0] += 1
            assert state == [1]  # a state of its own each time

        return rounds.Workload(key, act, fresh)

    found = rounds.take_turns([workload("a"), workload("b")], rounds=3, least_ns=1)
    assert order[-6:] == ["a", "b"] * 3
    assert all(len(timing.samples) == 3 and timing.low <= timing.median <= timing.high for timing in found.values())


def test_an_hourglass_in_mid_flow_has_a_pile_a_stream_and_a_crater(monkeypatch):
    monkeypatch.setattr(worlds, "TALLEST", 120)  # so that the larger one is enlarged from 80 x 120
    for size in ((80, 120), (160, 240)):
        worlds.flowing.cache_clear()
        world = worlds.flowing(size)
        half = size[1] // 2
        assert 0.28 < world.sand[half:].sum() / world.grains < 0.45
        later = world.copy()
        advance(later, worlds.GLASS_RULE, 200)
        assert later.sand[half:].sum() > world.sand[half:].sum()
    worlds.flowing.cache_clear()


def test_settled_sand_never_moves_again():
    world = worlds.settled((61, 80))
    before = world.sand
    advance(world, worlds.GLASS_RULE, 1000)
    assert (world.sand == before).all() and before[40:].sum() == before.sum() > 0


def test_a_goal_is_met_on_its_side_of_the_limit_and_missed_when_spoiled():
    assert goals.at_least("pace", 0.7, 0.7).met and not goals.at_least("pace", 0.69, 0.7).met
    assert goals.at_most("time", 16.0, 16.0).met and not goals.at_most("time", 16.1, 16.0).met
    spoiled = goals.at_most("time", 5.0, 16.0, " ms", spoiled="15 of 16 iterations")
    assert spoiled.verdict == "≤ 16 ms: not met (15 of 16 iterations)"


@pytest.mark.parametrize(
    ("report", "met"),
    [
        ({}, True),
        ({"iterations": 31}, False),
        ({"window": [600, 480]}, False),
        ({"frame_ms": {"median": 3, "p99": 17}}, False),
    ],
    ids=["in time", "sand left unmoved", "another window", "late"],
)
def test_a_frame_meets_its_goal_in_time_with_all_its_iterations_in_the_window_asked_for(report, met, monkeypatch):
    case = replace(HOURGLASS, window=(640, 480), iterations=8, goal=True)
    monkeypatch.setattr(frames, "timing", lambda *_: in_a_window(**report))
    (row,) = frames.frame_table(replace(TINY, frame_cases=(case,))).tables[0].rows
    assert row["goal"].met == met
