"""Laws of time: what is computed forward from a snapshot is what was; nothing done is ever lost."""

import time
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import Rule, advance, load_scene
from game.world.sand.fixtures import Fixture
from game.world.sessions import snapshots as snapshots
from game.world.sessions import timeline as timelines
from game.world.sessions.action import Clear, Draw, Fill, Flip, Load, Paint, Reshape, SetFixtures, SetRule, Turn
from game.world.sessions.history import Entry
from game.world.sessions.recording import Recording
from game.world.sessions.session import Session
from tests.cells import small_glass
from tests.sweeps import sweep, swept
from tests.world.random_sessions import SCENES, Listener, actions, obey, plain_world, played, plays, state

DOT = Paint("sand", (5.0, 5.0), (9.0, 5.0), 4)
GLASS = small_glass(40)
BAR = Paint("wall", (2.0, 12.0), (20.0, 12.0), 3)


@pytest.fixture(
    params=swept(
        ["no snapshot", "snapshots everywhere", "hardly any memory"], keep=["no snapshot", "hardly any memory"]
    ),
    autouse=True,
)
def spacing(request, monkeypatch):
    """Let every law hold whatever snapshots there are."""
    if request.param != "no snapshot":
        monkeypatch.setattr(timelines, "SPACING_NS", 0)
        monkeypatch.setattr(timelines, "SLICE_NS", 1)
        monkeypatch.setattr(timelines, "SHARE", 0)
    if request.param == "hardly any memory":
        monkeypatch.setattr(timelines, "MEGABYTE", 450)  # 115 KB: two snapshots or three
    return request.param


@given(plays)
def test_the_present_is_what_the_acts_make_of_the_start(play):
    session = played(play)
    world, rule = plain_world(*session.timeline.start, session.timeline.history.story(), session.now)
    assert session.world.digest() == world.digest() and session.rule == rule


@given(plays)
def test_what_the_journal_heard_tells_the_same_session(play):
    session = played(play)
    told = Session.retold(Recording(*session.timeline.start, session.journal.entries))
    told.seek(session.now)
    assert state(told) == state(session)
    for command in (("undo",), ("undo",), ("redo",), ("run", 7), ("redo",)):
        obey(told, command)
        obey(session, command)
    assert state(told) == state(session)


@given(plays)
def test_undo_of_everything_is_the_start(play):
    session = played(play)
    while session.undo():
        pass
    scene, seed = session.timeline.start
    world = scene.world(seed)
    advance(world, scene.rule, session.now)
    assert session.world.digest() == world.digest() and session.rule == scene.rule


@given(plays, st.integers(0, 150))
def test_rewinding_and_going_forward_again_is_the_identity(play, back):
    session = played(play)
    before = state(session)
    session.seek(min(back, session.now))
    session.timeline.run(before[0] - session.now)
    assert state(session) == before


@given(plays, actions)
def test_undo_leaves_the_sand_as_it_would_have_been(play, action):
    session, twin = played(play), played(play)
    entries = len(session.journal.entries)
    session.do(action)
    for each in (session, twin):
        each.timeline.run(13)
    if len(session.journal.entries) > entries:
        changed = state(session)
        assert session.undo()
        assert session.world.digest() == twin.world.digest()
        assert session.redo() and state(session) == changed


@given(plays)
def test_grains_are_those_of_the_start_and_those_painted_less_those_erased(play):
    session = played([])
    for command in play:
        obey(session, command)
        assert session.account.balanced(session.world)


@given(plays)
def test_snapshots_never_take_more_than_the_budget(play):
    session = played([])
    shelf = session.timeline.snapshots
    for command in play:
        obey(session, command)
        kept = list(shelf.kept)
        walls = {id(each.walls): each.walls.nbytes for each in kept}
        assert shelf.bytes == sum(each.moving.nbytes for each in kept) + sum(walls.values()) <= shelf.budget


def test_an_act_in_the_past_starts_a_new_future_and_redo_finds_the_old_one():
    session = Session(SCENES[1])
    session.timeline.run(40)
    session.do(DOT)
    session.timeline.run(40)
    old = state(session)
    session.seek(20)
    session.do(BAR)
    assert session.reached == 20 < old[0]
    session.seek(80)
    new = state(session)
    assert new != old and session.world.grains != old[-1].expected
    assert session.redo() and state(session) == old
    assert session.undo() and state(session) == new
    assert session.undo() and state(session) == old


