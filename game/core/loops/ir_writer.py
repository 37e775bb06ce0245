"""Writes a function as LLVM IR: instructions, blocks, and conversions between kinds of numbers."""

from game.core.loops.values import KINDS, STORED, Array, Scalar, item_of, kind_of, scalar, size_of

_HEAD = """declare ptr @sandglass_calloc(i64, i64)
declare void @sandglass_free(ptr)
declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)
"""


class Writer:
    """A function that is being written. After a jump it is `closed` until the next block begins."""

    def __init__(self):
        self.entry, self.lines, self.globals = [], [], {}
        self.declared = set()
        self.closed = False
        self._names = 0

    def name(self, start):
        """Return a name that is new."""
        self._names += 1
        return f"{start}{self._names}"

    def line(self, text):
        """Write an instruction, unless it would never be reached."""
        if not self.closed:
            self.lines.append("  " + text)

    def new(self, text):
        """Write an instruction and return the register that holds what it yields."""
        name = self.name("%v")
        self.line(f"{name} = {text}")
        return name

    def room(self, kind):
        """Return the place of a variable of a type of LLVM."""
        name = self.name("%r")
        self.entry.append(f"  {name} = alloca {kind}")
        return name

    def label(self):
        """Return the name of a block that is to be."""
        return self.name("b")

    def begin(self, label):
        """Begin a block, which the one before goes on to."""
        self.jump(label)
        self.lines.append(f"{label}:")
        self.closed = False

    def jump(self, label):
        """Go on in another block."""
        self.line(f"br label %{label}")
        self.closed = True

    def branch(self, test, yes, no):
        """Go on in one of two blocks."""
        self.line(f"br i1 {test.name}, label %{yes}, label %{no}")
        self.closed = True

    def intrinsic(self, name, kind, *operands):
        """Call a function of LLVM on numbers of one type, which it returns too."""
        self.declared.add(f"declare {kind} @{name}({', '.join([kind] * len(operands))})")
        return self.new(f"call {kind} @{name}({', '.join(f'{kind} {each}' for each in operands)})")

    def constant(self, array):
        """Return the address of a small array that is known."""
        if array.ndim != 1 or array.dtype.kind not in "iu":
            raise TypeError("a known array holds whole numbers, in one row")
        item = STORED[item_of(array.dtype)]
        listed = ", ".join(f"{item} {int(each)}" for each in array.ravel())
        text = f"private unnamed_addr constant [{array.size} x {item}] [{listed}], align 64"
        return self.globals.setdefault(text, f"@g{len(self.globals)}")

    # numbers

    def as_kind(self, value, kind):
        """Return a number as one of another kind, by value; integers wrap around."""
        value = scalar(value)
        if value.kind == kind or (value.kind in "iu" and kind in "iu"):
            return Scalar(kind, value.name)
        target = KINDS[kind]
        if kind == "b":
            return self.truth(value)
        if value.kind == "b":
            return Scalar(kind, self.new(f"{'zext' if kind in 'iu' else 'uitofp'} i1 {value.name} to {target}"))
        if value.kind in "iu":
            change = "sitofp" if value.kind == "i" else "uitofp"
        elif kind in "iu":
            change = "fptosi" if kind == "i" else "fptoui"
        else:
            change = "fpext" if kind == "d" else "fptrunc"
        return Scalar(kind, self.new(f"{change} {KINDS[value.kind]} {value.name} to {target}"))

    def truth(self, value):
        """Return whether a number is not zero."""
        value = scalar(value)
        if value.kind == "b":
            return value
        test = "fcmp une" if value.kind in "fd" else "icmp ne"
        zero = "0.0" if value.kind in "fd" else "0"
        return Scalar("b", self.new(f"{test} {KINDS[value.kind]} {value.name}, {zero}"))

    def as_item(self, value, item):
        """Return the register of a number as it is stored."""
        value, stored = scalar(value), STORED[item]
        if item == "b1":
            return self.new(f"zext i1 {self.truth(value).name} to i8")
        if item[0] == "f":
            return self.as_kind(value, kind_of(item)).name
        if value.kind in "fd":
            return self.new(f"fpto{'si' if item[0] == 'i' else 'ui'} {KINDS[value.kind]} {value.name} to {stored}")
        whole = self.as_kind(value, item[0]).name
        return whole if stored == "i64" else self.new(f"trunc i64 {whole} to {stored}")

    def from_item(self, name, item):
        """Return the Scalar of a register as it is stored."""
        if item == "b1":
            return Scalar("b", self.new(f"icmp ne i8 {name}, 0"))
        if item[0] == "f" or STORED[item] == "i64":
            return Scalar(kind_of(item), name)
        return Scalar(item[0], self.new(f"{'s' if item[0] == 'i' else 'z'}ext {STORED[item]} {name} to i64"))

    # memory

    def load(self, array, indices):
        """Return the item of an array at some indices."""
        stored = STORED[array.item]
        return self.from_item(self.new(f"load {stored}, ptr {self.address(array, indices).data}"), array.item)

    def store(self, array, indices, value):
        """Put a number in the place of an item."""
        name = self.as_item(value, array.item)
        self.line(f"store {STORED[array.item]} {name}, ptr {self.address(array, indices).data}")

    def address(self, array, indices):
        """Return the Array, of less axes, at some indices of the first axes; the last of all is an item."""
        data = array.data
        for axis, index in enumerate(indices):
            index = self.as_kind(index, "i").name
            if axis < len(array.strides):
                offset = self.new(f"mul i64 {index}, {array.strides[axis]}")
                data = self.new(f"getelementptr i8, ptr {data}, i64 {offset}")
            else:
                data = self.new(f"getelementptr {STORED[array.item]}, ptr {data}, i64 {index}")
        return Array(array.item, data, array.sides[len(indices) :], array.strides[len(indices) :])

    def allocate(self, item, sides):
        """Return a new Array of zeros that lasts as long as the kernel."""
        sides = tuple(scalar(each).name for each in sides)
        strides, size = [], str(size_of(item))
        for side in reversed(sides):
            strides.insert(0, size)
            size = self.new(f"mul i64 {side}, {size}")
        whole = self.new(f"add i64 {size}, 128")
        block = self.new(f"call ptr @sandglass_calloc(i64 1, i64 {whole})")
        enough, missing = self.label(), Scalar("b", self.new(f"icmp eq ptr {block}, null"))
        self.branch(missing, "full", enough)
        self.begin(enough)
        self.line(f"store ptr {self.new('load ptr, ptr %blocks')}, ptr {block}")
        self.line(f"store ptr {block}, ptr %blocks")
        start = self.new(f"ptrtoint ptr {block} to i64")
        start = self.new(f"and i64 {self.new(f'add i64 {start}, 127')}, -64")
        offset = self.new(f"sub i64 {start}, {self.new(f'ptrtoint ptr {block} to i64')}")
        return Array(item, self.new(f"getelementptr i8, ptr {block}, i64 {offset}"), sides, tuple(strides[:-1]))

    def text(self, name):
        """Return the module. The function takes the addresses of arguments and results; without memory it returns 1."""
        constants = [f"{name} = {text}" for text, name in self.globals.items()]
        return "\n".join(
            [
                _HEAD,
                *sorted(self.declared),
                *constants,
                f"define i32 @{name}(ptr %arguments, ptr %results) nounwind {{",
                "entry:",
                "  %blocks = alloca ptr",
                "  %status = alloca i32",
                "  store ptr null, ptr %blocks",
                "  store i32 0, ptr %status",
                *self.entry,
                "  br label %start",
                "start:",
                *self.lines,
                *([] if self.closed else ["  br label %leave"]),
                "full:",
                "  store i32 1, ptr %status",
                "  br label %leave",
                "leave:",
                "  %block = load ptr, ptr %blocks",
                "  %none = icmp eq ptr %block, null",
                "  br i1 %none, label %end, label %free",
                "free:",
                "  %before = load ptr, ptr %block",
                "  store ptr %before, ptr %blocks",
                "  call void @sandglass_free(ptr %block)",
                "  br label %leave",
                "end:",
                "  %told = load i32, ptr %status",
                "  ret i32 %told",
                "}",
            ]
        )
