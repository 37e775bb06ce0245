"""What one block does, against the pictures of the rule: all 81 blocks, and each probability's own events."""

from itertools import product

import pytest

from game import Rule, advance
from tests.cells import NAMES, rows_of, world_of

# corners a b / c d before -> after, and what decides it. '#' stands for sand or wall, and stays what it is.
PICTURES = [
    ("o. ..", ".. o.", None),
    (".o ..", ".. .o", None),
    ("oo ..", ".. oo", "fall_pair"),
    ("ow ..", ".w o.", "fall_pair"),
    ("wo ..", "w. .o", "fall_pair"),
    ("o. .#", ".. o#", "fall_low_left"),
    (".o #.", ".. #o", "fall_low_right"),
    ("o# .#", ".# o#", "fall_full_left"),
    ("#o #.", "#. #o", "fall_full_right"),
    ("o. #.", ".. #o", "topple_right"),
    (".o .#", ".. o#", "topple_left"),
]
ALL_BLOCKS = ["".join(corners) for corners in product(".ow", repeat=4)]


def expand(picture):
    """Return {block before: (block after, what decides it)}, each '#' of the picture being sand or wall."""
    before, after, name = picture
    before, after = before.replace(" ", ""), after.replace(" ", "")
    places = [i for i, corner in enumerate(before) if corner == "#"]
    found = {}
    for kinds in product("ow", repeat=len(places)):
        old, new = list(before), list(after)
        for place, kind in zip(places, kinds, strict=True):
            old[place] = new[place] = kind
        found["".join(old)] = "".join(new), name
    return found


EVENTS = {block: event for picture in PICTURES for block, event in expand(picture).items()}


def after_one_iteration(block, rule):
    """Return the block after the iteration whose partition it belongs to."""
    letters = block.replace("w", "#")
    world = world_of([letters[:2], letters[2:]])
    advance(world, rule, 1)
    return "".join(rows_of(world)).replace("#", "w")


def test_the_pictures_show_no_block_twice():
    assert len(EVENTS) == sum(len(expand(picture)) for picture in PICTURES)


@pytest.mark.parametrize("block", ALL_BLOCKS)
def test_a_certain_rule_does_what_the_pictures_show_and_nothing_else(block):
    after, _ = EVENTS.get(block, (block, None))
    assert after_one_iteration(block, Rule()) == after


@pytest.mark.parametrize("name", NAMES)
def test_each_probability_decides_its_own_events_only(name):
    never = Rule(**{name: 0.0})
    for block in ALL_BLOCKS:
        after, decided_by = EVENTS.get(block, (block, None))
        assert after_one_iteration(block, never) == (block if decided_by == name else after), block


@pytest.mark.parametrize("name", NAMES)
def test_each_probability_alone_lets_its_own_events_happen(name):
    only = Rule(**{other: float(other == name) for other in NAMES})
    for block in ALL_BLOCKS:
        after, decided_by = EVENTS.get(block, (block, None))
        assert after_one_iteration(block, only) == (after if decided_by in (None, name) else block), block
