"""Compiles kernels and keeps them between runs: the only importer of numba.

Numba's own cache does not notice a change in another file, so the cache lies in a folder named by a digest of all that
decides the machine code: every kernel source and the versions beneath them.
"""

import hashlib
import os
import platform
import shutil
import tempfile
from pathlib import Path

import llvmlite
import numba
import numpy as np
from platformdirs import user_cache_dir

FOLDERS_KEPT = (
    3  # caches of older sources and versions kept beside the current one; fewer means recompiling after a switch
)


def _digest():
    """Return a short hex digest of the kernel sources and of the versions that compile them."""
    digest = hashlib.sha256()
    for source in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(source.name.encode() + b"\0" + source.read_bytes() + b"\0")
    versions = (platform.python_version(), platform.machine(), numba.__version__, llvmlite.__version__, np.__version__)
    digest.update("\0".join(versions).encode())
    return digest.hexdigest()[:20]


def _writable(folder):
    """Return whether files can be made in `folder`, making it if need be."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError:
        return False
    return True


def _prune(home, current):
    """Remove all but the newest caches beside the current one."""
    older = sorted(home.glob("kernels-*"), key=lambda folder: folder.stat().st_mtime, reverse=True)
    for folder in [each for each in older if each != current][FOLDERS_KEPT:]:
        shutil.rmtree(folder, ignore_errors=True)


def cache_folder():
    """Return (folder, whether it is new) for compiled kernels; the folder is None where none can be written.

    Without one they live in memory only.
    """
    home = Path(os.environ.get("SANDGLASS_CACHE_DIR") or user_cache_dir("sandglass", appauthor=False))
    folder = home / f"kernels-{_digest()}"
    is_new = not folder.exists()
    if not _writable(folder):
        return None, False
    if is_new:
        _prune(home, folder)
    return folder, is_new


_FOLDER, NEW = cache_folder()
_kernels = []


def kernel(function):
    """Compile `function` when first called, without the interpreter lock, and keep the machine code between runs."""
    before = numba.config.CACHE_DIR
    numba.config.CACHE_DIR = str(_FOLDER or "")
    try:
        _kernels.append(numba.njit(function, cache=_FOLDER is not None, nogil=True))
    finally:
        numba.config.CACHE_DIR = before
    return _kernels[-1]


def ready():
    """Return the kernels that are ready to run, for which types of arguments: a set of (name, types in words)."""
    return {(each.py_func.__name__, str(types)) for each in _kernels for types in each.signatures}


def gate(function):
    """Compile `function` into each kernel that calls it, body and all: a call would count references to every array."""
    return numba.njit(function, forceinline=True)
