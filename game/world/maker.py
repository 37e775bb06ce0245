"""The hourglass maker: a glass as a few numbers, the scene it makes, and the glass that suits a time."""

import math
from dataclasses import asdict, dataclass

import numpy as np

from game.world import knob
from game.world.glass import CURVE, FILL, NECK, THICKNESS, hourglass
from game.world.knob import Knob
from game.world.rule import Rule
from game.world.scene import Scene

HEIGHT = Knob("height", 240, 24, 1200, "cells", "height of the glass and its surroundings", whole=True)
SLIMNESS = 0.75  # the lattice's width as a part of its height
MARGIN = 1 / 9, 1 / 60  # parts of the lattice's width and height that are left free at each side
WINDOW = 720  # pixels: about as high a new glass is shown

# A glass that suits a time. Sand passes a neck grain by grain at a pace that hardly depends on its width, so a glass
# runs for as many iterations as it has sand, and that grows with the square of its height.
RULE = Rule.with_p(0.75, "balanced")
ITERATIONS = 9400  # that a glass of HEIGHT.default cells takes, as measured; others within a few per cent in proportion
LIVELY, CALM = (10, 240), (1500, 60)  # (seconds, iterations per second) of a short time and a long one
SLOWEST = 30  # iterations per second; sand that moves more slowly stutters


@dataclass(frozen=True)
class Glass:
    """An hourglass in the middle of a lattice. Raises ValueError for numbers out of range."""

    width: int  # of the lattice, cells
    height: int
    across: int  # cells left free at the left and right
    down: int  # above and below
    neck: float = NECK.default
    curve: float = CURVE.default
    wall: float = THICKNESS.default
    fill: float = FILL.default

    def __post_init__(self):
        for name in ("width", "height"):
            object.__setattr__(self, name, knob.SIDE.check(getattr(self, name)))
        if min(self.width, self.height) < 5:
            raise ValueError(f"a glass must be at least 5×5 cells, got {self.width}×{self.height}")
        for each in (NECK, CURVE, THICKNESS, FILL):
            object.__setattr__(self, each.name, each.check(getattr(self, each.name)))
        for name, side in (("across", self.width), ("down", self.height)):
            most = max(0, (side - 5) // 2)
            margin = Knob(name, 0, 0, most, "cells", "room beside the glass", whole=True)
            object.__setattr__(self, name, margin.check(getattr(self, name)))

    @classmethod
    def of_height(cls, height, **shape):
        """Return the glass of the usual proportions on a lattice of that height, in cells."""
        width = max(5, round(SLIMNESS * height))
        return cls(
            width, height, *(round(part * side) for part, side in zip(MARGIN, (width, height), strict=True)), **shape
        )

    @classmethod
    def for_time(cls, seconds, size=None):
        """Return a glass that runs for about so many seconds at a good pace; size: (width, height) of its lattice."""
        if size is None:
            height = HEIGHT.default * math.sqrt(seconds * good_pace(seconds) / ITERATIONS)
            height = round(min(max(height, HEIGHT.low), HEIGHT.high))
            return cls.of_height(height, **_detail(height))
        width, height = size
        margins = (min(round(part * side), (side - 5) // 2) for part, side in zip(MARGIN, size, strict=True))
        return cls(width, height, *margins, **_detail(height))

    def cells(self):
        """Return (sand, walls), two (height, width) bool arrays, the upper bulb filled."""
        sand, walls = np.zeros((2, self.height, self.width), bool)
        box = slice(self.down, self.height - self.down), slice(self.across, self.width - self.across)
        high, wide = walls[box].shape
        sand[box], walls[box] = hourglass(high, wide, self.neck, self.curve, self.wall, self.fill)
        return sand, walls

    def scene(self, rule=RULE, speed=knob.SPEED.default):
        """Return the Scene of this glass."""
        sand, walls = self.cells()
        sand.flags.writeable = walls.flags.writeable = False
        cell = round(min(max(WINDOW / self.height, knob.CELL.low), knob.CELL.high))
        return Scene("glass", "Your glass", "", sand, walls, rule, speed, cell, made_of="glass")

    def as_dict(self):
        """The fields by name."""
        return asdict(self)


def good_pace(seconds):
    """Return the iterations per second at which sand looks best over so many seconds: the longer, the calmer."""
    (short_s, fast), (long_s, slow) = LIVELY, CALM
    part = math.log(seconds / short_s) / math.log(long_s / short_s)
    return min(max(fast * (slow / fast) ** part, SLOWEST), fast)


def _detail(height):
    """Return neck, curve and wall as they look right on a glass of that height."""
    return {
        "neck": NECK.default,
        "curve": 0.95,
        "wall": max(1.0, THICKNESS.default * math.sqrt(height / HEIGHT.default)),
    }
