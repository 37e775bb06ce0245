"""Compiles kernels and keeps them between runs: the only importer of numba.

Numba's own cache does not notice a change in another file, so the cache lies in a folder named by a digest of all that
decides the machine code: every kernel source and the versions beneath them. Nor does it survive a damaged file or a
full disk; here what cannot be read or written costs the time to compile, and nothing else.
"""

import hashlib
import os
import pickle
import platform
import shutil
import sys
import tempfile
from importlib import import_module
from pathlib import Path

import llvmlite
import numba
import numpy as np
from llvmlite import ir
from numba.core import cgutils
from numba.core.caching import FunctionCache
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps
from numba.extending import intrinsic
from platformdirs import user_cache_dir

from game.core.sealed_files import read_sealed, write_sealed

MOST_KEPT = 256  # passes of rules that are kept: some 10 to 300 KB each
FOLDERS_KEPT = 3  # caches of older sources and versions beside the current one; fewer means compiling after a switch


def _pass_by_scipy():
    """Import what of numba looks for BLAS in scipy, without it: no kernel calls BLAS, which takes 0.2 s to load."""
    if "scipy.linalg" in sys.modules:
        return
    sys.modules["scipy.linalg"] = None  # as if it were not installed
    try:
        import_module("numba.np.arraymath")
    finally:
        del sys.modules["scipy.linalg"]


_pass_by_scipy()


def _digest():
    """Return a short hex digest of the kernel sources and of the versions that compile them."""
    digest = hashlib.sha256()
    for source in sorted(Path(__file__).parent.rglob("*.py")):
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
    """Return (folder, whether it is new) for compiled kernels; the folder is None where none can be written.

    Without one they live in memory only.
    """
    home = Path(os.environ.get("SANDGLASS_CACHE_DIR") or user_cache_dir("sandglass", appauthor=False))
    folder = home / f"kernels-{_digest()}"
    is_new = not os.path.exists(folder)
    if not _writable(folder):
        return None, False
    if is_new:
        _prune(home, folder)
    return folder, is_new


_FOLDER, NEW = cache_folder()
_kernels = []
_troubles = []  # what was wrong with the cache in this run, in words


class _KernelCache(FunctionCache):
    """Keeps a kernel's machine code, a file for each signature, behind a checksum: code with a wrong byte crashes."""

    cache_path = str(_FOLDER)

    def __init__(self, function):
        self._py_func = function

    def load_overload(self, sig, target_context):
        """Return the CompileResult that is kept for a signature, or None where there is none that can be used."""
        target_context.refresh()
        path = self._path(sig, target_context.codegen())
        try:
            return CompileResult._rebuild(target_context, *pickle.loads(read_sealed(path)))
        except FileNotFoundError:
            return None
        except Exception as error:  # whatever pickle and LLVM trip over
            _note(path, "cannot read a compiled kernel", error)
            return None

    def save_overload(self, sig, data):
        """Keep the CompileResult for a signature, if that is possible."""
        path = self._path(sig, data.codegen)
        try:
            write_sealed(path, dumps(data._reduce()))
        except Exception as error:
            _note(path, "cannot keep a compiled kernel", error)

    def _path(self, sig, codegen):
        function = self._py_func
        key = repr((function.__module__, self._index_key(sig, codegen))).encode()
        return Path(self.cache_path, f"{function.__qualname__}-{hashlib.sha256(key).hexdigest()[:20]}.kernel")


def _note(path, doing, error):
    reason = getattr(error, "strerror", None) or str(error) or type(error).__name__
    _troubles.append(f"{path}: {doing}: {reason.lower()}; compiling costs time, nothing else".replace("\n", " "))


def trouble():
    """Return in one line what was wrong with the cache so far in this run, or None."""
    return _troubles[0] if _troubles else None


def kernel(function):
    """Compile `function` when first called, without the interpreter lock, and keep the machine code between runs."""
    made = numba.njit(function, nogil=True, no_cfunc_wrapper=True)
    if _FOLDER is not None:
        made._cache = _KernelCache(function)
    _kernels.append(made)
    return made


def kept(key, make):
    """Return what make() returns, a value that can be pickled; what it made for this key before is only read again.

    key: a text that, with the kernel sources and the versions beneath them, decides all.
    """
    path = _FOLDER and Path(_FOLDER, f"pass-{hashlib.sha256(key.encode()).hexdigest()[:20]}.pass")
    try:
        if path:
            return pickle.loads(read_sealed(path))
    except FileNotFoundError:
        pass
    except Exception as error:  # whatever pickle trips over
        _note(path, "cannot read a compiled rule", error)
    made = make()
    try:
        if path:
            write_sealed(path, pickle.dumps(made))
            _drop_oldest(path.parent)
    except OSError as error:
        _note(path, "cannot keep a compiled rule", error)
    return made


def _drop_oldest(folder):
    """Remove all but the newest passes of rules."""
    for path in sorted(folder.glob("*.pass"), key=_age, reverse=True)[MOST_KEPT:]:
        path.unlink(missing_ok=True)


def ready():
    """Return the kernels that are ready to run, for which types of arguments: a set of (name, types in words)."""
    return {(each.py_func.__name__, str(types)) for each in _kernels for types in each.signatures}


def gate(function):
    """Compile `function` into each kernel that calls it, body and all: a call would count references to every array."""
    return numba.njit(function, forceinline=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)


_WORD = ir.IntType(64)


@intrinsic
def call_pass(typingctx, address, words, at, may, origin, key, chances, size):
    """Call a pass of `core.compiler.vector_ir` at an address, an int64; of arrays it gets the pointers."""

    def generate(context, builder, signature, args):
        handed = []
        for kind, value in zip(signature.args[1:], args[1:], strict=True):
            if isinstance(kind, numba.types.Array):
                value = builder.ptrtoint(context.make_array(kind)(context, builder, value).data, _WORD)
            handed.append(value)
        kind = ir.FunctionType(_WORD, [_WORD] * len(handed))
        return builder.call(builder.inttoptr(args[0], kind.as_pointer()), handed)

    handed = words, at, may, origin, key, chances, size
    return numba.types.int64(address, *handed), generate


@intrinsic
def call_words(typingctx, address, at, first, size):
    """Call a pass of `core.compiler.word_pass` at an address, with the addresses in `at` from its place `first`."""

    def generate(context, builder, signature, args):
        data = context.make_array(signature.args[1])(context, builder, args[1]).data
        start = builder.ptrtoint(builder.gep(data, [args[2]]), _WORD)
        kind = ir.FunctionType(ir.VoidType(), [_WORD, _WORD])
        builder.call(builder.inttoptr(args[0], kind.as_pointer()), [start, args[3]])
        return context.get_dummy_value()

    return numba.types.none(address, at, numba.types.int64, numba.types.int64), generate


@intrinsic
def copy(typingctx, source, first, target, start, size):
    """Copy `size` items of a row of an array from its place `first` to another one's from `start`; they are apart."""

    def generate(context, builder, signature, args):
        places = []
        for at in (2, 0):
            data = context.make_array(signature.args[at])(context, builder, args[at]).data
            places.append(builder.gep(data, [args[at + 1]]))
        item = context.get_abi_sizeof(context.get_data_type(signature.args[0].dtype))
        cgutils.raw_memcpy(builder, *places, args[4], item, align=item)
        return context.get_dummy_value()

    number = numba.types.int64
    return numba.types.none(source, number, target, number, number), generate
