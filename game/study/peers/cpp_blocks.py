"""The same loop in C++: blocks.cpp, compiled into a temporary folder where there is a compiler."""

import ctypes
import os
import shutil
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import numpy as np

from game.study.peers import Peer

COMPILERS = ("c++", "g++", "clang++")
FLAGS = ("-O3", "-march=native", "-shared", "-fPIC")
PATIENCE_S = 60


class NoCompilerError(Exception):
    """There is no C++ compiler, or it does not compile; says which in one line."""


@cache
def compiled():
    """Return the peer; raise NoCompilerError."""
    names = (os.environ.get("CXX"), *COMPILERS)
    compiler = next((name for name in names if name and shutil.which(name)), None)
    if compiler is None:
        raise NoCompilerError(f"C++ left out: no compiler found (looked for {', '.join(COMPILERS)})")
    library = _library(compiler)

    def advance(cells, rule, start, iterations):
        offsets = np.array(rule.offsets, np.int64)
        height, width = cells.shape
        thresholds = (round(p * 2**32) for p in (rule.topple_left, rule.topple_right))
        library.advance(cells, height, width, offsets, len(offsets), start, iterations, *thresholds)

    return Peer("cpp", f"C++ {FLAGS[0]}, byte-per-cell loop", advance)


def _library(compiler):
    """Compile blocks.cpp and return it, loaded."""
    source = Path(__file__).with_name("blocks.cpp")
    with tempfile.TemporaryDirectory(prefix="sandglass-", ignore_cleanup_errors=True) as folder:
        output = Path(folder) / "blocks.so"
        try:
            command = [compiler, *FLAGS, str(source), "-o", str(output)]
            subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S, check=True)
            library = ctypes.CDLL(str(output))
        except (OSError, subprocess.SubprocessError) as error:
            said = (getattr(error, "stderr", None) or str(error)).strip().splitlines()[0]
            raise NoCompilerError(f"C++ left out: {compiler} failed: {said}") from None
    cells = np.ctypeslib.ndpointer(np.uint8, 2, flags="C,W")
    offsets = np.ctypeslib.ndpointer(np.int64, 2, flags="C")
    library.advance.argtypes = [
        cells, ctypes.c_int64, ctypes.c_int64, offsets, *[ctypes.c_int64] * 3, *[ctypes.c_uint64] * 2
    ]  # fmt: skip
    library.advance.restype = None
    return library
