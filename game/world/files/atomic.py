"""Files written in one step, read with a bound, and locked: a file is the old one or the new one, never half of it."""

import contextlib
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


def save(path, data):
    """Write bytes to the file at `path`, replacing it in one step; raise FileError, the old file as it was, if not.

    What the function returns after is on the disk: a power cut cannot take it back.
    """
    path = Path(path)
    temporary = None
    try:
        handle, temporary = tempfile.mkstemp(prefix=f".{path.name[:40]}-", suffix=".part", dir=path.parent)
        with open(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, 0o666 & ~UMASK)
        os.replace(temporary, path)
        sync_folder(path.parent)
    except (OSError, ValueError) as error:
        if temporary:
            with contextlib.suppress(OSError):
                os.unlink(temporary)
        raise trouble(path, "cannot save", error if isinstance(error, OSError) else OSError(str(error))) from None


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
