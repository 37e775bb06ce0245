"""Dispatch: a pass that looks which materials there are in each run of words, and calls a pass made for these.

Where few materials are together most gates of a large rule can be left out: of alchemy's 3,144 water alone needs 35.
The function is called as every pass is, see `vector_ir`; its `chances` are words as `DispatchTable` has them.
"""

import numpy as np

from game.core.compiler.ir_text import IrText
from game.core.compiler.vector_ir import ARGUMENTS

NAME = "sandglass_dispatch"
RUN = 16  # words that one pass is chosen for
MOST = 64  # passes to choose from
NOTHING = 255  # the number of no pass: nothing can happen among these materials
_LISTED = 2  # words before the list of passes


def source(bits, codes, lanes):
    """Return the text of the dispatch for `codes` codes of so many bits, without payload, and so many `lanes`."""
    return _Dispatch(bits, codes, lanes).text()


def eventful(table):
    """Return which sets of codes, (2**codes,) bool, a bit for each code, have an event among them."""
    found = np.zeros(2**table.codes, bool)
    shifts = table.bits * np.arange(4)
    for layer in table.layers:
        for claim in layer:
            codes = claim.states[:, None].astype(np.int64) >> shifts & (2**table.bits - 1)
            found[np.bitwise_or.reduce(1 << codes, axis=1)] = True
    for bit in range(table.codes):
        halves = found.reshape(-1, 2, 2**bit)
        halves[:, 1] |= halves[:, 0]
    return found


def cheapest(sets, costs, eventful):
    """Return the number of the cheapest pass for each set of codes, (2**codes,) uint8, NOTHING where none is needed.

    sets, costs: of each pass, the codes it knows as bits of a number, and its gates; the first one knows all codes.
    """
    keys = np.array(costs, np.uint32) << 8 | np.arange(len(costs), dtype=np.uint32)  # cost, then number
    best = np.full(len(eventful), keys[0])
    for known, key in zip(sets[1:], keys[1:], strict=True):
        best[known] = min(best[known], key)
    for bit in range(len(eventful).bit_length() - 1):  # what knows a code more will do
        halves = best.reshape(-1, 2, 2**bit)
        np.minimum(halves[:, 0], halves[:, 1], out=halves[:, 0])
    best[~eventful] = NOTHING
    return best.astype(np.uint8)


class DispatchTable:
    """What a dispatch reads and counts; `words` are good as long as this lives and what the addresses lead to."""

    def __init__(self, numbers, tally, passes):
        """numbers: see `cheapest`. tally: (2**codes,) uint32, the runs with each set. passes: (address, chances)s."""
        self._kept = numbers, tally, passes
        listed = [value for address, chances in passes for value in (address, chances.ctypes.data)]
        self.words = np.array([numbers.ctypes.data, tally.ctypes.data, *listed], np.uint64)


class _Dispatch(IrText):
    """Writes the function."""

    def __init__(self, bits, codes, lanes):
        super().__init__(lanes)
        self._bits, self._codes = bits, codes

    def text(self):
        self.head(NAME, ARGUMENTS)
        self.pointers("words", "at", "chances")
        places = [self.load_word("%at", number) for number in range(4 * self._bits)]
        streams = [self.new(f"getelementptr i64, ptr %words, i64 {place}") for place in places]
        tables = [self.new(f"inttoptr i64 {self.load_word('%chances', number)} to ptr") for number in range(_LISTED)]
        self.line("br label %top")
        self._next_run()
        self._hand_over(*tables, self._set(streams))
        self._end()
        return self.whole()

    def _next_run(self):
        self.start("top")
        self.line("%first = phi i64 [0, %entry], [%beyond, %again]")
        self.line("%told = phi i64 [0, %entry], [%told_then, %again]")
        self.line("%left = sub i64 %size_, %first")
        self.line(f"%few = icmp ult i64 %left, {RUN}")
        self.line(f"%here = select i1 %few, i64 %left, i64 {RUN}")
        self.line("%beyond = add i64 %first, %here")
        self.line("br label %look")

    def _set(self, streams):
        """Write the loop that looks at a run; return the set of its codes, a word."""
        self.start("look")
        self.line("%i = phi i64 [%first, %top], [%next, %look]")
        names = [f"%seen{code}" for code in range(self._codes)]
        seen = [self.meeting(name, [("zeroinitializer", "top"), (f"{name}_then", "look")]) for name in names]
        loaded = [self.load(stream, "%i") for stream in streams]
        for corner in range(4):
            held = self._decoded(loaded[corner * self._bits : (corner + 1) * self._bits])
            seen = [self.op("or", before, here) for before, here in zip(seen, held, strict=True)]
        for name, value in zip(names, seen, strict=True):
            self.line(f"{name}_then = or {self.kind} {value}, zeroinitializer")
        self.line(f"%next = add i64 %i, {self.lanes}")
        self.line("%more = icmp ult i64 %next, %beyond")
        self.line("br i1 %more, label %look, label %seen")
        self.start("seen")
        found = "0"
        for code, name in enumerate(names):
            flag = self.new(f"zext i1 {self.any_bit(f'{name}_then')} to i64")
            found = self.new(f"or i64 {found}, {self.new(f'shl i64 {flag}, {code}')}")
        return found

    def _decoded(self, bits):
        """Write where a corner has each code; bits: its code's, the lowest first."""
        held = [None]
        for bit in bits:
            off = self.inverse(bit)
            held = [way if before is None else self.op("and", before, way) for way in (off, bit) for before in held]
        return held[: self._codes]

    def _hand_over(self, numbers, tally, found):
        """Write the call of the pass for a set of codes."""
        place = self.new(f"getelementptr i32, ptr {tally}, i64 {found}")
        more = self.new(f"add i32 {self.new(f'load i32, ptr {place}')}, 1")
        self.line(f"store i32 {more}, ptr {place}")
        number = self.new(f"load i8, ptr {self.new(f'getelementptr i8, ptr {numbers}, i64 {found}')}")
        nothing = self.new(f"icmp eq i8 {number}, {NOTHING - 256}")
        self.line(f"br i1 {nothing}, label %again, label %call")
        self.start("call")
        twice = self.new(f"shl i64 {self.new(f'zext i8 {number} to i64')}, 1")
        slot = self.new(f"add i64 {twice}, {_LISTED}")
        address = self.new(f"inttoptr i64 {self.load_word('%chances', slot)} to ptr")
        chances = self.load_word("%chances", self.new(f"add i64 {slot}, 1"))
        octets = self.new("shl i64 %first, 3")
        words, may, origin = (self.new(f"add i64 %{name}_, {octets}") for name in ("words", "may", "origin"))
        handed = ", ".join(f"i64 {each}" for each in (words, "%at_", may, origin, "%key_", chances, "%here"))
        told = self.new(f"call i64 {address}({handed})")
        self.line(f"%told_now = or i64 %told, {told}")
        self.line("br label %again")

    def _end(self):
        self.start("again")
        self.line("%told_then = phi i64 [%told, %seen], [%told_now, %call]")
        self.line("%more_runs = icmp ult i64 %beyond, %size_")
        self.line("br i1 %more_runs, label %top, label %end")
        self.start("end")
        self.line("ret i64 %told_then")
