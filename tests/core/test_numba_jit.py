"""What numba compiles is a kernel like all others, and does what the other compiler makes of the same source."""

import gc
from typing import NamedTuple

import numba
import numpy as np
import pytest

from game import World, advance, load_rule
from game.core import jit, step


class Span(NamedTuple):
    """Where something is done, and by how much."""

    first: int
    by: float


@jit.gate
def scaled(value, by):
    return value * by


def fill(flat, rows, apart, span, grow, size):
    for k in range(span.first, len(flat)):
        flat[k] += scaled(float(k), span.by) if grow else 1.0
    for y in range(rows.shape[0]):
        for x in range(rows.shape[1]):
            rows[y, x] = rows[y, x] * size + np.uint64(y + rows.size) + np.uint64(apart[x])


def skip(values, stride):
    for k in range(0, len(values), stride):
        values[k] = 1


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    """Keep kernels in a folder of their own, and let no trouble with it be told elsewhere."""
    monkeypatch.setattr(jit, "_FOLDER", tmp_path / "kernels")
    monkeypatch.setattr(jit, "_troubles", [])
    monkeypatch.setattr(jit, "_kernels", [])


def filled(act, grow):
    """Return the arrays that an act like `fill` has worked on."""
    whole = np.arange(24, dtype=np.uint64).reshape(4, 6)
    arrays = np.zeros(5), whole[:, 1:4], np.arange(9, dtype=np.uint8)[::3]
    act(*arrays, Span(2, 0.5), grow, np.uint64(3))
    return arrays


@pytest.mark.parametrize("grow", [False, True])
def test_a_kernel_gets_numbers_arrays_and_tuples_as_python_does(grow):
    for expected, found in zip(filled(fill, grow), filled(jit.numba_kernel(fill), grow), strict=True):
        assert (expected == found).all()


def test_what_numba_compiled_once_is_only_read_again(monkeypatch):
    filled(jit.numba_kernel(fill), True)
    monkeypatch.setattr(jit, "_compile_by_numba", lambda *_: pytest.fail("it is compiled again"))
    jit._compile_by_numba.__name__ = "_compile_by_numba"
    assert filled(jit.numba_kernel(fill), True)[0].any() and jit.trouble() is None


def test_the_other_compiler_keeps_what_it_makes_apart():
    for kernel in (jit.kernel, jit.numba_kernel):
        kernel(skip)(np.zeros(3, np.int64), 1)
    assert len(list(jit.folder().iterdir())) == 2


def test_an_exception_in_a_kernel_is_raised():
    with pytest.raises(ArithmeticError, match="raised an exception"):
        jit.numba_kernel(skip)(np.zeros(3, np.int64), 0)


def test_what_numba_cannot_compile_is_compiled_without_it_and_every_start_says_so_until_it_can(monkeypatch):
    def fail(function, types):
        raise AttributeError("no such thing\nas a codegen")

    def start():
        values = np.zeros(5, np.int64)
        jit._troubles.clear()
        jit.numba_kernel(skip)(values, 2)
        assert values.tolist() == [1, 0, 1, 0, 1] and gc.isenabled()
        return jit.trouble()

    with monkeypatch.context() as patch:
        patch.setattr("game.core.numba_jit.compile_kernel", fail)
        words = "skip: numba cannot compile it: no such thing; it is compiled without numba"
        assert start() == words and start() == words
    assert start() is None


@pytest.mark.parametrize("collects", [True, False])
def test_numba_compiles_without_a_look_for_garbage_which_then_is_as_before(collects, monkeypatch):
    seen = []
    monkeypatch.setattr("game.core.numba_jit.compile_kernel", lambda *_: seen.append(gc.isenabled()) or (b"", ""))
    if not collects:
        gc.disable()
    try:
        jit._compile_by_numba(skip, ())
        assert seen == [False] and gc.isenabled() == collects
    finally:
        gc.enable()


def test_numba_works_for_others_as_before():
    def smaller(a, b):
        if a < 0:
            raise ValueError(a)
        return min(a, b)

    def smallest(values):
        values[0] = min(values[0], values[1])

    jit.numba_kernel(smallest)(np.array([2, 1]))
    assert numba.njit(smaller)(2, 1) == 1 and gc.isenabled()
    with pytest.raises(ValueError, match="-5"):
        numba.njit(smaller)(-5, 1)


@pytest.mark.parametrize("name", ["sand", "water-and-oil"])
def test_both_compilers_make_the_same_of_the_stepping(name, monkeypatch):
    rule, worlds = load_rule(name), []
    cells = np.random.default_rng(9).integers(0, len(rule.materials), (90, 300)).astype(np.uint8)
    for kernel in (step.advance_bands, jit.kernel(step.advance_bands.function)):
        monkeypatch.setattr(step, "advance_bands", kernel)
        worlds.append(World.from_materials(cells, rule, 4))
        for iterations in (1, 7, 40):
            advance(worlds[-1], rule, iterations)
    assert worlds[0].digest() == worlds[1].digest() and jit.trouble() is None
    assert (worlds[0].activity.quiet == worlds[1].activity.quiet).all()
