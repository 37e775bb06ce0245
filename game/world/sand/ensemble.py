"""Forecasts: where sand will be, from many independent runs that start alike.

Runs are replicas of one lattice, moved in groups so that memory is bounded. What a run does is a function of the seed
and of its own number: neither groups nor threads nor progress change a bit. The interpreter lock is released meanwhile.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from game.core.chance import CERTAIN, threshold
from game.core.compiler.rule_pass import pass_of
from game.core.ensemble.runs import BITS, advance_replicas, count_replicas, read_states, replicate
from game.world.sand import parameters
from game.world.sand.fixtures import act_on_replicas, changed_bits, pause
from game.world.sand.material_codes import SAND_NAME, check_held

MOST_WORDS = 64  # words of a bit of a cell in a group at most; more is no faster
# Words of a bit of all cells in a group, 64 MiB; more is faster on large lattices, but slow to lay out.
GROUP_WORDS = 2**23
FEW_WORDS = 8  # words in the first group of a forecast that grows: so much is cheaper by the run than less
BITE = 15_000  # work between two looks at `cancelled`, 1-10 ms; less costs speed on small lattices
STATE_CELLS = 64  # cells of a lattice whose state fits a word

_MASK = 2**64 - 1
_RUNS = parameters.RUNS.default


class Cancelled(Exception):  # noqa: N818 (not an error: the caller asked for it)
    """Raised by a computation whose `cancelled` returned true; nothing is kept of it."""


class Ensemble(NamedTuple):
    """What all runs have in common."""

    world: object  # where they start: a World, which is not changed
    cells: np.ndarray  # its codes, (H, W) uint8
    counted: tuple  # the codes that are counted
    rule: object  # a Rule
    runs: int

    @property
    def weight(self):
        """How many runs a replica stands for: all of them where nothing is left to chance."""
        return self.runs if certain(self.rule) else 1


def certain(rule):
    """Return whether `rule` leaves nothing to chance, so that all runs are alike."""
    return not rule.table.has_fair_bit and all(threshold(p) in (0, CERTAIN) for p in rule.values)


def density(world, rule, iterations, runs=_RUNS, of=SAND_NAME, progress=None, cancelled=None):
    """Return the fraction of `runs` independent runs that have a material in each cell after `iterations`.

    It is (H, W) float64. Each run starts as `world` is, which is not changed: with its iteration and its fixtures, and
    by its seed. of: the name of the material. progress(done_runs), if given, is called with the work done so far, in
    runs, up to `runs`. cancelled(), if given, is asked every few milliseconds; once it returns true, Cancelled is
    raised. Raises ValueError for a rule of other materials than the world's, for an unknown material, for `runs`
    outside [1, 10**9] and for other numbers out of range.
    """
    return counts_at(world, rule, [iterations], runs, of, progress, cancelled)[0] / runs


def counts_at(world, rule, moments, runs=_RUNS, of=SAND_NAME, progress=None, cancelled=None):
    """Return how many runs have a material in each cell at each moment: (moments, H, W) int64, exact.

    moments: iterations since the start, in rising order. The rest is as for `density`.
    """
    ensemble, moments = _checked(world, rule, runs, of), _checked_moments(moments)
    counts = np.zeros((len(moments), *world.shape), np.int64)
    for moment, _, group in _follow(ensemble, moments, progress, cancelled):
        _count(group, ensemble, counts[moment])
    return counts


def growing_counts(world, rule, iterations, runs=_RUNS, of=SAND_NAME, cancelled=None):
    """Yield (runs so far, how many of them have a material in each cell) after more and more runs, up to `runs`.

    The counts are one (H, W) int64 array, added to in place: each time what `counts_at` gives for so many runs. The
    rest is as for `density`.
    """
    ensemble, moments = _checked(world, rule, runs, of), _checked_moments([iterations])
    counts = np.zeros(world.shape, np.int64)
    for _, first, group in _follow(ensemble, moments, cancelled=cancelled, few=FEW_WORDS):
        _count(group, ensemble, counts)
        yield min(ensemble.runs, ensemble.weight * (first + len(group.seeds) * BITS)), counts


def states_at(world, rule, moments, runs=_RUNS, of=SAND_NAME, progress=None, cancelled=None):
    """Return the state of each run at each moment: (moments, runs) uint64; bit y·W + x is a material in cell (y, x).

    The lattice has 64 cells at most, else ValueError is raised, and the material one code. The rest is as for
    `counts_at`.
    """
    ensemble, moments = _checked(world, rule, runs, of), _checked_moments(moments)
    if ensemble.cells.size > STATE_CELLS:
        raise ValueError(f"states are of lattices of {STATE_CELLS} cells at most, got {ensemble.cells.size}")
    (code,) = ensemble.counted
    states = np.empty((len(moments), ensemble.runs), np.uint64)
    for moment, first, group in _follow(ensemble, moments, progress, cancelled):
        if ensemble.weight > 1:
            read_states(group, code, states[moment, :1])
            states[moment] = states[moment, 0]
        else:
            read_states(group, code, states[moment, first : first + len(group.seeds) * BITS])
    return states


class FollowedRuns:
    """Runs of one group that are followed from moment to moment: `density` at one after another, none of it twice."""

    def __init__(self, world, rule, runs, of=SAND_NAME):
        """Start `runs` runs, as for `density`; `world` must stay as it is meanwhile."""
        self._ensemble = _checked(world, rule, runs, of)
        self.runs = self._ensemble.runs
        self._group = _group(self._ensemble, 0, self.runs // self._ensemble.weight)
        self.now = 0  # iterations since the start

    @property
    def certain(self):
        """Whether all runs are alike."""
        return self._ensemble.weight > 1

    def run_to(self, moment, cancelled=None):
        """Go on to a moment that is not before `now`; once cancelled() has returned true, Cancelled is raised."""
        for _ in _stretches(self._group, self._ensemble, self.now, moment, cancelled):
            pass
        self.now = moment

    def counts(self):
        """Return how many runs have the material in each cell now: (H, W) int64."""
        counts = np.zeros(self._ensemble.world.shape, np.int64)
        _count(self._group, self._ensemble, counts)
        return counts


def _count(group, ensemble, counts):
    for code in ensemble.counted:
        count_replicas(group, code, ensemble.weight, counts)


def _checked(world, rule, runs, of):
    check_held(rule, world)
    counted = tuple(sorted(world.codes.codes_of(of)))
    return Ensemble(world, world.materials, counted, rule, parameters.RUNS.check(runs))


def _checked_moments(moments):
    moments = [parameters.ITERATIONS.check(moment) for moment in moments]
    for earlier, later in pairwise(moments):
        if later < earlier:
            raise ValueError(f"moments must be in rising order, got {later} after {earlier}")
    return moments


def _groups(ensemble, few):
    """Yield (number of the first run, runs) of each group; with `few` words to begin with, and then ever more."""
    replicas = ensemble.runs // ensemble.weight
    most = max(1, min(MOST_WORDS, GROUP_WORDS // ensemble.cells.size))
    first, words = 0, min(few, most)
    while first < replicas:
        here = min(BITS * words, replicas - first)
        yield first, here
        first += here
        words = min(2 * words, most)


def _group(ensemble, first, runs):
    """Return the Replicas of so many runs from number `first` on."""
    world, moving = ensemble.world, _pass_for(ensemble.rule, -(-runs // BITS))
    more_bits = changed_bits(world.fixtures, world.codes)
    return replicate(ensemble.cells, moving, world.seed, first, runs, more_bits)


def _follow(ensemble, moments, progress=None, cancelled=None, few=MOST_WORDS):
    """Yield (number of the moment, number of the first run, replicas) for each group of runs at each moment."""
    work = ensemble.runs // ensemble.weight * max(moments, default=0)
    for first, here in _groups(ensemble, few):
        group = _group(ensemble, first, here)
        now = 0
        for number, moment in enumerate(moments):
            for done in _stretches(group, ensemble, now, moment, cancelled):
                if progress is not None:
                    progress(ensemble.runs * (first * moments[-1] + here * done) // work)
            now = moment
            yield number, first, group
    if progress is not None:
        progress(ensemble.runs)


def _stretches(group, ensemble, now, moment, cancelled):
    """Run a group to iteration `moment` in place, its fixtures acting; yield how many are done."""
    while now < moment:
        end = moment
        world = ensemble.world
        if world.fixtures:
            begin = world.iteration + now
            act_on_replicas(world.fixtures, world.codes, begin, group)
            end = min(end, now + pause(world.fixtures, begin))
        for done in _bites(group, ensemble, now, end - now, cancelled):
            yield now + done
        now = end


def _bites(group, ensemble, now, iterations, cancelled):
    """Run iterations `now`, now + 1 … of a group in place, a bite at a time; yield how many are done."""
    begin = ensemble.world.iteration + now
    offsets = np.array(ensemble.rule.offsets, np.int64)
    offsets = np.roll(offsets, -(begin % len(offsets)), axis=0)
    moving = _pass_for(ensemble.rule, len(group.seeds))
    run = moving.code.address, moving.chances
    done = row = 0
    while done < iterations:
        if cancelled is not None and cancelled():
            raise Cancelled
        done, row = advance_replicas(group, run, offsets, np.uint64(begin & _MASK), iterations, done, row, BITE)
        yield done


def _pass_for(rule, words):
    """Return the Pass that moves groups of so many words, no more of them at a time than there are."""
    return pass_of(rule.table, rule.values, most_lanes=1 << (words - 1).bit_length())