def test_undo_while_time_runs_backwards_leaves_the_undone_act_behind(monkeypatch):
    monkeypatch.setattr(timelines, "CLOSE_NS", 0)
    session = Session(SCENES[1])
    session.timeline.run(20)
    session.do(DOT)
    session.timeline.run(20)
    session.timeline.rewinding = True
    for now in (38, 35, 30):
        session.seek(now)
    assert session.undo() and session.now == 30
    assert session.world.digest() == plain_world(SCENES[1], 0, [], 30)[0].digest()
    session.seek(25)
    assert session.world.digest() == plain_world(SCENES[1], 0, [], 25)[0].digest()


def test_time_run_from_the_past_repeats_what_was_done():
    session = Session(SCENES[1])
    session.timeline.run(10)
    session.do(Flip())
    session.timeline.run(10)
    there = state(session)
    session.seek(0)
    assert session.reached == 20
    for _ in range(20):
        session.step()
    assert state(session) == there


def test_a_stroke_and_a_drag_are_one_step():
    session = Session(SCENES[1])
    session.timeline.run(5)
    for number in range(8):
        session.do(Paint("sand", (number, 3.0), (number + 1, 3.0), 3), join=number > 0)
        session.timeline.run(2)
    for number in range(8):
        session.do(SetRule(Rule.with_p(0.9 - number / 10)), join=number > 0)
    assert session.undo() and session.rule == SCENES[1].rule and session.account.painted > 0
    assert session.undo() and session.account.painted == 0
    assert not session.undo()
    assert session.redo() and session.redo() and session.rule.p == pytest.approx(0.2)
    assert not session.redo()


def test_nothing_is_joined_to_an_act_that_was_left():
    session = Session(SCENES[1])
    session.do(DOT)
    session.undo()
    session.do(BAR, join=True)
    assert session.undo() and session.world.digest() == SCENES[1].world().digest()


@given(plays, actions)
def test_what_is_recorded_is_what_changes_the_world_or_the_rule(play, action):
    session = played(play)
    before, coloured = state(session), session.world.coloured
    heard, reached, line = len(session.journal.entries), session.reached, session.timeline.history.line
    acted = session.do(action)
    assert acted == (state(session) != before)
    if not acted:
        assert session.timeline.history.line is line and session.reached == reached
        assert len(session.journal.entries) == heard and session.world.coloured == coloured


TAP = SetFixtures((Fixture("tap", 3, 4),))


@pytest.mark.parametrize(
    ("before", "act"),
    [
        ([], Paint("sand", (-50.0, 5.0), (-40.0, 5.0), 4, colour="teal")),
        ([DOT], Paint("sand", (6.0, 5.0), (7.0, 5.0), 2)),
        ([Clear()], Paint("erase", (5.0, 5.0), (9.0, 5.0), 1, only="sand")),
        ([], Draw("rectangle", "sand", (-9.5, -9.5), (-3.5, -3.5))),
        ([Draw("rectangle", "wall", (2.5, 2.5), (8.5, 8.5))], Draw("ellipse", "wall", (3.5, 3.5), (7.5, 7.5))),
        ([Draw("rectangle", "wall", (2.5, 2.5), (8.5, 8.5))], Fill("wall", (3.5, 3.5))),
        ([Draw("rectangle", "sand", (2.5, 2.5), (8.5, 8.5), colour="teal")], Fill("sand", (99.5, 3.5))),
        ([Clear()], Clear()),
        ([TAP], TAP),
        ([Draw("rectangle", "erase", (-1.5, -1.5), (40.5, 40.5))], Flip()),
        ([Reshape(GLASS)], Reshape(GLASS)),
        ([], Load(SCENES[1], 0)),
    ],
)
def test_what_changes_nothing_is_no_act_and_leaves_the_future_alone(before, act):
    session = Session(SCENES[1])
    for each in before:
        session.do(each)
    here = state(session)
    session.timeline.run(20)
    session.do(BAR)
    session.seek(0)
    line = session.timeline.history.line
    assert not session.do(act) and state(session) == here
    assert session.timeline.history.line is line and session.reached == 20


def put_back(rule):
    """Return what a slider does that is dragged away and back, and what a switch does."""
    return [SetRule(replace(rule, fall_pair=0.3)), SetRule(replace(rule, fall_pair=0.6)), SetRule(rule)]


