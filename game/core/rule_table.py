"""A rule as the kernels take it: what every block state does, with no names of materials and no pictures.

A cell is a code of `bits` bits, below `codes`; code 0 is empty. The state of a block with the corners a b over c d is

    a | b << bits | c << 2·bits | d << 3·bits

Its layers are tried in order until one changes the block. In a layer at most one claim holds a state; the block's
number u of that layer decides which of the claim's outcomes happens, if any. Outcome i happens where

    T(i - 1) <= u < T(i),   T(i) = min(2**32, round(2**32 · (p of outcome 0 + … + p of outcome i))),   T(-1) = 0

with the sum taken by `math.fsum`. So an outcome that leaves the block as it is ends the trying of layers, too. All
layers look at the block as it was.

**Numbers.** u has 32 bits, the highest drawn first: draw n is bit `lane` of

    mix(key + (place · 32 + n) · 0x9E3779B97F4A7C15 + layer · LAYER_STEP)        mod 2**64

with mix and key as in `game.core.chance`. The fair bit of a block, one for all layers, is bit `lane` of
mix(key + place · 32 · 0x9E3779B97F4A7C15 + FAIR_STEP).

**Places.** A block's upper left corner is the cell (y, x), y and x >= -1: what is outside of the lattice holds the code
`outside` on all four sides, and every cell is in a block in every iteration. row = y // 2 and column = x // 2, rounded
down, so -1 // 2 = -1. A row of blocks is dealt out to words = ceil(ceil(width / 2) / 64) words in turn:

    lane, word = divmod(column, words), but for the column -1 lane = 0 and word = -1
    place = row · (words + 1) + word
"""

from dataclasses import dataclass, replace
from functools import cached_property
from hashlib import sha256

import numpy as np

LAYER_STEP = 0xD1B54A32D192ED03
FAIR_STEP = 0x8CB92BA72F3D8DD7
CERTAIN = -1  # the slot of what happens without chance

_BITS = range(2, 5)
_EDGES = ((0, 1), (2, 3), (0, 2), (1, 3))  # the corners of a block's rows and columns


@dataclass(frozen=True, eq=False)
class Outcome:
    """What a claim may come to."""

    slot: int  # place of its probability among those of the rule, or CERTAIN
    after: np.ndarray  # (n,) uint16: the block after, for each state of the claim


@dataclass(frozen=True, eq=False)
class Claim:
    """The block states that one picture, in one orientation, has to itself in its layer.

    Where a picture and its mirror image both match a state the fair bit decides: one of them claims it on the face 0,
    the other on the face 1. A picture that has some states to itself and others on one face makes a claim for either.
    """

    event: int  # number of the event in the file, for messages and order
    states: np.ndarray  # (n,) uint16, rising
    outcomes: tuple[Outcome, ...]  # in the order of their thresholds; at least one
    face: int | None = None  # the value of the fair bit with which it holds; None if with either


