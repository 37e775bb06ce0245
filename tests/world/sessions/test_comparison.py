"""The comparison: three worlds that hear the same and move by their own schedules."""

import time
from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from game import Rule, advance, load_rule, load_scene
from game.world.rules.rule import SCHEDULES
from game.world.sand import parameters
from game.world.sessions.action import Clear, Flip, Load, Paint, SetRule, apply
from game.world.sessions.comparison import Comparison, by_friction, by_rule, by_schedule, by_seed, present
from game.world.sessions.session import BUDGET_NS, Session

FRAME_NS = 16_666_667


@pytest.fixture
def three():
    """Return a Comparison of a small glass."""
    scene = load_scene("hourglass", (45, 60))
    return Comparison(replace(scene, rule=Rule.with_p(0.6, "balanced")), seed=9)


def digests(comparison):
    return {each: session.world.digest() for each, session in comparison.sessions.items()}


def test_each_world_is_an_advance_of_its_own_rule(three):
    start = three.world.copy()
    for _ in range(40):
        three.frame(FRAME_NS)
    assert three.now > 50
    for schedule, session in three.sessions.items():
        alone = start.copy()
        advance(alone, Rule.with_p(0.6, schedule.lower()), three.now)
        assert session.world.digest() == alone.digest()
    assert len(set(digests(three).values())) == 3


def test_what_is_done_to_one_is_done_to_all_and_each_keeps_its_schedule(three):
    acts = [
        Paint("sand", (22.0, 10.0), (30.0, 12.0), 5),
        SetRule(Rule(0.3, 0.9, fall_pair=0.5, schedule="margolus")),
        Flip(),
        Paint("wall", (5.0, 40.0), (40.0, 40.0), 2),
        Clear(),
        Paint("sand", (22.0, 10.0), (22.0, 10.0), 9),
    ]
    worlds = {each.capitalize(): (three.world.copy(), Rule.with_p(0.6, each)) for each in SCHEDULES}
    for act in acts:
        three.do(act)
        for _ in range(5):
            three.frame(FRAME_NS)
        for schedule, (world, rule) in worlds.items():
            world, rule = apply(act, world, rule)[:2]
            rule = replace(rule, schedule=schedule.lower())
            advance(world, rule, three.now - world.iteration)
            worlds[schedule] = world, rule
        assert digests(three) == {each: world.digest() for each, (world, _) in worlds.items()}
    assert [session.rule.schedule for session in three.sessions.values()] == list(SCHEDULES)
    assert all(session.account.balanced(session.world) for session in three.sessions.values())


def test_undo_rewind_and_redo_take_all_three_along(three):
    generator = np.random.default_rng(91)
    story = {}
    for number in range(12):
        three.timeline.run(17)
        three.keep_up()
        story[three.now] = digests(three)
        three.do(Flip() if number % 4 == 3 else Paint("sand", (22.0, 8.0), (22.0, 8.0), 1 + number % 5))
    last = digests(three)
    assert three.undo()
    assert digests(three) != last
    assert three.redo()
    assert digests(three) == last
    for now in generator.permutation(list(story)[:-1]):
        three.seek(int(now) - 1)
        three.step()
        three.timeline.rewinding = not three.timeline.rewinding
        assert all(session.now == now for session in three.sessions.values())
    three.seek(story_end := list(story)[-1])
    three.undo()
    assert digests(three) == story[story_end]


def test_those_that_follow_are_never_left_behind_by_a_small_budget(three):
    for _ in range(30):
        three.frame(10 * FRAME_NS, budget_ns=3000)
        assert len({session.now for session in three.sessions.values()}) == 1
    three.seek(3, budget_ns=3000)
    while three.timeline.goal is not None:
        three.frame(FRAME_NS, budget_ns=3000)
    three.keep_up()
    assert {session.now for session in three.sessions.values()} == {3}


def test_another_scene_is_loaded_under_each_schedule(three):
    three.do(Load(load_scene("paper"), 3))
    three.frame(FRAME_NS)
    assert [session.rule.schedule for session in three.sessions.values()] == list(SCHEDULES)
    assert {session.scene.title for session in three.sessions.values()} == {"The paper's hourglass"}


def test_the_present_is_a_scene_that_starts_where_a_session_is():
    session = Session(load_scene("hourglass", (45, 60)), seed=4)
    session.timeline.run(60)
    session.do(SetRule(Rule.with_p(0.2)))
    world = present(session).world(4)
    assert (world.sand == session.world.sand).all() and (world.walls == session.world.walls).all()
    assert present(session).rule == Rule.with_p(0.2) and present(session).neck == 30


def test_coloured_sand_is_compared_as_it_lies_now():
    session = Session(load_scene("rainbow"), 1)
    session.timeline.run(60)
    assert present(session).world(1).amounts == session.world.amounts


def test_a_limit_of_memory_holds_for_the_pasts_of_all_worlds():
    session = Comparison(load_scene("hourglass"))
    session.limit_memory(30)
    budgets = [each.timeline.memory_mb for each in session.sessions.values()]
    assert budgets == [10, 10, 10] and session.memory_mb == 30
    session.limit_memory(1)
    assert {each.timeline.memory_mb for each in session.sessions.values()} == {1}


