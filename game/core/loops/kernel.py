"""Kernels: functions that are compiled when they are first called with arguments of some types."""

import ctypes
import threading

from game.core.loops import signature
from game.core.loops.ir_writer import Writer
from game.core.loops.object_code import ObjectCode, compiled
from game.core.loops.statements import Body

NAME = "sandglass_kernel"


class Kernel:
    """A function that runs as machine code, without the interpreter's lock.

    keep: `keep(key, make)` returns what make() does, or did before for the same key, a text.
    """

    def __init__(self, function, keep):
        self.function, self._keep = function, keep
        self.__doc__, self.__name__ = function.__doc__, function.__name__
        self._ready, self._lock = {}, threading.Lock()

    def __call__(self, *arguments):
        """Run on arguments: numbers, arrays, and tuples of them."""
        types, words = [], []
        signature.describe(arguments, types, words)
        types = tuple(types)
        ready = self._ready.get(types) or self._make(types)
        return ready(words)

    @property
    def signatures(self):
        """The types of arguments that the kernel is ready for, in words."""
        return [signature.as_text(types) for types in list(self._ready)]

    def _make(self, types):
        function = self.function
        key = f"{function.__module__}.{function.__qualname__} {signature.as_text(types)}"
        with self._lock:
            if types not in self._ready:
                self._ready[types] = _ReadyKernel(types, *self._keep(key, lambda: compile_kernel(function, types)))
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
        self._pack = signature.packing(types).pack
        self._reading, self._is_tuple = signature.reading(kinds), kinds.startswith("(")

    def __call__(self, words):
        room = ctypes.create_string_buffer(self._reading.size) if self._reading.size else None
        if self._code.call(self._pack(*words), room):
            raise MemoryError("there is no memory for a kernel to work in")
        if room is None:
            return None
        results = self._reading.unpack(room)
        return results if self._is_tuple else results[0]
