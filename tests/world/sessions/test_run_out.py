"""Laws of the ending: found ahead of time, it is the iteration at which the last grain really passes."""

import numpy as np
import pytest

from game import Rule, advance, load_scene
from game.world.sand.fixtures import TAP, Fixture
from game.world.sand.neck import find_neck
from game.world.scenes.hourglass_maker import scene_of
from game.world.sessions.action import Clear, Flip, Paint, SetFixtures, SetRule
from game.world.sessions.run_out import Cancelled, at_rest, find_run_out, first_moment
from game.world.sessions.session import Session
from tests.cells import random_world, small_glass
from tests.sweeps import sweep

GLASS = small_glass(60)


def watched(session):
    """Run until all lies still, one iteration at a time; return the last iteration at which a grain left the top."""
    neck, last = find_neck(session.world), session.now
    before = neck.grains_above(session.world)
    while not at_rest(session.world, session.rule):
        session.timeline.run(1)
        now = neck.grains_above(session.world)
        if now != before:
            before, last = now, session.now
    return last


@sweep(
    ("p", "schedule"),
    [(1, "paper"), (0.75, "balanced"), (0.4, "margolus"), (0, "balanced")],
    keep=[(0.75, "balanced"), (0, "balanced")],
)
def test_the_ending_is_when_the_last_grain_passes(p, schedule):
    session = Session(scene_of(GLASS, Rule.with_p(p, schedule)), seed=3)
    session.timeline.run(8)
    ending = find_run_out(session.timeline.lookahead())
    assert ending.has_neck and not ending.endless and ending.start == 8
    assert watched(session) == ending.at > 8


def test_acts_still_to_come_are_foreseen():
    session = Session(scene_of(GLASS), seed=1)
    unturned = find_run_out(session.timeline.lookahead()).at
    session.timeline.run(300)
    session.do(Flip())
    session.timeline.run(10)
    session.do(Paint("sand", (22.0, 12.0), (24.0, 12.0), 5))
    ending = find_run_out(session.timeline.lookahead())
    session.seek(20)
    assert find_run_out(session.timeline.lookahead()).at == ending.at != unturned


def test_a_search_leaves_the_session_alone():
    session = Session(scene_of(GLASS), seed=1)
    before = session.world.digest()
    find_run_out(session.timeline.lookahead())
    assert session.world.digest() == before and session.now == 0


def test_sand_that_never_rests_has_no_end():
    session = Session(scene_of(GLASS, Rule.with_p(1e-6, "balanced")))
    assert find_run_out(session.timeline.lookahead(), most_iterations=5000).endless


def test_sand_under_a_tap_has_no_end_until_nothing_has_room():
    session = Session(scene_of(GLASS))
    session.do(SetFixtures((Fixture(TAP, 22, 20, every=7),)))
    assert find_run_out(session.timeline.lookahead(), most_iterations=500).endless
    ending = find_run_out(session.timeline.lookahead())
    session.timeline.run(ending.at + 10)
    neck = find_neck(session.world)
    assert not ending.endless and neck.grains_above(session.world) > 0 and at_rest(session.world, session.rule)


def test_with_a_tap_the_ending_is_the_last_change_above_the_neck():
    session = Session(scene_of(GLASS))
    session.do(SetFixtures((Fixture(TAP, 22, 20, every=7),)))
    ending = find_run_out(session.timeline.lookahead())
    assert ending.at == watched(session)


def test_nothing_ends_before_the_last_act_that_is_still_to_come():
    session = Session(scene_of(GLASS))
    session.do(Clear())
    session.do(SetFixtures((Fixture(TAP, 22, 20, every=60),)))
    session.timeline.run(400)
    session.do(SetFixtures(()))
    session.seek(1)
    assert find_run_out(session.timeline.lookahead()).at == 400


def test_a_search_that_is_not_wanted_stops():
    with pytest.raises(Cancelled):
        find_run_out(Session(scene_of(GLASS)).timeline.lookahead(), cancelled=lambda: True)


def test_without_a_neck_the_last_grain_is_the_last_that_moves():
    session = Session(load_scene("blank", (20, 30)))
    session.do(Paint("sand", (5.5, 2.5), (5.5, 9.5), 1))
    ending = find_run_out(session.timeline.lookahead())
    assert not ending.has_neck and not ending.endless
    session.timeline.run(ending.at - 1)
    before = session.world.sand
    session.timeline.run(1)
    assert at_rest(session.world, session.rule) and (session.world.sand != before).any()


@pytest.mark.parametrize("name", ["hourglass", "paper", "funnel", "galton", "sandpile", "fullhd"])
def test_a_glass_and_a_hopper_have_their_neck_where_they_are_narrowest(name):
    world = load_scene(name).world()
    neck = find_neck(world)
    walls = world.walls[neck.row]
    assert walls[neck.columns.start - 1] and walls[neck.columns.stop] and not walls[neck.columns].any()
    assert neck.columns.stop - neck.columns.start <= 4 and neck.grains_above(world) > 0


@pytest.mark.parametrize("name", ["ledges", "maze", "blank"])
def test_where_sand_has_several_ways_there_is_no_neck(name):
    assert find_neck(load_scene(name).world()) is None


def test_a_flip_turns_the_neck_over():
    world = load_scene("hourglass").world()
    row = find_neck(world).row
    world.flip()
    assert abs(find_neck(world).row - (world.shape[0] - row)) <= 1


@pytest.mark.parametrize("p", [0, 0.3, 1])
@pytest.mark.parametrize("schedule", ["margolus", "paper", "balanced"])
def test_a_world_at_rest_stays_as_it_is(p, schedule):
    world, rule = random_world(np.random.default_rng(8), 20, 30), Rule.with_p(p, schedule)
    for _ in range(400):
        if at_rest(world, rule):
            break
        advance(world, rule, 1)
    before = world.sand
    advance(world, rule, 500)
    assert (world.sand == before).all()


def test_the_first_moment_is_found_exactly():
    session = Session(scene_of(GLASS), seed=2)
    first = first_moment(session.timeline.lookahead(), 900, lambda world: world.iteration >= 617)
    assert first == 617


def test_friction_changed_on_the_way_changes_the_ending():
    session = Session(scene_of(GLASS), seed=2)
    before = find_run_out(session.timeline.lookahead()).at
    session.do(SetRule(Rule.with_p(0.2, "balanced")))
    assert find_run_out(session.timeline.lookahead()).at > before


def test_what_cannot_pass_is_told_of():
    session = Session(scene_of(GLASS))
    session.timeline.run(300)
    above = find_neck(session.world).grains_above(session.world)
    assert 0 == find_run_out(session.timeline.lookahead()).left < above
    middle = session.world.shape[0] / 2
    session.do(Paint("wall", (0.0, middle), (float(session.world.shape[1]), middle), 3))
    ending = find_run_out(session.timeline.lookahead())
    assert ending.left > 0.8 * above and ending.at - session.now < 60
