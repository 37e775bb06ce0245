"""The same loops in C++, compiled into a temporary folder where there is a compiler."""

import ctypes
import os
import shutil
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import numpy as np

from game.study.peers import Peer
from game.study.peers.block_table import block_table

COMPILERS = ("c++", "g++", "clang++")
FLAGS = ("-O3", "-march=native", "-shared", "-fPIC")
PATIENCE_S = 60
_LATTICE = [  # cells, height, width, offsets, partitions, start, iterations
    np.ctypeslib.ndpointer(np.uint8, 2, flags="C,W"),
    *[ctypes.c_int64] * 2,
    np.ctypeslib.ndpointer(np.int64, 2, flags="C"),
    *[ctypes.c_int64] * 3,
]
_TABLE = [ctypes.c_int64, *(np.ctypeslib.ndpointer(kind, 1, flags="C") for kind in (np.uint32, np.uint32, np.uint16))]


class NoCompilerError(Exception):
    """There is no C++ compiler, or it does not compile; says which in one line."""


@cache
def compiled():
    """Return the peer that knows the rule of sand; raise NoCompilerError."""
    library = _library("blocks.cpp", [*_LATTICE, *[ctypes.c_uint64] * 2])

    def advance(cells, rule, start, iterations):
        thresholds = (round(p * 2**32) for p in (rule.topple_left, rule.topple_right))
        library.advance(*_lattice_of(cells, rule), start, iterations, *thresholds)

    return Peer("cpp", f"C++ {FLAGS[0]}, byte-per-cell loop", advance)


def compiled_table():
    """Compile the loop by a table of block states anew and return the peer; raise NoCompilerError."""
    library = _library("table.cpp", [*_LATTICE, *_TABLE])

    def advance(cells, rule, start, iterations):
        library.advance(*_lattice_of(cells, rule), start, iterations, *block_table(rule))

    return Peer("cpp_table", f"C++ {FLAGS[0]}, bytes and a table of block states", advance)


def _lattice_of(cells, rule):
    """Return what a library takes of a lattice and of the rule's schedule."""
    offsets = np.array(rule.offsets, np.int64)
    return cells, *cells.shape, offsets, len(offsets)


def _library(name, takes):
    """Compile a source beside this module and return it, loaded; takes: the types of what its `advance` is given."""
    names = (os.environ.get("CXX"), *COMPILERS)
    compiler = next((name for name in names if name and shutil.which(name)), None)
    if compiler is None:
        raise NoCompilerError(f"C++ left out: no compiler found (looked for {', '.join(COMPILERS)})")
    source = Path(__file__).with_name(name)
    with tempfile.TemporaryDirectory(prefix="sandglass-", ignore_cleanup_errors=True) as folder:
        output = Path(folder) / "blocks.so"
        try:
            command = [compiler, *FLAGS, str(source), "-o", str(output)]
            subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S, check=True)
            library = ctypes.CDLL(str(output))
        except (OSError, subprocess.SubprocessError) as error:
            said = (getattr(error, "stderr", None) or str(error)).strip().splitlines()[0]
            raise NoCompilerError(f"C++ left out: {compiler} failed: {said}") from None
    library.advance.argtypes, library.advance.restype = takes, None
    return library
