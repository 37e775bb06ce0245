"""Sizes of cells: the same glass on the screen, drawn with cells of different sizes."""

import time
from dataclasses import dataclass

import numpy as np

from game import Rule, World, advance
from game.study.trade.points import PERCENT, Point
from game.world.sand.measure import grains_above, pile_heights
from game.world.scenes.hourglass import hourglass

WIDTH, HEIGHT = 480, 624  # pixels, of the glass
NECK, THICKNESS = 32, 16  # pixels
CELLS = (1, 2, 3, 4, 8, 16)  # pixels to a cell
DEFAULT = 3  # pixels to a cell in the scene `hourglass`
GRID = 16  # pixels: the common grid of profiles and density maps
RULE = Rule.with_p(0.75, "balanced")
SERIES = "pixels to a cell"


@dataclass(frozen=True)
class DrainedGlass:
    """A glass that has run out, and how it looked half way."""

    cell: int  # pixels
    grains: int
    iterations: int  # until it had run out
    seconds: float
    half: np.ndarray  # (HEIGHT / GRID, WIDTH / GRID): share of sand when half of it had run through
    profile: np.ndarray  # (WIDTH / GRID,) height of the lower pile then, pixels

    @property
    def flow(self):
        """Grains per iteration."""
        return self.grains / self.iterations

    @property
    def falls(self):
        """How often a free grain falls through the whole glass while it drains."""
        return self.iterations * self.cell / HEIGHT


def drain(cell, seed):
    """Let the glass run out at `cell` pixels to a cell."""
    height, width = HEIGHT // cell, WIDTH // cell
    sand, walls = hourglass(height, width, NECK / cell, 1.0, max(1.0, THICKNESS / cell), 0.75)
    world, grains, half, seconds = World.from_cells(sand, walls, seed), int(sand.sum()), None, 0.0
    step = max(8, grains // 200)
    while left := grains_above(world, height // 2):
        if half is None and left <= grains / 2:
            half = seen(world.sand, cell), pile_heights(world, height // 2 + 1)
        begin = time.perf_counter()
        advance(world, RULE, step)
        seconds += time.perf_counter() - begin
    profile = np.repeat(half[1] * float(cell), cell).reshape(-1, GRID).mean(axis=1)
    return DrainedGlass(cell, grains, world.iteration, seconds, half[0], profile)


def seen(sand, cell):
    """Return the share of sand in each square of the common grid."""
    pixels = sand.repeat(cell, axis=0).repeat(cell, axis=1)
    return pixels.reshape(HEIGHT // GRID, GRID, WIDTH // GRID, GRID).mean(axis=(1, 3))


def drains(study):
    """Return {pixels to a cell: [DrainedGlass, …]} over a few seeds."""
    seeds = range(study.either(2, 8))
    return {cell: [drain(cell, seed) for seed in seeds] for cell in study.track(CELLS, "pixels to a cell")}


def pixel_points(found):
    """Return the Points of `drains`, held against one pixel to a cell."""
    finest = np.mean([each.half for each in found[1]], axis=0)
    variance = np.var([each.half for each in found[1]], axis=0, ddof=1).mean() * 2 / len(found[1])
    floor = PERCENT * float(np.sqrt(variance))
    default = np.mean([each.seconds for each in found[DEFAULT]])
    points = []
    for cell, each in found.items():
        error = np.mean([one.half for one in each], axis=0) - finest
        grains = abs(error).sum() / 2 * (GRID / DEFAULT) ** 2  # of the default's size
        cost = float(np.mean([one.seconds for one in each]) / default)
        rms, most = PERCENT * np.sqrt((error**2).mean()), PERCENT * abs(error).max()
        points.append(Point(SERIES, str(cell), float(rms), float(most), float(grains), floor, cost, cell == DEFAULT))
    return points


def pixel_table(found):
    """Return (heads, rows): drain time, flow and pile by pixels to a cell."""
    finest = np.mean([each.profile for each in found[1]], axis=0)
    rows = []
    for cell, each in found.items():
        means = [float(np.mean([getattr(one, name) for one in each])) for name in ("iterations", "flow", "falls")]
        profile = np.mean([one.profile for one in each], axis=0)
        off = float(np.sqrt(((profile - finest) ** 2).mean()))
        rows.append((cell, each[0].grains, *means, float(profile.max()), off))
    heads = (
        "pixels to a cell",
        "grains",
        "iterations to drain",
        "flow, grains per iteration",
        "drain time, falls through the glass",
        "pile half way: height, pixels",
        "its profile's rms error, pixels",
    )
    return heads, rows
