"""Kept kernels save time and decide nothing: whatever becomes of the cache, a kernel is compiled and right."""

import errno
import os

import numpy as np
import pytest

from game.core import jit
from game.core.loops import kernel, object_code


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    """Return the folder of a cache of its own, and let no trouble with it be told elsewhere."""
    monkeypatch.setattr(jit, "_FOLDER", tmp_path / "kernels")
    monkeypatch.setattr(jit, "_troubles", [])
    monkeypatch.setattr(jit, "_kernels", [])
    return tmp_path / "kernels"


def total(values):
    found = 0
    for k in range(len(values)):
        found += values[k]
    return found


def started():
    """Return a kernel as a new process has it."""

    return jit.kernel(total)


@pytest.fixture(autouse=True)
def compiled(monkeypatch):
    """Return what was compiled, in a list."""
    compiled = []
    monkeypatch.setattr(kernel, "compiled", lambda text: compiled.append(text) or object_code.compiled(text))
    return compiled


@pytest.fixture
def runs(compiled):
    """Return a function that says whether the code of a kernel, which is right, was kept."""

    def run(started):
        before = len(compiled)
        assert started(np.arange(4)) == 6
        return len(compiled) == before

    return run


def test_what_was_compiled_once_is_only_read_again(cache, runs):
    assert not runs(started()) and runs(started())
    assert jit.trouble() is None and len(list(cache.iterdir())) == 1


def swapped(data):
    """Return the bytes with one in the middle changed."""
    return data[: len(data) // 2] + bytes([data[len(data) // 2] ^ 1]) + data[len(data) // 2 + 1 :]


@pytest.mark.parametrize("damage", [lambda data: b"", lambda data: data[:-9], swapped, lambda data: b"x" * 999])
def test_a_damaged_kernel_is_compiled_again_and_kept_again(cache, damage, runs):
    runs(started())
    (path,) = cache.iterdir()
    path.write_bytes(damage(path.read_bytes()))
    assert not runs(started())
    assert str(path) in jit.trouble() and jit.trouble().isprintable()
    assert runs(started())


@pytest.mark.parametrize("act", ["open", "replace"])
def test_a_full_disk_costs_the_next_start_time_and_leaves_nothing(cache, monkeypatch, act, runs):
    def full(*_, **__):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with monkeypatch.context() as patch:
        patch.setattr(jit.os if act == "replace" else jit.Path, {"open": "write_bytes"}.get(act, act), full)
        assert not runs(started())
    assert "cannot keep a compiled kernel: no space left on device" in jit.trouble()
    assert list(cache.iterdir()) == [] and not runs(started())


def test_a_folder_that_is_gone_or_is_none_is_no_trouble_to_the_sand(cache, runs):
    runs(started())
    jit.shutil.rmtree(cache)
    assert not runs(started()) and jit.trouble() is None and runs(started())
    jit.shutil.rmtree(cache)
    cache.write_text("not a folder")
    assert not runs(started()) and jit.trouble()


def test_caches_that_another_process_removes_meanwhile_are_passed_over(tmp_path, monkeypatch):
    (tmp_path / "kernels-gone").symlink_to(tmp_path / "nowhere")
    for number in range(jit.FOLDERS_KEPT + 2):
        (tmp_path / f"kernels-{number}").mkdir()
    jit._prune(tmp_path, tmp_path / "kernels-0")
    assert len([path for path in tmp_path.glob("kernels-*") if path.is_dir()]) == jit.FOLDERS_KEPT + 1


def test_what_was_made_for_a_key_is_only_read_again(cache):
    assert jit.kept("a key", lambda: (1, b"code")) == (1, b"code")
    assert jit.kept("a key", None) == (1, b"code")
    assert jit.kept("another", lambda: 2) == 2 and jit.trouble() is None


@pytest.mark.parametrize("damage", [lambda data: b"", lambda data: data[:-9], swapped])
def test_what_was_damaged_is_made_again_and_kept_again(cache, damage):
    jit.kept("a key", lambda: "made")
    (path,) = cache.iterdir()
    path.write_bytes(damage(path.read_bytes()))
    assert jit.kept("a key", lambda: "again") == "again"
    assert "cannot read a compiled rule" in jit.trouble() and jit.kept("a key", None) == "again"


def test_of_passes_the_newest_are_kept(cache, monkeypatch):
    monkeypatch.setattr(jit, "MOST_KEPT", 3)
    for number in range(5):
        jit.kept(str(number), lambda number=number: number)
        for path in cache.iterdir():
            os.utime(path, (path.stat().st_atime, path.stat().st_mtime - 10))
    assert len(list(cache.iterdir())) == 3 and jit.kept("4", None) == 4


def test_without_a_folder_all_is_made(monkeypatch):
    monkeypatch.setattr(jit, "_FOLDER", None)
    assert jit.kept("a key", lambda: 1) == 1 and jit.kept("a key", lambda: 2) == 2


def test_a_folder_that_cannot_be_written_costs_time_alone(cache, monkeypatch):
    cache.write_bytes(b"no folder")
    assert jit.kept("a key", lambda: 1) == 1 and "a compiled rule" in jit.trouble()
