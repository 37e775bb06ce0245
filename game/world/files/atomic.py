"""Files written in one step, read with a bound, and locked: a file is the old one or the new one, never half of it."""

import contextlib
import itertools
import os
import tempfile
from pathlib import Path

if os.name == "nt":
    import msvcrt
else:
    import fcntl


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask


UMASK = _umask()  # of this process, read once: that sets it for a moment, which two threads must not do at once


def printable(text):
    """Return text as it can be shown in one line: with a space for each sign that cannot."""
    return "".join(sign if sign.isprintable() else " " for sign in text)


class FileError(ValueError):
    """What is wrong with a file, as one line: FILE: PLACE: found X, wanted Y."""

    def __init__(self, line):
        super().__init__(printable(str(line)))


def trouble(path, doing, error):
    """Return the FileError for an OSError: which file, what was tried, why it went wrong."""
    return FileError(f"{path}: {doing}: {(error.strerror or str(error)).lower()}")


_parts = set()  # the paths of the files that this process is writing


class Part:
    """A file being written beside its place under another name; raises OSError. Nobody else sees it half written.

    It is locked until it is complete: one that is not was left by a process that was killed.
    """

    def __init__(self, folder, name):
        self.path, handle = _locked_part(Path(folder), name)
        self.file = open(handle, "wb")  # noqa: SIM115 - it stays open until it is put in its place or dropped
        _parts.add(self.path)

    def put(self, path):
        """Put the file at `path`, in the place of what is there."""
        self._complete()
        os.replace(self.path, path)
        self._forget(path)

    def put_as_new(self, name_of):
        """Put the file at the first free of the paths name_of(1), name_of(2) …; return which that is."""
        self._complete()
        path = next(path for path in map(name_of, itertools.count(1)) if moved(self.path, path))
        self._forget(path)
        return path

    def drop(self):
        """Leave nothing behind."""
        with contextlib.suppress(OSError):  # what is still to be written may find no room
            self.file.close()
        with contextlib.suppress(OSError):
            os.unlink(self.path)
        _parts.discard(self.path)

    def _complete(self):
        """Put all of it on the disk: a power cut cannot take it back."""
        self.file.flush()
        os.fsync(self.file.fileno())
        self.file.close()
        os.chmod(self.path, 0o666 & ~UMASK)

    def _forget(self, path):
        _parts.discard(self.path)
        sync_folder(Path(path).parent)


def _locked_part(folder, name):
    """Return (path, handle) of a new file that is locked: another start may have cleared one before it was."""
    while True:
        handle, path = tempfile.mkstemp(prefix=f".{name[:40]}-", suffix=".part", dir=folder)
        lock(handle)
        if os.name == "nt" or os.fstat(handle).st_nlink:
            return path, handle
        os.close(handle)


def moved(file, path):
    """Move a file to a path; return False where something is there already. Raises OSError."""
    try:
        os.link(file, path)
    except FileExistsError:
        return False
    except OSError:  # a file system without hard links: an empty file holds the place
        try:
            os.close(os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY))
        except FileExistsError:
            return False
        os.replace(file, path)
        return True
    os.unlink(file)
    return True


def clear_parts(folder):
    """Remove from a folder the files that a process was writing when it was killed."""
    for path in Path(folder).glob(".*.part"):
        with contextlib.suppress(OSError):
            handle = os.open(path, os.O_RDWR)
            try:
                left = lock(handle)
            finally:
                os.close(handle)
            if left:
                path.unlink()


def drop_parts():
    """Remove the files that this process is writing: it ends before they are complete."""
    for path in list(_parts):
        with contextlib.suppress(OSError):
            os.unlink(path)


def save(path, data):
    """Write bytes to the file at `path`, replacing it in one step; raise FileError, the old file as it was, if not.

    What the function returns after is on the disk: a power cut cannot take it back.
    """
    path = Path(path)
    _write(path, data, lambda part: part.put(path))


def save_as_new(name_of, data):
    """Write bytes to a new file at the first free of the paths name_of(1), name_of(2) …; return it; raise FileError."""
    return _write(name_of(1), data, lambda part: part.put_as_new(name_of))


def _write(path, data, put):
    part = None
    try:
        part = Part(path.parent, path.name)
        part.file.write(data)
        return put(part)
    except (OSError, ValueError) as error:
        if part:
            part.drop()
        raise trouble(path, "cannot save", error if isinstance(error, OSError) else OSError(str(error))) from None


def make_folder(folder):
    """Make a folder, and those it lies in, where they are not there; raise FileError."""
    try:
        Path(folder).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise trouble(folder, "cannot make the folder", error) from None


def load(path, most, error=FileError):
    """Return the bytes of the ordinary file at `path`, at most `most` of them; raise `error` for anything else."""
    try:
        if Path(path).exists() and not Path(path).is_file():
            raise error(f"{path}: file: found a folder or a device, wanted an ordinary file")
        with open(path, "rb") as file:
            data = file.read(most + 1)
    except (OSError, ValueError) as reason:
        if isinstance(reason, FileError):
            raise
        why = (getattr(reason, "strerror", None) or str(reason)).lower()
        raise error(f"{path}: cannot read: {why}") from None
    if len(data) > most:
        raise error(f"{path}: file: found a larger one, wanted at most {most} bytes")
    return data


def sync_folder(folder):
    """Put a folder's list of names on the disk, where the system can."""
    if os.name != "posix":
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


if os.name == "nt":
    FAR = 2**40  # bytes: a place that no file reaches, so that the lock does not keep anybody from reading

    def lock(handle):
        """Lock an open file and return whether that was possible; the system unlocks it when this process ends."""
        place = os.lseek(handle, 0, os.SEEK_CUR)
        os.lseek(handle, FAR, os.SEEK_SET)
        try:
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        finally:
            os.lseek(handle, place, os.SEEK_SET)
        return True

else:

    def lock(handle):
        """Lock an open file and return whether that was possible; the system unlocks it when this process ends."""
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        except OSError:  # a file system without locks: two writers of two files are better than no journal
            return True
        return True
