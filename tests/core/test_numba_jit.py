"""What numba compiled is kept as all kernels are, and does what the other compiler makes of the same source."""

import numpy as np
import pytest

from game import World, advance, load_rule
from game.core import jit, numba_jit, step
from tests.core.test_jit import swapped, total


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """Return the folder of a cache of its own, and let no trouble with it be told elsewhere."""
    monkeypatch.setattr(jit, "_FOLDER", tmp_path / "kernels")
    monkeypatch.setattr(jit, "_troubles", [])
    monkeypatch.setattr(jit, "_kernels", [])
    return tmp_path / "kernels"


def was_kept():
    """Return whether a kernel, as a new process has it, is right, and whether its code was kept."""
    kernel = numba_jit.numba_kernel(total)
    assert kernel(np.arange(4)) == 6
    return bool(kernel._compiled.stats.cache_hits)


def test_what_was_compiled_once_is_only_read_again(cache):
    assert not was_kept() and was_kept()
    assert jit.trouble() is None and len(list(cache.iterdir())) == 1


@pytest.mark.parametrize("damage", [lambda data: b"", swapped])
def test_a_damaged_kernel_is_compiled_again_and_kept_again(cache, damage):
    was_kept()
    (path,) = cache.iterdir()
    path.write_bytes(damage(path.read_bytes()))
    assert not was_kept()
    assert str(path) in jit.trouble() and jit.trouble().isprintable()
    assert was_kept()


def test_a_kernel_that_is_not_what_it_was_packed_as_is_compiled_again(cache, monkeypatch):
    was_kept()
    monkeypatch.setattr(numba_jit.CompileResult, "_rebuild", lambda *_: 1 / 0)
    assert not was_kept() and "division by zero" in jit.trouble()


def test_a_kernel_that_cannot_be_packed_is_only_not_kept(cache, monkeypatch):
    monkeypatch.setattr(numba_jit, "dumps", lambda _: 1 / 0)
    assert not was_kept() and "cannot keep a compiled kernel: division by zero" in jit.trouble()


def test_a_folder_that_cannot_be_written_is_no_trouble_to_the_sand(cache):
    cache.write_text("not a folder")
    assert not was_kept() and jit.trouble()


@pytest.mark.parametrize("name", ["sand", "water-and-oil"])
def test_both_compilers_make_the_same_of_the_stepping(name, monkeypatch):
    rule, worlds = load_rule(name), []
    cells = np.random.default_rng(9).integers(0, len(rule.materials), (90, 300)).astype(np.uint8)
    for kernel in (step.advance_bands, jit.kernel(step.advance_bands.function)):
        monkeypatch.setattr(step, "advance_bands", kernel)
        worlds.append(World.from_materials(cells, rule, 4))
        for iterations in (1, 7, 40):
            advance(worlds[-1], rule, iterations)
    assert worlds[0].digest() == worlds[1].digest()
    assert (worlds[0].activity.quiet == worlds[1].activity.quiet).all()
