"""Windows: runs the toy's own timing in a process of its own and returns what it says."""

import json
import os
import subprocess
import sys
from pathlib import Path

import game

PATIENCE_S = 120


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
