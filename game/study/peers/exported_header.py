"""The header that `export` writes, compiled: the same rule, the same numbers, in C."""

import ctypes
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from game.export.files import files
from game.export.start_scene import StartScene

FLAGS = ("-std=c99", "-O3", "-march=native")
PATIENCE_S = 120
_SOURCE = """
#define SANDGLASS_IMPLEMENTATION
#include "sandglass.h"
void fill(sandglass *world, const uint8_t *cells);
void fill(sandglass *world, const uint8_t *cells)
{
    uint32_t x, y;
    for (y = 0; y < world->at.height; y++)
        for (x = 0; x < world->at.width; x++) sandglass_set(world, (int)x, (int)y, *cells++);
}
"""


def is_there(compiler):
    """Return whether a compiler is there."""
    return shutil.which(compiler) is not None


class ExportedHeader:
    """The header of a rule, compiled; raises subprocess.SubprocessError or OSError where that fails."""

    def __init__(self, rule, compiler):
        start = StartScene(rule, np.zeros((1, 1), np.uint8), "a cell", ())
        with tempfile.TemporaryDirectory(prefix="sandglass-", ignore_cleanup_errors=True) as folder:
            place = Path(folder)
            (place / "sandglass.h").write_text(files(start)["sandglass.h"], encoding="utf-8")
            (place / "all.c").write_text(_SOURCE, encoding="utf-8")
            command = [compiler, *FLAGS, "-shared", "-fPIC", "all.c", "-o", "all.so"]
            subprocess.run(command, cwd=place, capture_output=True, timeout=PATIENCE_S, check=True)
            self._calls = ctypes.CDLL(str(place / "all.so"))
        number, memory = ctypes.c_int, ctypes.c_void_p
        self._calls.sandglass_bytes.argtypes = number, number
        self._calls.sandglass_init.argtypes = memory, number, number, ctypes.c_uint64
        self._calls.sandglass_step.argtypes = memory, ctypes.c_uint32
        self._calls.sandglass_cells.argtypes = memory, memory, ctypes.c_uint32
        self._calls.fill.argtypes = memory, memory

    def memory_of(self, world):
        """Return the memory of a world like a World at iteration 0: uint64, which starts at a cache line."""
        height, width = world.shape
        memory = _aligned(self._calls.sandglass_bytes(width, height) // 8)
        self._calls.sandglass_init(memory.ctypes.data, width, height, world.seed)
        cells = world.materials  # held while it is read
        self._calls.fill(memory.ctypes.data, cells.ctypes.data)
        return memory

    def advance(self, memory, iterations):
        """Run iterations of the rule in place."""
        self._calls.sandglass_step(memory.ctypes.data, iterations)

    def materials(self, memory, shape):
        """Return the codes of the cells of a memory, (H, W) uint8."""
        cells = np.empty(shape, np.uint8)
        self._calls.sandglass_cells(memory.ctypes.data, cells.ctypes.data, shape[1])
        return cells


def copy_of(memory):
    """Return a copy of a memory that starts at a cache line, too."""
    copy = _aligned(len(memory))
    copy[:] = memory
    return copy


def _aligned(words):
    room = np.empty(words + 8, np.uint64)
    start = -room.ctypes.data // 8 % 8
    return room[start : start + words]
