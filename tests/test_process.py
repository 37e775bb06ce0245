"""The process ends softly: by whatever signal, whenever it comes, and whatever its streams can take."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from game.core import jit
from game.world.files.settings import Settings
from tests.sweeps import sweep

ROOT = Path(__file__).parents[1]
NUMBERS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]
pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals are those of POSIX")


def started(*arguments, **environment):
    """Start the program as a terminal would, in a group of its own, in which every signal is heard."""
    return subprocess.Popen(
        [sys.executable, *arguments],
        cwd=ROOT, env={**os.environ, **environment}, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        start_new_session=True, preexec_fn=lambda: [signal.signal(each, signal.SIG_DFL) for each in NUMBERS],
    )  # fmt: skip


def at_work(group):
    """Return the processes of a group that have not ended."""
    found = []
    for each in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, of = each.read_text().rpartition(")")[2].split()[:3]
        except OSError:
            continue
        if int(of) == group and state != "Z":
            found.append(each.parent.name)
    return found


def ended(process, number):
    """Return (status, stderr, processes left) of a program that a signal was sent to, and how long it took."""
    os.killpg(process.pid, number)
    since = time.monotonic()
    _, said = process.communicate(timeout=100)
    return process.returncode, said, since


PLAYING = """
import sys
from game.play import app, loop
from game.cli import main
frame, begun = app.App.frame, []
def shown(self, *told):
    if not begun:
        self.parts.recorder.toggle()
        self.parts.settings["volume"] = 0.25
    begun.append(1)
    if len(begun) == 20:
        print("playing", flush=True)
    return frame(self, *told)
