"""The headless run: every shipped scene plays, keeps its grains and its budget, and ends in the same world again."""

import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from game import advance, cli, headless, load_scene, scene_names
from tests.sweeps import sweep

ROOT = Path(__file__).parents[1]
FIELDS = {
    "scene", "cells", "frames", "iterations", "grains_start", "grains_poured", "grains_swallowed", "grains_end",
    "balanced", "digest", "frame_ms", "budget_ms", "within_budget",
}  # fmt: skip


def command(*arguments, **environment):
    """Run main.py as a person would and return the finished process."""
    return subprocess.run(
        [sys.executable, "main.py", *arguments],
        cwd=ROOT, env={**os.environ, **environment}, capture_output=True, text=True, timeout=100, check=False,
    )  # fmt: skip


@sweep("name", scene_names(), keep=["hourglass", "fountain"])
def test_every_shipped_scene_keeps_its_grains_and_its_frame_budget(name, monkeypatch):
    monkeypatch.setattr(time, "perf_counter_ns", time.thread_time_ns)  # whatever else the machine has to do
    report = headless.run(load_scene(name), frames=40)
    assert report["balanced"]
    assert report["frame_ms"]["median"] <= 16
    assert report["within_budget"] and headless.status(report) == 0


def test_the_same_run_ends_in_the_same_world():
    first, again, other = (headless.run(load_scene("hourglass"), 30, seed=seed) for seed in (1, 1, 2))
    assert first["digest"] == again["digest"] != other["digest"]


def test_the_glass_is_turned_once_half_way():
    scene = load_scene("hourglass")
    report = headless.run(scene, frames=2)
    world = scene.world(0)
    due = round(report["iterations"] / 2)
    advance(world, scene.rule, due)
    world.flip()
    advance(world, scene.rule, report["iterations"] - due)
    assert report["digest"] == world.digest()


def test_lost_grains_or_a_missed_budget_end_with_status_1():
    good = {"within_budget": True, "balanced": True}
    assert headless.status(good) == 0
    assert headless.status(good | {"balanced": False}) == 1
    assert headless.status(good | {"within_budget": False}) == 1


def test_json_is_one_object_with_every_field(capsys):
    status = cli.main(["headless", "--scene", "paper", "--frames", "12", "--p", "0.5", "--seed", "3", "--json"])
    report = json.loads(capsys.readouterr().out)
    assert status == 0 and set(report) == FIELDS
    assert report["scene"] == "paper" and report["frames"] == 12 and report["cells"] == 61 * 61
    assert set(report["frame_ms"]) == {"median", "p99", "max"}


def test_headless_runs_without_pygame():
    code = (
        "import sys; sys.modules['pygame'] = None\n"
        "from game.cli import main\n"
        "sys.exit(main(['headless', '--scene', 'paper', '--frames', '3']))"
    )
    assert subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, check=False).returncode == 0


def test_a_start_that_finds_its_kernels_imports_no_compiler_and_nothing_of_the_study():
    code = (
        "import sys; from game.cli import main; main(['headless', '--scene', 'paper', '--frames', '2'])\n"
        "print({'numba', 'matplotlib', 'rich', 'scipy'} & set(sys.modules))"
    )
    headless.run(load_scene("paper"), frames=2)
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "set()"


def test_to_compile_by_numba_does_not_take_linear_algebra_along_nor_keeps_others_from_it():
    code = "import sys, game.core.numba_jit; print('scipy.linalg' in sys.modules); import scipy.linalg"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"


@sweep("driver", ["", "x11"], keep=["x11"])
def test_with_no_display_the_toy_says_so_and_runs_headless(driver):
    done = command(SDL_VIDEODRIVER=driver, DISPLAY="", WAYLAND_DISPLAY="")
    first, *rest = done.stdout.splitlines()
    assert done.returncode == 0 and "Traceback" not in done.stderr
    assert first.startswith("sandglass: no display") and any("grains" in line for line in rest)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--p", "1.5"], "p must be in [0, 1], got 1.5"),
        (["--p", "nan"], "p must be in [0, 1], got nan"),
        (["--p", "much"], "p must be in [0, 1], got 'much'"),
        (["headless", "--p", "-0.1"], "p must be in [0, 1], got -0.1"),
        (["headless", "--frames", "0"], "frames must be a whole number in"),
        (["headless", "--frames", "9999999999"], "frames must be a whole number in"),
        (["--seed", "-3"], "seed must be a whole number in"),
        (["--seed", "1.5"], "seed must be a whole number in"),
        (["--size", "480"], "size must be WIDTHxHEIGHT in cells"),
        (["--size", "0x5"], "size must be a whole number in [1, 16384] cells, got 0"),
        (["--size", "99999x5"], "got 99999"),
        (["--cell", "0"], "cell must be a whole number in [1, 64] pixels, got 0"),
        (["--ui-scale", "9"], "ui-scale must be in [0.75, 3]"),
        (["--scene", "nowhere"], "nowhere"),
        (["headless", "--scene", "/no/such/file.toml"], "/no/such/file.toml"),
        (["--speed", "3"], "--speed"),
        (["headles"], "headles"),
    ],
)
def test_bad_flags_get_one_line_and_status_2(arguments, words, capsys):
    with pytest.raises(SystemExit, match="2"):
        cli.main(arguments)
    said = capsys.readouterr()
    assert said.out == "" and words in said.err and said.err.count("\n") == 1


def test_a_process_that_refuses_ends_with_one_line_and_status_2():
    done = command("--p", "1.5")
    assert done.returncode == 2 and done.stdout == ""
    assert "p must be in [0, 1], got 1.5" in done.stderr and done.stderr.count("\n") == 1


def test_kernels_run_without_a_writable_cache(tmp_path):
    closed = tmp_path / "file"
    closed.write_text("not a folder")
    code = "from game.core import jit; print(jit.cache_folder())"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, env={**os.environ, "SANDGLASS_CACHE_DIR": str(closed)},
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stdout.strip() == "None"


def test_the_cache_is_named_by_the_sources(tmp_path):
    def folder_for(edit):
        copy = tmp_path / f"copy{len(edit)}"
        shutil.copytree(ROOT / "game", copy / "game")
        with open(copy / "game" / "core" / "block.py", "a", encoding="utf-8") as source:
            source.write(edit)
        code = "from game.core import jit; print(jit.cache_folder())"
        environment = {**os.environ, "SANDGLASS_CACHE_DIR": str(tmp_path / "cache")}
        return subprocess.run(
            [sys.executable, "-c", code], cwd=copy, env=environment, capture_output=True, text=True, check=True
        ).stdout

    assert folder_for("") != folder_for("# an edit in another file than the kernel's own\n")


def test_the_report_is_short_text():
    report = headless.run(load_scene("paper"), frames=5)
    text = headless.text(report)
    assert len(text.splitlines()) <= 8 and report["digest"] in text
    assert np.isfinite(report["frame_ms"]["p99"])
