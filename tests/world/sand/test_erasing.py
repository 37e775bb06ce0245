"""The eraser takes a fixture where it comes over the middle of one of its cells, and looks at few of them."""

import time

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from game import Rule, World
from game.core.paint.primitives import ELLIPSE, RECTANGLE, covers
from game.core.paint.strokes import DIAMOND, ROUND, SQUARE, comes_over
from game.world.sand.erasing import is_in_figure, is_under_brush
from game.world.sand.fixtures import DRAIN, Fixture
from game.world.sessions.action import Paint, perform

sides, cells = st.integers(1, 9), st.integers(-6, 14)
fixtures = st.builds(Fixture, st.just(DRAIN), cells, cells, sides, sides)
halves = st.integers(-8, 30).map(lambda number: number / 2)
places = st.tuples(halves, halves)


def cells_of(fixture):
    left, top, right, bottom = fixture.box
    return [(x, y) for y in range(top, bottom) for x in range(left, right)]


@given(fixtures, st.sampled_from((ROUND, SQUARE, DIAMOND)), places, places, st.integers(1, 9))
def test_a_brush_reaches_a_fixture_whose_cells_it_comes_over(fixture, shape, start, end, diameter):
    wanted = any(comes_over(shape, *cell, *start, *end, diameter / 2) for cell in cells_of(fixture))
    assert is_under_brush(fixture, shape, start, end, diameter / 2) == wanted


@given(fixtures, st.sampled_from((RECTANGLE, ELLIPSE)), cells, cells, sides, sides)
def test_a_figure_reaches_a_fixture_whose_cells_it_covers(fixture, kind, left, top, width, height):
    box = left, top, left + width, top + height
    assert is_in_figure(fixture, kind, box) == any(covers(kind, *cell, *box) for cell in cells_of(fixture))


def test_erasing_beside_large_fixtures_costs_no_more_than_without_them():
    empty = np.zeros((2000, 2000), bool)
    act = Paint("erase", (600.0, 1900.0), (1500.0, 900.0), 40)
    took = {}
    for drains in ((), tuple(Fixture(DRAIN, 10 * number, 500, 1000, 900) for number in range(-10, 0))):
        world = World.from_cells(empty, empty)
        perform(act, world, Rule())
        world.fixtures = drains
        start = time.thread_time_ns()
        perform(act, world, Rule())
        took[bool(drains)] = time.thread_time_ns() - start
        assert world.fixtures == drains
    assert took[True] < 3 * took[False] + 50_000_000
