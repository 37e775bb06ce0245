"""Processes of their own: the toy with its window, and a virtual screen for it where there is none."""

import json
import os
import shutil
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import game

PATIENCE_S = 120
VIRTUAL = "4000x2400x24"  # pixels: room for a 4K window and its surroundings


class NoWindowError(Exception):
    """The toy could not be timed in a window; says why in one line."""


def timing(arguments, environment):
    """Run `python -m game.play.trials.frame_timing` and return its report; raise NoWindowError."""
    root = str(Path(game.__file__).parents[1])
    paths = [root, *filter(None, [environment.get("PYTHONPATH")])]
    command = [sys.executable, "-m", "game.play.trials.frame_timing", *map(str, arguments), "--json"]
    try:
        done = subprocess.run(
            command, env=environment | {"PYTHONPATH": os.pathsep.join(paths)}, capture_output=True, text=True,
            timeout=PATIENCE_S, check=True,
        )  # fmt: skip
        return json.loads(done.stdout.splitlines()[-1])
    except (subprocess.SubprocessError, ValueError, IndexError) as error:
        said = (getattr(error, "stderr", None) or str(error)).strip().splitlines()
        raise NoWindowError(said[-1] if said else "no report") from None


@contextmanager
def screen():
    """Yield (environment for a process with a window, what it is shown on besides the driver's own name)."""
    environment = {**os.environ, "SDL_AUDIODRIVER": os.environ.get("SDL_AUDIODRIVER", "dummy")}
    has_screen = sys.platform != "linux" or any(map(os.environ.get, ("DISPLAY", "WAYLAND_DISPLAY")))
    if os.environ.get("SDL_VIDEODRIVER") or has_screen:
        yield environment, ""
    elif shutil.which("Xvfb"):
        with _virtual() as display:
            yield environment | {"DISPLAY": display}, "Xvfb"
    else:
        yield environment | {"SDL_VIDEODRIVER": "dummy"}, "no screen"


@contextmanager
def _virtual():
    """Run a virtual X server and yield its display."""
    reading, writing = os.pipe()
    command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", VIRTUAL, "-noreset", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(writing)
    try:
        with os.fdopen(reading) as number:
            yield f":{number.readline().strip()}"
    finally:
        server.terminate()
        server.wait()
