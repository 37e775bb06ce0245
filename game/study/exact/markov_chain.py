"""The Markov chain of the rule on a small lattice: every state within reach and the probability of every move.

Plain Python and numpy. It shares nothing with the kernels that it checks. A state is an int whose bit y·W + x is
set where cell (x, y) holds sand; walls never change and are left out of it. The blocks of one partition are independent
given the state, so an iteration's successors are the product of what its blocks can do.
"""

from dataclasses import dataclass
from itertools import product

import numpy as np

KINDS = (
    "topple_left",
    "topple_right",
    "fall_pair",
    "fall_low_left",
    "fall_low_right",
    "fall_full_left",
    "fall_full_right",
)
CERTAIN = None  # a lone grain always falls
SCHEDULES = {  # offsets (x, y) of the blocks, iteration by iteration, repeated
    "margolus": ((0, 0), (1, 1)),
    "paper": ((0, 0), (1, 1), (0, 1), (1, 0)),
    "balanced": ((0, 0), (1, 1), (1, 0), (0, 1)),
}
TALLY_BITS = 8  # bits of a tally for each kind: no more than 16 blocks fit into 64 cells

# Corners a b / c d before and after, and what decides it: '#' is sand or wall and stays, 'w' a wall, 'o' sand.
PICTURES = (
    ("o. ..", ".. o.", CERTAIN),
    (".o ..", ".. .o", CERTAIN),
    ("oo ..", ".. oo", "fall_pair"),
    ("ow ..", ".w o.", "fall_pair"),
    ("wo ..", "w. .o", "fall_pair"),
    ("o. .#", ".. o#", "fall_low_left"),
    (".o #.", ".. #o", "fall_low_right"),
    ("o# .#", ".# o#", "fall_full_left"),
    ("#o #.", "#. #o", "fall_full_right"),
    ("o. #.", ".. #o", "topple_right"),
    (".o .#", ".. o#", "topple_left"),
)


def _events():
    """Return {corners before: (indices of the corners that change, kind)}, each '#' being sand or wall."""
    found = {}
    for before, after, kind in PICTURES:
        before, after = before.replace(" ", ""), after.replace(" ", "")
        changed = tuple(i for i in range(4) if before[i] != after[i])
        for stands in product("ow", repeat=before.count("#")):
            each = iter(stands)
            corners = "".join(next(each) if corner == "#" else corner for corner in before)
            found[corners] = changed, kind
    return found


EVENTS = _events()


@dataclass(frozen=True)
class Moves:
    """Every possible move of one partition: n ways from states to states, by index."""

    source: np.ndarray  # (n,) int
    target: np.ndarray  # (n,) int
    happened: np.ndarray  # (n, 7) int: how many events of each kind took place
    failed: np.ndarray  # (n, 7) int: how many could have and did not

    def weights(self, probabilities):
        """Return the probability of each move, (n,) float64, for seven probabilities."""
        p = np.asarray(probabilities, np.float64)
        return (p**self.happened * (1.0 - p) ** self.failed).prod(axis=1)


@dataclass(frozen=True)
class Chain:
    """The Markov chain of a lattice and a schedule: the states within reach, the first one first, and their moves."""

    states: np.ndarray  # (S,) uint64
    moves: tuple  # Moves, one for each offset of the schedule

    def distributions(self, probabilities, iterations):
        """Yield the (S,) float64 distribution over the states after 1, 2, … `iterations` iterations.

        Sums of float64 products: good to some 1e-14.
        """
        weights = [moves.weights(probabilities) for moves in self.moves]
        chances = np.zeros(len(self.states))
        chances[0] = 1.0
        for iteration in range(iterations):
            phase = iteration % len(self.moves)
            moves = self.moves[phase]
            flow = chances[moves.source] * weights[phase]
            chances = np.bincount(moves.target, flow, len(self.states))
            yield chances


def explore(rows, offsets):
    """Return the Chain of a lattice drawn as rows of '.', 'o' and '#', for a schedule of offsets (x, y)."""
    start = sum(1 << place for place, cell in enumerate("".join(rows)) if cell == "o")
    partitions = [_partition(rows, x, y) for x, y in offsets]
    index, todo = {start: 0}, [(start, 0)]
    seen, ways = {(start, 0)}, [[] for _ in offsets]
    while todo:
        state, phase = todo.pop()
        after = (phase + 1) % len(offsets)
        for target, happened, failed in _successors(state, partitions[phase]):
            ways[phase].append((index[state], index.setdefault(target, len(index)), happened, failed))
            if (target, after) not in seen:
                seen.add((target, after))
                todo.append((target, after))
    return Chain(np.array(list(index), np.uint64), tuple(map(_moves, ways)))


def _partition(rows, x, y):
    """Return (cells, what happens) for each block of the partition at (x, y).

    cells: the bits of the block's own cells. What happens: {state of these cells: (bits that change, kind)}.
    """
    height, width = len(rows), len(rows[0])

    def corner(column, row):
        """Return the cell's bit, 0 for a wall."""
        inside = 0 <= column < width and 0 <= row < height
        return 1 << (row * width + column) if inside and rows[row][column] != "#" else 0

    blocks = [
        [corner(column + right, row + down) for down in (0, 1) for right in (0, 1)]
        for row in range(-y, height, 2)
        for column in range(-x, width, 2)
    ]
    return [(sum(corners), _events_of(corners)) for corners in blocks]


def _events_of(corners):
    """Return {state of a block's cells: (bits that change, kind)} for four corners, each its cell's bit or 0."""
    found = {}
    for letters, (changed, kind) in EVENTS.items():
        if all((letter == "w") == (bit == 0) for letter, bit in zip(letters, corners, strict=True)):
            sand = sum(bit for letter, bit in zip(letters, corners, strict=True) if letter == "o")
            found[sand] = sum(corners[i] for i in changed), kind
    return found


def _successors(state, blocks):
    """Return [(state after, tally of what happened, tally of what did not)]: all ways one iteration can go."""
    ways = [(state, 0, 0)]
    for cells, events in blocks:
        event = events.get(state & cells)
        if event is None:
            continue
        change, kind = event
        if kind is CERTAIN:
            ways = [(after ^ change, happened, failed) for after, happened, failed in ways]
        else:
            one = 1 << TALLY_BITS * KINDS.index(kind)
            ways = [(after ^ change, happened + one, failed) for after, happened, failed in ways] + [
                (after, happened, failed + one) for after, happened, failed in ways
            ]
    return ways


def _moves(ways):
    source, target, happened, failed = np.array(ways, np.int64).reshape(-1, 4).T
    return Moves(source, target, _untallied(happened), _untallied(failed))


def _untallied(tallies):
    """Return how often each kind occurs in each tally, (n, 7) int."""
    return (tallies[:, None] >> TALLY_BITS * np.arange(len(KINDS))) & (2**TALLY_BITS - 1)
