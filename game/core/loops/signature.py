"""Signatures: the types of a kernel's arguments, how these are handed over, and which values they are in its body.

A number is handed over as eight bytes, an array as the address of its object. What a kernel needs of that lies where
NumPy's C API says (PyArrayObject): behind the head of the object the address of the items, how many axes there are, and
the addresses of the sides and of the strides.
"""

import struct

import numpy as np

from game.core.loops.values import KINDS, Array, Scalar, item_of

_HEAD = object.__basicsize__
_SIDES, _STRIDES = _HEAD + 16, _HEAD + 24
_ITEMS = {np.dtype(code): item_of(code) for code in "?bBhHiIlLqQfd"}
NUMBERS = {bool: "b", np.bool_: "b", int: "i", float: "d", np.float64: "d", np.float32: "f"} | {
    np.dtype(code).type: "u" if code.isupper() else "i" for code in "bBhHiIlLqQ"
}
_PACKED = {"i": "q", "u": "Q", "b": "?7x", "f": "d", "d": "d"}


def describe(values, types, words):
    """Append the types of arguments to one list, and what is handed over of them to another one."""
    for value in values:
        kind = type(value)
        if kind in NUMBERS:
            types.append(NUMBERS[kind])
            words.append(value)
        elif isinstance(value, np.ndarray):
            strides = value.strides
            # where the last items lie side by side, or there are no two of them, their stride does not matter
            is_dense = not strides or strides[-1] == value.itemsize or value.shape[-1] < 2
            types.append((value.dtype, len(strides), is_dense))
            words.append(id(value))
        elif isinstance(value, tuple):
            types += kind, len(value)
            describe(value, types, words)
        else:
            raise TypeError(f"a kernel takes no {kind.__name__}")


def as_text(types):
    """Return types as a text that is the same in every run; raise TypeError for what no kernel takes."""
    parts = []
    for each in types:
        if type(each) is tuple:
            dtype, axes, is_dense = each
            if dtype not in _ITEMS:
                raise TypeError(f"a kernel takes no items of type {dtype}")
            parts.append(f"{_ITEMS[dtype]}[{axes}{'' if is_dense else ' apart'}]")
        else:
            parts.append(each.__name__ if isinstance(each, type) else str(each))
    return " ".join(parts)


def packing(types):
    """Return the struct.Struct of what is handed over of arguments of some types."""
    codes = ("Q" if type(each) is tuple else _PACKED[each] for each in types if isinstance(each, (tuple, str)))
    return struct.Struct("=" + "".join(codes))


def arguments(writer, types):
    """Write the loads of arguments of some types; return their values."""
    remaining, places, found = iter(types), iter(range(len(types))), []
    for each in remaining:
        found.append(_argument(writer, each, remaining, places))
    return found


def _argument(writer, kind, remaining, places):
    if isinstance(kind, type):
        items = [_argument(writer, next(remaining), remaining, places) for _ in range(next(remaining))]
        return kind._make(items) if hasattr(kind, "_make") else tuple(items)
    place = writer.new(f"getelementptr i64, ptr %arguments, i64 {next(places)}")
    if isinstance(kind, tuple):
        return _array(writer, writer.new(f"load ptr, ptr {place}"), *kind)
    if kind == "b":
        return Scalar(kind, writer.new(f"icmp ne i64 {writer.new(f'load i64, ptr {place}')}, 0"))
    if kind == "f":
        return writer.as_kind(Scalar("d", writer.new(f"load double, ptr {place}")), kind)
    return Scalar(kind, writer.new(f"load {KINDS[kind]}, ptr {place}"))


def _array(writer, found, dtype, axes, is_dense):
    """Write the loads of what is known of an array object."""

    def numbers(offset, count):
        start = _member(writer, found, offset)
        places = (writer.new(f"getelementptr i64, ptr {start}, i64 {axis}") for axis in range(count))
        return tuple([writer.new(f"load i64, ptr {place}") for place in places])

    sides, strides = numbers(_SIDES, axes), numbers(_STRIDES, axes - is_dense)
    return Array(_ITEMS[dtype], _member(writer, found, _HEAD), sides, strides)


def _member(writer, found, offset):
    return writer.new(f"load ptr, ptr {writer.new(f'getelementptr i8, ptr {found}, i64 {offset}')}")


def results(writer, value):
    """Write the stores of what a kernel returns; return their kinds, behind "(" for a tuple, or "" for None."""
    if value is None:
        return ""
    is_tuple = isinstance(value, tuple) and not isinstance(value, Scalar)
    kinds = "(" if is_tuple else ""
    for place, each in enumerate(value if is_tuple else [value]):
        kind = "i" if each.kind == "b" else "d" if each.kind == "f" else each.kind
        name = writer.as_kind(each, kind).name
        address = writer.new(f"getelementptr i64, ptr %results, i64 {place}")
        writer.line(f"store {KINDS[kind]} {name}, ptr {address}")
        kinds += each.kind
    return kinds


def reading(kinds):
    """Return the struct.Struct of results of some kinds."""
    codes = {"i": "q", "u": "Q", "b": "?7x", "f": "d", "d": "d"}
    return struct.Struct("<" + "".join(codes[kind] for kind in kinds.strip("(")))
