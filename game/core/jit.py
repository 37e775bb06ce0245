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
from llvmlite import ir
from numba.core import cgutils
from numba.extending import intrinsic
from platformdirs import user_cache_dir

FOLDERS_KEPT = 3  # caches of older sources and versions beside the current one; fewer means compiling after a switch
STREAMS = 20  # places in an array that a loop with `apart` can go along from


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
        _kernels.append(numba.njit(function, cache=_FOLDER is not None, nogil=True, no_cfunc_wrapper=True))
    finally:
        numba.config.CACHE_DIR = before
    return _kernels[-1]


def ready():
    """Return the kernels that are ready to run, for which types of arguments: a set of (name, types in words)."""
    return {(each.py_func.__name__, str(types)) for each in _kernels for types in each.signatures}


def gate(function):
    """Compile `function` into each kernel that calls it, body and all: a call would count references to every array."""
    return numba.njit(function, forceinline=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)


def _scopes(module):
    """Return what LLVM calls an alias scope for each stream."""
    domain = module.add_metadata(["streams"])
    return [module.add_metadata([f"stream {number}", domain]) for number in range(STREAMS)]


def _mark(module, instruction, stream):
    """Say that a load or store is in a stream and in no other."""
    scopes = _scopes(module)
    own = scopes.pop(stream)
    instruction.set_metadata("alias.scope", module.add_metadata([own]))
    instruction.set_metadata("noalias", module.add_metadata(scopes))


def _pointers(context, builder, signature, args):
    """Yield (number, pointer) of the words that `load` or `store` is for."""
    data = context.make_array(signature.args[0])(context, builder, args[0]).data
    for number in range(len(signature.args[1])):
        place = builder.add(builder.extract_value(args[1], number), args[2])
        yield number, builder.gep(data, [place])


@intrinsic
def apart(typingctx):
    """Promise, ahead of a loop, that no two of the streams in it ever meet: what is not checked need not be paid for.

    The compiler has each pair of places in an array checked for overlap before a loop, and where they are many it
    gives up and takes word by word. `load` and `store` say which stream they belong to; they must be in the function
    that calls this, since scopes are made anew for each function compiled into another.
    """

    def generate(context, builder, signature, args):
        kind = ir.FunctionType(ir.VoidType(), [ir.MetaDataType()])
        declare = cgutils.get_or_insert_function(builder.module, kind, "llvm.experimental.noalias.scope.decl")
        for scope in _scopes(builder.module):
            builder.call(declare, [builder.module.add_metadata([scope])])

    return numba.types.void(), generate


@intrinsic(prefer_literal=True)
def load(typingctx, array, places, i, stream):
    """Return word i from each of the places, a tuple as long; they are the streams from `stream` on, a literal."""

    def generate(context, builder, signature, args):
        words = []
        for number, pointer in _pointers(context, builder, signature, args):
            words.append(builder.load(pointer))
            _mark(builder.module, words[-1], stream.literal_value + number)
        return context.make_tuple(builder, signature.return_type, words)

    return numba.types.UniTuple(array.dtype, len(places))(array, places, i, stream), generate


@intrinsic(prefer_literal=True)
def store(typingctx, array, places, i, words, stream):
    """Write word i at each of the places; they are the streams from `stream` on, a literal."""

    def generate(context, builder, signature, args):
        for number, pointer in _pointers(context, builder, signature, args):
            written = builder.store(builder.extract_value(args[3], number), pointer)
            _mark(builder.module, written, stream.literal_value + number)

    return numba.types.void(array, places, i, words, stream), generate
