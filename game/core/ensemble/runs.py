"""Ensembles: many independent replicas of one lattice, a bit each, moved a group at a time.

Bit i of word w of a bit of a cell's code is replica 64·w + i of the group; bits that never change, as those of walls,
are held once for all. A block's corners are then plain words, whatever the partition, and one run of a rule's pass
moves the block in the whole group. Most blocks need no visit: one in which no replica can move falls asleep until a
block that shares a cell with it moves.

Arrays have a border of one cell, which is outside, so cell (row, column) is at [row + 1, column + 1].
"""

from typing import NamedTuple

import numpy as np

from game.core.chance import iteration_key, mix, seed_stream
from game.core.jit import gate, kernel
from game.core.loops.calls import call_pass

BITS = 64

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_FULL = np.uint64(2**64 - 1)
_GOLDEN = np.uint64(0x9E3779B97F4A7C15)
_STEP = np.uint64(32 * 0x9E3779B97F4A7C15 % 2**64)  # from the draws of one block to those of the next
_ENSEMBLE = np.uint64(0x656E73656D626C65)  # keeps replicas apart from a world of the same seed


class Replicas(NamedTuple):
    """A group of replicas at one moment. Words beyond those of the runs fill up the last vector of a pass."""

    flat: np.ndarray  # (n,) uint64: the cells, then `words` words of zeros and as many of ones
    cells: np.ndarray  # (H + 2, W + 2, changing bits, words) uint64, a view of it: the cells' codes, bit by bit
    codes: np.ndarray  # (H + 2, W + 2) uint8: the codes at the start, good for bits that never change
    changing: np.ndarray  # (bits,) bool: which bits of a code change
    full: np.ndarray  # (words,) uint64: the bits that are replicas
    awake: np.ndarray  # (H + 2, W + 2) uint8: whether the block with this upper left corner needs a visit
    seeds: np.ndarray  # (words,) uint64: each word's own seed


