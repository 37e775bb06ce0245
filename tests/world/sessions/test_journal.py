"""Laws of the journal: what was done is on file at once, and a session that died goes on from its last act."""

import errno
import os
import random
import signal
import threading
import time

import pytest

from game.world.rules.rule import Rule
from game.world.sessions import journal as journals
from game.world.sessions.action import Clear, Flip, Paint, SetRule
from game.world.sessions.journal import Journal, JournalError, finish, prune, unfinished
from game.world.sessions.recording import Recording, load_replay
from game.world.sessions.session import Session
from tests.sweeps import sweep
from tests.world.random_sessions import SCENES, state

KILLS = 20, 100  # in a quick run, and in a sweep
FRAME_NS = 16_666_667
DOT = Paint("sand", (5.0, 5.0), (9.0, 5.0), 4)


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """Keep the journals of tests apart from the player's own."""
    monkeypatch.setenv("SANDGLASS_DATA_DIR", str(tmp_path))
    return tmp_path / "journals"


def session_with_journal(seed=0):
    session = Session(SCENES[1], seed)
    session.journal = Journal.begin(SCENES[1], seed)
    return session


def resumed(path):
    """Return the session that a journal tells, where it ended, writing on."""
    journal, recording = Journal.resume(path)
    session = Session.retold(recording)
    session.seek(recording.end)
    session.journal = journal
    return session


def acts_of(seed):
    """Yield what the player of a random session does, for ever."""
    chance = random.Random(seed)
    while True:
        kind = chance.randrange(8)
        place = chance.uniform(0, 30), chance.uniform(0, 24)
        if kind < 4:
            yield "do", Paint(("sand", "wall", "erase")[kind % 3], place, place, chance.randrange(1, 8)), kind == 3
        elif kind == 4:
            yield "do", chance.choice((Flip(), Clear(), SetRule(Rule.with_p(chance.random())))), False
        elif kind == 5:
            yield chance.choice(("undo", "redo")), False
        elif kind == 6:
            yield "seek", chance.randrange(200)
        else:
            yield "frame", chance.randrange(FRAME_NS)


def obey(session, command):
    getattr(session, command[0])(*command[1:])


def test_a_session_goes_on_where_it_was_left():
    session = session_with_journal(seed=3)
    for command, _ in zip(acts_of(1), range(60), strict=False):
        obey(session, command)
    session.do(DOT)
    session.journal.abandon()
    path = next(unfinished())
    again = resumed(path)
    assert state(again) == state(session)
    again.do(Flip())
    again.journal.abandon()
    session.journal = None
    session.do(Flip())
    assert state(resumed(path)) == state(session)


def _die(seed, pipe):
    """Play a random session, saying after each act how many were done, until killed."""
    session = session_with_journal(seed)
    for number, command in enumerate(acts_of(seed), 1):
        obey(session, command)
        os.write(pipe, number.to_bytes(4, "little"))


@sweep("kills", KILLS, keep=KILLS[:1])
@pytest.mark.skipif(not hasattr(os, "fork"), reason="kills a forked process")
def test_every_session_killed_at_a_random_moment_recovers_to_its_last_act(folder, kills):
    warm = Session(SCENES[1])
    for command, _ in zip(acts_of(0), range(40), strict=False):
        obey(warm, command)
    for seed in range(kills):
        told = _acts_before_death(seed)
        paths = list(folder.glob("*.sandglass"))
        if paths:
            _assert_recovered(paths, seed, told)
        else:
            assert told == 0
        for path in paths:
            path.unlink()


def _acts_before_death(seed):
    """Kill a session at a random moment and return how many acts it had reported done."""
    ear, mouth = os.pipe()
    child = os.fork()
    if not child:
        try:
            _die(seed, mouth)
        finally:
            os._exit(1)
    os.close(mouth)
    time.sleep(random.Random(seed).uniform(0.0005, 0.02))
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    with open(ear, "rb") as file:
        return len(file.read()) // 4


