"""LLVM IR as text: what the writers of functions on vectors of words have in common."""

FULL = 2**64 - 1
# The stack is aligned for spilled vectors, else they straddle cache lines; Windows' probe of large frames is no
# symbol that can be resolved here.
_ATTRIBUTES = 'alignstack(64) nounwind "stackrealign" "frame-pointer"="all" "no-stack-arg-probe"'


class IrText:
    """Writes a function on vectors of `lanes` words that returns a word, a line after the other."""

    def __init__(self, lanes):
        self.lanes, self.kind = lanes, f"<{lanes} x i64>"
        self.lines, self.count, self.block = [], 0, ""

    def head(self, name, arguments):
        """Begin the function; its arguments are words, each called %name_."""
        self.lines.append(f"define i64 @{name}({', '.join(f'i64 %{each}_' for each in arguments)}) {_ATTRIBUTES} {{")
        self.start("entry")

    def pointers(self, *names):
        """Make pointers %name of arguments."""
        for name in names:
            self.line(f"%{name} = inttoptr i64 %{name}_ to ptr")

    def whole(self):
        """End the function and return the text."""
        self.lines.append("}")
        self.lines.append(f"declare i1 @llvm.vector.reduce.or.v{self.lanes}i1(<{self.lanes} x i1>)")
        return "\n".join(self.lines)

    def line(self, text):
        """Write a line."""
        self.lines.append("  " + text)

    def start(self, label):
        """Begin a block."""
        self.lines.append(f"{label}:")
        self.block = label

    # --- values: each of these writes what works one out, and returns its name ---

    def new(self, text):
        """Write a value that a piece of text works out."""
        self.count += 1
        self.line(f"%v{self.count} = {text}")
        return f"%v{self.count}"

    def op(self, op, x, y):
        """Write an operation on two vectors."""
        return self.new(f"{op} {self.kind} {x}, {y}")

    def constant(self, value):
        """Return a vector of one number."""
        value = value % 2**64
        value -= 2**64 if value >= 2**63 else 0
        return "<" + ", ".join([f"i64 {value}"] * self.lanes) + ">"

    def inverse(self, x):
        """Write the inverse of a vector."""
        return self.op("xor", x, self.constant(FULL))

    def any_of(self, values):
        """Write the or of some vectors, at least one."""
        result = values[0]
        for each in values[1:]:
            result = self.op("or", result, each)
        return result

    def any_bit(self, x):
        """Write whether a vector has a bit set, an i1."""
        flags = self.new(f"icmp ne {self.kind} {x}, zeroinitializer")
        return self.new(f"call i1 @llvm.vector.reduce.or.v{self.lanes}i1(<{self.lanes} x i1> {flags})")

    def all_lanes(self, scalar):
        """Write a vector of one word."""
        first = self.new(f"insertelement {self.kind} poison, i64 {scalar}, i32 0")
        return self.new(f"shufflevector {self.kind} {first}, {self.kind} poison, <{self.lanes} x i32> zeroinitializer")

    def meeting(self, name, ways):
        """Write a phi of (vector, label) pairs at the start of a block."""
        self.line(f"{name} = phi {self.kind} " + ", ".join(f"[{value}, %{label}]" for value, label in ways))
        return name

    # --- memory ---

    def load(self, base, index):
        """Write a vector from the words of a pointer, from an index on."""
        return self.new(f"load {self.kind}, ptr {self._place(base, index)}, align 8")

    def load_word(self, base, index):
        """Write a word of those of a pointer."""
        return self.new(f"load i64, ptr {self._place(base, index)}")

    def store(self, value, base, index):
        """Store a vector among the words of a pointer, from an index on."""
        self.line(f"store {self.kind} {value}, ptr {self._place(base, index)}, align 8")

    def _place(self, base, index):
        return self.new(f"getelementptr i64, ptr {base}, i64 {index}")
