"""Expressions of Python as instructions: what they yield as a Scalar, an Array, a tuple, or an object that is known."""

import ast
import operator

import numpy as np

from game.core.loops import arithmetic
from game.core.loops.values import Array, Scalar, item_of, scalar, size_of

_KNOWN = (bool, int, float)
_FOLDED = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    ast.LShift: operator.lshift,
    ast.RShift: operator.rshift,
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
}


def is_known(*values):
    """Return whether values are plain numbers that are known beforehand."""
    return all(type(each) in _KNOWN for each in values)


def evaluate(body, node):
    """Return what an expression in a `Body` yields."""
    return _EXPRESSIONS[type(node)](body, node)


def binary(writer, kind, left, right):
    """Return what a binary operator yields."""
    if is_known(left, right):
        return _FOLDED[kind](left, right)
    return arithmetic.operate(writer, kind, left, right)


def _constant(body, node):
    return node.value


def _name(body, node):
    return body.value_of(node.id)


def _attribute(body, node):
    value = evaluate(body, node.value)
    if isinstance(value, Array):
        if node.attr == "shape":
            return tuple(Scalar("i", side) for side in value.sides)
        if node.attr == "size":
            size = Scalar("i", "1")
            for side in value.sides:
                size = arithmetic.operate(body.writer, ast.Mult, size, Scalar("i", side))
            return size
        return value, node.attr  # a method
    return getattr(value, node.attr)


def _tuple(body, node):
    return tuple(evaluate(body, each) for each in node.elts)


def _binary(body, node):
    return binary(body.writer, type(node.op), evaluate(body, node.left), evaluate(body, node.right))


def _unary(body, node):
    value, writer = evaluate(body, node.operand), body.writer
    if isinstance(node.op, ast.Not):
        return not value if is_known(value) else Scalar("b", writer.new(f"xor i1 {writer.truth(value).name}, true"))
    if isinstance(node.op, ast.USub):
        return -value if is_known(value) else arithmetic.negate(writer, value)
    return ~value if is_known(value) else arithmetic.invert(writer, value)


def _both_or_either(body, node):
    """Evaluate no more parts than decide."""
    writer, end, is_and = body.writer, body.writer.label(), isinstance(node.op, ast.And)
    place = writer.room("i1")
    for each in node.values:
        value = writer.truth(evaluate(body, each))
        writer.line(f"store i1 {value.name}, ptr {place}")
        if each is not node.values[-1]:
            go_on = writer.label()
            writer.branch(value, *((go_on, end) if is_and else (end, go_on)))
            writer.begin(go_on)
    writer.begin(end)
    return Scalar("b", writer.new(f"load i1, ptr {place}"))


def _compare(body, node):
    values = [evaluate(body, each) for each in (node.left, *node.comparators)]
    result = None
    for kind, left, right in zip(node.ops, values, values[1:], strict=False):
        one = arithmetic.compare(body.writer, type(kind), left, right)
        result = arithmetic.operate(body.writer, ast.BitAnd, result, one) if result else one
    return result


def _choice(body, node):
    """Evaluate one of two expressions."""
    writer, (yes, no, end) = body.writer, (body.writer.label() for _ in range(3))
    writer.branch(writer.truth(evaluate(body, node.test)), yes, no)
    parts = []
    for label, part in ((yes, node.body), (no, node.orelse)):
        writer.begin(label)
        value = evaluate(body, part)
        parts.append((value, len(writer.lines)))
        writer.jump(end)
    (first, at_first), (second, at_second) = parts
    place, shown = body.room_for_either(first, second)
    # each part is written to its place at the end of its own block
    for value, at in ((second, at_second), (first, at_first)):
        after, writer.lines = writer.lines[at:], writer.lines[:at]
        writer.closed = False
        body.put(place, shown, value)
        writer.lines += after
    writer.closed = True
    writer.begin(end)
    return body.get(place, shown)


def _subscript(body, node):
    value = evaluate(body, node.value)
    if isinstance(value, np.ndarray):
        value = Array(item_of(value.dtype), body.writer.constant(value), (str(len(value)),), ())
    if isinstance(value, Array):
        found = element(body, value, node.slice)
        return body.writer.load(found, ()) if not found.sides else found
    return items_of(value)[evaluate(body, node.slice)]


def items_of(value):
    """Return a tuple that is known, of what is known or not; raise TypeError for anything else."""
    if isinstance(value, (Array, Scalar)) or not isinstance(value, tuple):
        raise TypeError("this is no tuple")
    return value


