"""Passes: the machine code of a rule, made when first asked for and checked before it is used."""

import pickle
from contextlib import suppress
from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np

from game.core.compiler import dispatch, self_check
from game.core.compiler.beside import run_beside
from game.core.compiler.dispatch import DispatchTable
from game.core.compiler.machine_code import MachineCode, compiled, features, lanes, machine
from game.core.compiler.narrowing import LEAST_GATES, NarrowPasses
from game.core.compiler.plan import Plan, gate_count, kinds_of, plan, threshold_of, thresholds_in
from game.core.compiler.vector_ir import NAME, chances_of, source
from game.core.jit import kept, read
from game.core.rule_table import corners

LARGEST_BITS = 4  # of a cell, in rules that take long to compile
KEPT = 128  # passes in memory; each is some ten kilobytes


class Pass(NamedTuple):
    """A rule ready to run, for one set of probabilities."""

    code: MachineCode  # to be kept as long as its address is used
    chances: np.ndarray  # see `vector_ir`, or `dispatch` where `kept` holds a DispatchTable
    outside: np.ndarray  # uint64: for each bit of a cell, payload last, a word of what is outside
    changing: np.ndarray  # bool: whether a bit of a cell can change
    outside_code: int
    edges: tuple  # two bools: whether blocks whose upper, and whose lower corners are outside have events
    lanes: int  # words it takes at a time
    kept: object = None  # what `chances` leads to

    @property
    def run(self):
        """What `core.step` needs of it for a band."""
        return self.code.address, self.outside, self.changing, self.chances


def pass_of(table, probabilities, payload=0, most_lanes=None):
    """Return the Pass of a RuleTable for a tuple of probabilities, one for each slot.

    payload: bits that go with a cell's content and decide nothing. most_lanes: words at a time at most. Of a large rule
    a later Pass may be quicker, see `narrowing`. Raises RuntimeError where the machine code of this machine does not do
    what the table says.
    """
    passes = _passes(table, probabilities, payload, most_lanes)
    if passes.narrow:
        passes.narrow.look()
    return passes.current()


def make_beside(table, probabilities):
    """Have the pass of a large RuleTable made and kept by another process, if that can be, and wait for it.

    A thread that waits holds nobody up; one that makes such a pass makes frames late.
    """
    what = table, tuple(kinds_of(table, probabilities).items()), 0, lanes()
    if table.bits == LARGEST_BITS and read(_key(*what), bool) is None:
        with suppress(OSError):
            run_beside(make_pass, *what)


def made_for(table, probabilities):
    """Wait for the narrower pass that is being made, and return how many there are of a RuleTable by now."""
    narrow = _passes(table, probabilities, 0, None).narrow
    if narrow is None:
        return 0
    narrow.wait()
    return len(narrow.known.made) - 1


def gates_of(table, probabilities):
    """Return how many gates the pass of a RuleTable has."""
    return _passes(table, probabilities, 0, None).gates


@lru_cache(maxsize=64)
def _passes(table, probabilities, payload, most_lanes):
    kinds = tuple(kinds_of(table, probabilities).items())
    return _Passes(table, probabilities, payload, _compiled(table, kinds, payload, min(lanes(), most_lanes or lanes())))


