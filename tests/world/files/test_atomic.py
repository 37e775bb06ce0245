"""Laws of saving: the old file or the new one, never half of either, and one line when it cannot be."""

import errno
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

from game.play.storage.films.film_file import FilmFile
from game.play.storage.films.gif import GifEncoder
from game.world.files import atomic
from game.world.files.atomic import FileError, clear_parts, save
from game.world.files.paths import numbered, save_new
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


def test_windows_that_save_in_one_second_have_a_file_each(tmp_path):
    script = (
        "import sys; from game.world.files.paths import save_new\n"
        "print(save_new('scenes', 'x', '.png', sys.argv[1].encode()))"
    )
    for number in range(2):  # in one second of the clock, unless it turns just now
        windows = [
            subprocess.Popen([sys.executable, "-c", script, f"{number}{letter}"], stdout=subprocess.PIPE, text=True)
            for letter in "abcd"
        ]
        paths = [window.communicate(timeout=100)[0].strip() for window in windows]
        assert len(set(paths)) == 4
        assert {Path(path).read_text() for path in paths} == {f"{number}{letter}" for letter in "abcd"}


@pytest.mark.parametrize("links", [True, False])
def test_no_new_file_takes_the_place_of_another(tmp_path, monkeypatch, links):
    if not links:
        monkeypatch.setattr(atomic.os, "link", refuse)
    with ThreadPoolExecutor(8) as threads:
        paths = list(threads.map(lambda number: save_new("pictures", "x", ".gif", b"%d" % number), range(40)))
    assert [path.read_bytes() for path in paths] == [b"%d" % number for number in range(40)]
    assert len(os.listdir(paths[0].parent)) == 40


def refuse(*_):
    raise PermissionError(errno.EPERM, "no hard links here")


def test_what_a_killed_process_was_writing_is_cleared_and_what_is_being_written_is_not(tmp_path):
    script = (
        "import os, sys, time; from game.world.files.atomic import Part\n"
        "part = Part(sys.argv[1], 'film'); part.file.write(b'x'); print(part.path, flush=True); time.sleep(600)"
    )
    window = subprocess.Popen([sys.executable, "-c", script, str(tmp_path)], stdout=subprocess.PIPE, text=True)
    path = Path(window.stdout.readline().strip())
    (tmp_path / ".recording-0ld.part").write_bytes(b"of a version that locked nothing")
    clear_parts(tmp_path)
    assert list(tmp_path.iterdir()) == [path]
    window.kill()
    window.communicate()
    clear_parts(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_file_whose_end_finds_no_room_leaves_nothing_and_is_named(tmp_path, monkeypatch):
    with pytest.raises(FileError, match=r"film.gif: cannot write the recording: no space left on device"):
        film = FilmFile(numbered(tmp_path / "film.gif"), GifEncoder(bytes(768)))
        film._part.file = open("/dev/full", "wb")  # noqa: SIM115 - the film closes it
        film.add(np.zeros((4, 4), np.uint8), 40)
        film.close()
    assert os.listdir(tmp_path) == []


def test_every_file_obeys_the_umask(tmp_path, monkeypatch):
    monkeypatch.setattr(atomic, "UMASK", 0o077)
    film = FilmFile(numbered(tmp_path / "film.gif"), GifEncoder(bytes(768)))
    film.add(np.zeros((4, 4), np.uint8), 40)
    for path in (film.close(), save_new("scenes", "x", ".png", b"")):
        assert path.stat().st_mode & 0o777 == 0o600