@pytest.mark.parametrize(
    "acts",
    [
        put_back(SCENES[1].rule),
        [SetRule(replace(SCENES[1].rule, schedule="paper")), SetRule(SCENES[1].rule)],
        [TAP, SetFixtures(())],
        [Turn(1), Turn(1), Turn(2)],
    ],
)
@sweep("place", ["at the end", "before a future", "after an undo"], keep=["before a future"])
def test_a_gesture_that_comes_back_to_where_it_began_is_no_act(acts, place):
    session, twin = Session(SCENES[1]), Session(SCENES[1])
    for each in session, twin:
        each.journal = Listener()
        if place != "at the end":
            each.do(BAR)
            each.timeline.run(20)
            each.do(DOT)
            each.undo()
            if place == "before a future":
                each.redo()
                each.seek(0)
                each.undo()
    for number, act in enumerate(acts):
        assert session.do(act, join=number > 0)
    told = Session.retold(Recording(*session.timeline.start, session.journal.entries))
    told.seek(session.now)
    steps = ("redo",), ("redo",), ("undo",), ("undo",), ("undo",), ("redo",)
    for step in ((), *steps):
        for each in (session, twin, told) if step else ():
            obey(each, step)
        assert state(session) == state(twin) == state(told)
        assert session.reached == twin.reached
        assert session.timeline.history.story() == twin.timeline.history.story() == told.timeline.history.story()


def test_starting_again_at_the_start_with_the_friction_that_is_set_is_no_act():
    session, rule = Session(SCENES[1]), Rule.with_p(0.1)
    session.do(SetRule(rule))
    session.do(Load(SCENES[1], 0))
    session.do(SetRule(rule), join=True)
    assert session.undo() and session.rule == SCENES[1].rule and not session.undo()


def test_a_gesture_is_an_act_where_time_went_on_or_something_was_painted():
    session, rule = Session(SCENES[1]), SCENES[1].rule
    for number, act in enumerate(put_back(rule)):
        session.do(act, join=number > 0)
        session.timeline.run(1)
    assert session.undo() and not session.undo()
    session.seek(0)
    for number, act in enumerate([BAR, *put_back(rule)]):
        session.do(act, join=number > 0)
    assert session.undo() and state(session) == state(Session(SCENES[1]))


def test_a_gesture_after_one_that_came_to_nothing_is_an_act_of_its_own():
    session, rule = Session(SCENES[1]), SCENES[1].rule
    session.do(BAR)
    barred = state(session)
    for number, act in enumerate([*put_back(rule), SetRule(Rule.with_p(0.2)), SetRule(Rule.with_p(0.1))]):
        session.do(act, join=number > 0)
    assert session.rule.p == pytest.approx(0.1)
    assert session.undo() and state(session) == barred


def test_an_act_that_changes_nothing_is_no_step():
    session = Session(SCENES[1])
    for _ in range(5):
        session.do(DOT)
        session.do(SetRule(session.rule))
    session.do(Clear())
    session.do(Clear())
    assert len(session.timeline.history.story()) == 2
    session.do(Flip())
    session.do(Flip())
    assert len(session.timeline.history.story()) == 4


def test_undo_goes_back_to_the_act_if_the_player_likes():
    session = Session(SCENES[1])
    session.timeline.run(30)
    before = state(session)
    session.do(Flip())
    session.timeline.run(30)
    assert session.undo(back=True) and state(session) == before
    session.seek(10)
    assert session.redo(back=True) and session.now == 30
    assert session.world.digest() != before[1]


def test_acts_of_one_iteration_keep_their_order():
    session = Session(SCENES[1])
    acts = [DOT, BAR, Clear(), DOT, Flip()]
    for act in acts:
        session.do(act)
    after = state(session)
    session.timeline.run(30)
    session.seek(0)
    assert state(session) == after
    assert [entry.what for entry in session.timeline.history.story()] == acts


def test_a_load_is_undone_with_its_rule_scene_and_pace():
    session = Session(SCENES[1], seed=2)
    session.timeline.run(9)
    session.do(Load(SCENES[2], 7))
    session.timeline.run(9)
    assert (session.scene, session.seed, session.world.iteration, session.now) == (SCENES[2], 7, 9, 18)
    session.undo()
    assert (session.scene, session.seed, session.world.iteration, session.now) == (SCENES[1], 2, 18, 18)
    assert session.clock.speed == SCENES[1].speed
    session.redo()
    assert session.scene is SCENES[2] and session.clock.speed == SCENES[2].speed


