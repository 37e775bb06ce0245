"""Fields of blocks that can do nothing but topple, which show the random bits that the kernels draw."""

from math import expm1, log1p

import numpy as np

from game import Rule, World, advance
from game.core.planes import SAND
from game.world.sand.ensemble import counts_at

BLOCKS = 2048  # blocks across and down a field: 4 million random bits at a time
REPLICA_POSTS = 100  # posts in a row of replicas
TOPPLED = SAND + 3  # plane of the cells in odd rows and columns, where a grain of `posts` lands


def field():
    """Return a World of posts two grains high, each of which can topple to the right into the space beside it."""
    sand = np.zeros((2 * BLOCKS, 2 * BLOCKS), bool)
    sand[:, 0::2] = True
    return World.from_cells(sand, np.zeros_like(sand))


def toppled(start, p, seed, iteration):
    """Return (BLOCKS - 1, BLOCKS - 1) bool: which blocks of a `field` topple with probability p in one iteration."""
    world = start.copy()
    world.seed, world.iteration = seed, iteration
    rule = Rule.with_p(p, "margolus")
    advance(world, rule, 1)
    down, right = (2, 1) if iteration % len(rule.offsets) else (1, 1)  # where the grains of this partition land
    return world.sand[down::2, right::2][: BLOCKS - 1, : BLOCKS - 1]


def fractions(start, digits, seed, iteration):
    """Return the uniform number of each block, rounded down to a multiple of 2**-digits, in units of that.

    A block topples where its number is below p, so its number is how many of the p = k · 2**-digits it withstands.
    Raises ValueError if one topples at some p and not at a larger one.
    """
    number = np.zeros((BLOCKS - 1, BLOCKS - 1), np.uint8)
    before = np.zeros(number.shape, bool)
    for k in range(1, 2**digits):
        now = toppled(start, k * 2.0**-digits, seed, iteration)
        if (before & ~now).any():
            raise ValueError(f"a block topples at p = {k - 1}/{2**digits} and not at {k}/{2**digits}")
        number += ~now
        before = now
    return number


def posts():
    """Return a World like `field` in which a toppled grain stays where it lands: walls are under every post."""
    sand = np.zeros((2 * BLOCKS, 2 * BLOCKS), bool)
    walls = np.zeros_like(sand)
    sand[0::4, 0::2] = sand[1::4, 0::2] = True
    walls[2::4] = walls[3::4] = True
    return World.from_cells(sand, walls)


def count_toppled(start, p, trials, seed):
    """Return (toppled, expected, trials) for `posts` that try again and again, and few of which succeed."""
    world, rule = start.copy(), Rule.with_p(p, "margolus")
    world.seed = seed
    candidates = start.grains // 2
    attempts = -(-trials // candidates)
    advance(world, rule, len(rule.offsets) * attempts)
    count = int(np.bitwise_count(world.planes[TOPPLED]).sum())
    return count, -candidates * expm1(attempts * log1p(-p)), attempts * candidates


def count_standing(start, p, trials, seed):
    """Return (standing, expected, trials) for `posts` that try once, world after world, and few of which fail."""
    rule = Rule.with_p(p, "margolus")
    candidates = start.grains // 2
    attempts = -(-trials // candidates)
    standing = 0
    for attempt in range(attempts):
        world = start.copy()
        world.seed, world.iteration = seed, len(rule.offsets) * attempt
        advance(world, rule, 1)
        standing += candidates - int(np.bitwise_count(world.planes[TOPPLED]).sum())
    return standing, attempts * candidates * (1.0 - p), attempts * candidates


def count_toppled_replicas(p, runs, attempts, seed):
    """Return (toppled, expected, trials) for a row of posts in `runs` replicas that try `attempts` times."""
    sand = np.zeros((2, 2 * REPLICA_POSTS), bool)
    sand[:, 0::2] = True
    rule = Rule.with_p(p, "margolus")
    counts = counts_at(World.from_cells(sand, np.zeros_like(sand), seed), rule, [len(rule.offsets) * attempts], runs)
    candidates = runs * REPLICA_POSTS
    return int(counts[0, 1, 1::2].sum()), -candidates * expm1(attempts * log1p(-p)), attempts * candidates