def test_a_leading_world_with_little_to_do_waits_for_those_with_much():
    session = Comparison(load_scene("hourglass", (24, 36)))
    large = load_scene("hourglass", (800, 1200))
    session.others = {schedule: Session(large) for schedule in session.others}
    session.frame(0, 1, due=1)  # what has to be compiled is
    start = time.thread_time_ns()
    for _ in range(10):
        session.frame(0, BUDGET_NS, due=100_000)
        assert len({each.now for each in session.sessions.values()}) == 1
    assert 1 < session.now < 10 * 100_000
    assert time.thread_time_ns() - start < 2 * 10 * BUDGET_NS


def test_a_moment_far_away_is_waited_for_in_all_worlds(three):
    three.seek(50_000, budget_ns=1)
    assert not three.arrived
    while not three.arrived:
        before = [session.timeline.moment.now for session in three.sessions.values()]
        three.catch_up(3000)
        after = [session.timeline.moment.now for session in three.sessions.values()]
        assert after >= before != after
    assert {session.now for session in three.sessions.values()} == {50_000}


def test_an_undo_on_the_way_to_a_far_moment_leaves_the_worlds_alike(three):
    three.timeline.run(40)
    three.keep_up()
    three.do(Flip())
    three.seek(30_000, budget_ns=1)
    three.undo(budget_ns=1)
    while not three.arrived:
        three.catch_up(10**6)
    alone = {each: Session(session.scene, 9) for each, session in three.sessions.items()}
    for each, session in alone.items():
        session.timeline.run(30_000)
        assert three.sessions[each].world.digest() == session.world.digest()


def test_an_act_that_changes_any_of_the_worlds_is_one_of_all(three):
    three.timeline.run(60)
    three.keep_up()
    leading, other = three.world, three.others["Paper"].world
    row, column = np.argwhere(other.sand & ~leading.sand)[0].tolist()
    dot = Paint("erase", (column, row), (column, row), 1, only="sand")
    before = digests(three)
    assert three.do(dot) and not three.do(dot)
    assert digests(three)[three.lead] == before[three.lead] and digests(three) != before
    assert len({len(each.timeline.history.story()) for each in three.sessions.values()}) == 1
    assert three.undo() and digests(three) == before


@pytest.mark.parametrize(("p", "lead"), [(0.5, "p = 0.5"), (0.6, "p = 0.25")])
def test_four_values_of_p_differ_in_nothing_else(p, lead):
    rule = Rule(p, p, fall_pair=0.9, schedule="balanced")
    scene = replace(load_scene("hourglass", (45, 60)), rule=rule)
    four = Comparison(scene, seed=9, subject=by_friction)
    assert four.lead == lead and list(four.sessions) == ["p = 0.25", "p = 0.5", "p = 0.75", "p = 1"]
    four.do(SetRule(Rule(0.1, 0.1, fall_pair=0.7, schedule="paper")))
    four.do(Paint("sand", (22.0, 10.0), (30.0, 12.0), 5))
    for _ in range(90):
        four.frame(FRAME_NS)
    alone = {}
    for value in parameters.PAPER_P:
        world, wanted = scene.world(9), Rule(value, value, fall_pair=0.7, schedule="paper")
        apply(Paint("sand", (22.0, 10.0), (30.0, 12.0), 5), world, wanted)
        advance(world, wanted, four.now)
        alone[f"p = {value:g}"] = world.digest()
    assert digests(four) == alone and len(set(alone.values())) == 4


def test_worlds_of_three_seeds_differ_in_nothing_else():
    scene = replace(load_scene("hourglass", (45, 60)), rule=Rule.with_p(0.5))
    three = Comparison(scene, seed=2**64 - 1, subject=partial(by_seed, number=3))
    assert list(three.sessions) == [f"Seed {2**64 - 1}", "Seed 0", "Seed 1"] and three.lead == f"Seed {2**64 - 1}"
    three.timeline.run(50)
    three.keep_up()
    wanted = []
    for seed in (2**64 - 1, 0, 1):
        world = scene.world(seed)
        advance(world, scene.rule, 50)
        wanted.append(world.digest())
    assert list(digests(three).values()) == wanted and len(set(wanted)) == 3


def test_any_rule_can_be_compared_under_schedules_and_seeds():
    for subject in (by_schedule, partial(by_seed, number=3)):
        three = Comparison(load_scene("kitchen"), seed=4, subject=subject)
        for _ in range(3):
            three.frame(FRAME_NS)
        assert all(session.account.balanced(session.world) for session in three.sessions.values())
        assert len(set(digests(three).values())) == 3


def test_worlds_of_several_rules_start_from_the_same_cells_and_are_painted_alike():
    scene = load_scene("hourglass", (45, 60))
    rules = {"Sand": scene.rule, "Rolling": load_rule("rolling-sand"), "Water": load_rule("water-and-oil")}
    three = Comparison(scene, seed=3, subject=partial(by_rule, rules=rules))
    assert three.lead == "Sand" and [each.rule for each in three.sessions.values()] == [*rules.values()]
    assert all((each.world.sand == scene.sand).all() for each in three.sessions.values())
    assert all((each.world.walls == scene.walls).all() for each in three.sessions.values())
    three.do(Paint("sand", (22.0, 30.0), (30.0, 32.0), 5))
    three.do(SetRule(Rule.with_p(0.2)))
    for _ in range(30):
        three.frame(FRAME_NS)
    assert [each.rule for each in three.sessions.values()] == [*rules.values()]
    assert len({each.world.sand.tobytes() for each in three.sessions.values()}) > 1
    assert all(session.account.balanced(session.world) for session in three.sessions.values())
