"""Let every test run without a display and without a sound card."""

import os
import sys
import tempfile
import uuid
from pathlib import Path

import pytest
from hypothesis import HealthCheck, is_hypothesis_test, settings

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
os.environ.setdefault("SDL_AUDIODRIVER", "dummy")

if sys.dont_write_bytecode:  # then every process would compile every module anew: keep it, but away from the sources
    sys.dont_write_bytecode, sys.pycache_prefix = False, str(Path(tempfile.gettempdir(), "sandglass-bytecode"))
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ["PYTHONPYCACHEPREFIX"] = sys.pycache_prefix

from game.core.loops.kernel import Kernel

try:
    import fcntl
except ImportError:  # Windows: kernels may be compiled twice there
    fcntl = None


def make_once(kernel, types, make=Kernel._make):
    """Compile the stepping while tests in other processes that need it wait, and then find it among what is kept."""
    if fcntl is None or kernel.function.__module__ != "game.core.step":
        return make(kernel, types)
    with open(Path(tempfile.gettempdir(), f"{kernel.__name__}.lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        return make(kernel, types)


Kernel._make = make_once


steady = settings(derandomize=True, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
settings.register_profile("few examples", steady, max_examples=10)
settings.register_profile("many examples", steady, max_examples=100)


def is_sweep(config):
    return config.option.markexpr == "sweep"


def pytest_configure(config):
    """Look at few examples of a law, and at many in a sweep."""
    settings.load_profile("many examples" if is_sweep(config) else "few examples")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config, items):
    """Let a sweep run what looks at examples, too."""
    for item in items if is_sweep(config) else ():
        if is_hypothesis_test(item.obj):
            item.add_marker("sweep")


@pytest.fixture(autouse=True)
def own_folder(request, tmp_path_factory, monkeypatch):
    """Keep the user's real files out of reach."""
    if "tmp_path" in request.fixturenames:
        folder = request.getfixturevalue("tmp_path")
    else:
        folder = tmp_path_factory.getbasetemp() / uuid.uuid4().hex  # at a fraction of the price
        folder.mkdir()
    monkeypatch.setenv("SANDGLASS_DATA_DIR", str(folder / "data"))
    monkeypatch.setenv("SANDGLASS_CONFIG_DIR", str(folder / "config"))
    return folder / "data"
