"""Golden pictures: sand, glass, stone and wood look as they always did, to the pixel, through every kind of view."""

import hashlib
import itertools

import numpy as np

from game import advance, load_scene
from game.world.looks.motion_samples import MotionSamples
from game.world.looks.painter import Painter
from game.world.looks.themes import THEMES, WALL_LOOKS
from game.world.looks.view import View
from tests.cells import coloured
from tests.sweeps import sweep

FRAME = (3, 2, 300, 220)
CELLS = (3, 1, 0.7, 0.3, 0.11)  # pixels to a cell: each is drawn or counted in a way of its own
ITERATIONS = 9
GOLDEN = {
    ("hourglass", False): "a928ab3b3e98ac5e",
    ("hourglass", True): "afeea04753fd62ba",
    ("rainbow", True): "e296517e6936e517",
    ("city", False): "be733b31472406fb",
    ("maze", True): "a12072daf5a549b4",
}


def pictures(world, streams):
    """Yield a world's pictures in every theme, with every kind of walls, through every kind of view."""
    middle = world.shape[1] / 2, world.shape[0] / 2
    looks = itertools.product(THEMES.values(), WALL_LOOKS, CELLS, (None, streams), (True, False))
    for colours, walls, cell, followed, mixes in looks:
        view, pixels = View.near(world.shape, FRAME, cell, middle, 150, 110), np.full((230, 310), 7, np.uint32)
        Painter(view, colours, walls, mixes=mixes).draw(world, pixels, streams=followed)
        yield pixels


@sweep(("name", "dyed"), GOLDEN, keep=[("hourglass", True), ("city", False)])
def test_a_scene_looks_as_it_always_did(name, dyed):
    scene, streams, digest = load_scene(name), MotionSamples(), hashlib.blake2b(digest_size=8)
    world = scene.world()
    if dyed and not world.coloured:
        world = coloured(world, np.random.default_rng(1))
    for _ in range(ITERATIONS):
        advance(world, scene.rule, 1)
        streams.note(world)
    for each in pictures(world, streams):
        digest.update(each.tobytes())
    assert digest.hexdigest() == GOLDEN[name, dyed]
