"""Memory: what is freed goes back to the system, and what lasts is not looked through again and again.

The allocator of Linux (glibc) keeps a heap for each of many threads, and learns to put arrays of up to 32 MB there;
between what lives longer they leave holes that are never filled again. A window under random input grew so from 420 to
610 MB in eight minutes; with what is set here it stayed below 300.
"""

import ctypes
import gc
import os
import sys
from functools import cache

M_MMAP_THRESHOLD, M_ARENA_MAX = -3, -8  # names of malloc.h
LARGE = 2**20  # bytes: what is larger has pages of its own; less of a limit costs time, since new pages come empty
HEAPS = 2


def give_back_freed():
    """Have the allocator give back what is freed, where it is one that has to be told; return whether it listened."""
    mallopt = _of_glibc("mallopt")
    return bool(mallopt and mallopt(M_MMAP_THRESHOLD, LARGE) and mallopt(M_ARENA_MAX, HEAPS))


def give_back_holes():
    """Have the allocator give back the free pages between what lives, which it keeps otherwise; return whether it did.

    That takes 1 ms, and 16 ms where it gives back 140 MB.
    """
    malloc_trim = _of_glibc("malloc_trim")
    return bool(malloc_trim and malloc_trim(0))


def spare_what_lasts():
    """Have the garbage collector pass over all that there is now: libraries, kernels, scenes, controls.

    They are some 130,000 objects, and to look through them in mid-play takes 60 ms, four frames.
    """
    gc.freeze()


@cache
def _of_glibc(name):
    """Return that function of the allocator of Linux, or None where there is another."""
    try:
        return getattr(ctypes.CDLL(None), name) if sys.platform == "linux" else None
    except (OSError, AttributeError):  # another C library
        return None


def resident_mb():
    """Return the memory that the process takes, in MB."""
    try:
        with open("/proc/self/statm", encoding="ascii") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 2**20
    except OSError:  # no Linux
        import resource

        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
