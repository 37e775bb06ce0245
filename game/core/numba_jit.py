"""The stepping of the automaton, compiled by numba and kept between runs: the only importer of numba in the toy.

Numba makes the fastest loops of any compiler for Python, and takes seconds to; so it has the one kernel in which the
sand's time goes, and `loops` the many others. Its own cache does not notice a change in another file, nor does it
survive a damaged one; so its machine code is kept as that of all kernels is, see `jit`.
"""

import pickle
import sys
from importlib import import_module


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

import numba  # noqa: E402
from llvmlite import ir  # noqa: E402
from numba.core.caching import FunctionCache  # noqa: E402
from numba.core.compiler import CompileResult  # noqa: E402
from numba.core.serialize import dumps  # noqa: E402
from numba.extending import intrinsic, overload, register_jitable  # noqa: E402

from game.core import jit  # noqa: E402
from game.core.loops.calls import call_pass  # noqa: E402

_WORD = ir.IntType(64)


class _Cache(FunctionCache):
    """Keeps a kernel's machine code, for each signature."""

    cache_path = ""

    def __init__(self, function):
        self._py_func = function

    def load_overload(self, sig, target_context):
        """Return the CompileResult that is kept for a signature, or None where there is none that can be used."""
        target_context.refresh()

        def load(data):
            return CompileResult._rebuild(target_context, *pickle.loads(data))

        return jit.read(*self._key(sig, target_context.codegen(), load))

    def save_overload(self, sig, data):
        """Keep the CompileResult for a signature, if that is possible."""
        jit.keep(*self._key(sig, data.codegen, lambda: dumps(data._reduce())))

    def _key(self, sig, codegen, act):
        function = self._py_func
        key = repr((function.__module__, numba.__version__, self._index_key(sig, codegen)))
        return key, act, f"{function.__qualname__}-", "kernel"


class _Stepper:
    """A kernel of numba's."""

    def __init__(self, function):
        self.__doc__, self.__name__, self.function = function.__doc__, function.__name__, function
        _register_gates(function)
        self._compiled = numba.njit(function, nogil=True, no_cfunc_wrapper=True)
        self._compiled._cache = _Cache(function)

    def __call__(self, *arguments):
        return self._compiled(*arguments)

    @property
    def signatures(self):
        """The types of arguments that the kernel is ready for, in words."""
        return [str(types) for types in self._compiled.signatures]


def numba_kernel(function):
    """Compile `function` by numba when first called, and keep the machine code between runs; it runs without the lock.

    Gates are compiled into it, body and all, as in every kernel.
    """
    return jit.noted(_Stepper(function))


def _register_gates(function):
    """Let numba compile the gates that a function calls, and those that they call."""
    for name in function.__code__.co_names:
        called = function.__globals__.get(name)
        if hasattr(called, "is_gate") and called not in _gates:
            _gates.add(called)
            register_jitable(forceinline=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)(called)
            _register_gates(called)


_gates = set()


@intrinsic
def _call(typingctx, address, words, at, may, origin, key, chances, size):
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


@overload(call_pass, jit_options={"forceinline": True, "no_cpython_wrapper": True, "no_cfunc_wrapper": True})
def _call_pass(address, words, at, may, origin, key, chances, size):
    return lambda address, words, at, may, origin, key, chances, size: _call(
        address, words, at, may, origin, key, chances, size
    )
