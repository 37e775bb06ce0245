"""The journal: every act written to a file as it happens, so that no session is lost in a crash.

A journal is a session file (see `session_format`) that grows. Each line goes to the system at once, and so survives the
death of the process; every SYNC_S it is forced to the disk, which bounds what a power cut can take. Each
window has a journal of its own, locked while it is open: one without an end that nobody has locked is left from a
crash. The end of one whose player has let it go tells no digest.
"""

import contextlib
import os
import re
import shutil
import threading
import time
from datetime import UTC, datetime
from pathlib import Path

from game.world.files.atomic import FileError, load, lock, trouble
from game.world.files.paths import folder_of
from game.world.sessions.history import WAIT, Entry
from game.world.sessions.recording import SUFFIX, parse
from game.world.sessions.session_format import LARGEST_FILE, LineWriter, ReplayError

SYNC_S = 2.0  # a power cut takes no more than this; less wears the disk
WAIT_S = 1.0  # between two notes that time went on: after a crash a session goes on from there
STOPPED = f".stopped{SUFFIX}"  # how the name ends of a journal that could not be written to its session's end
MOST_JOURNALS = 30  # older ones that are finished are removed
MOST_BYTES = 100 * 10**6  # of all journals but the open ones
LONGEST_END = 120  # bytes, of the line that ends a journal
AN_END = re.compile(rb'"do":"end".*\n')
A_DIGEST = re.compile(rb'"digest":"[^"]')
AN_ACT = re.compile(rb'"do":"(?!wait)')


class JournalError(FileError):
    """Why a journal cannot be written or taken up again, as one line."""


def data_folder():
    """Return the folder of the user's journals."""
    return folder_of("journals")


class Journal:
    """An open journal; `begin` and `resume` make one. Its methods raise JournalError where it cannot be written."""

    def __init__(self, path, handle, pen):
        self.path = path
        self.acted = False  # the player has done something since it was begun, or before it was resumed
        self._handle, self._pen, self._size = handle, pen, os.fstat(handle).st_size
        self._noted_at, self._waited_s = None, time.monotonic()
        self._synced_s, self._syncing, self._failed = time.monotonic(), None, None

    @classmethod
    def begin(cls, scene, seed, folder=None):
        """Open a new journal for a session that starts with `scene` and `seed`, and prune the old ones."""
        folder = Path(folder or data_folder())
        try:
            folder.mkdir(parents=True, exist_ok=True)
            prune(folder)
            stamp = datetime.now(UTC).strftime("%Y-%m-%dT%H-%M-%S.%f")
            path = folder / f"{stamp}-{os.getpid()}{SUFFIX}"
            journal = cls(path, _open(path, os.O_CREAT | os.O_EXCL), LineWriter())
            if not lock(journal._handle):
                journal._shut()
                raise OSError("another window has it open")
        except OSError as error:
            raise JournalError(trouble(folder, "cannot keep a journal", error)) from None
        try:
            journal._write(journal._pen.header(scene, seed))
        except JournalError:
            journal.path.unlink(missing_ok=True)
            raise
        return journal

    @classmethod
    def resume(cls, path):
        """Open the journal of a session to go on with it; return (journal, its Recording).

        What cannot be read at its end is cut off; if that is more than a torn last line, a copy is left beside it.
        """
        path = Path(path)
        data, _ = _parted(load(path, LARGEST_FILE, JournalError))
        try:
            recording, (kept, checksum, known) = parse(data, path)
            handle = _open(path)
        except ReplayError as error:
            raise JournalError(error) from None
        except OSError as error:
            raise JournalError(trouble(path, "cannot take up the journal", error)) from None
        journal = cls(path, handle, LineWriter(checksum, known))
        try:
            if not lock(handle):
                raise OSError("another window has it open")
            if b"\n" in data[kept:]:
                shutil.copyfile(path, f"{path}.damaged")
            os.ftruncate(handle, kept)
        except OSError as error:
            journal._shut()
            raise JournalError(trouble(path, "cannot take up the journal", error)) from None
        journal.acted = True
        return journal, recording

    def note(self, entry):
        """Write an Entry; those that only say that time went on are written now and then."""
        self._check()
        if entry.what == WAIT:
            if entry.at == self._noted_at or time.monotonic() - self._waited_s < WAIT_S:
                return
            self._waited_s = time.monotonic()
        self.acted |= entry.what != WAIT
        self._noted_at = entry.at
        line = self._pen.entry(entry)
        if self._pen.known.are_too_many or self._size + len(line) > LARGEST_FILE - LONGEST_END:
            self._stop()
            raise JournalError(f"{self.path}: cannot write the journal: it is full, with {self._size} bytes")
        self._write(line)

    def close(self, at, digest):
        """Write the end, so that the session counts as finished, and put all of it on the disk."""
        self._write_last(self._pen.end(at, digest))

    def leave(self, at, digest):
        """Write where the session is and its end: without the end the next start can go on from there."""
        self._write_last(self._pen.entry(Entry(at, WAIT)) + self._pen.end(at, digest))

    def abandon(self):
        """Leave the journal as a crash does."""
        self._shut()

    def _write_last(self, line):
        self._check()
        self._write(line)
        if self._syncing:
            self._syncing.join()
        self._sync()
        self._shut()
        self._check()

    def _write(self, line):
        try:
            while line:
                written = os.write(self._handle, line)
                line, self._size = line[written:], self._size + written
        except OSError as error:
            self._stop()
            raise JournalError(trouble(self.path, "cannot write the journal", error)) from None
        if time.monotonic() - self._synced_s >= SYNC_S and not (self._syncing and self._syncing.is_alive()):
            self._synced_s = time.monotonic()
            self._syncing = threading.Thread(target=self._sync, daemon=True)
            self._syncing.start()

    def _sync(self):
        """Put what was written on the disk; this takes long, so it is done beside the frames."""
        try:
            os.fsync(self._handle)
            if os.name == "posix" and os.fstat(self._handle).st_nlink == 0:
                raise FileNotFoundError("the file has vanished")
        except OSError as error:
            self._failed = error

    def _check(self):
        if self._failed:
            error, self._failed = self._failed, None
            self._stop()
            raise JournalError(trouble(self.path, "cannot write the journal", error)) from None

    def _stop(self):
        """Shut the journal while its session goes on, and let its name say so: even on a full disk that can be done."""
        self._shut()
        if not self.path.name.endswith(STOPPED):
            with contextlib.suppress(OSError):
                self.path = self.path.rename(self.path.with_name(self.path.name.removesuffix(SUFFIX) + STOPPED))

    def _shut(self):
        if self._syncing:
            self._syncing.join()
        if self._handle is not None:
            os.close(self._handle)
        self._handle = None


