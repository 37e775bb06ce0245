"""What can happen in each block in the coming iteration, by plain numpy over a part of the lattice."""

from typing import NamedTuple

import numpy as np

from game.world.sand.crop import Crop

# Grains that move together, each from one corner of the block to another: (row, column) of both.
FALL_LEFT, FALL_RIGHT, FALL_PAIR, TOPPLE_RIGHT, TOPPLE_LEFT = range(5)
MOVES = (
    (((0, 0), (1, 0)),),
    (((0, 1), (1, 1)),),
    (((0, 0), (1, 0)), ((0, 1), (1, 1))),
    (((0, 0), (1, 1)),),
    (((0, 1), (1, 0)),),
)


class BlockEvents(NamedTuple):
    """What can happen in some blocks: one entry of each array a block."""

    rows: np.ndarray  # int64, the lattice row of the block's upper left corner, -1 if that is outside
    columns: np.ndarray
    moves: np.ndarray  # int64, places in MOVES
    chances: np.ndarray  # float64, 0 < p ≤ 1

    def only(self, which):
        """Return the events that a bool array picks."""
        return BlockEvents(*(each[which] for each in self))


def offset(world, rule):
    """Return the (x, y) of the first block of the partition that the coming iteration uses."""
    return rule.offsets[world.iteration % len(rule.offsets)]


def coming_events(world, rule, box):
    """Return the BlockEvents of the coming iteration in the blocks that a CropBox touches."""
    box = box.grown(2, world.shape)
    x, y = offset(world, rule)
    sand, walls = Crop(world, box).cells
    bottom, right = box.top + box.height, box.left + box.width
    above, left = 2 * (box.top == 0), 2 * (box.left == 0)
    outside = (above, bottom == world.shape[0]), (left, right == world.shape[1])
    sand, walls = np.pad(sand, outside), np.pad(walls, outside, constant_values=True)
    top, first = box.top - above + y, box.left - left + x
    a, b, _, _ = _corners(sand, x, y)
    oa, ob, oc, od = _corners(sand | walls, x, y)
    left, right = a & ~oc, b & ~od
    right_topple, left_topple = a & oc & ~ob & ~od, b & od & ~oa & ~oc
    moves = np.select([left & right, left, right, right_topple], [FALL_PAIR, FALL_LEFT, FALL_RIGHT, TOPPLE_RIGHT], -1)
    moves[left_topple] = TOPPLE_LEFT
    kinds = [  # of two that are true the first one counts
        ((left & ~ob & ~od) | (right & ~oa & ~oc), 1.0),
        ((left & ob & ~od) | (right & oa & ~oc), rule.fall_pair),
        (left & ~ob, rule.fall_low_left),
        (right & ~oa, rule.fall_low_right),
        (left, rule.fall_full_left),
        (right, rule.fall_full_right),
        (right_topple, rule.topple_right),
        (left_topple, rule.topple_left),
    ]
    chances = np.select(*zip(*kinds, strict=True))
    rows, columns = np.nonzero((moves >= 0) & (chances > 0))
    found = rows, columns
    return BlockEvents(top + 2 * rows, first + 2 * columns, moves[found], chances[found])


def happened(events, world, box):
    """Return which of the events, told before the last iteration for a CropBox, have come about: a bool array."""
    box = box.grown(2, world.shape)
    sand, _ = Crop(world, box).cells
    first = np.array([move[0][0] for move in MOVES])[events.moves]
    return ~sand[events.rows - box.top + first[:, 0], events.columns - box.left + first[:, 1]]


def _corners(cells, x, y):
    """Return the corners a b c d of all whole blocks from (x, y) on."""
    height, width = (cells.shape[0] - y) // 2 * 2, (cells.shape[1] - x) // 2 * 2
    cells = cells[y : y + height, x : x + width]
    return cells[::2, ::2], cells[::2, 1::2], cells[1::2, ::2], cells[1::2, 1::2]