def test_a_long_way_is_gone_in_frames(monkeypatch):
    session, twin = Session(SCENES[1]), Session(SCENES[1])
    twin.timeline.run(400)
    ticks = iter(range(0, 10**15, 500_000))
    monkeypatch.setattr(time, "perf_counter_ns", lambda: next(ticks))
    assert not session.seek(400, budget_ns=4_000_000)
    assert 0 < session.world.iteration < 400 == session.now
    frames = 0
    while session.timeline.goal is not None:
        assert session.frame(16_000_000, 4_000_000) > 0 and session.due == 0
        frames += 1
    assert frames >= 1 and state(session) == state(twin)


def test_an_act_on_the_way_waits_for_the_sand_to_arrive():
    session, twin = Session(SCENES[1]), Session(SCENES[1])
    session.seek(300, budget_ns=1)
    session.do(DOT)
    twin.timeline.run(300)
    twin.do(DOT)
    assert state(session) == state(twin)


@pytest.mark.parametrize("now", [-1, 1.5, "3", None, 2**60])
def test_only_a_moment_can_be_sought(now):
    with pytest.raises(ValueError, match="at must be a whole number in"):
        Session(SCENES[0]).seek(now)


def test_a_smaller_budget_takes_effect_at_once(spacing):
    session = Session(SCENES[1])
    session.timeline.run(60)
    shelf = session.timeline.snapshots
    shelf.fit(40_000, session.timeline.history.line)
    assert shelf.bytes <= 40_000
    session.seek(30)
    assert session.world.digest() == plain_world(*session.timeline.start, [], 30)[0].digest()


def test_shrinking_looks_through_the_past_a_few_times_however_much_there_is(monkeypatch):
    for name, value in (("SPACING_NS", 0), ("SLICE_NS", 1), ("SHARE", 0), ("MEGABYTE", 10**6)):
        monkeypatch.setattr(timelines, name, value)
    session, looks, past = Session(SCENES[1]), [], snapshots.past_of
    session.timeline.run(1000)
    shelf = session.timeline.snapshots
    monkeypatch.setattr(snapshots, "past_of", lambda act: looks.append(act) or past(act))
    before = len(shelf)
    shelf.fit(shelf.bytes // 30, session.timeline.history.line)
    assert before > 500 and 0 < len(shelf) <= before // 15 and len(looks) < 20
    assert np.diff([0, *sorted(each.now for each in shelf.kept), 1000]).max() < 500


def test_distances_between_snapshots_grow_with_age(monkeypatch):
    monkeypatch.setattr(timelines, "MEGABYTE", 2000)  # 512 KB: some 25 snapshots
    monkeypatch.setattr(timelines, "SPACING_NS", 0)
    monkeypatch.setattr(timelines, "SLICE_NS", 1)
    monkeypatch.setattr(timelines, "SHARE", 0)
    session = Session(SCENES[0])
    monkeypatch.setattr(session.timeline.moment, "run", lambda some: _steadily(session, some))
    session.timeline.run(2000)
    kept = sorted(each.now for each in session.timeline.snapshots.kept)
    gaps = np.diff([0, *kept])
    assert len(kept) > 10 and kept[-1] >= 1990
    assert gaps[: len(gaps) // 3].mean() > 4 * gaps[-len(gaps) // 3 :].mean()


def _steadily(session, iterations):
    """Run as Moment.run does, each iteration taking a microsecond of work."""
    moment = session.timeline.moment
    advance(moment.world, moment.rule, iterations)
    moment.work_ns += 1000 * iterations
    return 1000 * iterations


def test_entries_at_any_moments_make_a_session():
    entries = [Entry(50, DOT), Entry(20, BAR), Entry(90, Flip()), Entry(10, "undo"), Entry(95, "redo")]
    session = Session.retold(Recording(SCENES[1], 0, entries))
    session.seek(100)
    world, _ = plain_world(SCENES[1], 0, session.timeline.history.story(), 100)
    assert session.world.digest() == world.digest()


def test_any_point_of_ten_minutes_is_near(spacing):
    if spacing != "no snapshot":
        pytest.skip("measured once, as it ships")
    session = Session(load_scene("hourglass"))
    for number in range(60):
        session.timeline.run(1600)
        session.do(Paint("sand", (60.0 + number, 30.0), (62.0, 34.0), 5))
    session.do(Flip())
    took_ms = []
    for now in np.random.default_rng(1).integers(0, 96_000, 25).tolist():
        start = time.thread_time()
        session.seek(now)
        took_ms.append(1000 * (time.thread_time() - start))
    assert np.median(took_ms) <= 50
