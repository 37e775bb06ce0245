"""Work in a process beside this one is done there, and trouble with it is no trouble here."""

import os
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from game import load_rule
from game.core import jit
from game.core.compiler import rule_pass
from game.core.compiler.beside import run_beside
from game.core.compiler.rule_pass import make_beside, pass_of


@pytest.fixture(autouse=True)
def own_cache(tmp_path, monkeypatch):
    """Keep machine code in a folder of its own."""
    monkeypatch.setattr(jit, "_FOLDER", tmp_path / jit.cache_folder().name)


def note_niceness(path):
    path.write_text(str(os.nice(0)))


def beat(path):
    for _ in range(6000):
        with path.open("a") as beats:
            beats.write("x")
        time.sleep(0.01)


def beats_in(path, wait_s):
    time.sleep(wait_s)
    return path.stat().st_size if path.exists() else 0


def test_a_process_ends_with_the_one_that_waits_for_it(tmp_path):
    beats = tmp_path / "beats"
    script = f"""
from pathlib import Path
from game.core.compiler.beside import run_beside
from {beat.__module__} import beat
run_beside(beat, Path({str(beats)!r}))
"""
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    with subprocess.Popen([sys.executable, "-c", script], env=environment) as waiting:
        deadline_s = time.monotonic() + 60
        while not beats_in(beats, 0.01) and time.monotonic() < deadline_s:
            pass
        waiting.kill()
    assert any(beats_in(beats, 0) == beats_in(beats, 1) > 0 for _ in range(20))


def test_more_than_a_pipe_holds_is_handed_over(tmp_path):
    run_beside(Path.write_text, tmp_path / "note", "done" * 2**18)
    assert (tmp_path / "note").stat().st_size == 2**20


def test_what_is_called_is_done_by_another_process(tmp_path):
    run_beside(Path.write_text, tmp_path / "note", "done")
    assert (tmp_path / "note").read_text() == "done"


def test_modules_are_found_as_here_and_not_in_the_current_folder(tmp_path, monkeypatch):
    for name in ("game", "pickle", "numpy"):
        (tmp_path / f"{name}.py").write_text("raise SystemExit")
    elsewhere = tmp_path / f"a{os.pathsep}b"
    elsewhere.mkdir()
    (elsewhere / "only_here.py").write_text("def act(path):\n    path.touch()\n")
    monkeypatch.syspath_prepend(elsewhere)
    monkeypatch.chdir(tmp_path)
    from only_here import act

    run_beside(act, tmp_path / "note")
    run_beside(jit.kept, "a key", list)
    assert (tmp_path / "note").exists() and jit.kept("a key", None) == []


def test_what_it_keeps_is_found_here():
    run_beside(jit.kept, "a key", list)
    assert jit.kept("a key", None) == []


@pytest.mark.skipif(not hasattr(os, "nice"), reason="this system knows no niceness")
def test_what_is_not_urgent_gives_way(tmp_path):
    for is_urgent in (True, False):
        run_beside(note_niceness, tmp_path / str(is_urgent), is_urgent=is_urgent)
    assert int((tmp_path / "True").read_text()) == os.nice(0)
    assert int((tmp_path / "False").read_text()) == min(os.nice(0) + 10, 19)


def test_a_call_that_fails_is_only_over(tmp_path, capfd):
    run_beside(Path.read_text, tmp_path / "nothing")
    assert capfd.readouterr() == ("", "")


def test_where_nothing_is_kept_or_no_interpreter_is_at_hand_no_process_is_started(monkeypatch):
    with monkeypatch.context() as patch, pytest.raises(OSError, match="no process"):
        patch.setattr(jit, "_FOLDER", None)
        run_beside(print)
    for program in ("/opt/engine/engine", "", None):
        monkeypatch.setattr(sys, "executable", program)
        with pytest.raises(OSError, match="no process"):
            run_beside(print)


def test_a_large_rule_is_made_by_another_process_and_only_taken_here(monkeypatch):
    rule = load_rule("water-and-oil")
    monkeypatch.setattr(rule_pass, "LARGEST_BITS", rule.table.bits)
    table = replace(rule.table)  # as read anew
    make_beside(table, rule.values)
    monkeypatch.setattr(rule_pass, "_made", lambda *_: 1 / 0)
    monkeypatch.setattr(rule_pass, "run_beside", None)
    make_beside(table, rule.values)
    assert pass_of(table, rule.values).outside_code == rule.codes.wall
    monkeypatch.setattr(jit, "_FOLDER", None)
    monkeypatch.setattr(rule_pass, "run_beside", run_beside)
    make_beside(replace(rule.table), rule.values)
