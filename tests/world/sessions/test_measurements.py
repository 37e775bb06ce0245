"""The watch: its rows are the measures, and nothing that an act did is taken for flow."""

import csv
import io
import math

import numpy as np
import pytest

from game import Rule, load_rule, load_scene
from game.world.sand.measure import grains_above, pile, surface_slope
from game.world.sand.reaction_counts import ReactionMeter
from game.world.sessions import measurements
from game.world.sessions.action import Clear, Draw, Flip, Load, Paint, SetRule
from game.world.sessions.measurements import Measurements
from game.world.sessions.session import Session


@pytest.fixture
def glass():
    """Return (session, its watch at the neck)."""
    session = Session(load_scene("hourglass", (60, 80)), seed=5)
    return session, Measurements(session, session.scene.neck)


def test_the_rows_of_the_table_are_the_measures(glass):
    session, one = glass
    expected, before = [], None
    for number in range(20):
        session.timeline.run(37)
        one.follow(number / 4, 2.5)
        above, rests = grains_above(session.world, 40), pile(session.world, 40)
        flow = math.nan if before is None else (before - above) / 37
        slope = surface_slope(rests.surface)
        row = session.now, number / 4, above, session.world.grains - above, flow, rests.height, *slope, 2.5
        expected.append((*row, *session.world.amounts))
        before = above
    found = list(csv.reader(io.StringIO(measurements.csv(one.columns, one.rows()).decode(), newline="")))
    assert tuple(found[0]) == one.columns and len(found) == 21
    numbers = [[float(text) if text else math.nan for text in row] for row in found[1:]]
    assert np.allclose(numbers, expected, rtol=1e-5, equal_nan=True)
    assert sum(row[4] * 37 for row in expected[1:]) == expected[0][2] - expected[-1][2]


def test_a_glass_knows_its_neck_at_any_size_and_other_scenes_have_none():
    assert load_scene("hourglass").neck == 120 and load_scene("paper").neck == 30
    assert load_scene("hourglass", (60, 80)).neck == 40
    assert load_scene("funnel").neck is None and load_scene("blank").neck is None


@pytest.mark.parametrize("act", [Flip(), Clear(), Paint("sand", (30.0, 20.0), (30.0, 20.0), 9)])
def test_what_an_act_moves_is_no_flow(glass, act):
    session, one = glass
    for number, what in enumerate((None, act, SetRule(Rule.with_p(0.2)), None)):
        if what:
            session.do(what)
        session.timeline.run(50)
        one.follow(number, 1.0)
    first, second, third, fourth = one.flows()
    assert math.isnan(first) and math.isnan(second) and not math.isnan(third) and not math.isnan(fourth)


def test_going_back_in_time_forgets_what_has_not_happened_yet(glass):
    session, one = glass
    for number in range(8):
        session.timeline.run(50)
        one.follow(number, 1.0)
    session.seek(130)
    one.follow(9.0, 1.0)
    assert [each.now for each in one.samples] == [50, 100, 130]
    session.do(Flip())
    one.follow(9.5, 1.0)
    assert [each.now for each in one.samples] == [50, 100, 130] and math.isnan(one.flows()[-1])


def test_a_long_story_is_thinned_and_keeps_its_end_its_sum_and_its_slowest_frame(glass, monkeypatch):
    session, one = glass
    monkeypatch.setattr(measurements, "MOST", 10)
    for number in range(57):
        session.timeline.run(10)
        one.follow(number, 50.0 if number == 20 else 1.0)
        assert len(one.samples) <= 10 and one.samples[-1].now == session.now
    assert max(each.frame_ms for each in one.samples) == 50.0
    steps = np.diff([each.now for each in one.samples])
    assert sum(one.flows()[1:] * steps) == pytest.approx(one.samples[0].above - one.samples[-1].above)


def test_a_fresh_scene_is_measured_from_its_own_start(glass):
    session, one = glass
    session.timeline.run(500)
    one.follow(0.0, 1.0)
    session.do(Load(session.scene, 7))
    one.follow(1.0, 1.0)
    session.timeline.run(20)
    one.follow(2.0, 1.0)
    assert [each.now for each in one.samples] == [0, 20]


def lava_in_water():
    session = Session(load_scene("blank", (64, 40)), seed=5)
    session.do(SetRule(load_rule("alchemy")))
    session.do(Draw("rectangle", "water", (0.0, 10.0), (63.0, 39.0)))
    session.do(Draw("rectangle", "lava", (20.0, 0.0), (40.0, 20.0)))
    return session


def test_reactions_are_counted_between_samples_and_told_by_name():
    session = lava_in_water()
    one, stone = Measurements(session, 0), session.world.codes.code("stone")
    hardens = "water quenches lava"
    one.follow(0.0, 1.0)
    for second in (1.0, 2.0):
        for _ in range(150):
            one.watch()
            session.timeline.run(1)
        one.follow(second, 1.0)
    quenched = [each.reactions.get(hardens, 0) for each in one.samples]
    others = [sum(n for name, n in each.reactions.items() if name in ("lava cools",)) for each in one.samples]
    formed = [each.amounts[stone] - one.samples[0].amounts[stone] for each in one.samples]
    assert [a + b for a, b in zip(quenched, others, strict=True)] == pytest.approx(formed) and quenched[2] > 0
    rates = one.reactions()[hardens]
    assert math.isnan(rates[0]) and [rate * 150 for rate in rates[1:]] == pytest.approx(np.diff(quenched).tolist())
    assert one.columns[-len(one.reactions()) :] == tuple(
        f"{n.replace(' ', '_')}_per_iteration" for n in one.reactions()
    )
    assert {len(row) for row in one.rows()} == {len(one.columns)}


def test_iterations_not_watched_are_taken_to_be_as_those_watched():
    session = lava_in_water()
    session.timeline.run(5)
    one = Measurements(session, 0)
    one.follow(0.0, 1.0)
    one.watch()
    one.watch()
    seen = ReactionMeter().look(session.world, session.rule)
    session.timeline.run(10)
    one.follow(1.0, 1.0)
    assert seen and one.samples[-1].reactions == pytest.approx({name: 10 * n for name, n in seen.items()})


def test_a_future_that_was_left_takes_its_reactions_along():
    session = lava_in_water()
    one = Measurements(session, 0)
    for second in range(4):
        one.watch()
        session.timeline.run(50)
        one.follow(second, 1.0)
    session.seek(120)
    one.follow(9.0, 1.0)
    assert one.samples[-1].reactions == one.samples[-2].reactions