class _Passes:
    """The Pass of a rule for one set of probabilities, and those that follow as narrower passes are made."""

    def __init__(self, table, probabilities, payload, made):
        self._table, self._probabilities, self._made = table, probabilities, made
        self.narrow, self.gates = made.narrow, made.whole.gates
        total = table.bits + payload
        outside = np.array([(2**64 - 1) * (table.outside >> bit & 1) for bit in range(total)], np.uint64)
        turned = {bit for layer in made.whole.plan.layers for level in layer.deltas for _, bit in level}
        changing = np.array([bit in turned or bit >= table.bits for bit in range(total)])
        self._chances = [self._chances_for(made.whole)]
        whole, edges = made.whole, edges_of(table)
        self._latest = Pass(whole.code, self._chances[0], outside, changing, table.outside, edges, whole.lanes)
        self._known = None

    def current(self):
        """Return the Pass of today."""
        if self.narrow and self._known is not self.narrow.known:
            self._widen(self.narrow.known)
        return self._latest

    def _widen(self, known):
        """Let the dispatch choose among the passes of a Known; two threads may be here, and both get it right."""
        before = self._chances  # of another thread's, it may be more
        chances = [*before, *map(self._chances_for, known.made[len(before) :])][: len(known.made)]
        passes = [(each.code.address, own) for each, own in zip(known.made, chances, strict=True)]
        told = DispatchTable(known.numbers, self.narrow.tally, passes)
        code, kept_alive = self._made.dispatch, (told, known.made)
        self._latest = self._latest._replace(code=code, chances=told.words, kept=kept_alive)
        self._chances, self._known = chances, known

    def _chances_for(self, made):
        return chances_of(made.plan, lambda _, slots: threshold_of(slots, self._probabilities))


@lru_cache(maxsize=64)
def edges_of(table):
    """Return whether blocks whose upper, and whose lower corners are outside have events: two bools."""
    return _events_beside(table, (0, 1)), _events_beside(table, (2, 3))


class _MadePass(NamedTuple):
    """What is the same for all probabilities of the same kinds."""

    plan: Plan  # without its circuit
    code: MachineCode
    lanes: int
    gates: int


class _CompiledRule(NamedTuple):
    whole: _MadePass
    dispatch: MachineCode | None  # of a large rule
    narrow: NarrowPasses | None


@lru_cache(maxsize=KEPT)
def _compiled(table, kinds, payload, most_lanes):
    """Return the _CompiledRule of a table."""
    whole = make_pass(table, kinds, payload, most_lanes)
    if payload or whole.gates < LEAST_GATES:
        return _CompiledRule(whole, None, None)
    code = compiled(dispatch.source(table.bits, table.codes, whole.lanes))
    about = table, kinds, payload, whole.lanes
    narrow = NarrowPasses(table, whole, partial(make_pass, *about), partial(_kept_pass, *about))
    return _CompiledRule(whole, MachineCode(code, dispatch.NAME), narrow)


def make_pass(table, kinds, payload, most_lanes, codes=None):
    """Return the _MadePass of a table, for some of its codes or, if they are None, all; it is kept between runs."""
    what = table, kinds, payload, most_lanes, codes
    return _loaded(kept(_key(*what), partial(_made, *what)))


def _kept_pass(*what):
    """Return what `make_pass` has kept before, or None."""
    before = read(_key(*what), pickle.loads)
    return before and _loaded(before)


def _key(table, kinds, payload, most_lanes, codes=None):
    return f"{table.digest} {kinds} {payload} {most_lanes} {codes} {machine()} {features()}"


def _loaded(made):
    plan, at_once, code, gates = made
    return _MadePass(plan, MachineCode(code, NAME), at_once, gates)


def _made(table, kinds, payload, most_lanes, codes):
    """Return (Plan without its circuit, words at a time, machine code, gates) of a pass that was checked."""
    table, kinds = table.narrowed(codes) if codes else table, dict(kinds)
    gates = plan(table, {slots: kinds[slots] for slots in thresholds_in(table)})
    for at_once in dict.fromkeys((most_lanes, 1)):
        code = compiled(source(gates, at_once, payload))
        made = MachineCode(code, NAME)
        if self_check.agrees(made.address, table, gates, kinds, payload, at_once):
            return gates._replace(circuit=None), at_once, code, gate_count(gates)
    raise RuntimeError(f"the code made for this rule moves blocks otherwise than its table says: {machine()}")


def _events_beside(table, row):
    """Return whether a claim holds a state in which a row of corners is outside."""
    states = [corners(claim.states, table.bits) for layer in table.layers for claim in layer]
    return any((np.all([codes[corner] == table.outside for corner in row], axis=0)).any() for codes in states)
