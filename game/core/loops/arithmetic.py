"""Operators and functions on numbers, as instructions: as in numpy, except that integers have 64 bits.

Of two integers the result is signed if either is. What would depend on that, a quotient or a comparison of both sorts,
is refused.
"""

import ast

from game.core.loops.values import KINDS, Scalar, scalar

_WHOLE = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.BitAnd: "and", ast.BitOr: "or", ast.BitXor: "xor"}
_REAL = {ast.Add: "fadd", ast.Sub: "fsub", ast.Mult: "fmul", ast.Div: "fdiv"}
_COMPARED = {ast.Eq: "eq", ast.NotEq: "ne", ast.Lt: "lt", ast.LtE: "le", ast.Gt: "gt", ast.GtE: "ge"}


def common_kind(values):
    """Return the kind of which numbers are that meet."""
    kinds = {each.kind for each in values}
    if "d" in kinds or ("f" in kinds and kinds - {"f", "b"}):
        return "d"
    for kind in "fiu":
        if kind in kinds:
            return kind
    return "b"


def operate(writer, operator, left, right):
    """Return the Scalar of a binary operator of Python on two numbers."""
    left, right = scalar(left), scalar(right)
    kind = common_kind((left, right))
    if operator is ast.Pow:
        return _power(writer, left, right)
    if operator is ast.Div and kind in "iub":
        kind = "d"
    if kind in "fd":
        values = (writer.as_kind(each, kind).name for each in (left, right))
        return Scalar(kind, writer.new(f"{_REAL[operator]} {KINDS[kind]} {', '.join(values)}"))
    if kind == "b" and operator in (ast.BitAnd, ast.BitOr, ast.BitXor):
        return Scalar("b", writer.new(f"{_WHOLE[operator]} i1 {left.name}, {right.name}"))
    if operator in (ast.LShift, ast.RShift):
        kind = "u" if left.kind == "u" else "i"
        name = "shl" if operator is ast.LShift else "lshr" if kind == "u" else "ashr"
    elif operator in (ast.FloorDiv, ast.Mod):
        return _quotient(writer, operator, left, right)
    else:
        kind, name = "i" if kind == "b" else kind, _WHOLE[operator]
    values = (writer.as_kind(each, "i").name for each in (left, right))
    return Scalar(kind, writer.new(f"{name} i64 {', '.join(values)}"))


def _power(writer, left, right):
    if not right.name.isdigit() or int(right.name) < 1:
        raise TypeError("an exponent is known, and 1 or more")
    result = left
    for _ in range(int(right.name) - 1):
        result = operate(writer, ast.Mult, result, left)
    return result


def sort_of(left, right):
    """Return "u" or "i" for two integers of one sort; a literal that is not negative is of either."""
    kinds = {each.kind for each in (left, right) if each.kind != "b" and not each.name.isdigit()}
    if len(kinds) > 1:
        raise TypeError("signed and unsigned integers meet: convert one of them")
    return kinds.pop() if kinds else common_kind((left, right))


def _quotient(writer, operator, left, right):
    """Return the quotient, rounded down, or the remainder, which has the sign of the divisor."""
    kind = sort_of(left, right)
    left, right = writer.as_kind(left, kind).name, writer.as_kind(right, kind).name
    wants_rest = operator is ast.Mod
    power = int(right) if right.isdigit() else 0
    if kind == "u":
        return Scalar(kind, writer.new(f"{'urem' if wants_rest else 'udiv'} i64 {left}, {right}"))
    if power and power & (power - 1) == 0:
        text = f"and i64 {left}, {power - 1}" if wants_rest else f"ashr i64 {left}, {power.bit_length() - 1}"
        return Scalar(kind, writer.new(text))
    rest = writer.new(f"srem i64 {left}, {right}")
    signs = writer.new(f"icmp slt i64 {writer.new(f'xor i64 {rest}, {right}')}, 0")
    is_off = writer.new(f"and i1 {signs}, {writer.new(f'icmp ne i64 {rest}, 0')}")
    if wants_rest:
        return Scalar(kind, writer.new(f"add i64 {rest}, {writer.new(f'select i1 {is_off}, i64 {right}, i64 0')}"))
    whole = writer.new(f"sdiv i64 {left}, {right}")
    return Scalar(kind, writer.new(f"sub i64 {whole}, {writer.new(f'zext i1 {is_off} to i64')}"))


def compare(writer, operator, left, right):
    """Return the Scalar of a comparison."""
    left, right = scalar(left), scalar(right)
    kind, name = common_kind((left, right)), _COMPARED[operator]
    if kind in "fd":
        values = (writer.as_kind(each, kind).name for each in (left, right))
        return Scalar("b", writer.new(f"fcmp {'u' if name == 'ne' else 'o'}{name} {KINDS[kind]} {', '.join(values)}"))
    if operator not in (ast.Eq, ast.NotEq):
        name = f"{'u' if sort_of(left, right) == 'u' else 's'}{name}"
    values = (writer.as_kind(each, "i").name for each in (left, right))
    return Scalar("b", writer.new(f"icmp {name} i64 {', '.join(values)}"))


def invert(writer, value):
    """Return ~value of an integer."""
    value = scalar(value)
    if value.kind not in "iu":
        raise TypeError("only the bits of a whole number are turned over")
    return Scalar(value.kind, writer.new(f"xor i64 {value.name}, -1"))


def negate(writer, value):
    """Return -value."""
    value = scalar(value)
    if value.kind in "fd":
        return Scalar(value.kind, writer.new(f"fneg {KINDS[value.kind]} {value.name}"))
    return operate(writer, ast.Sub, Scalar(value.kind, "0"), value)


def extreme(writer, values, wants_more):
    """Return the least or the greatest of some numbers."""
    values = [scalar(each) for each in values]
    kind = common_kind(values)
    if kind in "iub":
        for each in values:
            kind = sort_of(each, values[0])
    first, *rest = (writer.as_kind(each, kind) for each in values)
    for each in rest:
        is_other = compare(writer, ast.Gt if wants_more else ast.Lt, each, first)
        first = chosen(writer, is_other, each, first)
    return first


def chosen(writer, test, yes, no):
    """Return one of two numbers of a kind."""
    kind = KINDS[yes.kind]
    return Scalar(yes.kind, writer.new(f"select i1 {test.name}, {kind} {yes.name}, {kind} {no.name}"))


def absolute(writer, value):
    """Return abs(value)."""
    value = scalar(value)
    if value.kind in "fd":
        suffix = "f64" if value.kind == "d" else "f32"
        return Scalar(value.kind, writer.intrinsic(f"llvm.fabs.{suffix}", KINDS[value.kind], value.name))
    return chosen(writer, compare(writer, ast.Lt, value, 0), negate(writer, value), value)


def rounded(writer, value, name):
    """Return `floor` or `ceil` of a float."""
    value = scalar(value)
    suffix = "f64" if value.kind == "d" else "f32"
    return Scalar(value.kind, writer.intrinsic(f"llvm.{name}.{suffix}", KINDS[value.kind], value.name))