@dataclass(frozen=True, eq=False)
class RuleTable:
    """A rule. Compared by identity: a rule that was read once is compiled once.

    The claims of a layer are in the order of the file. No two hold one state on one face. Fewer gates come of claims
    whose states, with those that earlier claims of the layer hold thrown in, are all that a picture matches.

    Raises ValueError for claims that break the contract; what may lie outside of the lattice may not change, which is
    two cells of the code outside that are a row or a column of a block.
    """

    bits: int  # of a cell: 2, 3 or 4
    codes: int  # codes in use, 0 … codes - 1; states with others never occur
    outside: int  # code of what is outside of the lattice
    slots: tuple[str, ...]  # the names of the probabilities, for messages
    layers: tuple[tuple[Claim, ...], ...]
    among: tuple[int, ...] | None = None  # the codes that occur, if not all in use do

    def __post_init__(self):
        if self.bits not in _BITS:
            raise ValueError(f"a cell has 2, 3 or 4 bits, got {self.bits}")
        if not 0 <= self.outside < self.codes <= 2**self.bits:
            raise ValueError(f"codes of {self.bits} bits, with {self.outside} outside, got {self.codes}")
        for number, layer in enumerate(self.layers):
            held = np.zeros((2, self.states), bool)
            for claim in layer:
                _check_claim(self, claim)
                for face in (0, 1) if claim.face is None else (claim.face,):
                    if held[face, claim.states].any():
                        raise ValueError(f"layer {number}: event {claim.event} claims a state that is claimed already")
                    held[face, claim.states] = True

    @property
    def states(self):
        """The number of block states."""
        return 2 ** (4 * self.bits)

    @cached_property
    def digest(self):
        """Hex digits that name all that the table says, but for the names of the probabilities."""
        among = "" if self.among is None else f" {self.among}"
        digest = sha256(f"{self.bits} {self.codes} {self.outside}{among}".encode())
        for number, layer in enumerate(self.layers):
            for claim in layer:
                digest.update(f"\n{number} {claim.face} {claim.event} ".encode() + claim.states.tobytes())
                for outcome in claim.outcomes:
                    digest.update(f" {outcome.slot} ".encode() + outcome.after.tobytes())
        return digest.hexdigest()

    @property
    def used_states(self):
        """The block states of codes that occur, rising."""
        states = np.arange(self.states)
        return states[_all_among(states, self.bits, range(self.codes) if self.among is None else self.among)]

    @property
    def claimed_states(self):
        """The block states that some claim holds, rising."""
        claimed = np.zeros(self.states, bool)
        for layer in self.layers:
            for claim in layer:
                claimed[claim.states] = True
        return np.flatnonzero(claimed)

    @property
    def has_fair_bit(self):
        """Whether a fair bit decides about any state."""
        return any(claim.face is not None for layer in self.layers for claim in layer)

    def narrowed(self, codes):
        """Return the RuleTable of the same rule for lattices, or parts of them, that hold some of the codes only."""
        layers = tuple(
            tuple(
                Claim(
                    claim.event,
                    claim.states[held],
                    tuple(replace(outcome, after=outcome.after[held]) for outcome in claim.outcomes),
                    claim.face,
                )
                for claim in layer
                if (held := _all_among(claim.states, self.bits, codes)).any()
            )
            for layer in self.layers
        )
        return replace(self, layers=layers, among=tuple(sorted(codes)))


def corners(states, bits):
    """Return the codes of the corners a b c d of block states, four arrays."""
    return [(np.asarray(states) >> (bits * corner)) & (2**bits - 1) for corner in range(4)]


def state_of(codes, bits):
    """Return the block state with these codes at the corners a b c d."""
    return sum(code << (bits * corner) for corner, code in enumerate(codes))


def _all_among(states, bits, codes):
    """Return which block states have nothing but some codes at their corners."""
    among = np.zeros(2**bits, bool)
    among[list(codes)] = True
    return np.all([among[each] for each in corners(states, bits)], axis=0)


def _check_claim(table, claim):
    """Raise ValueError unless a claim's states rise, have codes in use, and its outcomes leave the outside alone."""
    where = f"event {claim.event}"
    if not claim.outcomes or claim.face not in (None, 0, 1):
        raise ValueError(f"{where}: a claim has an outcome, and the face None, 0 or 1")
    if len(claim.states) == 0 or (np.diff(claim.states.astype(np.int64)) <= 0).any():
        raise ValueError(f"{where}: the states of a claim rise, and there is one")
    for outcome in claim.outcomes:
        if not CERTAIN <= outcome.slot < len(table.slots):
            raise ValueError(f"{where}: slot {outcome.slot} of {len(table.slots)}")
        if outcome.after.shape != claim.states.shape:
            raise ValueError(f"{where}: {len(outcome.after)} blocks after {len(claim.states)}")
        _check_cells(table, corners(claim.states, table.bits), corners(outcome.after, table.bits), where)


def _check_cells(table, before, after, where):
    """Raise ValueError unless the codes at the corners, four arrays each, are in use and what is outside stays."""
    if any((codes >= table.codes).any() for codes in (*before, *after)):
        raise ValueError(f"{where}: codes are below {table.codes}")
    outside = [codes == table.outside for codes in before]
    if np.all(outside, axis=0).any():
        raise ValueError(f"{where}: a block of nothing but the outside, code {table.outside}, has no event")
    for first, second in _EDGES:
        at_border = outside[first] & outside[second]
        if any((after[corner][at_border] != table.outside).any() for corner in (first, second)):
            raise ValueError(f"{where}: a row or column of a block that may be outside, code {table.outside}, changes")
