"""Locks on open files: held by one process, let go by the system when it ends, however it ends."""

import os

try:
    import fcntl
except ImportError:  # Windows
    import msvcrt

    FAR = 2**40  # bytes: a place that no file reaches, so that the lock keeps nobody from reading

    def lock(handle):
        """Lock an open file and return whether that was possible."""
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
        """Lock an open file and return whether that was possible."""
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        except OSError:  # a file system without locks: better two writers of two files than no journal
            return True
        return True
