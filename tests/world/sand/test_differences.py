"""Differences of worlds: cell by cell, by the names of what they hold."""

import numpy as np
import pytest

from game import World, load_rule
from game.world.sand.differences import differing


def plain(one, other):
    """Compare cell by cell, by name."""
    names, others = np.array(one.codes.told), np.array(other.codes.told)
    return names[one.materials] != others[other.materials]


@pytest.mark.parametrize("shape", [(1, 1), (7, 130), (64, 64), (33, 257)])
def test_cells_differ_that_hold_materials_of_other_names(shape):
    generator = np.random.default_rng(18)
    rule = load_rule("alchemy")
    cells = [generator.integers(0, 3, shape).astype(np.uint8) for _ in range(3)]
    sands = [World.from_cells(each == 1, each == 2) for each in cells]
    other = World.from_materials(generator.integers(0, len(rule.materials), shape).astype(np.uint8), rule)
    for worlds in (sands, [*sands[:2], other], [other, other.copy()]):
        lead, *rest = worlds
        wanted = [plain(lead, each) for each in rest]
        found = differing(worlds)
        assert (found[0] == np.logical_or.reduce(wanted)).all()
        assert all((mine == its).all() for mine, its in zip(found[1:], wanted, strict=True))


def test_worlds_that_are_alike_differ_nowhere_however_they_have_moved():
    sand = np.random.default_rng(19).random((40, 150)) < 0.5
    one = World.from_cells(sand, np.zeros_like(sand))
    assert not any(each.any() for each in differing([one, one.copy(), one.copy()]))
