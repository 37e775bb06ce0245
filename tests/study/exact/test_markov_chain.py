"""The chain: right by hand, by the plain twin's table and in fractions; and the lattices show all there is to see."""

import math
from fractions import Fraction
from functools import cache
from itertools import product

import numpy as np
import pytest

from game.study.exact import markov_chain
from game.study.exact.lattices import LATTICES
from game.study.exact.markov_chain import EVENTS, SCHEDULES, explore
from game.study.exact.trials import PROBABILITIES
from game.world.rules import rule
from tests import reference
from tests.sweeps import sweep

HALF = (0.5,) * 2 + (1.0,) * 5
SEVEN = PROBABILITIES["seven different"]


def chances(rows, schedule, probabilities, iterations):
    """Return {state: probability} after some iterations."""
    found = explore(rows, SCHEDULES[schedule])
    *_, last = found.distributions(probabilities, iterations)
    return {int(state): chance for state, chance in zip(found.states, last, strict=True) if chance}


def state_of(rows):
    return sum(1 << place for place, cell in enumerate("".join(rows)) if cell == "o")


def test_the_kinds_are_the_rules_probabilities_in_order():
    assert tuple(each.name for each in rule.PROBABILITIES) == markov_chain.KINDS


def test_the_schedules_are_the_rules():
    assert rule.SCHEDULES == SCHEDULES


def test_all_81_blocks_do_what_the_plain_twin_says():
    for corners in product(".ow", repeat=4):
        twin = reference.event(*(corner.replace("w", "#") for corner in corners))
        if twin is None:
            assert "".join(corners) not in EVENTS
            continue
        after, name = twin
        changed, kind = EVENTS["".join(corners)]
        assert kind == (None if name == reference.ALWAYS else name)
        assert changed == tuple(i for i in range(4) if after[i] != corners[i].replace("w", "#"))


def test_a_tower_of_two_topples_with_p():
    assert chances(["o.", "o."], "margolus", (0.3, 0.2, *[1.0] * 5), 1) == {
        state_of(["o.", "o."]): pytest.approx(0.8),
        state_of(["..", "oo"]): pytest.approx(0.2),
    }


def test_two_blocks_are_independent():
    found = chances(["o..o", "o..o"], "margolus", (0.3, 0.2, *[1.0] * 5), 1)
    assert found == {
        state_of(["o..o", "o..o"]): pytest.approx(0.8 * 0.7),
        state_of(["...o", "oo.o"]): pytest.approx(0.2 * 0.7),
        state_of(["o...", "o.oo"]): pytest.approx(0.8 * 0.3),
        state_of(["....", "oooo"]): pytest.approx(0.2 * 0.3),
    }


def test_a_grain_at_the_left_edge_falls_in_every_iteration():
    assert chances(["o", ".", "."], "margolus", HALF, 2) == {state_of([".", ".", "o"]): 1.0}


@pytest.mark.parametrize("schedule", SCHEDULES)
@sweep("name", ["tower", "ledges", "walls in every role"], keep=["tower", "ledges"])
def test_float_chances_are_those_in_fractions(name, schedule):
    found = explore(LATTICES[name], SCHEDULES[schedule])
    exact = {0: Fraction(1)}
    p = [Fraction(each) for each in SEVEN]

    @cache
    def weight(happened, failed):
        ways = zip(p, happened, failed, strict=True)
        return math.prod((each**yes * (1 - each) ** no for each, yes, no in ways), start=Fraction(1))

    *_, last = found.distributions(SEVEN, 7)
    for iteration in range(7):
        moves, after = found.moves[iteration % len(found.moves)], {}
        ways = {}
        counts = (map(tuple, each.tolist()) for each in (moves.happened, moves.failed))
        for source, target, *way in zip(moves.source.tolist(), moves.target.tolist(), *counts, strict=True):
            ways.setdefault(source, []).append((target, weight(*way)))
        for state, chance in exact.items():
            for target, share in ways[state]:
                after[target] = after.get(target, 0) + chance * share
        exact = after
    assert sum(exact.values()) == 1
    assert all(last[state] == pytest.approx(float(chance), rel=1e-12, abs=0) for state, chance in exact.items())


@sweep("name", LATTICES, keep=["walls in every role", "neck of two cells", "pegs"])
def test_chances_add_up_to_one_and_grains_to_their_number(name):
    rows = LATTICES[name]
    found = explore(rows, SCHEDULES["paper"])
    assert (np.bitwise_count(found.states) == "".join(rows).count("o")).all()
    for distribution in found.distributions(SEVEN, 30):
        assert abs(distribution.sum() - 1.0) < 1e-12


def test_the_lattices_are_small_and_drawn_in_full():
    for name, rows in LATTICES.items():
        assert {len(row) for row in rows} == {len(rows[0])}, name
        assert len(rows) * len(rows[0]) <= 64 and set("".join(rows)) <= set(".o#"), name


def blocks_of(rows):
    """Return the corners of every block in every state that a lattice can reach."""
    states = explore(rows, SCHEDULES["balanced"]).states
    height, width = len(rows), len(rows[0])
    sand = (states[:, None] >> np.arange(height * width, dtype=np.uint64)) & np.uint64(1)
    cells = np.where(np.array(list("".join(rows))) == "#", 2, sand).reshape(-1, height, width)
    cells = np.pad(cells, ((0, 0), (1, 1), (1, 1)), constant_values=2).astype(int)
    codes = 27 * cells[:, :-1, :-1] + 9 * cells[:, :-1, 1:] + 3 * cells[:, 1:, :-1] + cells[:, 1:, 1:]
    letters = ["".join(corners) for corners in product(".ow", repeat=4)]
    return {letters[code] for code in np.unique(codes)}


def test_the_lattices_show_every_event_with_sand_and_walls_in_every_role():
    seen = set().union(*map(blocks_of, LATTICES.values()))
    assert seen >= set(EVENTS), sorted(set(EVENTS) - seen)
