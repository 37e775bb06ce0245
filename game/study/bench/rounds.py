"""Rounds: workloads timed in turns, A B C A B C …, so that noise meets all of them alike."""

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from game.study.peers.exported_header import copy_of
from game.study.peers.lattice import lattice
from game.study.report.table import three_digits
from game.world.sand.advance import advance

# Iterations before the clock starts: a world in play has learned where its sand is still, a copy has to learn it anew.
LEAD_IN = 8


@dataclass(frozen=True)
class Workload:
    """Something to time: `act` on a `fresh` state does `units` of work; only `act` is timed."""

    key: str
    act: Callable  # takes the state
    fresh: Callable = lambda: None  # returns a state
    units: int = 1


@dataclass(frozen=True)
class Timing:
    """What one unit of work took, in nanoseconds: one mean for each round."""

    samples: tuple

    @property
    def median(self):
        """The median round."""
        return statistics.median(self.samples)

    @property
    def low(self):
        """The fastest round."""
        return min(self.samples)

    @property
    def high(self):
        """The slowest round."""
        return max(self.samples)

    def times(self, other):
        """Return how many times as long as `other` this took: the median over the rounds they shared."""
        return statistics.median(mine / theirs for mine, theirs in zip(self.samples, other.samples, strict=True))

    def as_dict(self):
        """The median, the range and the number of rounds, as the JSON has them."""
        return {"median_ns": self.median, "low_ns": self.low, "high_ns": self.high, "rounds": len(self.samples)}


def take_turns(workloads, rounds, least_ns):
    """Return {key: Timing} of the workloads, `rounds` rounds of samples of at least `least_ns` each.

    Two acts before them compile, warm caches and find how often a short act must be repeated to fill a sample.
    """
    for each in workloads:
        _elapsed(each, 1)
    repeats = {each.key: -(-least_ns // max(_elapsed(each, 1), 1)) for each in workloads}
    samples = {each.key: [] for each in workloads}
    for _ in range(rounds):
        for each in workloads:
            count = repeats[each.key]
            samples[each.key].append(_elapsed(each, count) / count / each.units)
    return {key: Timing(tuple(found)) for key, found in samples.items()}


def _elapsed(workload, repeats):
    """Return how many nanoseconds `repeats` acts take, each on a fresh state whose making is not counted."""
    total = 0
    for _ in range(repeats):
        state = workload.fresh()
        start = time.perf_counter_ns()
        workload.act(state)
        total += time.perf_counter_ns() - start
    return total


def _spread(unit_ns, timing):
    """Return a Timing in a unit of so many nanoseconds: the median, and the range over the rounds."""
    low, high = (three_digits(each / unit_ns) for each in (timing.low, timing.high))
    return f"{three_digits(timing.median / unit_ns)} ({low}–{high})"


MILLISECONDS, MICROSECONDS = partial(_spread, 1e6), partial(_spread, 1e3)


def ours(key, world, rule, batch, calls=1):
    """Return `calls` calls of `batch` iterations each."""

    def act(state):
        for _ in range(calls):
            advance(state, rule, batch)

    return Workload(key, act, _in_play(world, rule), batch * calls)


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
    return Workload(peer.key, lambda state: peer.advance(state, rule, world.iteration, batch), cells.copy, batch)


def header_in_c(key, header, world, batch):
    """Return `batch` iterations of an ExportedHeader on a world at iteration 0."""
    memory = header.memory_of(world)

    def fresh():
        state = copy_of(memory)
        header.advance(state, LEAD_IN)
        return state

    return Workload(key, lambda state: header.advance(state, batch), fresh, batch)


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

    return Workload("xor", act, units=passes)