def unfinished(folder=None):
    """Yield the paths of journals with acts that have no end and that nobody has open, the last written first."""
    return (path for path in _journals(folder) if not _is_open(path) and _is_unfinished(path))


def left_over(folder=None):
    """Return the path of the journal to go on with, or None.

    That is one that a crash left, or else the last one with acts, unless its player has let it go.
    """
    return next(unfinished(folder), None) or _last_closed(folder)


def _last_closed(folder):
    for path in _journals(folder):
        acts, end = _parted(b"" if _is_open(path) else _load_begun(path))
        if AN_ACT.search(acts):
            return path if A_DIGEST.search(end) else None
    return None


def finish(path):
    """Mark the session of a journal as finished, so that it is not offered again."""
    journal, recording = Journal.resume(path)
    journal.close(recording.end, "")


def acts_in(path):
    """Return how many acts a journal holds, undone ones and the segments of strokes among them; raise FileError."""
    return len(AN_ACT.findall(load(path, LARGEST_FILE)))


def prune(folder=None):
    """Remove the oldest finished journals, so that neither number nor size of all passes its bound.

    Open ones stay, and so does what a crash left until somebody has gone on with it or let it go.
    """
    number, size = 0, 0
    for path in _journals(folder):
        try:
            number, size = number + 1, size + path.stat().st_size
            over = number >= MOST_JOURNALS or size > MOST_BYTES
            if over and not _is_open(path) and not _is_unfinished(path):
                path.unlink()
                Path(f"{path}.damaged").unlink(missing_ok=True)
        except OSError:
            continue


def _journals(folder):
    """Return the paths of journals, the one written last first; their names tell what the clock said, not their age."""

    def written(path):
        try:
            return path.stat().st_mtime_ns, path.name
        except OSError:
            return 0, path.name

    return sorted(Path(folder or data_folder()).glob(f"*{SUFFIX}"), key=written, reverse=True)


def _open(path, flags=0):
    return os.open(path, os.O_RDWR | os.O_APPEND | getattr(os, "O_BINARY", 0) | flags, 0o600)


def _is_open(path):
    """Return whether a window has a journal open."""
    try:
        handle = _open(path)
    except OSError:
        return True
    try:
        return not lock(handle)
    finally:
        os.close(handle)


def _is_unfinished(path):
    """Return whether a journal has acts but no end, without reading them all one by one."""
    acts, end = _parted(_load_begun(path))
    return not end and AN_ACT.search(acts) is not None


def _load_begun(path):
    """Return the bytes of a journal, or none where it has no start, without which nothing can be gone on with."""
    try:
        data = load(path, LARGEST_FILE)
        parse(data[: data.find(b"\n") + 1], path)
    except FileError:
        return b""
    return data


def _parted(data):
    """Return (what is before the line that ends a journal, that line or none)."""
    last = data.rfind(b"\n", 0, -1) + 1
    return (data[:last], data[last:]) if AN_END.search(data, last) else (data, b"")
