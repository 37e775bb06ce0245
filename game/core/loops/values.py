"""Values of a kernel while it is compiled: numbers in registers, arrays in memory, and tuples of them.

Integers are worked on as 64 bits, whatever they are stored as. A tuple is a tuple, a NamedTuple one of its kind, and
what is known beforehand is a Python object. A *shape* says what a value is without saying where.
"""

from typing import NamedTuple

import numpy as np

KINDS = {"i": "i64", "u": "i64", "f": "float", "d": "double", "b": "i1"}  # signed, unsigned, floats, bool
STORED = {  # types of items, as numpy and as LLVM know them
    **{"b1": "i8", "f4": "float", "f8": "double"},
    **{f"{sign}{size}": f"i{8 * size}" for sign in "iu" for size in (1, 2, 4, 8)},
}


class Scalar(NamedTuple):
    """A number: a register or a literal of LLVM, of one of KINDS."""

    kind: str
    name: str


class Array(NamedTuple):
    """An array: the registers of its address, its sides, and its strides in bytes.

    There is no stride of the last axis where its items lie side by side.
    """

    item: str  # one of STORED
    data: str
    sides: tuple
    strides: tuple


def item_of(dtype):
    """Return which of STORED a numpy dtype is."""
    return np.dtype(dtype).str[1:]


def size_of(item):
    """Return how many bytes an item takes."""
    return int(item[1:])


def kind_of(item):
    """Return the kind of a Scalar that is loaded from memory."""
    return {"f4": "f", "f8": "d", "b1": "b"}.get(item, item[0])


def scalar(value):
    """Return a Scalar of a number that is known or not, or None for what is no number."""
    if isinstance(value, Scalar):
        return value
    if isinstance(value, (bool, np.bool_)):
        return Scalar("b", "true" if value else "false")
    if isinstance(value, (int, np.integer)):
        kind = "u" if isinstance(value, np.unsignedinteger) else "i"
        return Scalar(kind, str((int(value) + 2**63) % 2**64 - 2**63))
    if isinstance(value, np.float32):
        return Scalar("f", f"0x{np.float64(value).view(np.uint64):016X}")
    if isinstance(value, (float, np.floating)):
        return Scalar("d", f"0x{np.float64(value).view(np.uint64):016X}")
    return None


def leaves(value):
    """Return the registers of a value, as pairs of (type, register)."""
    if isinstance(value, Array):
        return [("ptr", value.data), *(("i64", each) for each in value.sides + value.strides)]
    if isinstance(value, tuple) and not isinstance(value, Scalar):
        return [leaf for each in value for leaf in leaves(each)]
    number = scalar(value)
    return [(KINDS[number.kind], number.name)]


def rebuilt(value, names):
    """Return a value of the same shape with other registers, taken from an iterator."""
    if isinstance(value, Array):
        data, sides = next(names), tuple(next(names) for _ in value.sides)
        return Array(value.item, data, sides, tuple(next(names) for _ in value.strides))
    if isinstance(value, tuple) and not isinstance(value, Scalar):
        return like(value, [rebuilt(each, names) for each in value])
    return Scalar(scalar(value).kind, next(names))


def like(value, items):
    """Return a tuple of the same kind with other items."""
    return type(value)._make(items) if hasattr(value, "_fields") else tuple(items)


def shape(value):
    """Return what a value is, without its registers, as something that can be compared."""
    if isinstance(value, Array):
        return value.item, len(value.sides), len(value.strides)
    if isinstance(value, tuple) and not isinstance(value, Scalar):
        return tuple(map(shape, value))
    return scalar(value).kind
