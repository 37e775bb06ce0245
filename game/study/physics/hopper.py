"""A hopper that flows for as long as it is looked at."""

import numpy as np

from game import World
from game.world.sand.measure import flow, grains_above

BELOW = 40  # rows under the neck
CLEARED = 8  # rows under the neck that keep their sand
INTERVAL = 24  # iterations between two clearings: a whole number of rounds, and fewer than a grain needs to the ground


class Hopper:
    """A full box of sand of `height` rows over a funnel of 45 degrees that ends in a neck of `neck` cells."""

    def __init__(self, width, height, neck, rule, seed=1):
        cone = (width - neck) // 2
        self.row = height + cone + 1  # first row under the neck
        self.rule = rule
        axis = np.abs(np.arange(width) + 0.5 - width / 2)
        inner = np.full(self.row + BELOW, width / 2)
        inner[height : self.row] = neck / 2 + np.arange(cone, -1, -1)
        walls = axis > inner[:, None]
        sand = ~walls
        sand[self.row :] = False
        self.world = World.from_cells(sand, walls, seed).of(rule.codes)

    @property
    def grains(self):
        """How many grains are above the neck."""
        return grains_above(self.world, self.row)

    def run(self, intervals):
        """Let it flow for so many intervals; return the flow in grains per iteration."""
        total = 0.0
        for _ in range(intervals):
            total += flow(self.world, self.rule, INTERVAL, self.row)
            self._clear()
        return total / intervals

    def _clear(self):
        """Take away what has left, which would pile up to the neck."""
        cells, old = self.world.materials, self.world
        left = cells[self.row + CLEARED :]
        left[left != old.codes.wall] = 0
        self.world = World.of_codes(cells, old.codes, old.seed)
        self.world.iteration = old.iteration
