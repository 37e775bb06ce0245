"""Laws of the glass: the same upside down, watertight, and it empties to the last grain."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.world.rules.rule import SCHEDULES, Rule
from game.world.sand.advance import advance
from game.world.sand.world import World
from game.world.scenes.hourglass import hourglass

sides, shapes = st.integers(5, 90), (st.floats(1, 8), st.floats(0, 1), st.floats(1, 6))
glasses = st.tuples(sides, sides, *shapes, st.floats(0, 1))
roomy_glasses = st.tuples(st.integers(20, 90), sides, *shapes, st.floats(0, 0.7))  # no full bulb below holds sand up


def inside(walls):
    """Return the cells with glass at both sides."""
    return (np.cumsum(walls, axis=1) > 0) & (np.cumsum(walls[:, ::-1], axis=1) > 0)[:, ::-1] & ~walls


@given(glasses)
def test_glass_is_the_same_upside_down_and_in_a_mirror(glass):
    sand, walls = hourglass(*glass)
    assert (walls == walls[::-1]).all()
    assert (walls == walls[:, ::-1]).all()
    assert (sand == sand[:, ::-1]).all()
    assert not (sand & walls).any()


@given(glasses)
def test_every_cell_beside_the_inside_is_inside_or_glass(glass):
    walls = hourglass(*glass)[1]
    within = np.pad(inside(walls), 1)
    beyond = ~within & ~np.pad(walls, 1)
    assert not (within[1:] & beyond[:-1]).any()
    assert not (within[:-1] & beyond[1:]).any()
    assert not (within[:, 1:] & beyond[:, :-1]).any()


@given(glasses)
def test_funnel_is_never_flatter_than_45_degrees(glass):
    walls = hourglass(*glass)[1]
    widths = inside(walls).sum(axis=1)
    below_middle = widths[len(widths) // 2 :]
    assert np.diff(below_middle).max(initial=0) <= 2  # one cell at each side


@given(roomy_glasses, st.floats(0.4, 1), st.integers(0, 99))
def test_glass_drains_to_the_last_grain(glass, p, seed):
    sand, walls = hourglass(*glass)
    world = World.from_cells(sand, walls, seed)
    advance(world, Rule.with_p(p, "balanced"), 30_000)
    assert not world.sand[: len(sand) // 2].any()


@given(glasses, st.tuples(*[st.floats(0, 1)] * 7), st.sampled_from(sorted(SCHEDULES)), st.integers(0, 99))
def test_sand_stays_inside_the_glass_whatever_the_rule(glass, probabilities, schedule, seed):
    sand, walls = hourglass(*glass)
    world = World.from_cells(sand, walls, seed)
    for _ in range(4):
        advance(world, Rule(*probabilities, schedule), 500)
        world.flip()
        assert not (world.sand & ~inside(walls)).any()
        assert world.grains == sand.sum()


@pytest.mark.parametrize(
    ("width", "neck", "cells"), [(61, 1, 1), (61, 2, 3), (61, 4, 5), (60, 1, 2), (60, 3, 4), (9, 40, 7)]
)
def test_neck_is_rounded_to_what_can_stand_on_the_axis(width, neck, cells):
    walls = hourglass(61, width, neck, 1, 1, 0.5)[1]
    assert inside(walls)[30].sum() == cells


@pytest.mark.parametrize("fill", [0, 0.25, 0.5, 1])
def test_fill_is_the_part_of_the_bulb_that_is_full(fill):
    sand, walls = hourglass(400, 200, 4, 1, 4, fill)
    bulb = inside(walls)[:200].any(axis=1).sum()
    assert sand.any(axis=1).sum() == pytest.approx(fill * bulb, abs=1)
    full = sand.any(axis=1)
    assert (sand[full] == inside(walls)[full]).all()


@pytest.mark.parametrize("wall", [2, 3, 5.5, 8])
def test_glass_is_equally_thick_all_along_its_normal(wall):
    walls = hourglass(300, 200, 4, 1, wall, 0.5)[1]
    within = np.argwhere(inside(walls)[:150])
    for row in range(60, 150, 7):
        outermost = np.flatnonzero(walls[row])[0]
        nearest = np.hypot(*(within - (row, outermost)).T).min()
        assert nearest == pytest.approx(wall, abs=1)


@pytest.mark.parametrize(("height", "width"), [(4, 9), (9, 4), (0, 0)])
def test_glass_needs_five_cells_each_way(height, width):
    with pytest.raises(ValueError, match=f"an hourglass must be at least 5×5 cells, got {width}×{height}"):
        hourglass(height, width, 2, 1, 1, 0.5)