def _assert_recovered(paths, seed, told):
    """Assert that the journal tells a session in which all acts reported done were done, and at most one more."""
    path = next(unfinished(), None)
    entries = []
    if path is not None:
        session = resumed(path)
        session.journal.abandon()
        entries = load_replay(path).entries
    for done in (told, told + 1):
        twin, heard = Session(SCENES[1], seed), []
        twin.journal = type("Ear", (), {"note": lambda self, entry, heard=heard: heard.append(entry)})()
        for command, _ in zip(acts_of(seed), range(done), strict=False):
            obey(twin, command)
        acts = [entry for entry in heard if entry.what != "wait"]
        if [(e.at, e.join) for e in acts] == [(e.at, e.join) for e in entries if e.what != "wait"]:
            if acts:
                twin.seek(session.now)
                assert state(session) == state(twin)
            return
    raise AssertionError(f"session {seed}: {told} acts were reported done, {len(entries)} entries are on file")


def test_a_torn_last_line_is_dropped():
    session = session_with_journal()
    session.do(DOT)
    before = state(session)
    session.do(Flip())
    session.journal.abandon()
    path = session.journal.path
    path.write_bytes(path.read_bytes()[:-5])
    again = resumed(next(unfinished()))
    assert state(again) == before
    again.do(Clear())
    again.journal.close(0, again.world.digest())
    assert load_replay(path).problem is None and not path.with_name(path.name + ".damaged").exists()


def test_what_follows_a_damaged_line_is_set_aside():
    session = session_with_journal()
    for act in (DOT, Flip(), Clear()):
        session.do(act)
    session.journal.abandon()
    path = session.journal.path
    data = path.read_bytes().replace(b"flip", b"slip")
    path.write_bytes(data)
    again = resumed(path)
    assert [entry.what for entry in again.timeline.history.story()] == [DOT]
    assert path.with_name(path.name + ".damaged").read_bytes() == data


def test_a_finished_session_is_not_offered_again_and_is_a_replay():
    session = session_with_journal()
    session.do(DOT)
    session.frame(FRAME_NS)
    session.journal.close(session.now, session.world.digest())
    assert not list(unfinished())
    recording = load_replay(session.journal.path)
    again = Session.retold(recording)
    again.seek(recording.end)
    assert again.world.digest() == recording.digest


def test_a_session_without_acts_or_one_that_was_declined_is_not_offered():
    session = session_with_journal()
    session.journal.abandon()
    assert not list(unfinished())
    session = session_with_journal()
    session.do(DOT)
    session.journal.abandon()
    finish(next(unfinished()))
    assert not list(unfinished()) and load_replay(session.journal.path).problem is None


def test_two_windows_leave_each_others_journals_alone():
    one, other = session_with_journal(1), session_with_journal(2)
    for number in range(20):
        (one, other)[number % 2].do(Flip())
    assert one.journal.path != other.journal.path and not list(unfinished())
    with pytest.raises(JournalError, match="another window has it open"):
        Journal.resume(one.journal.path)
    one.journal.abandon()
    assert list(unfinished()) == [one.journal.path]
    assert state(resumed(one.journal.path)) == state(one)
    other.journal.close(0, "")


def test_a_journal_whose_lock_was_not_had_is_not_begun(folder, monkeypatch):
    monkeypatch.setattr(journals, "lock", lambda handle: False)
    with pytest.raises(JournalError, match="cannot keep a journal: another window has it open"):
        Journal.begin(SCENES[1], 0)
    assert all(path.stat().st_size == 0 for path in folder.iterdir())


def test_time_that_went_on_without_an_act_is_noted_now_and_then(monkeypatch):
    seconds = iter(range(1000))
    monkeypatch.setattr(journals.time, "monotonic", lambda: next(seconds))
    session = session_with_journal()
    session.do(DOT)
    for _ in range(50):
        session.frame(FRAME_NS)
    session.journal.abandon()
    again = resumed(session.journal.path)
    assert again.now >= session.now - 5 > 50
    size = session.journal.path.stat().st_size
    assert size < 6000


def test_a_full_disk_is_said_once_and_costs_no_sand(monkeypatch):
    session, twin = session_with_journal(), Session(SCENES[1])
    session.do(DOT)

    def full(*_):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with monkeypatch.context() as patch:
        patch.setattr(journals.os, "write", full)
        session.do(Flip())
    assert session.journal is None and "no space left on device" in session.trouble and "\n" not in session.trouble
    session.do(Clear())
    for act in (DOT, Flip(), Clear()):
        twin.do(act)
    assert state(session) == state(twin)
    assert [entry.what for entry in load_replay(next(unfinished())).entries] == [DOT]