def replicate(codes, moving, seed, first, runs, more_bits=0):
    """Return `runs` replicas of cells, (H, W) uint8 codes, the first of them number `first`, a multiple of 64.

    moving: the Pass that is to move them. more_bits: a number whose bits change beside those that it changes. Bits past
    the last replica take no part.
    """
    height, width = codes.shape
    full = full_words(runs, moving.lanes)
    changing = moving.changing | [bool(more_bits >> bit & 1) for bit in range(len(moving.changing))]
    shape = height + 2, width + 2, int(changing.sum()), len(full)
    size = int(np.prod(shape))
    flat = np.zeros(size + 2 * len(full), np.uint64)
    flat[size + len(full) :] = _FULL
    bordered = np.full(shape[:2], moving.outside_code, np.uint8)
    bordered[1:-1, 1:-1] = codes
    cells = flat[:size].reshape(shape)
    fill(cells, bordered, np.flatnonzero(changing), full)
    seeds = np.empty(len(full), np.uint64)
    word_seeds(np.uint64(seed), first // BITS, seeds)
    return Replicas(flat, cells, bordered, changing, full, np.ones(bordered.shape, np.uint8), seeds)


def full_words(runs, lanes=1):
    """Return the words of a bit that is set in each of `runs` replicas: (words,) uint64, a multiple of `lanes`."""
    words = -(-runs // BITS)
    full = np.zeros(-(-words // lanes) * lanes, np.uint64)
    full[:words] = _FULL
    full[words - 1] >>= np.uint64(words * BITS - runs)
    return full


@kernel
def fill(cells, codes, bits, full):
    """Put the bits numbered `bits` of codes, (H + 2, W + 2) uint8, in the cells of the replicas of `full`, in place."""
    height, width = codes.shape
    for y in range(height):
        for x in range(width):
            for at in range(len(bits)):
                if codes[y, x] >> bits[at] & 1:
                    for word in range(len(full)):
                        cells[y, x, at, word] = full[word]


@kernel
def word_seeds(seed, first, seeds):
    """Write the seeds of words of replicas to `seeds`, the first of them that of word `first` of the ensemble."""
    for word in range(len(seeds)):
        seeds[word] = mix(seed ^ _ENSEMBLE) + np.uint64(first + word) * _GOLDEN


@gate
def _visit(run, replicas, y, x, origin, at):
    """Run a pass on the block with its upper left corner at [y, x] of a group, in place; return what it does.

    origin: (words,) uint64, the keys of the iteration. at: room for the places of the corners.
    """
    address, chances = run
    flat, cells, codes, changing, full = replicas
    across, depth, words, bits = cells.shape[1], cells.shape[2], cells.shape[3], len(changing)
    for corner in range(4):
        row, column = y + (corner >> 1), x + (corner & 1)
        place = (row * across + column) * depth * words
        for bit in range(bits):
            if changing[bit]:
                at[corner * bits + bit] = place
                place += words
            else:
                at[corner * bits + bit] = cells.size + np.int64(codes[row, column] >> bit & 1) * words
    key = np.uint64(y * across + x) * _STEP
    return call_pass(address, flat, at, full, origin, key, chances, words)


@kernel
def advance_replicas(replicas, run, offsets, iteration, iterations, done, row, budget):
    """Run iterations in place, resuming at (done, row) and stopping once `budget` is spent.

    A visit to a block spends 1 and 1 for each 16 words. Return the (done, row) to resume at; done is `iterations` at
    the end. run: (address of a pass, its chances). offsets: (x, y) of the iterations from number `iteration`, a uint64,
    repeated.
    """
    awake, seeds = replicas.awake, replicas.seeds
    group = replicas.flat, replicas.cells, replicas.codes, replicas.changing, replicas.full
    height, width = awake.shape[0] - 2, awake.shape[1] - 2
    at, keys = np.empty(4 * len(replicas.changing), np.int64), np.empty(len(seeds), np.uint64)
    spent, cost = 0, 1 + len(seeds) // 16
    while done < iterations:
        x0, y0 = offsets[done % len(offsets)]
        for k in range(len(seeds)):
            keys[k] = iteration_key(seed_stream(seeds[k]), iteration + np.uint64(done))
        for y in range(max(row, 1 - y0), height + 1, 2):
            if spent > budget:
                return done, y
            spent += 1 + width // BITS
            for x in range(1 - x0, width + 1, 2):
                if awake[y, x]:
                    told = _visit(run, group, y, x, keys, at)
                    spent += cost
                    if told & 2:
                        awake[max(0, y - 1) : y + 2, max(0, x - 1) : x + 2] = 1
                    elif told == 0:
                        awake[y, x] = 0
        done, row = done + 1, 0
    return done, row


@gate
def holding(replicas, y, x, word, code):
    """Return in which replicas of a word a cell has a code; y and x are with the border."""
    found, at = replicas.full[word], 0
    for bit in range(len(replicas.changing)):
        if replicas.changing[bit]:
            held = replicas.cells[y, x, at, word]
            at += 1
        else:
            held = _ZERO - np.uint64(replicas.codes[y, x] >> bit & 1)
        found &= held if code >> bit & 1 else ~held
    return found


@gate
def ones(word):
    """Return the number of bits set in a word."""
    word -= (word >> _ONE) & np.uint64(0x5555555555555555)
    word = (word & np.uint64(0x3333333333333333)) + ((word >> np.uint64(2)) & np.uint64(0x3333333333333333))
    word = (word + (word >> np.uint64(4))) & np.uint64(0x0F0F0F0F0F0F0F0F)
    return (word * np.uint64(0x0101010101010101)) >> np.uint64(56)


@kernel
def count_replicas(replicas, code, weight, counts):
    """Add `weight` times the number of replicas with a code to `counts`, an (H, W) int64 array, cell by cell."""
    height, width = counts.shape
    for y in range(height):
        for x in range(width):
            found = _ZERO
            for word in range(len(replicas.full)):
                found += ones(holding(replicas, y + 1, x + 1, word, code))
            counts[y, x] += weight * np.int64(found)


@kernel
def read_states(replicas, code, states):
    """Write where each replica has a code to `states`, (runs,) uint64: bit y·W + x is cell (y, x), of 64 at most."""
    height, width = replicas.codes.shape[0] - 2, replicas.codes.shape[1] - 2
    for run in range(len(states)):
        word, bit = run // BITS, np.uint64(run % BITS)
        state = _ZERO
        for y in range(height):
            for x in range(width):
                state |= ((holding(replicas, y + 1, x + 1, word, code) >> bit) & _ONE) << np.uint64(y * width + x)
        states[run] = state
