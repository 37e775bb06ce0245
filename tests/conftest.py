"""Let every test run without a display and without a sound card."""

import os
import tempfile
from pathlib import Path

import pytest
from numba.core.compiler_lock import global_compiler_lock
from numba.core.dispatcher import Dispatcher

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
os.environ.setdefault("SDL_AUDIODRIVER", "dummy")

try:
    import fcntl
except ImportError:  # Windows: kernels may be compiled twice there
    fcntl = None


def compile_once(dispatcher, signature, compile_it=Dispatcher.compile):
    """Compile a kernel while tests in other processes that need it wait, and then find it among those kept."""
    function = dispatcher.py_func
    is_kernel = function.__module__.startswith("game.") and not dispatcher.targetoptions.get("forceinline")
    if fcntl is None or not is_kernel:
        return compile_it(dispatcher, signature)
    path = Path(tempfile.gettempdir(), f"{function.__module__}.{function.__name__}.lock")
    with global_compiler_lock, open(path, "w") as lock:  # in this order, or two threads would wait for each other
        fcntl.flock(lock, fcntl.LOCK_EX)
        return compile_it(dispatcher, signature)


Dispatcher.compile = compile_once


@pytest.fixture(autouse=True)
def own_folder(tmp_path, monkeypatch):
    """Keep the user's real files out of reach."""
    monkeypatch.setenv("SANDGLASS_DATA_DIR", str(tmp_path / "data"))
    monkeypatch.setenv("SANDGLASS_CONFIG_DIR", str(tmp_path / "config"))
    return tmp_path / "data"
