"""Statements of Python as instructions: the body of a function, written into that of the kernel which calls it."""

import ast
import builtins
import inspect
import textwrap
from functools import cache

from game.core.loops import arithmetic
from game.core.loops.expressions import binary, element, evaluate, is_known, items_of
from game.core.loops.values import Array, Scalar, leaves, like, rebuilt, scalar, shape


class NotCompilableError(Exception):
    """A function is not of the part of Python that kernels are written in."""


@cache
def _tree_of(function):
    """Return (definition of a function, names that it assigns)."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(function))).body[0]
    stored = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
    return tree, stored


class Body:
    """The body of a function as it is called in one place."""

    def __init__(self, writer, function, arguments):
        self.writer, self.function = writer, function
        self._tree, self._stored = _tree_of(function)
        self._variables, self._given = {}, {}
        self._loops, self._end, self._result = [], writer.label(), None
        names = [each.arg for each in self._tree.args.args]
        for name, value in zip(names, arguments, strict=True):
            if name in self._stored:
                self._set(name, value)
            else:
                self._given[name] = value

    def write(self):
        """Write the body, and return what it returns."""
        self._all(self._tree.body)
        self.writer.begin(self._end)
        return None if self._result is None else self.get(*self._result)

    def call(self, function, arguments):
        """Write the body of another function here, and return what it returns."""
        if not hasattr(function, "is_gate"):
            raise TypeError(f"a kernel cannot call {function!r}")
        return Body(self.writer, function, arguments).write()

    # variables

    def value_of(self, name):
        """Return what a name stands for."""
        if name in self._variables:
            return self.get(*self._variables[name])
        if name in self._given:
            return self._given[name]
        if name in self._stored:
            raise TypeError(f"{name} has no value yet")
        known = self.function.__globals__
        return known[name] if name in known else getattr(builtins, name)

    def room_for(self, value):
        """Return (places, value): room for the registers of a value, and what shows its shape."""
        return [self.writer.room(kind) for kind, _ in leaves(value)], value

    def room_for_either(self, first, second):
        """Return the same for one of two values."""
        return self.room_for(self._common(first, second))

    def get(self, places, shown):
        """Return the value in its places."""
        kinds = (kind for kind, _ in leaves(shown))
        loads = (self.writer.new(f"load {kind}, ptr {each}") for kind, each in zip(kinds, places, strict=True))
        return rebuilt(shown, loads)

    def put(self, places, shown, value):
        """Store a value in its places, converted if that is no loss."""
        value = self._as(value, shown)
        for (kind, name), place in zip(leaves(value), places, strict=True):
            self.writer.line(f"store {kind} {name}, ptr {place}")

    def _set(self, name, value):
        if name == "_":
            return
        if name not in self._variables:
            self._variables[name] = self.room_for(value)
        self.put(*self._variables[name], value)

    def _as(self, value, shown):
        """Return a value with the shape of another; only what is no loss is converted."""
        if isinstance(shown, Array) or (isinstance(shown, tuple) and not isinstance(shown, Scalar)):
            if isinstance(shown, Array) and shape(value) == shape(shown):
                return value
            if isinstance(shown, Array) or len(value) != len(shown):
                raise TypeError("a variable holds arrays or tuples of two kinds")
            return like(shown, [self._as(*each) for each in zip(value, shown, strict=True)])
        old, kind = scalar(value).kind, scalar(shown).kind
        if old == kind or (is_known(value) and kind != "b") or old + kind in ("bi", "bu", "fd", "id", "ud"):
            return self.writer.as_kind(value, kind)
        raise TypeError(f"a variable of kind {kind} becomes one of kind {old}")

    def _common(self, first, second):
        if isinstance(first, Array):
            return first
        if isinstance(first, tuple) and not isinstance(first, Scalar):
            return like(first, [self._common(*each) for each in zip(first, second, strict=True)])
        if is_known(first) and not is_known(second):
            first, second = second, first
        if is_known(second) and scalar(first).kind in "iu" and type(second) is int:
            return first
        return Scalar(arithmetic.common_kind((scalar(first), scalar(second))), "0")

    # statements

    def _all(self, statements):
        for each in statements:
            if self.writer.closed:
                return
            try:
                if isinstance(each, (ast.For, ast.While)) and each.orelse:
                    raise TypeError("loops have no else here")
                _STATEMENTS[type(each)](self, each)
            except NotCompilableError:
                raise
            except (KeyError, TypeError, AttributeError, ValueError, AssertionError) as error:
                code = self.function.__code__
                line = code.co_firstlineno + each.lineno - 1
                raise NotCompilableError(f"{code.co_filename}:{line}: cannot compile this: {error!r}") from error

    def _assign(self, node):
        value = evaluate(self, node.value)
        for target in node.targets:
            self._assign_to(target, value)

    def _assign_to(self, target, value):
        if isinstance(target, ast.Name):
            self._set(target.id, value)
        elif isinstance(target, ast.Subscript):
            found = element(self, evaluate(self, target.value), target.slice)
            self._fill(found, value)
        else:
            if isinstance(value, Array):
                value = [self._item(value, place) for place in range(len(target.elts))]
            for each, part in zip(target.elts, value if isinstance(value, list) else items_of(value), strict=True):
                self._assign_to(each, part)

    def _item(self, array, place):
        found = self.writer.address(array, [place])
        return found if found.sides else self.writer.load(found, ())

    def _fill(self, array, value):
        """Give all items of an array one value."""
        if not array.sides:
            self.writer.store(array, (), value)
            return
        with_index = self._count(0, Scalar("i", array.sides[0]), 1)
        self._fill(self.writer.address(array, [next(with_index)]), value)
        next(with_index, None)

    def _augment(self, node):
        value, kind = evaluate(self, node.value), type(node.op)
        if isinstance(node.target, ast.Name):
            self._set(node.target.id, binary(self.writer, kind, self.value_of(node.target.id), value))
            return
        found = element(self, evaluate(self, node.target.value), node.target.slice)
        if found.sides:
            raise TypeError("only one item is changed at a time")
        self.writer.store(found, (), binary(self.writer, kind, self.writer.load(found, ()), value))

    def _express(self, node):
        if not isinstance(node.value, ast.Constant):
            evaluate(self, node.value)

    def _if(self, node):
        writer, test = self.writer, evaluate(self, node.test)
        yes, no, end = (writer.label() for _ in range(3))
        writer.branch(writer.truth(test), yes, no)
        writer.begin(yes)
        self._all(node.body)
        writer.jump(end)
        writer.begin(no)
        self._all(node.orelse)
        writer.begin(end)

    def _while(self, node):
        writer, (head, inside, end) = self.writer, (self.writer.label() for _ in range(3))
        writer.begin(head)
        writer.branch(writer.truth(evaluate(self, node.test)), inside, end)
        writer.begin(inside)
        self._loops.append((head, end))
        self._all(node.body)
        self._loops.pop()
        writer.jump(head)
        writer.begin(end)

    def _for(self, node):
        call = node.iter
        if isinstance(call, ast.Call) and evaluate(self, call.func) is range:
            bounds = [evaluate(self, each) for each in call.args]
            start, stop, step = (0, *bounds, 1) if len(bounds) == 1 else (*bounds, 1)[:3]
            turns = self._count(start, stop, step)
            self._assign_to(node.target, next(turns))
            self._all(node.body)
            next(turns, None)
            return
        end = self.writer.label()
        for item in items_of(evaluate(self, call)):
            after = self.writer.label()
            self._loops.append((after, end))
            self._assign_to(node.target, item)
            self._all(node.body)
            self._loops.pop()
            self.writer.begin(after)
        self.writer.begin(end)

    def _count(self, start, stop, step):
        """Begin a loop and yield its number; go on after it when asked again."""
        writer, (head, inside, after, end) = self.writer, (self.writer.label() for _ in range(4))
        kind = arithmetic.sort_of(scalar(start), scalar(stop))
        start, stop, place = writer.as_kind(start, kind), writer.as_kind(stop, kind), writer.room("i64")
        writer.line(f"store i64 {start.name}, ptr {place}")
        writer.begin(head)
        number = Scalar(kind, writer.new(f"load i64, ptr {place}"))
        forward = not (is_known(step) and step < 0)
        writer.branch(arithmetic.compare(writer, ast.Lt if forward else ast.Gt, number, stop), inside, end)
        writer.begin(inside)
        self._loops.append((after, end))
        yield number
        self._loops.pop()
        writer.begin(after)
        following = arithmetic.operate(writer, ast.Add, number, writer.as_kind(step, kind))
        writer.line(f"store i64 {following.name}, ptr {place}")
        writer.jump(head)
        writer.begin(end)

    def _return(self, node):
        if node.value is not None:
            value = evaluate(self, node.value)
            if self._result is None:
                self._result = self.room_for(value)
            self.put(*self._result, value)
        self.writer.jump(self._end)

    def _continue(self, node):
        self.writer.jump(self._loops[-1][0])

    def _break(self, node):
        self.writer.jump(self._loops[-1][1])


_STATEMENTS = {
    ast.Assign: Body._assign,
    ast.AugAssign: Body._augment,
    ast.Expr: Body._express,
    ast.If: Body._if,
    ast.While: Body._while,
    ast.For: Body._for,
    ast.Return: Body._return,
    ast.Continue: Body._continue,
    ast.Break: Body._break,
}
