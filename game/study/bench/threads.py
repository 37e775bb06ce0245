"""Threads: what a second one would give. The kernels release the interpreter's lock; the product uses one thread."""

import os
from concurrent.futures import ThreadPoolExecutor

from game.study.bench import goals, table, worlds
from game.study.bench.checks import WrongCellsError
from game.study.bench.rounds import Candidate, take_turns
from game.study.bench.table import Column, Table
from game.world.sand.advance import advance
from game.world.sand.rule import Rule

COLUMNS = (
    Column("name", "work"),
    Column("time", "µs per iteration", table.MICROSECONDS),
    Column("gain", "of one thread", table.ratio),
)
BATCH = 200  # iterations between two meetings of the threads: meeting after each one would cost more


def thread_table(plan):
    """Return the pace of one thread and of two on lattices of half the size, and what follows from it."""
    half = (plan.thread_size[0], plan.thread_size[1] // 2)
    world, rule = worlds.moving(half), Rule()
    with ThreadPoolExecutor(2) as pool:
        _check(pool, world, rule)
        found = take_turns(
            [
                Candidate("one", lambda pair: _one(pair, rule, BATCH), lambda: _pair(world), BATCH),
                Candidate("two", lambda pair: _two(pool, pair, rule, BATCH), lambda: _pair(world), BATCH),
            ],
            plan.rounds,
            plan.sample_ns,
        )
    gain = found["one"].times(found["two"])
    rows = [
        {"name": "one thread, one half after the other", "time": found["one"], "gain": 1.0},
        {"name": "two threads, a half each", "time": found["two"], "gain": gain},
    ]
    return Table("threads", "6 · Threads", COLUMNS, rows, _notes(plan, gain))


def _notes(plan, gain):
    enough = os.cpu_count() >= 2 and gain >= goals.THREADS
    verdict = "the bound leaves room for one" if enough else "so there is none"
    return [
        f"{table.size(plan.thread_size)} cells as two halves that know nothing of each other, all moving, p = 1, "
        f"{BATCH} iterations between two meetings: an upper bound of what a second thread can give.",
        f"A second thread is wanted from {goals.THREADS}× on, measured {table.ratio(gain)} on {os.cpu_count()} cores: "
        f"{verdict}. The product runs on one thread.",
    ]


def _pair(world):
    return world.copy(), world.copy()


def _one(pair, rule, iterations):
    for world in pair:
        advance(world, rule, iterations)


def _two(pool, pair, rule, iterations):
    list(pool.map(lambda world: advance(world, rule, iterations), pair))


def _check(pool, world, rule):
    """Raise WrongCellsError unless two threads give the worlds that one gives."""
    alone, together = _pair(world), _pair(world)
    _one(alone, rule, BATCH)
    _two(pool, together, rule, BATCH)
    if [each.digest() for each in alone] != [each.digest() for each in together]:
        raise WrongCellsError("two threads give other worlds than one: nothing was timed")
