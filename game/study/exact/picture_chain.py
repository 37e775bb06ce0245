"""The Markov chain of a rule of pictures on a small lattice: the chance of every state, iteration by iteration.

Shares nothing with the kernels that it checks. A state is a number whose digits, to the base of the number of
materials, are the cells that hold no wall; walls never change. Blocks of a partition are independent given the state,
so an iteration is worked out block after block, on all states at once.
"""

from typing import NamedTuple

import numpy as np


class States(NamedTuple):
    """A distribution: states, each once, and how likely they are."""

    states: np.ndarray  # (n,) uint64
    chances: np.ndarray  # (n,) float64


class PictureChain:
    """A lattice drawn as rows of letters, under a PictureRule and a schedule of offsets (x, y)."""

    def __init__(self, rows, rule, offsets):
        self.rule, self.offsets, self.width = rule, offsets, len(rows[0])
        self.letters, self.claimed = "".join(rule.materials), set()  # names of the events that have come up
        self.cells = [place for place, letter in enumerate("".join(rows)) if letter != rule.wall]
        if len(self.letters) ** len(self.cells) > 2**64:
            raise ValueError(f"{len(self.cells)} cells of {len(self.letters)} materials have no number of 64 bits")
        self.walls = sum(1 << place for place, letter in enumerate("".join(rows)) if letter == rule.wall)
        self.worth = {place: len(self.letters) ** digit for digit, place in enumerate(self.cells)}
        self.partitions = [self._blocks(len(rows), x, y) for x, y in offsets]
        start = sum(self.worth[place] * self.letters.index("".join(rows)[place]) for place in self.cells)
        self.start = States(np.array([start], np.uint64), np.ones(1))

    def _blocks(self, height, x, y):
        """Return the blocks of the partition at (x, y): for each corner the worth of its cell, 0 for a wall."""

        def corner(column, row):
            inside = 0 <= column < self.width and 0 <= row < height
            return self.worth.get(row * self.width + column, 0) if inside else 0

        blocks = [
            [corner(column + right, row + down) for down in (0, 1) for right in (0, 1)]
            for row in range(-y, height, 2)
            for column in range(-x, self.width, 2)
        ]
        return [block for block in blocks if any(block)]

    def distributions(self, iterations, most_states):
        """Yield the States after 1, 2, … `iterations` iterations, as long as there are no more than `most_states`."""
        now = self.start
        for iteration in range(iterations):
            for block in self.partitions[iteration % len(self.partitions)]:
                now = _joined(*self._moved(now, block))
                if len(now.states) > most_states:
                    return
            yield now

    def _moved(self, now, block):
        """Return (states, chances) after whatever can happen in one block; states may occur more than once."""
        contents = self._contents(now.states, block)
        states, chances = [], []
        for content in np.unique(contents):
            here = np.flatnonzero(contents == content)
            letters = self._letters(int(content), block)
            fate = self.rule.fate(letters)
            self.claimed |= fate.events
            for after, p in fate.outcomes.items():
                change = sum(
                    worth * (self.letters.index(new) - self.letters.index(old))
                    for worth, old, new in zip(block, letters, after, strict=True)
                )
                states.append(now.states[here] + np.uint64(change % 2**64))
                chances.append(now.chances[here] * p)
        return np.concatenate(states), np.concatenate(chances)

    def _contents(self, states, block):
        """Return what a block holds in each state: a number whose digits are its corners, 0 for a wall."""
        base = len(self.letters)
        found = np.zeros(len(states), np.int64)
        for number, worth in enumerate(block):
            if worth:
                found += (states // np.uint64(worth) % np.uint64(base)).astype(np.int64) * base**number
        return found

    def _letters(self, content, block):
        digits = (content // len(self.letters) ** number % len(self.letters) for number in range(4))
        return "".join(
            self.letters[digit] if worth else self.rule.wall for digit, worth in zip(digits, block, strict=True)
        )

    def seen(self, now, letters):
        """Return the States of some materials as one: bit y·W + x is set where cell (x, y) holds one of them."""
        codes = [self.letters.index(letter) for letter in letters]
        states = np.full(len(now.states), self.walls if self.rule.wall in letters else 0, np.uint64)
        for place, worth in self.worth.items():
            holds = np.isin(now.states // np.uint64(worth) % np.uint64(len(self.letters)), codes)
            states |= holds.astype(np.uint64) << np.uint64(place)
        return _joined(states, now.chances)


def _joined(states, chances):
    """Return States in which each occurs once."""
    found, place = np.unique(states, return_inverse=True)
    return States(found, np.bincount(place, chances, len(found)))
