"""An exported header as a shared library, called from Python; compilers that this machine has."""

import ctypes
import shutil
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from game.export.files import files
from game.export.start_scene import small_start
from game.world.rules.rule import load_rule
from game.world.sand.schedules import SCHEDULES

FOLDER = Path(__file__).parent
STRICT = ("-Wall", "-Wextra", "-pedantic", "-Werror")
QUICK_BUILDS = {"gcc": ("gcc", "-O0"), "clang": ("clang", "-O0")}
BUILDS = QUICK_BUILDS | {
    f"{compiler} {' '.join(flags)}": (compiler, *flags)
    for compiler in ("gcc", "clang")
    for flags in (("-O2",), ("-O3", "-march=native"), ("-O3", "-ffast-math", "-mno-sse4"), ("-O2", "-U__GNUC__"))
}
CALLS = {
    "bytes": (ctypes.c_uint32, (ctypes.c_int, ctypes.c_int)),
    "init": (ctypes.c_void_p, (ctypes.c_void_p, ctypes.c_int, ctypes.c_int, ctypes.c_uint64)),
    "step": (ctypes.c_int, (ctypes.c_void_p, ctypes.c_uint32)),
    "iteration": (ctypes.c_uint64, (ctypes.c_void_p,)),
    "get": (ctypes.c_int, (ctypes.c_void_p, ctypes.c_int, ctypes.c_int)),
    "set": (ctypes.c_int, (ctypes.c_void_p, *[ctypes.c_int] * 3)),
    "disc": (ctypes.c_uint32, (ctypes.c_void_p, *[ctypes.c_int] * 4)),
    "flip": (None, (ctypes.c_void_p,)),
    "count": (ctypes.c_uint32, (ctypes.c_void_p, ctypes.c_int)),
    "cells": (ctypes.c_int, (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint32)),
    "colours": (ctypes.c_int, (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint32)),
    "set_chance": (ctypes.c_int, (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double)),
    "chance": (ctypes.c_double, (ctypes.c_void_p, ctypes.c_char_p)),
    "set_schedule": (ctypes.c_int, (ctypes.c_void_p, ctypes.c_int)),
    "chance_name": (ctypes.c_char_p, (ctypes.c_int,)),
    "material_name": (ctypes.c_char_p, (ctypes.c_int,)),
    "scene": (None, (ctypes.c_void_p,)),
    "digest": (None, (ctypes.c_void_p, ctypes.c_char_p)),
    "sum": (ctypes.c_uint64, (ctypes.c_double, ctypes.c_double)),
    "fill": (None, (ctypes.c_void_p, ctypes.c_void_p)),
}
SHIM = """
#define SANDGLASS_IMPLEMENTATION
#include "sandglass.h"
void sandglass_fill(sandglass *world, const uint8_t *cells);
void sandglass_fill(sandglass *world, const uint8_t *cells)
{
    int x, y;
    for (y = 0; y < (int)world->at.height; y++)
        for (x = 0; x < (int)world->at.width; x++) sandglass_set(world, x, y, *cells++);
}
uint64_t sandglass_sum(double first, double second);
uint64_t sandglass_sum(double first, double second)
{
    const double chances[2] = { first, second };
    const int8_t terms[SG_TERMS + 1] = { 0, 1 };
    return sg_threshold(chances, terms);
}
"""


def needs(*programs):
    """Skip the test unless all programs are found."""
    for program in programs:
        if not shutil.which(program):
            pytest.skip(f"no {program} found")


def builds(wanted=QUICK_BUILDS):
    """Return the names of those builds wanted that this machine can make; skip the test where there is none."""
    found = [name for name, (compiler, *_) in wanted.items() if shutil.which(compiler)]
    if not found:
        pytest.skip("neither gcc nor clang found")
    return found


@cache
def texts_of(rule_name):
    """Return {name: text} of the files that export a shipped rule."""
    return files(small_start(load_rule(rule_name)))


def run(*command, **options):
    """Run a program; return what it printed. What it complains of is in the test's failure."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, **options)
    assert done.returncode == 0, f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}"
    return done.stdout


@cache
def library(rule_name, build):
    """Return a Library of a shipped rule."""
    with tempfile.TemporaryDirectory(prefix="sandglass-") as folder:
        return compiled(texts_of(rule_name)["sandglass.h"], build, Path(folder))


def compiler_of(build):
    """Return the command of a build, without files."""
    compiler, *flags = BUILDS[build]
    return compiler, "-std=c99", *flags


def compiled(header, build, folder):
    """Return the Library of the text of a header; linked apart, for with -ffast-math it would change this process."""
    (folder / "sandglass.h").write_text(header, encoding="utf-8")
    (folder / "shim.c").write_text(SHIM, encoding="utf-8")
    run(*compiler_of(build), *STRICT, "-fPIC", "-c", "shim.c", cwd=folder)
    run(compiler_of(build)[0], "-shared", "shim.o", "-o", "shim.so", cwd=folder)
    return Library(folder / "shim.so")


class Library:
    """The calls of a header, as in `library.step(world, 4)`."""

    def __init__(self, path):
        loaded = ctypes.CDLL(str(path))
        for name, (result, arguments) in CALLS.items():
            call = getattr(loaded, f"sandglass_{name}")
            call.restype, call.argtypes = result, arguments
            setattr(self, name, call)

    def world(self, cells, seed, schedule=None):
        """Return a new CWorld with (H, W) uint8 cells."""
        return CWorld(self, cells, seed, schedule)


class CWorld:
    """A world of a Library, and its memory."""

    def __init__(self, calls, cells, seed=0, schedule=None):
        height, width = cells.shape
        self.calls, self.shape = calls, cells.shape
        self.memory = np.full(calls.bytes(width, height) // 8, 0xA5A5A5A5A5A5A5A5, np.uint64)
        self.at = calls.init(self.memory.ctypes.data, width, height, seed)
        calls.fill(self.at, np.ascontiguousarray(cells).ctypes.data)
        if schedule is not None:
            assert calls.set_schedule(self.at, list(SCHEDULES).index(schedule))

    def __getattr__(self, name):
        call = getattr(self.calls, name)
        return lambda *arguments: call(self.at, *arguments)

    @property
    def materials(self):
        """The codes of the cells, (H, W) uint8."""
        height, width = self.shape
        cells = np.full((height, width + 3), 255, np.uint8)
        assert self.cells(cells.ctypes.data, width + 3)
        assert (cells[:, width:] == 255).all()
        return cells[:, :width]

    def name(self):
        """Return the digest."""
        digest = ctypes.create_string_buffer(33)
        self.digest(digest)
        return digest.value.decode()
