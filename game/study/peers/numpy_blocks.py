"""The plain block rule in numpy: the bench's twin of the product, with all seven probabilities, and a peer.

It shares nothing with game.core. The four corners of all blocks of a band of rows are four arrays.
"""

import numpy as np

from game.study.peers import Peer
from game.study.peers.lattice import EMPTY, SAND

BAND = 256  # rows of cells moved at a time; all 16384 at once would need gigabytes for the arrays in between
GOLDEN = np.uint64(0x9E3779B97F4A7C15)


def advance(cells, rule, start, iterations, uniform):
    """Run `iterations` iterations on a lattice, the first of them numbered `start`, in place.

    uniform(iteration, rows, columns) gives a random number in [0, 2**32) for each of the blocks that it names.
    """
    height, width = cells.shape[0] - 1, cells.shape[1] - 1
    for iteration in range(start, start + iterations):
        x, y = rule.offsets[iteration % len(rule.offsets)]
        left, top = 1 - x, 1 - y
        wide = -(-(width - left) // 2)
        for y in range(top, height, BAND):
            high = -(-(min(height, y + BAND) - y) // 2)
            band = cells[y : y + 2 * high, left : left + 2 * wide]
            corners = [band[dy::2, dx::2] for dy in (0, 1) for dx in (0, 1)]
            _move(
                corners, rule, lambda rows, columns, t=iteration, y=y, x=x: uniform(t, (y - 1) // 2 + rows, columns - x)
            )


def _move(corners, rule, uniform):
    """Move the sand of blocks whose corners are a b over c d, in place."""
    a, b, c, d = corners
    free_a, free_b, free_c, free_d = (corner == EMPTY for corner in corners)
    sand_a, sand_b = a == SAND, b == SAND
    fall_left, fall_right = sand_a & free_c, sand_b & free_d
    left_free, right_free = free_a & free_c, free_b & free_d
    topple_left, topple_right = sand_b & ~free_d & left_free, sand_a & ~free_c & right_free
    kinds = {
        "topple_left": lambda: topple_left,
        "topple_right": lambda: topple_right,
        "fall_pair": lambda: (fall_left & ~free_b & free_d) | (fall_right & ~free_a & free_c),
        "fall_low_left": lambda: fall_left & free_b & ~free_d,
        "fall_low_right": lambda: fall_right & free_a & ~free_c,
        "fall_full_left": lambda: fall_left & ~free_b & ~free_d,
        "fall_full_right": lambda: fall_right & ~free_a & ~free_c,
    }
    stay = _refused(kinds, rule, uniform)
    if stay is not None:
        for event in (fall_left, fall_right, topple_left, topple_right):
            event[stay] = False
    a ^= fall_left | topple_right
    b ^= fall_right | topple_left
    c ^= fall_left | topple_left
    d ^= fall_right | topple_right


def _refused(kinds, rule, uniform):
    """Return the (rows, columns) of the blocks whose event chance refuses, or None where nothing is left to chance."""
    refused = []
    for name, blocks in kinds.items():
        threshold = round(getattr(rule, name) * 2**32)
        if threshold < 2**32:
            rows, columns = np.nonzero(blocks())
            stays = uniform(rows, columns) >= threshold
            refused.append((rows[stays], columns[stays]))
    return tuple(map(np.concatenate, zip(*refused, strict=True))) if refused else None


def own_chance(seed):
    """Return a `uniform` that draws from numpy's generator."""
    generator = np.random.default_rng(seed)
    return lambda iteration, rows, columns: generator.integers(2**32, size=rows.size, dtype=np.uint64)


def product_chance(seed, width):
    """Return the `uniform` that the product is specified to have, for a lattice `width` cells wide.

    Bit i of the draws of splitmix64's finaliser at (seed, iteration, word of blocks) belongs to block i of the word,
    the first draw being the most significant digit.
    """
    words = -(-width // 128)
    draws = np.arange(32, dtype=np.uint64)

    def uniform(iteration, rows, columns):
        lane, word = np.divmod(columns, words)
        lane[columns == -1], word[columns == -1] = 0, -1
        place = (rows * (words + 1) + word).astype(np.uint64)
        with np.errstate(over="ignore"):
            key = mix(mix(np.uint64(seed) + GOLDEN) + np.uint64(iteration) * GOLDEN)
            bits = mix(key + (place[:, None] * np.uint64(32) + draws) * GOLDEN)
        digits = (bits >> lane.astype(np.uint64)[:, None]) & np.uint64(1)
        return (digits << draws[::-1]).sum(axis=1, dtype=np.uint64)

    return uniform


def mix(z):
    """Return splitmix64's finaliser of z, uint64 (Steele, Lea & Flood 2014)."""
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return z ^ (z >> np.uint64(31))


NUMPY = Peer(
    "numpy",
    "numpy, block rule on arrays",
    lambda cells, rule, start, iterations: advance(cells, rule, start, iterations, own_chance(start)),
)
