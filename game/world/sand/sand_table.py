"""The table of the sand's rule: every block state of empty cells, sand and walls, and what it may become."""

from itertools import product

import numpy as np

from game.core.rule_table import CERTAIN, Claim, Outcome, RuleTable, state_of
from game.world.sand import parameters

BITS = 2
EMPTY, SAND, WALL = range(3)  # codes; bit 0 is a cell of the planes of sand, bit 1 of those of walls

SLOTS = tuple(each.name for each in parameters.PROBABILITIES)

# Corners a b / c d before and after, and the probability. '#' is sand or wall, and stays what it is; 'w' is wall.
PICTURES = (
    ("o. ..", ".. o.", None),
    (".o ..", ".. .o", None),
    ("oo ..", ".. oo", "fall_pair"),
    ("ow ..", ".w o.", "fall_pair"),
    ("wo ..", "w. .o", "fall_pair"),
    ("o. .#", ".. o#", "fall_low_left"),
    (".o #.", ".. #o", "fall_low_right"),
    ("o# .#", ".# o#", "fall_full_left"),
    ("#o #.", "#. #o", "fall_full_right"),
    (".o .#", ".. o#", "topple_left"),
    ("o. #.", ".. #o", "topple_right"),
)
_CODES = {".": (EMPTY,), "o": (SAND,), "w": (WALL,), "#": (SAND, WALL)}


def _claim(number, before, after, name):
    before, after = before.replace(" ", ""), after.replace(" ", "")
    found = {}
    for codes in product(*(_CODES[sign] for sign in before)):
        changed = [code if sign == "#" else _CODES[sign][0] for sign, code in zip(after, codes, strict=True)]
        found[state_of(codes, BITS)] = state_of(changed, BITS)
    states = sorted(found)
    after = np.array([found[state] for state in states], np.uint16)
    slot = CERTAIN if name is None else SLOTS.index(name)
    return Claim(number, np.array(states, np.uint16), (Outcome(slot, after),))


SAND_TABLE = RuleTable(
    BITS, 3, WALL, SLOTS, (tuple(_claim(number, *picture) for number, picture in enumerate(PICTURES)),)
)
