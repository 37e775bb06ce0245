"""Any rule in numpy, block states looked up: the bench's twin of the product, and of the peers that look states up.

It takes from game.core what a rule says, a RuleTable, and nothing else. A lattice is that of the peers.
"""

from math import fsum
from typing import NamedTuple

import numpy as np

from game.core.rule_table import CERTAIN, FAIR_STEP, LAYER_STEP
from game.study.peers.numpy_blocks import GOLDEN, mix

BAND = 256  # rows of cells moved at a time
DIGITS = 32  # of a random number, binary


class Layer(NamedTuple):
    """What a layer makes of each block state, with the fair bit 0 and with 1: outcome i if limit i - 1 <= u < limit i.

    Where there are fewer outcomes than the most, the last limit is repeated; without any all are 0.
    """

    limits: np.ndarray  # (2, states, outcomes) uint64
    after: np.ndarray  # (2, states, outcomes) uint16

    @property
    def claimed(self):
        """Which states the layer may change, (states,) bool."""
        return (self.limits[:, :, -1] > 0).any(axis=0)

    @property
    def is_fair(self):
        """Which states the fair bit decides about, (states,) bool."""
        return (self.limits[0] != self.limits[1]).any(axis=1) | (self.after[0] != self.after[1]).any(axis=1)


class Chances(NamedTuple):
    """Where random numbers come from; both take an iteration and the rows and columns of blocks of its partition."""

    digit: object  # (iteration, rows, columns, layer, number of the digit from the highest) -> 0 and 1
    face: object  # (iteration, rows, columns) -> 0 and 1


def layers_of(rule):
    """Return the Layers of a Rule, as its table tells them."""
    table, found = rule.table, []
    for claims in table.layers:
        most = max((len(claim.outcomes) for claim in claims), default=1)
        layer = Layer(np.zeros((2, table.states, most), np.uint64), np.zeros((2, table.states, most), np.uint16))
        for claim in claims:
            numbers = [1.0 if each.slot == CERTAIN else rule.values[each.slot] for each in claim.outcomes]
            for face in (0, 1) if claim.face is None else (claim.face,):
                for number, outcome in enumerate(claim.outcomes):
                    limit = min(2**DIGITS, round(2**DIGITS * fsum(numbers[: number + 1])))
                    layer.limits[face, claim.states, number:] = limit
                    layer.after[face, claim.states, number:] = outcome.after[:, None]
        found.append(layer)
    return found


def advance(cells, rule, start, iterations, layers, chances):
    """Run `iterations` iterations on a lattice, the first of them numbered `start`, in place."""
    height, width = cells.shape[0] - 1, cells.shape[1] - 1
    looked_up = [(layer, layer.claimed, layer.is_fair) for layer in layers]
    for iteration in range(start, start + iterations):
        x, y = rule.offsets[iteration % len(rule.offsets)]
        wide = -(-(width - 1 + x) // 2)
        for top in range(1 - y, height, BAND):
            high = -(-(min(height, top + BAND) - top) // 2)
            band = cells[top : top + 2 * high, 1 - x : 1 - x + 2 * wide]
            corners = [band[down::2, right::2] for down in (0, 1) for right in (0, 1)]
            rows, columns = np.indices((high, wide)).reshape(2, -1)
            where = rows + (top - 1) // 2, columns - x
            _move(corners, rule.table.bits, looked_up, chances, iteration, *where)


def _move(corners, bits, looked_up, chances, iteration, rows, columns):
    """Move the blocks whose corners are a b over c d, in place."""
    before = sum(corner.astype(np.int64) << (bits * number) for number, corner in enumerate(corners)).ravel()
    after, free = before.copy(), np.ones(len(before), bool)
    for number, (layer, claimed, is_fair) in enumerate(looked_up):
        here = np.flatnonzero(free & claimed[before])
        face, torn = np.zeros(len(here), np.int64), is_fair[before[here]]
        face[torn] = chances.face(iteration, rows[here[torn]], columns[here[torn]])
        chosen = _chosen(
            layer.limits[face, before[here]], _digits(chances, iteration, rows[here], columns[here], number)
        )
        happens = chosen < layer.limits.shape[2]
        blocks = here[happens]
        after[blocks] = layer.after[face[happens], before[blocks], chosen[happens]]
        free[blocks] = False
    for number, corner in enumerate(corners):
        corner[...] = (after >> (bits * number) & (2**bits - 1)).reshape(corner.shape)


def _digits(chances, iteration, rows, columns, layer):
    """Return what gives a binary digit of the random numbers of some of the blocks."""
    return lambda some, digit: chances.digit(iteration, rows[some], columns[some], layer, digit)


def _chosen(limits, digit_of):
    """Return how many of its limits, (n, outcomes) rising, the number of each block has reached.

    The highest digits are drawn first, and no more of them than it takes.
    """
    low = np.zeros(len(limits), np.uint64)
    undecided = np.flatnonzero(((limits > 0) & (limits < 2**DIGITS)).any(axis=1))
    for digit in range(DIGITS):
        size = np.uint64(1 << (DIGITS - 1 - digit))
        least = low[undecided] + digit_of(undecided, digit).astype(np.uint64) * size
        low[undecided] = least
        inside = (limits[undecided] > least[:, None]) & (limits[undecided] < (least + size)[:, None])
        undecided = undecided[inside.any(axis=1)]
    return (limits <= low[:, None]).sum(axis=1)


def product_chances(seed, width):
    """Return the Chances that the product is specified to have, for a lattice `width` cells wide."""
    words = -(-width // 128)

    def bit(iteration, rows, columns, step):
        lane, word = np.divmod(columns, words)
        lane[columns == -1], word[columns == -1] = 0, -1
        place = (rows * (words + 1) + word).astype(np.uint64)
        with np.errstate(over="ignore"):
            key = mix(mix(np.uint64(seed) + GOLDEN) + np.uint64(iteration) * GOLDEN)
            return mix(key + place * np.uint64(DIGITS) * GOLDEN + np.uint64(step % 2**64)) >> lane.astype(
                np.uint64
            ) & np.uint64(1)

    def digit(iteration, rows, columns, layer, number):
        return bit(iteration, rows, columns, number * int(GOLDEN) + layer * LAYER_STEP)

    return Chances(digit, lambda iteration, rows, columns: bit(iteration, rows, columns, FAIR_STEP))
