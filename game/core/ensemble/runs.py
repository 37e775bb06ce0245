"""Ensembles: many independent replicas of one lattice, a bit each, moved a group at a time.

Bit i of a cell's word w is replica 64·w + i of the group. A block's corners are then plain words, whatever the
partition, and one visit to a block moves the sand of the whole group. Most blocks need no visit: one in which no
replica can move falls asleep until a block that shares a cell with it moves.

Arrays have a border of one cell, which is wall, so cell (row, column) is at [row + 1, column + 1].
"""

from typing import NamedTuple

import numpy as np

from game.core.chance import iteration_key, mix, seed_stream
from game.core.ensemble.block_visit import KEYS, SCRATCH, seven_of, visit
from game.core.jit import gate, kernel

BITS = 64

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_GOLDEN = np.uint64(0x9E3779B97F4A7C15)
_ENSEMBLE = np.uint64(0x656E73656D626C65)  # keeps replicas apart from a world of the same seed


class Replicas(NamedTuple):
    """A group of replicas at one moment."""

    cells: np.ndarray  # (H + 2, W + 2, words) uint64: sand, bit by bit
    walls: np.ndarray  # (H + 2, W + 2) uint8: 1 where wall, the same in all replicas
    awake: np.ndarray  # (H + 2, W + 2) uint8: whether the block with this upper left corner needs a visit
    seeds: np.ndarray  # (words,) uint64: each word's own seed


def replicate(sand, walls, seed, first, runs):
    """Return `runs` replicas of two (H, W) bool arrays, the first of them number `first`, a multiple of 64.

    Bits past the last replica hold no sand, so nothing ever happens in them and no count sees them.
    """
    height, width = sand.shape
    full = full_words(runs)
    words = len(full)
    cells = np.zeros((height + 2, width + 2, words), np.uint64)
    fill(cells, sand, full)
    solid = np.ones((height + 2, width + 2), np.uint8)
    solid[1:-1, 1:-1] = walls
    return Replicas(cells, solid, np.ones(solid.shape, np.uint8), word_seeds(np.uint64(seed), first // BITS, words))


def full_words(runs):
    """Return the words of a cell that has sand in each of `runs` replicas: (words,) uint64."""
    words = -(-runs // BITS)
    full = np.full(words, 2**64 - 1, np.uint64)
    full[-1] >>= np.uint64(words * BITS - runs)
    return full


@kernel
def fill(cells, sand, full):
    """Put `full`, (words,) uint64, in every cell where sand is, in place."""
    height, width = sand.shape
    for y in range(height):
        for x in range(width):
            if sand[y, x]:
                for word in range(len(full)):
                    cells[y + 1, x + 1, word] = full[word]


@kernel
def word_seeds(seed, first, words):
    """Return the seeds of `words` words of replicas, the first of them word `first` of the ensemble."""
    seeds = np.empty(words, np.uint64)
    for word in range(words):
        seeds[word] = mix(seed ^ _ENSEMBLE) + np.uint64(first + word) * _GOLDEN
    return seeds


@kernel
def advance_replicas(replicas, offsets, iteration, iterations, chances, done, row, budget):
    """Run iterations in place, resuming at (done, row) and stopping once `budget` is spent.

    A visit to a block spends 1 and 1 for each 16 words. Return the (done, row) to resume at; done is `iterations` at
    the end. offsets: (x, y) of the iterations from number
    `iteration`, a uint64, repeated. chances: the masks (always, digits) of the rule's `Chance`.
    """
    cells, walls, awake, seeds = replicas
    height, width = awake.shape[0] - 2, awake.shape[1] - 2
    always, bits = seven_of(chances[0], 0, 1), chances[1]
    scratch = np.empty(SCRATCH, np.uint64)
    spent, cost = 0, 1 + len(seeds) // 16
    while done < iterations:
        x0, y0 = offsets[done % len(offsets)]
        for k in range(len(seeds)):
            scratch[KEYS + k] = iteration_key(seed_stream(seeds[k]), iteration + np.uint64(done))
        for y in range(max(row, 1 + y0), height + 1, 2):
            if spent > budget:
                return done, y
            spent += 1 + width // BITS
            for x in range(1 + x0, width + 1, 2):
                if awake[y, x]:
                    place = np.uint64(y * (width + 2) + x)
                    moved, could = visit(cells, walls, y, x, scratch, place, always, bits)
                    spent += cost
                    if moved:
                        awake[y - 1 : y + 2, x - 1 : x + 2] = 1
                    elif not could:
                        awake[y, x] = 0
        done, row = done + 1, 0
    return done, row


@gate
def ones(word):
    """Return the number of bits set in a word."""
    word -= (word >> _ONE) & np.uint64(0x5555555555555555)
    word = (word & np.uint64(0x3333333333333333)) + ((word >> np.uint64(2)) & np.uint64(0x3333333333333333))
    word = (word + (word >> np.uint64(4))) & np.uint64(0x0F0F0F0F0F0F0F0F)
    return (word * np.uint64(0x0101010101010101)) >> np.uint64(56)


@kernel
def count_replicas(cells, weight, counts):
    """Add `weight` times the number of replicas with sand to `counts`, an (H, W) int64 array, cell by cell."""
    height, width = counts.shape
    for y in range(height):
        for x in range(width):
            found = _ZERO
            for word in range(cells.shape[2]):
                found += ones(cells[y + 1, x + 1, word])
            counts[y, x] += weight * np.int64(found)


@kernel
def read_states(cells, states):
    """Write each replica's cells to `states`, (runs,) uint64: bit y·W + x is cell (y, x). H·W is at most 64."""
    height, width = cells.shape[0] - 2, cells.shape[1] - 2
    for run in range(len(states)):
        word, bit = run // BITS, np.uint64(run % BITS)
        state = _ZERO
        for y in range(height):
            for x in range(width):
                state |= ((cells[y + 1, x + 1, word] >> bit) & _ONE) << np.uint64(y * width + x)
        states[run] = state
