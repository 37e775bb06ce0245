"""Readers: functions that pack arguments of the types of one signature, each written for it.

To look at arguments one by one, as `signature.describe` does, takes longer than many a kernel.
"""

from itertools import count

import numpy as np

from game.core.loops.signature import NUMBERS, packing


def reader(types):
    """Return a function that packs a tuple of arguments, if they are plainly of some types, and else returns None."""
    source = _Source(types)
    names = [source.part(kind) for kind in source.remaining]
    lines = [f"if len(arguments) != {len(names)}: return", *_unpacking(names, "arguments"), *source.lines]
    text = "\n ".join(["def read(arguments):", *lines, f"return pack({', '.join(source.words)})"])
    exec(text, source.known)
    return source.known["read"]


def _unpacking(names, value):
    return [f"{', '.join(names)}, = {value}"] if names else []


class _Source:
    """What a reader is made of: its lines, the words that it packs, and what it knows by name."""

    def __init__(self, types):
        self.remaining, self.lines, self.words = iter(types), [], []
        self.known = {"ndarray": np.ndarray, "pack": packing(types).pack}
        self._numbers = count()

    def part(self, kind):
        """Write what looks at an argument of a kind; return its name."""
        name = f"v{next(self._numbers)}"
        if isinstance(kind, type):
            self._tuple(name, kind)
        elif isinstance(kind, tuple):
            self._array(name, *kind)
        else:
            known = self._know({each for each, code in NUMBERS.items() if code == kind})
            self.lines.append(f"if type({name}) not in {known}: return")
            self.words.append(name)
        return name

    def _tuple(self, name, kind):
        size, at = next(self.remaining), len(self.lines)
        names = [self.part(next(self.remaining)) for _ in range(size)]
        self.lines[at:at] = [
            f"if type({name}) is not {self._know(kind)} or len({name}) != {size}: return",
            *_unpacking(names, name),
        ]

    def _array(self, name, dtype, axes, is_dense):
        if axes == 1 and is_dense:
            strides = f"{name}.strides != ({dtype.itemsize},)"
        else:
            strides = f"{name}.ndim != {axes}"
            strides += f" or {name}.strides[-1] {'!=' if is_dense else '=='} {dtype.itemsize}" if axes else ""
        test = f"type({name}) is not ndarray or {strides} or {name}.dtype != {self._know(dtype)}"
        self.lines.append(f"if {test}: return")
        self.words.append(f"id({name})")

    def _know(self, value):
        """Return the name by which the lines know a value."""
        name = f"k{len(self.known)}"
        self.known[name] = value
        return name
