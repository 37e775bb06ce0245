"""The worlds that are measured: everything moves, an hourglass flows, everything rests. Sizes: (width, height)."""

from functools import lru_cache

import numpy as np

from game.core.compiler.narrowing import ASKED
from game.core.compiler.rule_pass import made_for
from game.world.sand.advance import advance
from game.world.sand.world import World
from game.world.scenes.scene import load_scene

SEED = 2020
GLASS_RULE = load_scene("hourglass").rule  # the rule its scene file names
PASSED = 0.3  # part of the sand that has run through the neck in mid-flow: a pile below, a crater above
TALLEST = 1080  # cells: taller glasses are enlarged from one up to this tall, as their own flow would take minutes …
COOKED = 2048  # iterations of a kitchen in which all that can meet soon has met
REST = 16  # … and then run height / REST iterations, which wears the enlarged corners of their slopes away


@lru_cache(maxsize=2)
def moving(size):
    """Return a lattice without walls, half of its cells sand at random: none of them at rest for a while."""
    width, height = size
    words = np.random.default_rng(SEED).integers(256, size=(height, -(-width // 8)), dtype=np.uint8)
    sand = np.unpackbits(words, axis=1, count=width).view(np.bool_)
    return World.from_cells(sand, np.zeros_like(sand), SEED)


def strewn(size, rule):
    """Return a lattice half of whose cells are empty, the others of all the rule's other materials but wall."""
    width, height = size
    generator = np.random.default_rng(SEED)
    filled = np.array(sorted(rule.codes.filled), np.uint8)
    cells = filled[generator.integers(len(filled), size=(height, width), dtype=np.uint8)]
    return World.from_materials(cells * generator.integers(2, size=cells.shape, dtype=np.uint8), rule, SEED)


def in_colours(world):
    """Return a world with a colour at random for each of its grains."""
    sand = world.sand
    colours = np.random.default_rng(SEED).integers(0, 8, sand.shape, np.uint8) * sand
    coloured = World.from_cells(sand, world.walls, world.seed, colours)
    coloured.iteration = world.iteration
    return coloured


def moving_iterations(size, most):
    """Return for how many iterations, at most `most`, a lattice of `moving` sand has no part at rest to speak of."""
    return max(4, min(most, size[1] // 2 // 4 * 4))


@lru_cache(maxsize=4)
def flowing(size):
    """Return the hourglass scene drawn at `size`, in mid-flow."""
    width, height = size
    if height <= TALLEST:
        return _run_down(load_scene("hourglass", size).world(SEED))
    factor = -(-height // TALLEST)
    shorter = flowing((-(-width // factor), -(-height // factor))).sand
    walls = load_scene("hourglass", size).walls
    sand = shorter.repeat(factor, axis=0).repeat(factor, axis=1)[:height, :width] & ~walls
    world = World.from_cells(sand, walls, SEED)
    advance(world, GLASS_RULE, height // REST)
    return world


@lru_cache(maxsize=1)
def cooking(size, rule):
    """Return the kitchen scene at `size` on its way by alchemy, the passes made that its materials deserve by then."""
    world = load_scene("kitchen", size).world(SEED)
    for _ in range(COOKED // (4 * ASKED)):
        for _ in range(ASKED):
            advance(world, rule, 4)
        made_for(rule.table, rule.values)
    return World.from_materials(world.materials, rule, SEED)


@lru_cache(maxsize=2)
def settled(size):
    """Return the hourglass scene at `size` with all its sand at rest in the lower bulb."""
    world = load_scene("hourglass", size).world(SEED)
    world.flip()
    iterations, before = 64, None
    while before is None or not np.array_equal(before, world.sand):
        before = world.sand
        advance(world, GLASS_RULE, iterations)
        iterations *= 2
    return world


def _run_down(world):
    """Run the hourglass until the part PASSED of its sand is below the middle, and return it."""
    height = world.shape[0]
    enough = PASSED * world.grains
    while world.sand[height // 2 :].sum() < enough:
        advance(world, GLASS_RULE, height)
    return world
