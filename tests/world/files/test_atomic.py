"""Laws of saving: the old file or the new one, never half of either, and one line when it cannot be."""

import errno
import os
from concurrent.futures import ThreadPoolExecutor

import pytest

from game.world.files import atomic
from game.world.files.atomic import FileError, save
from game.world.files.paths import new_file
from game.world.sessions.session import Session
from tests.saved import save_replay
from tests.world.random_sessions import SCENES


def test_a_file_is_replaced_whole(tmp_path):
    path = tmp_path / "x"
    for data in (b"one", b"two" * 100_000, b""):
        save(path, data)
        assert path.read_bytes() == data and os.listdir(tmp_path) == ["x"]


@pytest.mark.parametrize("broken", ["fsync", "replace", "chmod"])
def test_a_full_disk_leaves_the_old_file_and_nothing_else(tmp_path, monkeypatch, broken):
    def full(*_):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    path = tmp_path / "x"
    save(path, b"old")
    monkeypatch.setattr(atomic.os, broken, full)
    with pytest.raises(FileError, match="x: cannot save: no space left on device"):
        save(path, b"new")
    assert path.read_bytes() == b"old" and os.listdir(tmp_path) == ["x"]


@pytest.mark.parametrize("path", ["no/such/folder/x", "x\0y", "file/x", "."])
def test_where_nothing_can_be_saved_is_said_in_one_line(tmp_path, monkeypatch, path):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("")
    with pytest.raises(FileError) as caught:
        save_replay(path, Session(SCENES[0]))
    assert str(caught.value).isprintable() and os.listdir(tmp_path) == ["file"]


def test_a_saved_file_can_be_read_by_those_who_may_read_others(tmp_path):
    save(tmp_path / "x", b"")
    (tmp_path / "y").write_bytes(b"")
    assert (tmp_path / "x").stat().st_mode == (tmp_path / "y").stat().st_mode


def test_no_save_sets_the_umask_under_other_threads(tmp_path, monkeypatch):
    monkeypatch.delattr(atomic.os, "umask")
    save(tmp_path / "x", b"")
    assert (tmp_path / "x").exists()


def test_no_two_new_files_are_given_one_path():
    with ThreadPoolExecutor(8) as threads:
        paths = list(threads.map(lambda _: new_file("pictures", "x", ".gif"), range(40)))
    assert len(set(paths)) == 40 and not any(path.exists() for path in paths)
