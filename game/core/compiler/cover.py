"""Covers: gates for a set of block states, as simple as the states that do not matter allow.

What a picture matches is, nearly always, a class of codes at each corner and a relation between some pairs of them.
That is found again here from the states alone; a set that is nothing of the kind is split bit by bit.
"""

from itertools import combinations

import numpy as np

from game.core.compiler.circuit import FALSE, TRUE

PAIRS = tuple(combinations(range(4), 2))


class Covers:
    """Makes literals of sets of block states in a circuit; its first inputs are the bits of the corners' codes."""

    def __init__(self, circuit, bits):
        self.circuit, self.bits = circuit, bits
        self._known = {}

    def bit(self, corner, number):
        """Return the literal of a bit of a corner's code."""
        return self.circuit.input(corner * self.bits + number)

    def cover(self, wanted, unwanted):
        """Return a literal that is true on the states `wanted` and false on those `unwanted`, both (states,) bool."""
        key = wanted.tobytes(), unwanted.tobytes()
        if key not in self._known:
            self._known[key] = self._cover(wanted, unwanted)
        return self._known[key]

    def _cover(self, wanted, unwanted):
        side = (2**self.bits,) * 4
        wanted, unwanted = wanted.reshape(side), unwanted.reshape(side)
        parts = _parts(wanted, unwanted)
        if parts is None:
            return self._split(wanted.ravel(), unwanted.ravel(), range(4))
        result = TRUE
        for part in sorted(parts):
            others = {each: shadow for each, shadow in parts.items() if each != part}
            literal = self._part(part, wanted, _product(others, unwanted))
            parts[part] = self._holds(literal)
            result = self.circuit.and_(result, literal)
        return result

    def _part(self, part, wanted, unwanted):
        """Return a literal on one corner or two, true for what `wanted` shows of them, and false for unwanted."""
        axes = tuple(3 - corner for corner in range(4) if corner not in part)
        wanted, unwanted = (states.any(axis=axes).ravel() for states in (wanted, unwanted))
        key = part, wanted.tobytes(), unwanted.tobytes()
        if key not in self._known:
            self._known[key] = self._split(wanted, unwanted, part)
        return self._known[key]

    def _holds(self, literal):
        """Return the states, indexed d c b a, for which a literal is true."""
        states = np.unpackbits(self.circuit.table(literal).view(np.uint8), bitorder="little")
        return states[: 2 ** (4 * self.bits)].astype(bool).reshape((2**self.bits,) * 4)

    def _split(self, wanted, unwanted, corners):
        """Return the literal of a set of states of some corners, split bit by bit, in the cheapest order tried."""
        orders = []
        for numbers in (range(self.bits), range(self.bits)[::-1]):
            orders.append([(corner, number) for number in numbers for corner in corners])
            if len(corners) > 1:
                orders.append([(corner, number) for corner in corners for number in numbers])
        places = [(corner, number) for corner in corners for number in range(self.bits)]
        builders = []
        for order in orders:
            axes = [len(places) - 1 - places.index(each) for each in order]
            sets = [_number(flags.reshape((2,) * len(places)).transpose(axes)) for flags in (wanted, unwanted)]
            literals = [self.bit(*each) for each in order]
            builders.append(lambda sets=sets, literals=literals: self._decide(*sets, literals, {}))
        return self.circuit.cheapest(builders)

    def _decide(self, wanted, unwanted, literals, known):
        """Return the literal of a set of states, numbered with the first of `literals` as their highest bit.

        Sets of states are ints here, whose bit i is state i.
        """
        if not wanted:
            return FALSE
        if not unwanted:
            return TRUE
        key = wanted, unwanted, len(literals)
        if key not in known:
            half, rest = 2 ** (len(literals) - 1), literals[1:]
            low = [each & ((1 << half) - 1) for each in (wanted, unwanted)]
            high = [each >> half for each in (wanted, unwanted)]
            either = [one | other for one, other in zip(low, high, strict=True)]
            if not either[0] & either[1]:
                known[key] = self._decide(*either, rest, known)
            else:
                high, low = self._decide(*high, rest, known), self._decide(*low, rest, known)
                known[key] = self.circuit.choice(literals[0], high, low)
        return known[key]


def _parts(wanted, unwanted):
    """Return {corners: what states show of them} that together tell wanted and unwanted apart, or None."""
    parts = {(corner,): _shadow(wanted, (corner,)) for corner in range(4)}
    pairs = {}
    while (inside := _product(parts, unwanted)).any():
        pairs = pairs or {pair: _shadow(wanted, pair) for pair in PAIRS}
        left = {pair: np.count_nonzero(inside & shadow) for pair, shadow in pairs.items() if pair not in parts}
        best = min(left, key=left.get, default=None)
        if best is None or left[best] == np.count_nonzero(inside):
            return None
        parts[best] = pairs[best]
    for part in sorted(parts, key=len):
        others = {each: shadow for each, shadow in parts.items() if each != part}
        if not _product(others, unwanted).any():
            parts = others
    return parts


def _number(flags):
    """Return bool flags as the bits of an int, the first flag lowest."""
    return int.from_bytes(np.packbits(flags.ravel(), bitorder="little").tobytes(), "little")


def _shadow(states, corners):
    """Return all states that agree with one of `states`, indexed d c b a, at some corners; broadcastable."""
    return states.any(axis=tuple(3 - corner for corner in range(4) if corner not in corners), keepdims=True)


def _product(parts, states):
    """Return which of the states, indexed d c b a, agree with every part."""
    for shadow in parts.values():
        states = states & shadow
    return states
