"""Flow and piles: the laws that the study of the schedules and of sand as physics rests on."""

import numpy as np
import pytest

from game import Rule, World, advance
from game.study.paper.sticking import glass, stuck
from game.study.physics.claims import CLAIMS, claim_table
from game.study.physics.flow import PER_COLUMN
from game.study.physics.hopper import INTERVAL, Hopper
from game.study.physics.kinds import KINDS, ROLLING
from game.study.report import report
from game.study.report.statistics import Sample, shape_of
from game.study.trade import cell_sizes, part
from game.study.trade.chance_settings import shortened
from game.study.trade.points import Point, point
from game.world.rules.rule import SCHEDULES


@pytest.mark.parametrize("schedule", PER_COLUMN)
@pytest.mark.parametrize("neck", [2, 7])
@pytest.mark.parametrize("kind", KINDS)
def test_a_plug_falls_column_by_column_and_then_the_surface_flows_whatever_the_neck(schedule, neck, kind):
    hopper = Hopper(40 + neck % 2, 80, neck, kind.rule.with_schedule(schedule))
    assert hopper.run(2) == pytest.approx(neck * PER_COLUMN[schedule], rel=0.02)
    hopper.run(24)
    assert hopper.run(4) == pytest.approx(2 * PER_COLUMN[schedule])


@pytest.mark.parametrize("rule", [Rule.with_p(0.5, "balanced"), ROLLING.rule])
def test_a_hopper_loses_nothing_but_what_flows_out(rule):
    hopper = Hopper(40, 60, 4, rule)
    before = hopper.grains
    left = round(INTERVAL * 3 * hopper.run(3))
    assert left > 0 and hopper.grains == before - left


def test_what_of_real_sand_each_rule_bears_out_is_read_off_the_rows():
    quantities = [each for told in CLAIMS.values() for each in told]
    rows = [report.claimed(each, number, None, 0, 4, "real sand") for number, each in enumerate(quantities)]
    table = claim_table(rows)
    assert table.cells()[:3] == [
        ["a heap of dry sand stands at 30-35°", "yes: 0", "yes: 1"],
        ["an hourglass runs out to the last grain", "yes: 2", "yes: 3"],
        ["the flow does not depend on how much is left", "yes: 4", "no: 5"],
    ]
    with pytest.raises(KeyError, match="final slope"):
        claim_table(rows[1:])


@pytest.mark.parametrize("schedule", SCHEDULES)
def test_a_schedule_in_a_mirror_is_the_schedule_a_column_further(schedule):
    sand, walls, axis = glass(0)
    moved_sand, moved_walls, _ = glass(1)
    here, moved = World.from_cells(sand, walls), World.from_cells(moved_sand, moved_walls)
    for world in (here, moved):
        advance(world, Rule(schedule=schedule), 300)
    assert (here.sand == moved.sand[:, 1:][:, ::-1]).all() and axis == 30


@pytest.mark.parametrize("right", [0, 1])
@pytest.mark.parametrize("down", [0, 1])
def test_sand_sticks_to_one_slope_under_margolus_and_to_none_under_the_others(right, down):
    sides = stuck("margolus", 1.0, right, down)
    assert min(sides) == 0 < max(sides)
    assert stuck("paper", 1.0, right, down) == stuck("balanced", 1.0, right, down) == (0, 0)


def test_the_shape_of_a_cone_is_its_height_width_and_spread():
    density = np.zeros((21, 21))
    for row in range(5):  # five rows over a floor of two: 9, 7, 5, 3 and 1 grains
        density[18 - row, 6 + row : 15 - row] = 1.0
    walls = np.zeros((21, 21), bool)
    walls[19:] = True
    height, width, mean_height, spread = shape_of(density, walls)
    assert (height, width) == (5.0, 9.0)
    assert mean_height == pytest.approx(np.average(np.arange(5) + 0.5, weights=[9, 7, 5, 3, 1]))
    assert spread == pytest.approx(2.0)


def test_batches_give_their_mean_and_its_standard_error():
    found = Sample.of([[1.0, 4.0], [3.0, 4.0]])
    assert found.mean.tolist() == [2.0, 4.0] and found.error.tolist() == [1.0, 0.0]


def test_an_error_is_told_in_points_and_in_grains():
    reference, found = np.zeros((2, 2)), np.array([[0.0, 0.5], [0.5, 0.0]])
    each = point("s", "x", found, reference, 0.1, 1.0)
    assert (each.rms, each.most, each.misplaced) == (pytest.approx(35.355, abs=1e-3), 50.0, 0.5)


@pytest.mark.parametrize(("bits", "p"), [(1, 0.5), (2, 0.75), (4, 0.6875), (32, round(0.7 * 2**32) / 2**32)])
def test_a_probability_is_shortened_to_the_nearest_fraction(bits, p):
    assert shortened(0.7, bits) == p


def test_cells_of_all_sizes_show_the_same_sand_on_the_common_grid():
    shares = [
        cell_sizes.seen(np.ones((cell_sizes.HEIGHT // cell, cell_sizes.WIDTH // cell), bool), cell)
        for cell in cell_sizes.CELLS
    ]
    assert all(share.shape == (39, 30) and (share == 1.0).all() for share in shares)


def test_the_picture_of_the_trade_draws_every_series():
    points = [Point(series, "1", 1.0, 2.0, 3.0, 0.1, 1.0, True) for series in part.COLOURS]
    panels = part.drawn(points).axes
    assert [panel.get_title() for panel in panels] == list(part.COLOURS)
