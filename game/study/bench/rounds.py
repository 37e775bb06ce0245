"""Rounds: candidates timed in turns, A B C A B C …, so that noise meets all of them alike."""

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Candidate:
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
        return statistics.median(own / its for own, its in zip(self.samples, other.samples, strict=True))

    def as_dict(self):
        """The median, the range and the number of rounds, as the JSON has them."""
        return {"median_ns": self.median, "low_ns": self.low, "high_ns": self.high, "rounds": len(self.samples)}


def take_turns(candidates, rounds, least_ns):
    """Return {key: Timing} of the candidates, `rounds` rounds of samples of at least `least_ns` each.

    Two acts before them compile, warm caches and find how often a short act must be repeated to fill a sample.
    """
    for each in candidates:
        _elapsed(each, 1)
    repeats = {each.key: -(-least_ns // max(_elapsed(each, 1), 1)) for each in candidates}
    samples = {each.key: [] for each in candidates}
    for _ in range(rounds):
        for each in candidates:
            count = repeats[each.key]
            samples[each.key].append(_elapsed(each, count) / count / each.units)
    return {key: Timing(tuple(found)) for key, found in samples.items()}


def _elapsed(candidate, repeats):
    """Return how many nanoseconds `repeats` acts take, each on a fresh state whose making is not counted."""
    total = 0
    for _ in range(repeats):
        state = candidate.fresh()
        start = time.perf_counter_ns()
        candidate.act(state)
        total += time.perf_counter_ns() - start
    return total
