"""Compiles kernels and keeps them between runs.

The cache lies in a folder named by a digest of all that decides the machine code: every source of this floor and the
versions beneath it. What cannot be read or written costs the time to compile, and nothing else.
"""

import gc
import hashlib
import os
import pickle
import platform
import shutil
import tempfile
from pathlib import Path

import llvmlite
import numpy as np
from platformdirs import user_cache_dir

from game.core.compiler.machine_code import features, machine
from game.core.loops.kernel import Kernel, compile_kernel
from game.core.sealed_files import read_sealed, write_sealed

MOST_KEPT = 256  # passes of rules that are kept: some 10 to 300 KB each
FOLDERS_KEPT = 3  # caches of older sources and versions beside the current one; fewer means compiling after a switch

_COST = "compiling costs time, nothing else"


def _digest():
    """Return a short hex digest of the kernel sources and of the versions that compile them."""
    digest = hashlib.sha256()
    for source in sorted(Path(__file__).parent.rglob("*.py")):
        digest.update(source.name.encode() + b"\0" + source.read_bytes() + b"\0")
    # a version of numba goes with one of llvmlite, which is at hand without importing numba
    versions = (platform.python_version(), platform.machine(), llvmlite.__version__, np.__version__)
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


def _age(folder):
    """Return when a folder was changed last, and for one that another process removes just now that it is old."""
    try:
        return folder.stat().st_mtime
    except OSError:
        return 0.0


def _prune(home, current):
    """Remove all but the newest caches beside the current one."""
    older = sorted(home.glob("kernels-*"), key=_age, reverse=True)
    for folder in [each for each in older if each != current][FOLDERS_KEPT:]:
        shutil.rmtree(folder, ignore_errors=True)


def cache_folder():
    """Return the folder for compiled kernels, or None where none can be written: then they live in memory only."""
    home = Path(os.environ.get("SANDGLASS_CACHE_DIR") or user_cache_dir("sandglass", appauthor=False))
    folder = home / f"kernels-{_digest()}"
    is_new = not os.path.exists(folder)
    if not _writable(folder):
        return None
    if is_new:
        _prune(home, folder)
    return folder


_FOLDER = cache_folder()


def folder():
    """Return the folder in which machine code is kept, a Path, or None where none is."""
    return _FOLDER


_kernels = []
_troubles = []  # what went wrong in this run, in words


def _note(what, doing, error, cost):
    reason = (getattr(error, "strerror", None) or str(error) or type(error).__name__).partition("\n")[0]
    _troubles.append(f"{what}: {doing}: {reason.lower()}; {cost}")


def trouble():
    """Return in one line what went wrong with the cache or with numba so far in this run, or None."""
    return _troubles[0] if _troubles else None


def kernel(function):
    """Compile `function` when first called, and keep the machine code between runs; it runs without the lock."""
    return _known(Kernel(function, lambda key, types: _kept_code(compile_kernel, function, key, types)))


def numba_kernel(function):
    """Do what `kernel` does, but by numba; `function` returns nothing."""

    def code(key, types):
        try:
            return _kept_code(_compile_by_numba, function, key, types)
        except Exception as error:  # a numba that is made otherwise inside than those it was tried with
            _note(function.__name__, "numba cannot compile it", error, "it is compiled without numba")
            return _kept_code(compile_kernel, function, key, types)

    return _known(Kernel(function, code))


def _known(kernel):
    _kernels.append(kernel)
    return kernel


def _kept_code(compiler, function, key, types):
    """Return what a compiler makes of a function, or made of it before."""
    by = f"{compiler.__name__} {key} {machine()} {features()}"
    return kept(by, lambda: compiler(function, types), f"{function.__name__}-", "kernel")


def _compile_by_numba(function, types):
    collects = gc.isenabled()
    gc.disable()  # what numba makes is hardly ever garbage: to look for it takes a sixth of the time
    try:
        from game.core import numba_jit  # here, since that takes 0.3 s, and most runs find the machine code

        return numba_jit.compile_kernel(function, types)
    finally:
        if collects:
            gc.enable()


def is_kept(kernel):
    """Return whether machine code of a kernel is kept, for some types of arguments."""
    return bool(_FOLDER) and any(Path(_FOLDER).glob(f"{kernel.__name__}-*.kernel"))


def gate(function):
    """Let kernels call `function`: it is compiled into each of them, body and all."""
    function.is_gate = True
    return function


def kept(key, make, start="", kind="rule"):
    """Return what make() returns, a value that can be pickled; what it made for this key before is only read again.

    key: a text that, with the sources of this floor and the versions beneath it, decides all. start, kind: how the name
    of its file begins and ends; "rule" and "kernel" are the kinds.
    """
    before = read(key, pickle.loads, start, kind)
    if before is not None:
        return before
    made = make()
    keep(key, lambda: pickle.dumps(made), start, kind)
    return made


def read(key, load, start="", kind="rule"):
    """Return what load() makes of the bytes kept for a key, or None where there are none that it can use."""
    path = _path(key, start, kind)
    try:
        return load(read_sealed(path)) if path else None
    except FileNotFoundError:
        return None
    except Exception as error:  # whatever pickle and LLVM trip over
        _note(path, f"cannot read a compiled {kind}", error, _COST)
        return None


def keep(key, dump, start="", kind="rule"):
    """Keep the bytes that dump() returns for a key, if that is possible."""
    path = _path(key, start, kind)
    try:
        if path:
            write_sealed(path, dump())
            _drop_oldest(path.parent)
    except Exception as error:  # a full disk, or what cannot be pickled
        _note(path, f"cannot keep a compiled {kind}", error, _COST)


def _path(key, start, kind):
    return _FOLDER and Path(_FOLDER, f"{start}{hashlib.sha256(key.encode()).hexdigest()[:20]}.{kind}")


def _drop_oldest(folder):
    """Remove all but the newest passes of rules."""
    for path in sorted(folder.glob("*.rule"), key=_age, reverse=True)[MOST_KEPT:]:
        path.unlink(missing_ok=True)


def ready():
    """Return the kernels that are ready to run, for which types of arguments: a set of (name, types in words)."""
    return {(each.__name__, types) for each in _kernels for types in each.signatures}
