"""When the last grain passes the neck: the iteration, computed ahead of time on a copy of the session."""

import time
from dataclasses import dataclass, replace

import numpy as np

from game.core.chance import threshold
from game.world.sand.advance import advance
from game.world.sand.block_events import can_change
from game.world.sand.crop import CropBox
from game.world.sand.ensemble import Cancelled
from game.world.sand.fixtures import TAP
from game.world.sand.neck import find_neck

BATCH = 64  # iterations before the first look; their number doubles while a batch takes less than BATCH_NS
BATCH_NS = 4_000_000  # work between two looks at the neck and at `cancelled`
MOST_ITERATIONS = 50_000_000  # what has not ended by then counts as endless: at 240 a second it is two days
MOST_NS = 30 * 10**9  # work after which the search is given up
MOST_NS_BY_TAPS = 2 * 10**9  # the same where taps pour: such sand hardly ever ends


@dataclass(frozen=True)
class RunOut:
    """What is known of a session's way to its last grain."""

    start: int  # the iteration of the session at which the search began
    at: int  # the iteration by which the last grain has passed; `start` where none will
    has_neck: bool  # False: there is no neck, and the last grain is the last that moves at all
    endless: bool  # the search was given up: sand was still passing, or could, when `at` was reached
    iteration_ns: float  # what an iteration took on the way, on average
    left: int = 0  # grains that stay above the neck, if there is one

    @property
    def iterations(self):
        """How many iterations there are from the start of the search to the last grain."""
        return self.at - self.start


def find_run_out(lookahead, cancelled=None, most_iterations=MOST_ITERATIONS, most_ns=MOST_NS):
    """Return the RunOut of a Lookahead, which is used up.

    Grains that stick forever do not count: the end is the last iteration at which anything changes above the neck
    or, where there is no neck, anywhere; the last act still to come is one that does. cancelled(), if given, is asked
    every few milliseconds; once it returns true, Cancelled is raised.
    """
    start, work_ns = lookahead.now, lookahead.moment.work_ns
    if any(each.kind == TAP for each in lookahead.world.fixtures):
        most_ns = min(most_ns, MOST_NS_BY_TAPS)
    if lookahead.last_act is not None:
        _run_in_batches(lookahead, lookahead.last_act, cancelled)
    last_act, neck = lookahead.now, find_neck(lookahead.world)
    sign = _sign(neck)
    before, left, endless = _last_change(lookahead, sign, cancelled, start + most_iterations, work_ns + most_ns)
    at = last_act if before is None else _exactly(before, lookahead.now, sign, left)
    spent_ns = lookahead.moment.work_ns - work_ns
    stay = left if neck else 0
    return RunOut(start, at, neck is not None, endless, spent_ns / max(1, lookahead.now - start), stay)


def _exactly(lookahead, end, sign, left):
    """Return the last iteration up to `end` at which the sign changes; from there on it is `left`."""
    if not lookahead.world.fixtures:
        return first_moment(lookahead, end, lambda world: sign(world) == left)
    last, before = lookahead.now, sign(lookahead.world)
    while lookahead.now < end:  # a tap brings back what has passed, so that no half can be left out
        lookahead.run_to(lookahead.now + 1)
        if sign(lookahead.world) != before:
            last, before = lookahead.now, sign(lookahead.world)
    return last


def first_moment(lookahead, end, reached):
    """Return the first iteration up to `end` at which `reached(world)` is true, and stays so; it is by `end`."""
    if reached(lookahead.world):
        return lookahead.now
    while end - lookahead.now > 1:
        middle = lookahead.copy()
        middle.run_to((lookahead.now + end) // 2)
        if reached(middle.world):
            end = middle.now
        else:
            lookahead = middle
    return end


def at_rest(world, rule):
    """Return whether nothing can change any more under `rule`: neither now nor by any chance it leaves."""
    trial = world.copy()
    trial.fixtures = tuple(replace(each, every=1) for each in world.fixtures)
    if rule.is_sand:
        eager = rule.with_chances(**{name: _possible(p) for name, p in rule.chances.items()})
        advance(trial, eager, len(rule.offsets))
        return bool(np.array_equal(_contents(trial), _contents(world)))
    advance(trial, rule, len(rule.offsets))
    if not np.array_equal(_contents(trial), _contents(world)):
        return False
    return not any(can_change(world, rule, box) for box in _restless(trial, len(rule.offsets)))


def _restless(world, iterations):
    """Yield the CropBoxes of the bands in which an event had a block in so many last iterations."""
    rows = 2 * world.activity.band_rows
    for band in np.flatnonzero(world.activity.quiet < iterations).tolist():
        yield CropBox.within(world.shape, band * rows, 0, (band + 1) * rows, world.shape[1])


def _possible(p):
    return 1.0 if threshold(p) else 0.0


def _sign(neck):
    """Return a function of a world whose value changes whenever sand passes the neck or, without one, moves."""
    return neck.grains_above if neck else lambda world: _contents(world).tobytes()


def _contents(world):
    """Return the words of what the cells hold, colours left out, without the seams, which tell nothing."""
    where = world.layout
    planes = world.planes[: 4 * where.bits, : where.rows * where.stride]
    return planes.reshape(-1, where.rows, where.stride)[:, :, : where.words]


def _last_change(lookahead, sign, cancelled, last, last_ns):
    """Run until no sand can pass; return (lookahead before the batch of the last change, or None; final sign; endless).

    last, last_ns: the iteration and the work at which the search is given up.
    """
    before, left, batch = None, sign(lookahead.world), BATCH
    while left and not at_rest(lookahead.world, lookahead.moment.rule):
        if lookahead.now >= last or lookahead.moment.work_ns >= last_ns:
            return before, left, True
        _check(cancelled)
        kept, began = lookahead.copy(), lookahead.moment.work_ns
        lookahead.run_to(lookahead.now + batch)
        now = sign(lookahead.world)
        if now != left:
            before, left = kept, now
        if lookahead.moment.work_ns - began < BATCH_NS:
            batch *= 2
    return before, left, False


def _run_in_batches(lookahead, end, cancelled):
    while lookahead.now < end:
        _check(cancelled)
        began = time.perf_counter_ns()
        batch = BATCH
        while lookahead.now < end and time.perf_counter_ns() - began < BATCH_NS:
            lookahead.run_to(min(end, lookahead.now + batch))
    lookahead.run_to(end)


def _check(cancelled):
    if cancelled is not None and cancelled():
        raise Cancelled