app.App.frame = shown
sys.exit(main(["--scene", "paper"]))
"""


@sweep("number", NUMBERS, keep=[signal.SIGTERM])
def test_a_signal_ends_the_window_as_closing_it_does(number, own_folder, tmp_path):
    window = started("-c", PLAYING)
    assert window.stdout.readline() == "playing\n"
    os.killpg(window.pid, number)
    status, said, _ = ended(window, number)
    assert (status, said) == (128 + number, "")
    assert Settings(tmp_path / "config" / "settings.toml")["volume"] == 0.25
    (journal,) = (own_folder / "journals").iterdir()
    assert '"do":"end"' in journal.read_text().splitlines()[-1]
    assert [path.suffix for path in (own_folder / "pictures").iterdir()] == [".gif"]
    assert not at_work(window.pid)


@sweep("number", NUMBERS, keep=[signal.SIGINT])
def test_a_signal_while_kernels_compile_leaves_nobody_at_work(number, tmp_path):
    window = started("main.py", SANDGLASS_CACHE_DIR=str(tmp_path / "cache"))
    until = time.monotonic() + 60
    while not list(tmp_path.glob("cache/*/*.kernel")) and time.monotonic() < until:
        time.sleep(0.02)
    status, said, since = ended(window, number)
    assert (status, said) == (128 + number, "")
    while at_work(window.pid) and time.monotonic() < since + 10:
        time.sleep(0.02)
    assert not at_work(window.pid)


@sweep(
    "arguments",
    [["headless", "--frames", "99999"], ["bench"], ["study", "--out", "/tmp/never"]],
    keep=[["headless", "--frames", "99999"]],
)
def test_commands_without_a_window_end_by_ctrl_c_without_a_traceback(arguments):
    command = started("main.py", *arguments)
    time.sleep(0.6)
    assert ended(command, signal.SIGINT)[:2] == (130, "")
    assert not at_work(command.pid)


def test_a_signal_that_is_ignored_stays_ignored():
    script = (
        "import os, signal; from game import process; signal.signal(signal.SIGHUP, signal.SIG_IGN)\n"
        "print(process.run(lambda: (os.kill(os.getpid(), signal.SIGHUP), 7)[1]))"
    )
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.stdout == "7\n"


def test_a_signal_that_a_library_swallows_ends_all_the_same():
    script = (
        "import os, signal, time; from game import process\n"
        "def work():\n"
        "    try:\n        os.kill(os.getpid(), signal.SIGTERM); time.sleep(60)\n"
        "    except BaseException:\n        time.sleep(60)\n"
        "process.run(work)"
    )
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, check=False, timeout=40)
    assert (done.returncode, done.stderr) == (143, b"")


def test_a_signal_in_a_finalizer_ends_all_the_same():
    script = (
        "import os, signal, time; from game import process\n"
        "class Dies:\n    def __del__(self): os.kill(os.getpid(), signal.SIGTERM); time.sleep(9)\n"
        "def work():\n    Dies(); time.sleep(9)\n"
        "process.run(work)"
    )
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (143, "")


@sweep("encoding", ["ascii", "latin-1", "cp437"], keep=["ascii"])
@sweep(
    "arguments", [["--help"], ["headless", "--help"], ["study", "--help"], ["--scene", "→"]], keep=[["--scene", "→"]]
)
def test_what_a_terminal_cannot_show_is_replaced(encoding, arguments):
    command = started("main.py", *arguments, PYTHONIOENCODING=encoding)
    _, said = command.communicate(timeout=100)
    assert "Traceback" not in said and command.returncode == (2 if "--scene" in arguments else 0)


@sweep("arguments", [["--help"], ["headless", "--scene", "paper", "--frames", "2"]], keep=[["--help"]])
def test_output_that_cannot_be_written_is_one_line_and_status_2(arguments):
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [sys.executable, "main.py", *arguments],
            cwd=ROOT,
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert done.returncode == 2
    assert done.stderr == "sandglass: the output cannot be written: no space left on device\n"


SAND = (ROOT / "assets" / "rules" / "sand.toml").read_bytes()
WITHOUT_ONE = SAND.replace(b"fall_pair", b"fall_both")


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """Return a folder with the program in it, whose files can be damaged."""
    folder = tmp_path_factory.mktemp("copy")
    for name in ("game", "assets"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("*.png"))
    return folder


@sweep(
    ("content", "found", "command"),
    [
        (None, "no such file", "rule water-and-oil"),
        (b"", "found 0 materials", "rule water-and-oil"),
        (SAND[:900], "broken TOML", "rule water-and-oil"),
        (b"\xff" + SAND, "the byte 0xff", "rule water-and-oil"),
        (WITHOUT_ONE, "fall_both", "rule water-and-oil"),
        (WITHOUT_ONE, "fall_both", "headless --frames 1"),
        (WITHOUT_ONE, "fall_both", "--scene paper"),
        (WITHOUT_ONE, "fall_both", "bench --quick"),
    ],
    keep=[(WITHOUT_ONE, "fall_both", "--scene paper")],
)
def test_a_shipped_rule_that_is_damaged_is_one_line_and_status_2(content, found, command, copy):
    path = copy / "assets" / "rules" / "sand.toml"
    path.unlink(missing_ok=True) if content is None else path.write_bytes(content)
    done = subprocess.run(
        [sys.executable, "-m", "game", *command.split()], cwd=copy, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert found in done.stderr and "sand" in done.stderr


@sweep(
    "also", ["--p 0.1", "--seed 3", "--size 9x9", "--scene paper", "--frames 3"], keep=["--scene paper", "--frames 3"]
)
def test_what_a_recording_decides_is_refused_beside_it(also):
    for command in ([], ["headless"])[also.startswith("--frames") :]:
        done = subprocess.run(
            [sys.executable, "main.py", *command, "--replay", "some.sandglass", *also.split()],
            cwd=ROOT, capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert done.returncode == 2 and done.stderr.count("\n") == 1
        assert f"--replay and {also.split()[0]} do not go together" in done.stderr


def test_a_kernel_cache_that_is_damaged_costs_a_run_one_line(tmp_path):
    cache = {"SANDGLASS_CACHE_DIR": str(tmp_path / "cache")}
    if jit._FOLDER and jit._FOLDER.exists():  # which saves compiling all of it
        shutil.copytree(jit._FOLDER, tmp_path / "cache" / jit._FOLDER.name)
    for content in (None, b""):
        for path in tmp_path.glob("cache/*/pack_cells*") if content is not None else ():
            path.write_bytes(content)
        command = started("main.py", "headless", "--scene", "paper", "--frames", "2", "--json", **cache)
        out, said = command.communicate(timeout=600)
        assert command.returncode == 0 and json.loads(out)["grains_end"] == 528
        assert said.count("\n") == (content is not None) and "Traceback" not in said


PACKING = """
import numpy as np
from game.core.planes import layout, pack, unpack

cells = np.arange(35, dtype=np.uint8).reshape(5, 7) % 3
print((unpack(pack(cells, layout(5, 7)), layout(5, 7)) == cells).all())
"""


def test_programs_that_compile_at_once_and_are_killed_leave_a_cache_that_is_good(tmp_path):
    cache = {"SANDGLASS_CACHE_DIR": str(tmp_path / "cache")}

    def run():
        return started("-c", PACKING, **cache)

    commands, until = [run() for _ in range(3)], time.monotonic() + 60
    while not list(tmp_path.glob("cache/*/*.kernel")) and time.monotonic() < until:
        time.sleep(0.01)
    commands.pop().kill()
    for command in (*commands, run()):
        out, said = command.communicate(timeout=600)
        assert (command.returncode, out, said) == (0, "True\n", "")
