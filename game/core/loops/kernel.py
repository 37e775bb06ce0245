"""Kernels: functions that are compiled when they are first called with arguments of some types."""

import ctypes
import threading
from functools import cached_property

from game.core.loops import signature
from game.core.loops.ir_writer import Writer
from game.core.loops.object_code import ObjectCode, compiled
from game.core.loops.reader import reader
from game.core.loops.statements import Body

NAME = "sandglass_kernel"


class Kernel:
    """A function that runs as machine code, without the interpreter's lock.

    code: `code(key, types)` returns what `compile_kernel` does for the function and some types; of both the key, a
    text, tells all.
    """

    def __init__(self, function, code):
        self.function, self._code = function, code
        self.__doc__, self.__name__ = function.__doc__, function.__name__
        self._ready, self._latest, self._lock = {}, None, threading.Lock()

    def __call__(self, *arguments):
        """Run on arguments: numbers, arrays, and tuples of them."""
        ready = self._latest
        packed = ready.read(arguments) if ready else None
        if packed is None:
            types, words = [], []
            signature.describe(arguments, types, words)
            types = tuple(types)
            self._latest = ready = self._ready.get(types) or self._make(types)
            packed = ready.pack(*words)
        return ready(packed)

    @property
    def signatures(self):
        """The types of arguments that the kernel is ready for, in words."""
        return [signature.as_text(types) for types in list(self._ready)]

    def _make(self, types):
        key = f"{self.function.__module__}.{self.function.__qualname__} {signature.as_text(types)}"
        with self._lock:
            if types not in self._ready:
                self._ready[types] = _ReadyKernel(types, *self._code(key, types))
        return self._ready[types]


def compile_kernel(function, types):
    """Return (machine code of a function for arguments of some types, the kinds of its results)."""
    writer = Writer()
    returned = Body(writer, function, signature.arguments(writer, types)).write()
    kinds = signature.results(writer, returned)
    return compiled(writer.text(NAME)), kinds


class _ReadyKernel:
    """Machine code for arguments of some types."""

    def __init__(self, types, code, kinds):
        self._code = ObjectCode(code, NAME)
        self._types, self.pack = types, signature.packing(types).pack
        self._reading, self._is_tuple = signature.reading(kinds), kinds.startswith("(")

    @cached_property
    def read(self):
        """What reads the arguments of later calls: kernels that are called once need none."""
        return reader(self._types)

    def __call__(self, packed):
        size = self._reading.size
        room = ctypes.create_string_buffer(size) if size else None
        status = self._code.call(packed, room)
        if status == 1:
            raise MemoryError("there is no memory for a kernel to work in")
        if status:
            raise ArithmeticError("a kernel compiled by numba has raised an exception")
        if not size:
            return None
        results = self._reading.unpack(room)
        return results if self._is_tuple else results[0]
