"""A plan as LLVM IR with explicit vectors: a function that runs one iteration on the blocks of many words.

    i64 pass(words, at, may, origin, key, chances, size)

words: uint64, all planes. at: int64, where the words start of each bit at the corner a, then b c d; each corner's bits
of payload, which go where its content goes, follow the bits of its code. may: (size,) uint64, blocks that take part.
origin: (size,) uint64, which with `key` is where the draws of a word of blocks start. chances: see `chances_of`.
Returned are two bits: 1 if there was an event, or could have been one, 2 if an outcome was accepted.

The pass takes `lanes` words at a time; `may` and `origin` go up to a whole vector, and what is read beyond `size` is
written back as it was. A layer without an event in all those blocks is left early. Else random words are drawn until
no outcome is undecided; then what changes is stored. Where all that happens is certain, and nothing goes with it,
nothing is left early: to store what changes takes less time than a branch that was foretold wrongly.
"""

from itertools import pairwise

import numpy as np

from game.core.chance import DRAWS
from game.core.compiler.circuit import FALSE, TRUE
from game.core.compiler.ir_text import FULL, IrText
from game.core.rule_table import FAIR_STEP, LAYER_STEP

NAME = "sandglass_pass"
UNROLL = 2  # draws between two looks at whether any block is undecided

_GOLDEN = 0x9E3779B97F4A7C15
_MULTIPLIERS = (30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB)
_LAST_SHIFT = 31
ARGUMENTS = ("words", "at", "may", "origin", "key", "chances", "size")


def source(plan, lanes, payload=0):
    """Return the text of the pass of a Plan for so many `lanes` and bits of `payload`."""
    return _Pass(plan, lanes, payload).text()


def chances_of(plan, bound):
    """Return what a pass compares random bits with, (n,) uint64; bound(layer, slots): a threshold below 2**32.

    First come, for each layer, the draws that matter; then its masks, by draw and group, all ones where that binary
    digit of the group's threshold is 1.
    """
    draws, masks = [], []
    for number, layer in enumerate(plan.layers):
        bounds = np.array([bound(number, group.slots) for group in layer.groups], np.uint64)
        digits = bounds >> np.arange(DRAWS - 1, -1, -1, dtype=np.uint64)[:, None] & np.uint64(1)
        draws.append(int(digits.any(axis=1).nonzero()[0].max(initial=-1)) + 1)
        masks.append(np.where(digits == 1, np.uint64(FULL), np.uint64(0)).ravel())
    return np.concatenate([np.array(draws, np.uint64), *masks])


