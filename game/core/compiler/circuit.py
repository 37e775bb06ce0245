"""Circuits: networks of two-input gates in which gates that do the same are one.

A circuit's inputs are the bits of a block's state, and its fair bit if the rule has one. There are few enough states to
know what a gate yields for each of them, a truth table; gates with equal tables, on the states that matter, are shared.

A literal is 2 · node + (1 if inverted). Node 0 is false, nodes 1 … are the inputs, the others are gates.
"""

from typing import NamedTuple

import numpy as np

FALSE, TRUE = 0, 1


class Gate(NamedTuple):
    """What a node is made of."""

    op: str  # "and" or "xor"
    x: int  # literals, the smaller first
    y: int


class Circuit:
    """Gates over so many inputs; what they yield for a state matters where `care`, (2**inputs,) bool, says so."""

    def __init__(self, inputs, care):
        self.inputs = inputs
        self.care = packed(care)
        states = np.arange(2**inputs, dtype=np.uint32)
        first = int(np.argmax(care))
        self._place, self._bit = first // 64, np.uint64(first % 64)
        self.gates, self._tables, self._keys, self._literals = [], [], [], {}
        self._add(None, np.zeros_like(self.care))
        for each in range(inputs):
            self._add(None, packed((states >> np.uint32(each)) & 1 == 1) & self.care)
        self._made = {}  # literal of each Gate asked for

    def input(self, number):
        """Return the literal of an input."""
        return 2 * (1 + number)

    def table(self, literal):
        """Return a literal's truth table, packed."""
        table = self._tables[literal >> 1]
        return ~table & self.care if literal & 1 else table

    def meet(self, x, y):
        """Return whether two literals are both true for some state."""
        return bool((self.table(x) & self.table(y)).any())

    def and_(self, x, y):
        """Return the literal of x and y."""
        if FALSE in (x, y) or x == y ^ 1:
            return FALSE
        if x in (TRUE, y):
            return y
        return x if y == TRUE else self._gate(Gate("and", min(x, y), max(x, y)))

    def or_(self, x, y):
        """Return the literal of x or y."""
        return self.and_(x ^ 1, y ^ 1) ^ 1

    def xor(self, x, y):
        """Return the literal of x or y but not both."""
        inverted, x, y = (x ^ y) & 1, x & ~1, y & ~1
        if x == y:
            return FALSE ^ inverted
        if FALSE in (x, y):
            return (x | y) ^ inverted
        return self._gate(Gate("xor", min(x, y), max(x, y))) ^ inverted

    def all(self, literals):
        """Return the literal of all of them."""
        result = TRUE
        for each in literals:
            result = self.and_(result, each)
        return result

    def any(self, literals):
        """Return the literal of any of them."""
        return self.all(each ^ 1 for each in literals) ^ 1

    def choice(self, which, high, low):
        """Return the literal of `high` where `which` is true, else `low`."""
        if high == TRUE:
            return self.or_(which, low)
        if high == FALSE:
            return self.and_(which ^ 1, low)
        if low == TRUE:
            return self.or_(which ^ 1, high)
        return self.xor(low, self.and_(which, self.xor(high, low)))

    def cheapest(self, builders):
        """Return the literal of the builder that adds the fewest gates."""
        costs = []
        for build in builders:
            gates, made = len(self.gates), len(self._made)
            build()
            costs.append(len(self.gates) - gates)
            self._forget(gates, made)
        return builders[costs.index(min(costs))]()

    def cone(self, literals):
        """Return the gates that the literals need, in the order in which they were made: so few values are alive."""
        needed, stack = set(), [literal >> 1 for literal in literals]
        while stack:
            node = stack.pop()
            if node not in needed and node > self.inputs:
                needed.add(node)
                stack += [self.gates[node].x >> 1, self.gates[node].y >> 1]
        return sorted(needed)

    def uses(self, literals, number):
        """Return whether the literals depend on an input, as they are made."""
        node = 1 + number
        gates = (self.gates[each] for each in self.cone(literals))
        return any(literal >> 1 == node for literal in literals) or any(node in (x >> 1, y >> 1) for _, x, y in gates)

    def _gate(self, gate):
        if gate not in self._made:
            x, y = self.table(gate.x), self.table(gate.y)
            self._made[gate] = self._shared(gate, x & y if gate.op == "and" else x ^ y)
        return self._made[gate]

    def _shared(self, gate, table):
        """Return the literal of a table: that of a gate there is, be it inverted, or of a new one."""
        key, inverted = self._key(table)
        if key not in self._literals:
            self._add(gate, table)
        return self._literals[key] ^ inverted

    def _add(self, gate, table):
        key, inverted = self._key(table)
        self._literals.setdefault(key, 2 * len(self.gates) ^ inverted)
        self.gates.append(gate)
        self._tables.append(table)
        self._keys.append(key)

    def _key(self, table):
        """Return what a table and its inverse have in common, and whether this one is the inverse."""
        inverted = int(table[self._place] >> self._bit & 1)
        return (~table & self.care if inverted else table).tobytes(), inverted

    def _forget(self, gates, made):
        """Undo what came after so many gates and so many answers."""
        for key in self._keys[gates:]:
            del self._literals[key]
        while len(self._made) > made:
            self._made.popitem()
        del self.gates[gates:], self._tables[gates:], self._keys[gates:]


def packed(flags):
    """Return bool flags as the bits of uint64 words, the first flag lowest."""
    octets = np.zeros(-(-len(flags) // 64) * 8, np.uint8)
    bits = np.packbits(flags, bitorder="little")
    octets[: len(bits)] = bits
    return octets.view(np.uint64)
