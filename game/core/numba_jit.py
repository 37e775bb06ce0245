"""Compiles kernels by numba: the only importer of numba in the toy, itself imported where something is to be compiled.

Numba makes the fastest loops of any compiler for Python, and takes seconds to; so it has the one kernel in which the
sand's time goes, and `loops` the many others. What numba makes is a function in LLVM IR. A kernel around it hands over
the arguments, and LLVM makes one piece of machine code of both.
"""

import sys
from contextlib import contextmanager
from importlib import import_module

import numpy as np
from llvmlite import ir

from game.core.loops import signature
from game.core.loops.calls import call_pass
from game.core.loops.ir_writer import Writer
from game.core.loops.kernel import NAME
from game.core.loops.object_code import compiled
from game.core.loops.values import Array, Scalar, leaves, size_of


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
from numba import types as kinds  # noqa: E402
from numba.core.codegen import JITCodeLibrary, JITCPUCodegen  # noqa: E402
from numba.core.compiler_lock import global_compiler_lock  # noqa: E402
from numba.core.registry import cpu_target  # noqa: E402
from numba.extending import intrinsic, overload, register_jitable  # noqa: E402

_OPTIONS = {  # nothing is called from Python, takes memory, or raises
    "no_cpython_wrapper": True,
    "no_cfunc_wrapper": True,
    "_nrt": False,
    "error_model": "numpy",
}
_NUMBERS = {"i": kinds.int64, "u": kinds.uint64, "f": kinds.float32, "d": kinds.float64, "b": kinds.boolean}
_WORD = ir.IntType(64)


def compile_kernel(function, types):
    """Return (machine code of a function that returns nothing, the kinds of its results), as `loops.kernel` does.

    Gates are compiled into it, body and all.
    """
    writer = Writer()
    arguments = signature.arguments(writer, types)
    name, text = _compiled(function, kinds.none(*map(_type_of, arguments)))
    handed = [("ptr", writer.room("ptr")), ("ptr", writer.room("ptr")), *_handed(writer, arguments)]
    writer.declared.add(f"declare i32 @{name}({', '.join(kind for kind, _ in handed)})")
    status = writer.new(f"call i32 @{name}({', '.join(map(' '.join, handed))})")
    failed = writer.new(f"icmp ne i32 {status}, 0")
    writer.line(f"store i32 {writer.new(f'select i1 {failed}, i32 2, i32 0')}, ptr %status")
    return compiled(writer.text(NAME), text), ""


def _compiled(function, types):
    """Return the name of a function in numba's IR, and the IR."""
    _register_gates(function)
    dispatcher = numba.njit(**_OPTIONS)(function)
    with _ir_alone():
        dispatcher.compile(types)
    return dispatcher.get_compile_result(types).fndesc.llvm_func_name, dispatcher.inspect_llvm(types.args)


class _Library(JITCodeLibrary):
    """The IR of a function as it is written: optimised it is with the whole kernel, and then made machine code."""

    def _optimize_functions(self, module):
        pass

    def _optimize_final_module(self):
        pass

    def _finalize_final_module(self):
        self._finalized = True

    def get_pointer_to_function(self, name):
        self._ensure_finalized()
        return 0


class _Codegen(JITCPUCodegen):
    _library_class = _Library

    def set_env(self, name, environment):
        pass


@contextmanager
def _ir_alone():
    """Keep numba from making more than IR."""
    context = cpu_target.target_context
    with global_compiler_lock:
        usual, context._internal_codegen = context.codegen(), _Codegen("sandglass")
        try:
            yield
        finally:
            context._internal_codegen = usual


def _type_of(value):
    """Return numba's type of a value of `loops`."""
    if isinstance(value, Scalar):
        return _NUMBERS[value.kind]
    if isinstance(value, Array):
        axes = len(value.sides)
        return kinds.Array(
            numba.from_dtype(np.dtype(value.item)), axes, "C" if axes == 1 and not value.strides else "A"
        )
    return kinds.BaseTuple.from_types(tuple(map(_type_of, value)), type(value))


def _handed(writer, values):
    """Return the arguments of numba's function for values of `loops`, as pairs of (type, register).

    Of an array these are its owner and its object, none; how many items it has, of how many bytes, and where; its sides
    and its strides.
    """
    found = []
    for value in values:
        if isinstance(value, Array):
            found += _array(writer, value)
        elif not isinstance(value, Scalar):
            found += _handed(writer, value)
        elif value.kind == "b":
            found.append(("i8", writer.as_item(value, "b1")))
        else:
            found += leaves(value)
    return found


def _array(writer, value):
    count, size = "1", str(size_of(value.item))
    for side in value.sides:
        count = writer.new(f"mul i64 {count}, {side}")
    strides = (*value.strides, size)[: len(value.sides)]
    words = (("i64", each) for each in (*value.sides, *strides))
    return [("ptr", "null"), ("ptr", "null"), ("i64", count), ("i64", size), ("ptr", value.data), *words]


def _register_gates(function):
    """Let numba compile the gates that a function calls, and those that they call."""
    for name in function.__code__.co_names:
        called = function.__globals__.get(name)
        if hasattr(called, "is_gate") and called not in _gates:
            _gates.add(called)
            register_jitable(forceinline=True, **_OPTIONS)(called)
            _register_gates(called)


_gates = set()


@intrinsic
def _call(typingctx, address, words, at, may, origin, key, chances, size):
    """Call a pass of `core.compiler.vector_ir` at an address, an int64; of arrays it gets the pointers."""

    def generate(context, builder, signature, args):
        handed = []
        for kind, value in zip(signature.args[1:], args[1:], strict=True):
            if isinstance(kind, kinds.Array):
                value = builder.ptrtoint(context.make_array(kind)(context, builder, value).data, _WORD)
            handed.append(value)
        kind = ir.FunctionType(_WORD, [_WORD] * len(handed))
        return builder.call(builder.inttoptr(args[0], kind.as_pointer()), handed)

    handed = words, at, may, origin, key, chances, size
    return kinds.int64(address, *handed), generate


@overload(call_pass, jit_options={"forceinline": True, **_OPTIONS})
def _call_pass(address, words, at, may, origin, key, chances, size):
    return lambda address, words, at, may, origin, key, chances, size: _call(
        address, words, at, may, origin, key, chances, size
    )
