"""At p = 1 the rule is the Sand rule that Golly ships: an independent program, run by data/make_golly_sand.py."""

import json
from collections import defaultdict
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from game import Rule, World, advance
from tests import reference

GOLLY = json.loads(Path(__file__).with_name("data").joinpath("golly_sand.json").read_text())
CERTAIN = defaultdict(lambda: 1.0)  # every event's probability

every_world = pytest.mark.parametrize("kept", GOLLY["worlds"].values(), ids=GOLLY["worlds"])


def legs(kept):
    """Return (iteration reached before, iteration, Golly's cells then) for each iteration kept of a world."""
    return [(before, after, kept[str(after)]) for before, after in pairwise(int(iteration) for iteration in kept)]


def rows_of(world):
    """Return the world's cells as rows of characters."""
    letters = np.where(world.walls, "#", np.where(world.sand, "o", "."))
    return ["".join(row) for row in letters]


@every_world
def test_certain_rule_of_the_twin_agrees_with_golly_sand(kept):
    cells = kept["0"]
    for before, after, golly in legs(kept):
        cells = reference.run(cells, CERTAIN, GOLLY["schedule"], seed=0, iterations=after - before, start=before)
        assert ["".join(row) for row in cells] == golly, f"iteration {after}"


@every_world
def test_certain_rule_agrees_with_golly_sand(kept):
    cells = np.array([list(row) for row in kept["0"]])
    world = World.from_cells(cells == "o", cells == "#")
    for before, after, golly in legs(kept):
        advance(world, Rule(schedule=GOLLY["schedule"]), after - before)
        assert rows_of(world) == golly, f"iteration {after}"