def element(body, array, index):
    """Return the Array at an index, of no axes if that is one item."""
    writer = body.writer
    indices = index.elts if isinstance(index, ast.Tuple) else [index]
    data, sides, strides = array.data, [], []
    for axis, each in enumerate(indices):
        rest = Array(array.item, data, array.sides[axis:], array.strides[axis:])
        if isinstance(each, ast.Slice):
            if each.step:
                raise TypeError("parts of an array have no steps")
            low = evaluate(body, each.lower) if each.lower else 0
            side = Scalar("i", array.sides[axis])
            high = arithmetic.extreme(writer, (evaluate(body, each.upper), side), False) if each.upper else side
            size = arithmetic.operate(writer, ast.Sub, high, low)
            sides.append(arithmetic.extreme(writer, (size, 0), True).name)
            strides += array.strides[axis : axis + 1]
            data = writer.address(rest, [low]).data
        else:
            at = evaluate(body, each)
            if is_known(at) and at < 0:
                raise TypeError("an index is counted from the start")
            data = writer.address(rest, [at]).data
    count = len(indices)
    return Array(array.item, data, (*sides, *array.sides[count:]), (*strides, *array.strides[count:]))


def _call(body, node):
    if node.keywords:
        raise TypeError("arguments have no names here")
    function = evaluate(body, node.func)
    arguments = [evaluate(body, each) for each in node.args]
    if isinstance(function, tuple):
        return _METHODS[function[1]](body.writer, function[0], *arguments)
    if function in _FUNCTIONS:
        return _FUNCTIONS[function](body.writer, *arguments)
    if isinstance(function, type) and issubclass(function, np.generic):
        return cast(body.writer, arguments[0], item_of(function))
    if hasattr(function, "write_call"):
        return function.write_call(body.writer, *arguments)
    return body.call(function, arguments)


def cast(writer, value, item):
    """Return a number as it is after it was stored as an item of some type."""
    value = scalar(value)
    if (value.kind, item[0]) in (("i", "i"), ("u", "u"), ("u", "i"), ("i", "u")) and item[1:] == "8":
        return Scalar(item[0], value.name)
    return writer.from_item(writer.as_item(value, item), item)


def _length(writer, value):
    if isinstance(value, Array):
        return Scalar("i", value.sides[0])
    return len(value if isinstance(value, np.ndarray) else items_of(value))


def _room(writer, sides, dtype):
    sides = sides if isinstance(sides, tuple) and not isinstance(sides, Scalar) else (sides,)
    return writer.allocate(item_of(dtype), sides)


def _extreme(wants_more):
    def write(writer, *values):
        if is_known(*values):
            return max(values) if wants_more else min(values)
        return arithmetic.extreme(writer, values, wants_more)

    return write


def _whole(writer, value):
    return int(value) if is_known(value) else cast(writer, value, "i8")


def _viewed(writer, array, dtype):
    """Return an array's bytes as items of another type."""
    old, new = size_of(array.item), size_of(item_of(dtype))
    kind = ast.Mult if old > new else ast.FloorDiv
    last = arithmetic.operate(writer, kind, Scalar("i", array.sides[-1]), max(old, new) // min(old, new))
    return array._replace(item=item_of(dtype), sides=(*array.sides[:-1], last.name))


def _flat(writer, array, side):
    """Return an array without gaps as one of one axis."""
    size = Scalar("i", "1")
    for each in array.sides:
        size = arithmetic.operate(writer, ast.Mult, size, Scalar("i", each))
    return Array(array.item, array.data, (size.name,), ())


_METHODS = {"view": _viewed, "reshape": _flat}
_FUNCTIONS = {
    len: _length,
    int: _whole,
    abs: arithmetic.absolute,
    min: _extreme(False),
    max: _extreme(True),
    np.empty: _room,
    np.zeros: _room,
    np.floor: lambda writer, value: arithmetic.rounded(writer, value, "floor"),
    np.ceil: lambda writer, value: arithmetic.rounded(writer, value, "ceil"),
}
_EXPRESSIONS = {
    ast.Constant: _constant,
    ast.Name: _name,
    ast.Attribute: _attribute,
    ast.Tuple: _tuple,
    ast.BinOp: _binary,
    ast.UnaryOp: _unary,
    ast.BoolOp: _both_or_either,
    ast.Compare: _compare,
    ast.IfExp: _choice,
    ast.Subscript: _subscript,
    ast.Call: _call,
}