class _Pass(IrText):
    """Writes the function."""

    def __init__(self, plan, lanes, payload):
        super().__init__(lanes)
        self.plan, self.payload = plan, payload
        self.values = {}  # node -> (name, whether it holds the inverse)
        self.streams = []

    def text(self):
        self.head(NAME, ARGUMENTS)
        self._entry()
        self._loop()
        return self.whole()

    # --- gates ---

    def work_out(self, literals):
        """Write the gates that literals need and that are not there yet."""
        for node in self.plan.circuit.cone(literals):
            if node not in self.values:
                self.values[node] = self._gate(self.plan.circuit.gates[node])

    def _gate(self, gate):
        (x, x_inverted), (y, y_inverted) = (self._held(literal) for literal in gate[1:])
        if gate.op == "xor":
            return self.op("xor", x, y), x_inverted != y_inverted
        if x_inverted and y_inverted:
            return self.op("or", x, y), True
        if x_inverted:
            return self.op("and", y, self.inverse(x)), False
        return self.op("and", x, self.inverse(y) if y_inverted else y), False

    def _held(self, literal):
        name, inverted = self.values[literal >> 1]
        return name, inverted != bool(literal & 1)

    def literal(self, literal):
        if literal in (FALSE, TRUE):
            return self.constant(FULL if literal else 0)
        name, inverted = self._held(literal)
        return self.inverse(name) if inverted else name

    # --- the function ---

    def _entry(self):
        self.pointers("words", "at", "may", "origin", "chances")
        total = self.plan.bits + self.payload
        for number in range(4 * total):
            self.streams.append(self.new(f"getelementptr i64, ptr %words, i64 {self.load_word('%at', number)}"))
        self.key = self.all_lanes("%key_")
        self.line("br label %top")

    def _loop(self):
        self.start("top")
        self.line("%i = phi i64 [0, %entry], [%next, %again]")
        stirred = self.meeting("%stirred", [("zeroinitializer", "entry"), ("%stirred_then", "again")])
        moved = self.meeting("%moved", [("zeroinitializer", "entry"), ("%moved_then", "again")])
        for corner in range(4):
            for number in range(self.plan.bits):
                node = 1 + corner * self.plan.bits + number
                self.values[node] = self.load(self._stream(corner, number), "%i"), False
        free = self.load("%may", "%i")
        ways = []
        if self.plan.watch is not None:
            self.work_out([self.plan.watch])
            lively = self.any_bit(self.op("and", self.literal(self.plan.watch), free))
            self.line(f"br i1 {lively}, label %lively, label %again")
            ways.append((stirred, moved, self.block))
            self.start("lively")
        eventful = [number for number, layer in enumerate(self.plan.layers) if layer.event != FALSE]
        layer = self._certain_layer if self._is_quick(eventful) else self._layer
        for number in eventful:
            stirred, moved, free = layer(number, stirred, moved, free)
        self.line("br label %again")
        ways.append((stirred, moved, self.block))
        self.start("again")
        self.meeting("%stirred_then", [(value, label) for value, _, label in ways])
        self.meeting("%moved_then", [(value, label) for _, value, label in ways])
        self.line(f"%next = add i64 %i, {self.lanes}")
        self.line("%more = icmp ult i64 %next, %size_")
        self.line("br i1 %more, label %top, label %end")
        self.start("end")
        bits = [self.new(f"zext i1 {self.any_bit(each)} to i64") for each in ("%stirred_then", "%moved_then")]
        twice = self.new(f"shl i64 {bits[1]}, 1")
        self.line(f"ret i64 {self.new(f'or i64 {bits[0]}, {twice}')}")

    def _is_quick(self, eventful):
        """Return whether all that happens is certain, in one layer, and takes nothing with it."""
        layers = [self.plan.layers[number] for number in eventful]
        return len(layers) == 1 and layers[0].sure == [layers[0].event] and not self.payload

    def _stream(self, corner, number):
        return self.streams[corner * (self.plan.bits + self.payload) + number]

    def _layer(self, number, stirred, moved, free):
        """Write a layer; return what stirred and what moved so far, and which blocks are free for the next layer."""
        layer = self.plan.layers[number]
        self.work_out([layer.event])
        here = self.op("and", self.literal(layer.event), free)
        stirred = self.op("or", stirred, here)
        self.line(f"br i1 {self.any_bit(here)}, label %act{number}, label %done{number}")
        before, outer = self.block, dict(self.values)
        self.start(f"act{number}")
        accepted = self._decide(number, layer, free)
        self._act(number, layer, accepted)
        decided = self.any_of(accepted)
        moved_now = self.op("or", moved, decided)
        free_now = self.op("and", free, self.inverse(decided))
        after, self.values = self.block, outer
        self.line(f"br label %done{number}")
        self.start(f"done{number}")
        moved = self.meeting(f"%moved{number}", [(moved, before), (moved_now, after)])
        free = self.meeting(f"%free{number}", [(free, before), (free_now, after)])
        return stirred, moved, free

    def _certain_layer(self, number, stirred, _, free):
        """Write the only layer of a rule that has events, all of which happen."""
        layer = self.plan.layers[number]
        accepted = self._decide(number, layer, free)
        self._act(number, layer, accepted)
        stirred = self.op("or", stirred, accepted[0])
        return stirred, stirred, free  # what moved is what stirred

    # --- chance ---

    def _random(self, place):
        for shift, multiplier in _MULTIPLIERS:
            place = self.op("xor", place, self.op("lshr", place, self.constant(shift)))
            place = self.op("mul", place, self.constant(multiplier))
        return self.op("xor", place, self.op("lshr", place, self.constant(_LAST_SHIFT)))

    def _origin(self, step):
        place = self.op("add", self.load("%origin", "%i"), self.key)
        return self.op("add", place, self.constant(step)) if step else place

    def _decide(self, number, layer, free):
        """Write what decides; return, by level, the blocks in which the outcome or an earlier one happens."""
        wanted = [*layer.sure, *(group.blocks for group in layer.groups)]
        changes = [literal for level in (*layer.deltas, *layer.moves) for literal in level.values()]
        fair = self.plan.fair
        if fair is not None and self.plan.circuit.uses([*wanted, *changes], fair):
            self.values[1 + fair] = self._random(self._origin(FAIR_STEP)), False
        self.work_out(wanted)
        sure = [self.op("and", self.literal(each), free) for each in layer.sure]
        if not layer.groups:
            return sure
        blocks = [self.literal(group.blocks) for group in layer.groups]
        levels = range(len(layer.sure))
        own = [[at for at, group in enumerate(layer.groups) if group.level == level] for level in levels]
        undecided = [
            self.op("and", self.any_of([blocks[at] for at in own[level]]), free) if own[level] else self.constant(0)
            for level in levels
        ]
        return self._draw(number, layer, sure, undecided, blocks, own)

    def _draw(self, number, layer, sure, undecided, blocks, own):
        """Write the loop that draws for the undecided blocks."""
        before, loop, again, done = self.block, f"draw{number}", f"undrawn{number}", f"drawn{number}"
        starts = {"place": self._origin(number * LAYER_STEP)}
        for level, (yes, rest) in enumerate(zip(sure, undecided, strict=True)):
            starts |= {f"yes{level}": yes, f"rest{level}": rest}
        draws = self.load_word("%chances", number)
        first = len(self.plan.layers) + DRAWS * sum(len(each.groups) for each in self.plan.layers[:number])
        masks = self.new(f"getelementptr i64, ptr %chances, i64 {first}")
        self.line(f"br i1 {self.any_bit(self.any_of(undecided))}, label %{loop}, label %{done}")
        self.start(loop)
        self.line(f"%n{number} = phi i64 [0, %{before}], [%n{number}_next, %{again}]")
        ends = {name: f"%{name}_{number}_next" for name in starts}
        values = {
            name: self.meeting(f"%{name}_{number}", [(value, before), (ends[name], again)])
            for name, value in starts.items()
        }
        row = self.new(f"getelementptr i64, ptr {masks}, i64 {self.new(f'mul i64 %n{number}, {len(blocks)}')}")
        for name, value in self._compared(values, row, blocks, own).items():
            self.line(f"{ends[name]} = or {self.kind} {value}, zeroinitializer")
        self.line(f"%n{number}_next = add i64 %n{number}, {UNROLL}")
        # First whether draws are left, which is foretold right where few are needed, then whether any matters.
        more = self.new(f"icmp ult i64 %n{number}_next, {draws}")
        self.line(f"br i1 {more}, label %{again}, label %{done}")
        self.start(again)
        some = self.any_bit(self.any_of([end for name, end in ends.items() if name.startswith("rest")]))
        self.line(f"br i1 {some}, label %{loop}, label %{done}")
        self.start(done)
        return [
            self.meeting(
                f"%accepted{level}_{number}",
                [(yes, before), *((ends[f"yes{level}"], block) for block in (loop, again))],
            )
            for level, yes in enumerate(sure)
        ]

    def _compared(self, values, row, blocks, own):
        """Write UNROLL draws and what they decide; return the values after them: place, yes and rest by level."""
        values = dict(values)
        for turn in range(UNROLL):
            random = self._random(values["place"])
            values["place"] = self.op("add", values["place"], self.constant(_GOLDEN))
            for level, groups in enumerate(own):
                if groups:
                    rest, digit = values[f"rest{level}"], self._digit(row, turn * len(blocks), groups, blocks)
                    won = self.op("and", rest, self.op("and", digit, self.inverse(random)))
                    values[f"yes{level}"] = self.op("or", values[f"yes{level}"], won)
                    differ = self.op("xor", random, digit)
                    values[f"rest{level}"] = self.op("and", rest, self.inverse(differ))
        return values

    def _digit(self, row, first, groups, blocks):
        """Write the binary digit of each block's threshold."""
        masks = [self.all_lanes(self.load_word(row, first + at)) for at in groups]
        return self.any_of([self.op("and", blocks[at], mask) for at, mask in zip(groups, masks, strict=True)])

    # --- changes ---

    def _act(self, number, layer, accepted):
        """Write what the outcomes change, and the stores."""
        own = [accepted[0]]
        own += [self.op("and", now, self.inverse(before)) for before, now in pairwise(accepted)]
        self.work_out([literal for level in (*layer.deltas, *layer.moves) for literal in level.values()])
        for corner, bit in sorted({key for level in layer.deltas for key in level}):
            parts = [
                self.op("and", mine, self.literal(delta[corner, bit]))
                for mine, delta in zip(own, layer.deltas, strict=True)
                if (corner, bit) in delta
            ]
            stream = self._stream(corner, bit)
            # Layers before this one have stored what they changed, in other blocks of the same words.
            old = self.load(stream, "%i") if number else self.values[1 + corner * self.plan.bits + bit][0]
            self.store(self.op("xor", old, self.any_of(parts)), stream, "%i")
        if self.payload:
            self._carry(layer, own)

    def _carry(self, layer, own):
        """Write how the bits of payload follow what they belong to."""
        taken = {}
        for mine, moves in zip(own, layer.moves, strict=True):
            for move, literal in moves.items():
                taken.setdefault(move, []).append(self.op("and", mine, self.literal(literal)))
        taken = {move: self.any_of(parts) for move, parts in taken.items()}
        for bit in range(self.plan.bits, self.plan.bits + self.payload):
            old = {corner: self.load(self._stream(corner, bit), "%i") for corner in {*sum(taken, ())}}
            for corner in sorted({move[0] for move in taken}):
                new = old[corner]
                for (to, source), blocks in taken.items():
                    if to == corner:
                        new = self.op("xor", new, self.op("and", blocks, self.op("xor", old[corner], old[source])))
                self.store(new, self._stream(corner, bit), "%i")
