"""Passes over rows of words: a function on words, written with & | ^ ~ + << >>, as machine code for many words.

    void pass(at, size)

at: int64, the addresses of the streams that are read, then of those written. A pass takes `lanes` words at a time, so
streams go on for LINE words beyond `size`, and what is written there means nothing. The same function works out the
same of arrays of uint64.
"""

from game.core.compiler.machine_code import MachineCode, compiled, lanes

FULL = 2**64 - 1
NAME = "sandglass_words"


class Word:
    """Some words at once, of which only a name is known while a pass is written."""

    def __init__(self, writer, name):
        self.writer, self.name = writer, name

    def __and__(self, other):
        return self.writer.op("and", self, other)

    def __or__(self, other):
        return self.writer.op("or", self, other)

    def __xor__(self, other):
        return self.writer.op("xor", self, other)

    def __add__(self, other):
        return self.writer.op("add", self, other)

    __rand__, __ror__, __rxor__ = __and__, __or__, __xor__

    def __lshift__(self, bits):
        return self.writer.op("shl", self, bits)

    def __rshift__(self, bits):
        return self.writer.op("lshr", self, bits)

    def __invert__(self):
        return self ^ FULL


class Streams:
    """The words that a pass reads, by number; each is loaded when it is first asked for.

    pairs: whether a stream's words are taken two by two, each read as (even, odd).
    """

    def __init__(self, writer, pairs):
        self._writer, self._pairs, self._known = writer, pairs, {}

    def __getitem__(self, number):
        if number not in self._known:
            self._known[number] = self._pair(number) if self._pairs else self._writer.load(number, "%i")
        return self._known[number]

    def _pair(self, number):
        writer = self._writer
        first = writer.new("shl i64 %i, 1")
        halves = writer.load(number, first), writer.load(number, writer.new(f"add i64 {first}, {writer.lanes}"))
        return tuple(writer.dealt(*halves, odd) for odd in (0, 1))


class _Writer:
    """Writes a pass, a line after the other; what was worked out before is not worked out again."""

    def __init__(self, lanes):
        self.lanes, self.kind = lanes, f"<{lanes} x i64>"
        self.head, self.lines, self._known = [], [], {}

    def new(self, text):
        if text not in self._known:
            self._known[text] = f"%v{len(self._known)}"
            self.lines.append(f"  {self._known[text]} = {text}")
        return self._known[text]

    def op(self, op, x, y):
        x, y = self._value(x), self._value(y)
        if op not in ("shl", "lshr") and y < x:
            x, y = y, x
        return Word(self, self.new(f"{op} {self.kind} {x}, {y}"))

    def _value(self, word):
        if isinstance(word, Word):
            return word.name
        signed = word - 2**64 if word >= 2**63 else word
        return "<" + ", ".join([f"i64 {signed}"] * self.lanes) + ">"

    def dealt(self, low, high, odd):
        places = ", ".join(f"i32 {2 * lane + odd}" for lane in range(self.lanes))
        both = f"{self.kind} {low.name}, {self.kind} {high.name}"
        return Word(self, self.new(f"shufflevector {both}, <{self.lanes} x i32> <{places}>"))

    def load(self, stream, index):
        return Word(self, self.new(f"load {self.kind}, ptr {self._place(stream, index)}, align 4"))

    def store(self, word, stream):
        self.lines.append(f"  store {self.kind} {self._value(word)}, ptr {self._place(stream, '%i')}, align 4")

    def _place(self, stream, index):
        line = f"  %s{stream} = load ptr, ptr %t{stream}"
        if line not in self.head:
            self.head += [f"  %t{stream} = getelementptr i64, ptr %at, i64 {stream}", line]
        return self.new(f"getelementptr i64, ptr %s{stream}, i64 {index}")

    def text(self):
        return "\n".join(
            [
                f"define void @{NAME}(i64 %at_, i64 %size) nounwind {{",
                "entry:",
                "  %at = inttoptr i64 %at_ to ptr",
                *self.head,
                "  br label %top",
                "top:",
                "  %i = phi i64 [0, %entry], [%next, %top]",
                *self.lines,
                f"  %next = add i64 %i, {self.lanes}",
                "  %more = icmp ult i64 %next, %size",
                "  br i1 %more, label %top, label %end",
                "end:",
                "  ret void",
                "}",
            ]
        )


def word_pass(function, reads, pairs=False):
    """Return (MachineCode, how many words it writes) of a function that makes a list of words of so many Streams."""
    writer = _Writer(lanes())
    words = function(Streams(writer, pairs))
    for number, word in enumerate(words):
        writer.store(word, reads + number)
    return MachineCode(compiled(writer.text()), NAME), len(words)


def transposed(words):
    """Return eight words as those whose byte b of word r holds bit 8b + r of each of them, the first one lowest.

    So are the bits of 64 numbers made bytes. Source: Warren, Hacker's Delight, section 7-3.
    """
    words = list(words)
    for step, mask in ((4, 0x0F0F0F0F0F0F0F0F), (2, 0x3333333333333333), (1, 0x5555555555555555)):
        for low in (each for each in range(8) if not each & step):
            swapped = ((words[low] >> step) ^ words[low + step]) & mask
            words[low] = words[low] ^ (swapped << step)
            words[low + step] = words[low + step] ^ swapped
    return words
