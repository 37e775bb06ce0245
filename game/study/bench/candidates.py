"""What is timed: our iterations, a peer's, and the memory's own pace. Each starts from the same world every time."""

import numpy as np

from game.study.bench.rounds import Candidate
from game.study.peers.lattice import lattice
from game.world.sand.advance import advance

# Iterations before the clock starts: a world in play has learned where its sand is still, a copy has to learn it anew.
LEAD_IN = 8


def ours(key, world, rule, batch):
    """Return `batch` iterations in one call."""
    return Candidate(key, lambda state: advance(state, rule, batch), _in_play(world, rule), batch)


def ours_one_by_one(key, world, rule, calls):
    """Return `calls` calls of one iteration each."""

    def act(state):
        for _ in range(calls):
            advance(state, rule, 1)

    return Candidate(key, act, _in_play(world, rule), calls)


def _in_play(world, rule):
    """Return what makes copies of `world` that have been running."""

    def fresh():
        state = world.copy()
        advance(state, rule, LEAD_IN)
        return state

    return fresh


def theirs(peer, world, rule, batch):
    """Return `batch` iterations of a peer."""
    cells = lattice(world)
    return Candidate(peer.key, lambda state: peer.advance(state, rule, world.iteration, batch), cells.copy, batch)


def xor_pass(cells, passes):
    """Return the memory's own pace: `passes` passes of numpy.bitwise_xor over as many bits as there are cells.

    In place, a ^= b: it reads as many bits as there are in the planes of sand and walls, and writes as many as in those
    of sand, which is what an iteration cannot do without.
    """
    one = np.arange(-(-cells // 64), dtype=np.uint64)
    other = one * np.uint64(0x9E3779B97F4A7C15)

    def act(_):
        for _ in range(passes):
            np.bitwise_xor(one, other, out=one)

    return Candidate("xor", act, units=passes)
