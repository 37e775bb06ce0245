"""Work in a Python process of its own: what holds the interpreter's lock for long would make frames late in a thread.

What it makes is kept where `core.jit` keeps things, and taken from there.
"""

import os
import pickle
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from threading import Lock

from game.core import jit

USUAL_S = sys.getswitchinterval()  # for which a thread keeps the interpreter while another waits for it
SHORT_S = 0.0001  # … while passes are made: a frame gives it away and wants it back some ten times

_CODE = """
import os, pickle, sys, threading

def end_with_the_other():
    os.read(0, 1)  # nothing comes any more, until its end of the pipe is closed
    os._exit(1)

sys.path = pickle.load(sys.stdin.buffer)  # modules are found where the other process finds them
act, arguments, is_urgent = pickle.load(sys.stdin.buffer)
threading.Thread(target=end_with_the_other, daemon=True).start()
if hasattr(os, "nice") and not is_urgent:
    os.nice(10)  # it gives way to whatever else runs
act(*arguments)
"""

_giving_way = []
_lock = Lock()


@contextmanager
def giving_way():
    """Let other threads have the interpreter soon whenever they want it."""
    with _lock:
        _giving_way.append(None)
        sys.setswitchinterval(SHORT_S)
    try:
        yield
    finally:
        with _lock:
            _giving_way.pop()
            if not _giving_way:
                sys.setswitchinterval(USUAL_S)


class Call:
    """A function that was pickled once and for all: that of a large one takes longer than a frame may."""

    def __init__(self, act):
        self._pickled = pickle.dumps(act)

    def __call__(self, *arguments):
        """Call the function."""
        return pickle.loads(self._pickled)(*arguments)


def run_beside(act, *arguments, is_urgent=False):
    """Call act(*arguments) in a process of its own, and wait for its end; nobody hears what it returns or raises.

    Both can be pickled. is_urgent: it does not give way to whatever else runs. It ends with this process. Raises
    OSError where there can be no such process, or nothing is kept.
    """
    folder = jit.folder()
    is_python = Path(sys.executable or "").stem.lower().startswith("python")  # not a program that has it built in
    if folder is None or not is_python:
        raise OSError("no process beside this one would do any good")
    handed = pickle.dumps(sys.path) + pickle.dumps((act, arguments, is_urgent))
    with subprocess.Popen(
        [sys.executable, "-P", "-c", _CODE],  # -P: not in the current folder, whatever lies there
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env=os.environ | {"SANDGLASS_CACHE_DIR": str(folder.parent)},
        creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
    ) as process:
        process.stdin.write(handed)
        process.stdin.flush()
        process.wait()
