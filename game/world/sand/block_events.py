"""What can happen in each block in the coming iteration, by the rule's own table, over a part of the lattice."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.core.rule_table import corners, state_of
from game.world.sand.crop import Crop, CropBox

CORNERS = ((0, 0), (0, 1), (1, 0), (1, 1))  # (row, column) of a, b, c and d in a block


class BlockEvents(NamedTuple):
    """What can happen in some blocks: one entry of each array an outcome."""

    rows: np.ndarray  # int64, the lattice row of the block's upper left corner, -1 if that is outside
    columns: np.ndarray
    before: np.ndarray  # int64, the state of the block, see `core.rule_table`
    after: np.ndarray
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
    states, top, first = _states(world, box, x, y)
    found = [
        (row, column, state, after, p)
        for state in np.unique(states).tolist()
        if (outcomes := _outcomes(rule, state))
        for row, column in np.argwhere(states == state).tolist()
        for p, after in outcomes
    ]
    rows, columns, before, after, chances = np.array(sorted(found), float).reshape(-1, 5).T
    whole = (each.astype(np.int64) for each in (top + 2 * rows, first + 2 * columns, before, after))
    return BlockEvents(*whole, chances)


def block_at(world, rule, row, column, before=0):
    """Return the (row, column) of the block that holds a cell in the coming iteration, or in one `before` it."""
    x, y = rule.offsets[(world.iteration - before) % len(rule.offsets)]
    return row - (row - y) % 2, column - (column - x) % 2


def told_events(rule, state, after=None):
    """Return [(event, probability)] of what can change a block, or make just one other of it."""
    bits = rule.table.bits
    ends = [None if each is None else tuple(int(code) for code in corners(each, bits)) for each in (state, after)]
    return rule.happening(*ends)


def can_change(world, rule, box):
    """Return whether a block that a CropBox touches can change, in any partition of the rule's and by any chance."""
    box = box.grown(2, world.shape)
    return any(_outcomes(rule, state) for x, y in rule.offsets for state in _there(_states(world, box, x, y)[0]))


def possible_events(world, rule):
    """Return the names of the events that can change a block in any partition, by any chance, in the file's order."""
    box = CropBox(0, 0, *world.shape)
    there = {state for x, y in rule.offsets for state in _there(_states(world, box, x, y)[0])}
    found = {name for state in there for name in _events(rule, state)}
    return [each.name for each in rule.definition.events if each.name in found]


def _there(states):
    """Return the states that there are among some."""
    return np.flatnonzero(np.bincount(states.ravel())).tolist()


def _states(world, box, x, y):
    """Return (states of the blocks of the partition at (x, y) in a CropBox, first row, first column)."""
    bottom, right = box.top + box.height, box.left + box.width
    above, left = 2 * (box.top == 0), 2 * (box.left == 0)
    outside = (above, bottom == world.shape[0]), (left, right == world.shape[1])
    cells = np.pad(Crop(world, box).cells, outside, constant_values=world.codes.wall)[y:, x:]
    cells = cells[: len(cells) // 2 * 2, : cells.shape[1] // 2 * 2].astype(np.int64)
    corner_cells = cells[::2, ::2], cells[::2, 1::2], cells[1::2, ::2], cells[1::2, 1::2]
    return state_of(corner_cells, world.layout.bits), box.top - above + y, box.left - left + x


@lru_cache(maxsize=2**12)
def _outcomes(rule, state):
    """Return [(probability, state after)] of a block; none for one that holds a code of no material."""
    codes = corners(state, rule.table.bits)
    if max(codes) >= len(rule.materials):
        return []
    return [(p, state_of(after, rule.table.bits)) for p, after in rule.outcomes(codes)]


@lru_cache(maxsize=2**12)
def _events(rule, state):
    """Return the names of the events that can change a block."""
    codes = corners(state, rule.table.bits)
    return rule.events_of(codes) if max(codes) < len(rule.materials) else frozenset()


@lru_cache(maxsize=2**12)
def moves_between(before, after, bits):
    """Return what moves between two states of a block: a tuple of (corner, corner), each (row, column).

    Of a corner that takes what was nowhere else in the block, or whose content is nowhere any more, both are the same:
    there it changed.
    """
    old, new, found = corners(before, bits), corners(after, bits), []
    for corner in range(4):
        if new[corner] in (0, old[corner]):
            continue
        sources = [other for other in range(4) if old[other] == new[corner] != new[other]]
        sources.sort(key=lambda other: (corner ^ other != 2, corner ^ other != 3))  # from above, then across
        found.append((CORNERS[sources[0] if sources else corner], CORNERS[corner]))
    left = {start for start, _ in found}
    gone = [CORNERS[corner] for corner in range(4) if new[corner] == 0 != old[corner]]
    return (*found, *((corner, corner) for corner in gone if corner not in left))


def happened(events, world, box):
    """Return which of the events, told before the last iteration for a CropBox, have come about: a bool array."""
    box = box.grown(2, world.shape)
    cells = np.pad(Crop(world, box).cells, 2, constant_values=world.codes.wall).astype(np.int64)
    rows, columns = events.rows - box.top + 2, events.columns - box.left + 2
    here = state_of([cells[rows + row, columns + column] for row, column in CORNERS], world.layout.bits)
    return here == events.after
