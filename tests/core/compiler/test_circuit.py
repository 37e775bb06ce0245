"""Circuits: what gates yield, and that no two of them do the same."""

from itertools import product

import numpy as np
import pytest

from game.core.compiler.circuit import FALSE, TRUE, Circuit
from game.core.compiler.cover import Covers
from game.core.compiler.plan import kinds_of, plan
from game.world.rules.rule import SAND


def yields(circuit, literal):
    """Return what a literal is for each state, worked out gate by gate."""
    states = np.arange(2**circuit.inputs)
    known = {0: states < 0} | {1 + each: states >> each & 1 == 1 for each in range(circuit.inputs)}

    def value(literal):
        return known[literal >> 1] ^ bool(literal & 1)

    for node in circuit.cone([literal]):
        op, x, y = circuit.gates[node]
        known[node] = value(x) & value(y) if op == "and" else value(x) ^ value(y)
    return value(literal)


def test_gates_yield_what_they_are_called():
    circuit = Circuit(3, np.ones(8, bool))
    literals = [FALSE, TRUE, *(2 * node + inverted for node in (1, 2, 3) for inverted in (0, 1))]
    for x, y, z in product(literals, repeat=3):
        u, v, w = (yields(circuit, each) for each in (x, y, z))
        assert (yields(circuit, circuit.and_(x, y)) == u & v).all()
        assert (yields(circuit, circuit.or_(x, y)) == u | v).all()
        assert (yields(circuit, circuit.xor(x, y)) == u ^ v).all()
        assert (yields(circuit, circuit.choice(x, y, z)) == np.where(u, v, w)).all()


def test_what_does_the_same_is_one_gate():
    circuit = Circuit(2, np.ones(4, bool))
    x, y = circuit.input(0), circuit.input(1)
    before = circuit.xor(x, y)
    count = len(circuit.gates)
    inverted = circuit.and_(circuit.or_(x, y), circuit.and_(x, y) ^ 1)
    assert inverted == before and len(circuit.gates) == count + 2


def test_a_circuit_may_have_inputs_that_are_never_set():
    care = np.arange(16) < 4
    circuit = Circuit(4, care)
    assert (
        circuit.input(3) >> 1 == 4
        and (yields(circuit, circuit.xor(circuit.input(1), circuit.input(3)))[care] == [0, 0, 1, 1]).all()
    )


@pytest.mark.parametrize("bits", [2, 3])
def test_a_cover_is_true_where_wanted_and_false_where_not(bits):
    generator = np.random.default_rng(80)
    for share in (0.02, 0.3):
        circuit = Circuit(4 * bits, np.ones(2 ** (4 * bits), bool))
        covers = Covers(circuit, bits)
        wanted = generator.random(2 ** (4 * bits)) < share
        unwanted = ~wanted & (generator.random(len(wanted)) < 0.7)
        found = yields(circuit, covers.cover(wanted, unwanted))
        assert found[wanted].all() and not found[unwanted].any()


def test_certain_sand_takes_no_more_than_nineteen_gates():
    gates = plan(SAND.table, kinds_of(SAND.table, (1.0,) * 7))
    layer = gates.layers[0]
    assert len(gates.circuit.cone([layer.event, *layer.sure, *layer.deltas[0].values()])) <= 19
