"""Differences: the cells in which worlds of one shape hold other materials."""

import numpy as np

from game.core import planes as bit_planes


def differing(worlds):
    """Return for each of some worlds, of one shape, in which cells it differs from the first: (H, W) bool arrays.

    For the first it is where any other differs. Materials are alike that have one name.
    """
    first, *others = worlds
    found = [_differing_planes(first, other) for other in others]
    found.insert(0, np.bitwise_or.reduce(found))
    height, width = first.shape
    where = bit_planes.layout(height, width)
    return [bit_planes.unpack(np.concatenate([each, np.zeros_like(each)]), where).view(np.bool_) for each in found]


def _differing_planes(one, other):
    """Return four planes of the cells in which two worlds differ."""
    found = np.zeros((4, one.layout.length), np.uint64)
    if one.codes == other.codes:
        for first in range(0, 4 * one.layout.bits, 4):
            found |= one.planes[first : first + 4] ^ other.planes[first : first + 4]
        return found
    for name in {*one.codes.told, *other.codes.told}:
        found |= _planes_of(one, name) ^ _planes_of(other, name)
    return found


def _planes_of(world, name):
    if name not in world.codes.told:
        return np.zeros((4, world.layout.length), np.uint64)
    return bit_planes.planes_where(world.planes, world.layout, world.codes.codes_of(name))