def test_a_folder_that_cannot_be_written_is_said(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("not a folder")
    monkeypatch.setenv("SANDGLASS_DATA_DIR", str(tmp_path / "file"))
    with pytest.raises(JournalError, match="cannot keep a journal: not a directory"):
        Journal.begin(SCENES[0], 0)
    assert not list(unfinished())


@pytest.mark.skipif(os.name != "posix", reason="an open file cannot be removed")
def test_a_journal_that_vanished_is_said(monkeypatch):
    monkeypatch.setattr(journals, "SYNC_S", 0.0)
    session = session_with_journal()
    session.journal.path.unlink()
    for _ in range(3):
        session.do(Flip())
        for thread in threading.enumerate():
            if thread.daemon and thread is not threading.current_thread():
                thread.join(1)
    assert session.journal is None and "the file has vanished" in session.trouble


def test_old_journals_are_pruned_by_number_and_by_size_but_open_ones_stay(folder, monkeypatch):
    monkeypatch.setattr(journals, "MOST_JOURNALS", 5)
    kept_open = session_with_journal()
    paths = []
    for _ in range(8):
        session = session_with_journal()
        session.do(DOT)
        session.journal.close(0, "")
        paths.append(session.journal.path)
    left = sorted(folder.glob("*.sandglass"))
    assert left == sorted([kept_open.journal.path, *paths[-4:]]) or left == [kept_open.journal.path, *paths[-5:]]
    monkeypatch.setattr(journals, "MOST_BYTES", paths[-1].stat().st_size)
    prune()
    assert sorted(folder.glob("*.sandglass")) == [kept_open.journal.path, paths[-1]]


def test_a_journal_is_small_and_quick():
    session = session_with_journal()
    start = time.thread_time()
    for number in range(1000):
        session.do(Paint("sand", (number % 30, 3.0), (number % 30 + 1, 3.0), 3), join=True)
    assert (time.thread_time() - start) / 1000 < 0.002
    assert session.journal.path.stat().st_size < 150_000


def test_what_is_no_journal_is_refused(folder):
    folder.mkdir(parents=True)
    for name, data in (("a.sandglass", b""), ("b.sandglass", b"\xff" * 99), ("c.sandglass", b"{}\n{}\n")):
        (folder / name).write_bytes(data)
        with pytest.raises(JournalError):
            Journal.resume(folder / name)
    assert not list(unfinished())
    with pytest.raises(JournalError, match="no such file"):
        Journal.resume(folder / "none")
    assert Recording(SCENES[0], 0).problem is None


def test_frames_in_which_nothing_is_done_are_noted_once_a_second(monkeypatch):
    now_s = [100.0]
    monkeypatch.setattr(journals.time, "monotonic", lambda: now_s[0])
    session = session_with_journal()
    path, sizes = session.journal.path, []
    for _ in range(3):
        now_s[0] += journals.WAIT_S
        for _ in range(20):
            session.frame(FRAME_NS)
        sizes.append(path.stat().st_size)
    lines = path.read_bytes().count(b"\n")
    assert lines == 1 + 3 and sizes == sorted(set(sizes))


def test_a_journal_that_had_to_stop_says_so_and_how_much_it_holds(monkeypatch):
    session = session_with_journal()
    session.do(DOT)
    session.do(Flip())
    monkeypatch.setattr(journals.os, "write", full_disk)
    session.do(Clear())
    assert session.journal is None and "no space left" in session.trouble
    path = next(unfinished())
    assert path.name.endswith(journals.STOPPED) and journals.acts_in(path) == 2


def full_disk(handle, line):
    raise OSError(errno.ENOSPC, "No space left on device")


def test_no_journal_grows_larger_than_what_can_be_read_again(monkeypatch):
    session = session_with_journal()
    monkeypatch.setattr(journals, "LARGEST_FILE", session.journal.path.stat().st_size + 1000)
    for _ in range(100):
        session.do(Flip())
    assert session.journal is None and "it is full" in session.trouble
    path = next(unfinished())
    assert path.stat().st_size <= journals.LARGEST_FILE and resumed(path).timeline.history.story()


def test_what_a_crash_left_is_never_pruned_whatever_the_clock_said(folder, monkeypatch):
    session = session_with_journal()
    session.do(DOT)
    session.journal.abandon()
    left = session.journal.path
    for number in range(journals.MOST_JOURNALS + 5):
        later = session_with_journal(number)
        later.journal.close(0, "")
        later.journal.path.rename(folder / f"2099-01-01T00-00-{number:02}.000000-1.sandglass")
    os.utime(left, (0, 0))
    prune()
    assert list(unfinished()) == [left]
