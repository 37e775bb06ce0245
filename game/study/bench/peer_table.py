"""Peers in the same run: what the same automaton costs written in other ways."""

from game.study.bench import worlds
from game.study.bench.checks import peer_same_as_ours, same_as_twin
from game.study.bench.rounds import MICROSECONDS, ours, take_turns, theirs
from game.study.peers import cpp_blocks
from game.study.peers.byte_loop import BYTE_LOOP
from game.study.peers.numpy_blocks import NUMPY
from game.study.report import table
from game.study.report.report import Section
from game.study.report.table import Column, Table
from game.world.rules.rule import Rule

COLUMNS = (
    Column("size", "lattice", table.size),
    Column("world", "world"),
    Column("name", "implementation"),
    Column("time", "µs per iteration", MICROSECONDS),
    Column("gcells", "Gcell/s", table.three_digits),
    Column("slower", "ours is faster", table.ratio),
    Column("checked", "checked"),
)
OURS = "ours"


def available():
    """Return (peers, notes on those left out)."""
    try:
        return [NUMPY, BYTE_LOOP, cpp_blocks.compiled()], []
    except cpp_blocks.NoCompilerError as error:
        return [NUMPY, BYTE_LOOP], [str(error)]


def peer_table(plan):
    """Return the times of peers and ours on the same worlds."""
    peers, notes = available()
    rows = []
    for size in plan.peer_sizes:
        rows += _rows(size, "all moving, p = 1", worlds.moving(size), Rule(), peers, plan)
        chance = Rule.with_p(0.5, worlds.GLASS_RULE.schedule)
        rows += _rows(size, "hourglass, p = 0.5", worlds.flowing(size), chance, peers, plan)
    notes += [
        f"One thread each, {plan.peer_batch} iterations in one call from the same world; a byte for each cell in every "
        "peer. The numpy rule works on the four corners of all blocks as arrays, the loops take block after block.",
        "Checked: so many iterations of ours gave the plain twin's cells, and so many of each peer ours, at p = 0 and "
        "at p = 1, where the peers' own random numbers decide nothing.",
    ]
    return Section("peers", "2 · Peers in the same run", [Table("", COLUMNS, rows), *notes])


def _rows(size, name, world, rule, peers, plan):
    checked = {OURS: same_as_twin(world, rule, plan.checked)}
    for peer in peers:
        checked[peer.key] = peer_same_as_ours(peer, world, rule, plan.checked)
    workloads = [ours(OURS, world, rule, plan.peer_batch)]
    workloads += [theirs(peer, world, rule, plan.peer_batch) for peer in peers]
    found = take_turns(workloads, plan.rounds, plan.sample_ns)
    names = {**{peer.key: peer.name for peer in peers}, OURS: "ours, bit planes"}
    return [
        {
            "size": size,
            "cells": size[0] * size[1],
            "world": name,
            "key": key,
            "name": names[key],
            "time": found[key],
            "gcells": size[0] * size[1] / found[key].median,
            "slower": None if key == OURS else found[key].times(found[OURS]),
            "checked": checked[key],
        }
        for key in names
    ]
