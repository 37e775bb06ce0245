"""The screen that windows are timed on: the one there is, else a virtual one, else none at all, said by name."""

import os
import shutil
import subprocess
import sys
from contextlib import contextmanager

VIRTUAL = "4000x2400x24"  # pixels: room for a 4K window and its surroundings


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
