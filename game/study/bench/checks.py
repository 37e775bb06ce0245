"""Checks: no time is printed for cells that differ from the plain twin's."""

import numpy as np

from game.study.peers import numpy_blocks, table_blocks
from game.study.peers.block_table import block_table, loop_chances
from game.study.peers.lattice import lattice, sand
from game.world.rules.rule import Rule
from game.world.sand.advance import advance

WORK = 200_000_000  # cells × iterations of one check: the twin takes about a second for them, and longer for chance
TABLE_WORK = 8_000_000  # the same for the twin of any rule
FEWEST = 4  # iterations: each schedule has then used all its partitions
SHORTEST = 2 * FEWEST  # the same for sand


class WrongCellsError(Exception):
    """An implementation moved sand elsewhere than the twin; says which, where and when."""


def iterations_for(cells, most):
    """Return how many iterations of a lattice of so many cells are compared, at most `most`."""
    return min(most, max(SHORTEST, WORK // cells))


def same_as_twin(world, rule, most):
    """Return for how many iterations `advance` and the twin agree from `world` on; raise WrongCellsError."""
    iterations = iterations_for(world.sand.size, most)
    twin = lattice(world)
    chance = numpy_blocks.product_chance(world.seed, world.shape[1])
    numpy_blocks.advance(twin, rule, world.iteration, iterations, chance)
    ours = world.copy()
    advance(ours, rule, iterations)
    _compare("advance", ours.sand, sand(twin), world.shape, iterations)
    return iterations


def same_with_colours(world, coloured, rule, most):
    """Return for how many iterations the cells of a coloured world evolve as those of `world` do without.

    Raises WrongCellsError if they do not, or if the number of grains of any colour changes.
    """
    iterations = iterations_for(world.sand.size, most)
    plain, dyed = world.copy(), coloured.copy()
    for each in (plain, dyed):
        advance(each, rule, iterations)
    _compare("advance with colours", dyed.sand, plain.sand, world.shape, iterations)
    if dyed.amounts != coloured.amounts:
        raise WrongCellsError("advance made or lost grains of a colour: nothing was timed")
    return iterations


def peer_same_as_ours(peer, world, rule, most):
    """Return for how many iterations `peer` agrees with `advance`, where it is checked against the twin beside it.

    The topple probabilities of `rule` are rounded to 0 and to 1 in turns, where both must agree cell by cell.
    """
    iterations = iterations_for(world.sand.size, most)
    for p in (0.0, 1.0):
        known = Rule.with_p(p, rule.schedule)
        theirs, ours = lattice(world), world.copy()
        peer.advance(theirs, known, world.iteration, iterations)
        advance(ours, known, iterations)
        _compare(peer.name, sand(theirs), ours.sand, world.shape, iterations)
    return iterations


def same_as_table_twin(world, rule, most):
    """Return for how many iterations `advance` and the twin of any rule agree from `world` on."""
    iterations = _iterations_of_any(world, most)
    twin, ours = lattice(world), world.copy()
    chances = table_blocks.product_chances(world.seed, world.shape[1])
    table_blocks.advance(twin, rule, world.iteration, iterations, table_blocks.layers_of(rule), chances)
    advance(ours, rule, iterations)
    _compare("advance", lattice(ours), twin, world.shape, iterations)
    return iterations


def table_peers_same_as_twin(peers, world, rule, most):
    """Return for how many iterations peers and the twin of any rule agree, all with the peers' table and numbers."""
    iterations = _iterations_of_any(world, most)
    twin = lattice(world)
    layers, chances = [block_table(rule).as_layer()], loop_chances(world.shape[1])
    table_blocks.advance(twin, rule, world.iteration, iterations, layers, chances)
    for peer in peers:
        theirs = lattice(world)
        peer.advance(theirs, rule, world.iteration, iterations)
        _compare(peer.name, theirs, twin, world.shape, iterations)
    return iterations


def header_same_as_ours(name, header, world, rule, most):
    """Return for how many iterations an ExportedHeader and `advance` agree; raise WrongCellsError if they do not."""
    iterations = _iterations_of_any(world, most)
    memory, ours = header.memory_of(world), world.copy()
    header.advance(memory, iterations)
    advance(ours, rule, iterations)
    _compare(name, header.materials(memory, world.shape), ours.materials, world.shape, iterations)
    return iterations


def _iterations_of_any(world, most):
    return min(most, max(FEWEST, TABLE_WORK // world.materials.size))


def _compare(name, found, wanted, shape, iterations):
    if not np.array_equal(found, wanted):
        wrong = np.argwhere(found != wanted)
        row, column = wrong[0]
        raise WrongCellsError(
            f"{name} differs from the plain twin in {len(wrong):,} cells of {shape[1]}×{shape[0]} after {iterations} "
            f"iterations, first in row {row}, column {column}: nothing was timed"
        )
