"""Passes: the machine code of a rule, made when first asked for and checked before it is used."""

from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np

from game.core.compiler import self_check
from game.core.compiler.machine_code import MachineCode, features, lanes, machine
from game.core.compiler.plan import Plan, kinds_of, plan, threshold_of
from game.core.compiler.vector_ir import NAME, chances_of, source
from game.core.jit import kept
from game.core.rule_table import corners

KEPT = 128  # passes in memory; each is some ten kilobytes


class Pass(NamedTuple):
    """A rule ready to run, for one set of probabilities."""

    code: MachineCode  # to be kept as long as its address is used
    chances: np.ndarray  # see `vector_ir`
    outside: np.ndarray  # uint64: for each bit of a cell, payload last, a word of what is outside
    changing: np.ndarray  # bool: whether a bit of a cell can change
    outside_code: int
    edges: tuple  # two bools: whether blocks whose upper, and whose lower corners are outside have events
    lanes: int  # words it takes at a time

    @property
    def run(self):
        """What `core.step` needs of it for a band."""
        return self.code.address, self.outside, self.changing, self.chances


@lru_cache(maxsize=64)
def pass_of(table, probabilities, payload=0, most_lanes=None):
    """Return the Pass of a RuleTable for a tuple of probabilities, one for each slot.

    payload: bits that go with a cell's content and decide nothing. most_lanes: words at a time at most. Raises
    RuntimeError where the machine code of this machine does not do what the table says.
    """
    kinds = kinds_of(table, probabilities)
    made = _compiled(table, tuple(kinds.items()), payload, min(lanes(), most_lanes or lanes()))
    chances = chances_of(made.plan, lambda _, slots: threshold_of(slots, probabilities))
    total = table.bits + payload
    outside = np.array([(2**64 - 1) * (table.outside >> bit & 1) for bit in range(total)], np.uint64)
    turned = {bit for layer in made.plan.layers for level in layer.deltas for _, bit in level}
    changing = np.array([bit in turned or bit >= table.bits for bit in range(total)])
    return Pass(made.code, chances, outside, changing, table.outside, edges_of(table), made.lanes)


@lru_cache(maxsize=KEPT)
def gates_of(table, kinds):
    """Return the Plan of a RuleTable; kinds: the items of what `kinds_of` returns."""
    return plan(table, dict(kinds))


def edges_of(table):
    """Return whether blocks whose upper, and whose lower corners are outside have events: two bools."""
    return _events_beside(table, (0, 1)), _events_beside(table, (2, 3))


class _CompiledRule(NamedTuple):
    plan: Plan
    code: MachineCode
    lanes: int


@lru_cache(maxsize=KEPT)
def _compiled(table, kinds, payload, most_lanes):
    """Return what is the same for all probabilities of the same kinds; the machine code is kept between runs."""
    key = f"{table.digest} {kinds} {payload} {most_lanes} {machine()} {features()}"
    gates, at_once, text, code = kept(key, partial(_made, table, kinds, payload, most_lanes))
    return _CompiledRule(gates, MachineCode(text, NAME, code), at_once)


def _made(table, kinds, payload, most_lanes):
    """Return (Plan without its circuit, words at a time, LLVM IR, machine code) of a pass that was checked."""
    gates = gates_of(table, kinds)
    for at_once in dict.fromkeys((most_lanes, 1)):
        text = source(gates, at_once, payload)
        made = MachineCode(text, NAME)
        if self_check.agrees(made.address, table, gates, dict(kinds), payload, at_once):
            return gates._replace(circuit=None), at_once, text, made.code
    raise RuntimeError(f"the code made for this rule moves blocks otherwise than its table says: {machine()}")


def _events_beside(table, row):
    """Return whether a claim holds a state in which a row of corners is outside."""
    states = [corners(claim.states, table.bits) for layer in table.layers for claim in layer]
    return any((np.all([codes[corner] == table.outside for corner in row], axis=0)).any() for codes in states)
