"""The fine glass: an hourglass in smaller cells, for a large window, that drains in the same time."""

import math
from dataclasses import replace

from game.world.sand import parameters
from game.world.scenes.hourglass import THICKNESS
from game.world.scenes.hourglass_maker import cells_of, resized

COARSE = 3  # pixels: cells this large show the curve of a glass as steps
FINE = 2  # pixels across the cells that it is made of instead: grains can still be told apart
FASTEST = 2500  # iterations per second: more would take much of a core
EVEN = 8  # rows are a multiple of this, so that the neck stands on the axis


def fine_glass(scene, room):
    """Return a scene of one glass in cells that suit a room of (width, height) in pixels; itself where its own do.

    Sand passes the neck grain by grain, so a glass of k times the rows runs k² times the iterations: the pace follows.
    """
    height, width = scene.shape
    if scene.glass is None or scene.coloured or min(room[1] / height, room[0] / width) < COARSE:
        return scene
    rows = min(room[1] / FINE, room[0] / FINE / width * height, height * math.sqrt(FASTEST / scene.speed))
    rows = EVEN * math.floor(rows / EVEN)
    times = rows / height
    if times <= 1.0:
        return scene
    glass = resized(scene.glass, rows)
    glass = replace(glass, wall=THICKNESS.check(scene.glass.wall * math.sqrt(times)))
    return replace(
        scene,
        cells=cells_of(glass, scene.rule.codes),
        glass=glass,
        neck=rows // 2,
        speed=parameters.SPEED.check(scene.speed * times**2),
        cell=FINE,
        shipped=False,
    )
