"""Time that runs ahead: it computes what would have come anyway, and stops at the very iteration that was wanted."""

import threading
import time

import numpy as np
import pygame
import pytest

from game.play.controls import fast_forward
from game.play.controls.fast_forward import MOST_TOGETHER
from game.play.timer import run_out_planner
from game.world.rules.rule import Rule
from game.world.sand.block_events import possible_events
from game.world.sand.neck import find_neck
from game.world.scenes.hourglass_maker import scene_of
from game.world.sessions.action import Flip, SetRule
from game.world.sessions.run_out import Cancelled, at_rest, find_run_out
from game.world.sessions.session import Session
from tests.cells import small_glass
from tests.play.player import Player

SCENE = scene_of(small_glass(60))


@pytest.fixture
def watcher():
    """Return a player with a small glass, whose time is held."""
    player = Player("hourglass", size=(700, 560))
    player.parts.sessions.open_scene(SCENE, 4)
    player.session.paused = True
    player.wait(0)
    yield player
    pygame.display.quit()


def go_on(player, frames=400):
    """Play frames until nothing runs ahead any more."""
    for _ in range(frames):
        player.settle()
        if player.parts.fast_forward.due() is None:
            return
    pytest.fail("it runs for ever")


def same_as_at_own_pace(session):
    twin = Session(SCENE, 4)
    twin.timeline.run(session.world.iteration)
    return twin.world.digest() == session.world.digest()


def test_a_held_key_runs_as_many_iterations_as_frames_hold(watcher):
    watcher.press(pygame.K_RIGHT)
    watcher.wait(5)
    assert watcher.world.iteration > 100 and same_as_at_own_pace(watcher.session)
    watcher.release(pygame.K_RIGHT)
    now = watcher.session.now
    watcher.wait(5)
    assert watcher.session.now == now, "let go, the pause holds again"


def test_a_held_key_goes_faster_from_frame_to_frame(watcher, monkeypatch):
    monkeypatch.setattr("game.play.frame_step.LEAST_STEPPING_NS", 10**12)  # on whatever machine
    watcher.press(pygame.K_RIGHT)
    places = []
    for _ in range(9):
        places.append(watcher.session.now)
        watcher.frame()
    steps = np.diff(places)
    assert (
        (np.diff(steps) >= 0).all() and steps[-1] > 1.5 * steps[0] and steps[0] < 20 * watcher.session.clock.speed / 60
    )


@pytest.mark.parametrize("let_go", [False, True])
def test_a_held_key_goes_no_further_than_to_rest(watcher, let_go):
    watcher.press(pygame.K_RIGHT)
    for _ in range(400):
        before = watcher.session.now
        watcher.frame()
        if let_go and watcher.session.now == before:  # it looks for the iteration in which all came to rest
            watcher.release(pygame.K_RIGHT)
            break
    watcher.settle()
    watcher.wait(5)
    twin = Session(SCENE, 4)
    twin.timeline.run(watcher.world.iteration - 1)
    assert not at_rest(twin.world, twin.rule) and at_rest(watcher.world, watcher.session.rule)
    assert watcher.session.reached == watcher.session.now and not (
        let_go and watcher.parts.fast_forward.due() is not None
    )


def test_the_key_belongs_to_a_control_that_has_the_keyboard(watcher):
    watcher.click(watcher.control("p"))
    watcher.press(pygame.K_RIGHT)
    watcher.wait(3)
    assert watcher.world.iteration == 0 and not watcher.parts.fast_forward.held


def test_a_button_that_was_clicked_keeps_neither_right_nor_escape_to_itself(watcher):
    watcher.click(watcher.control("Compare"))
    watcher.settle()
    assert len(watcher.parts.sessions.waiting) == 1
    watcher.key(pygame.K_ESCAPE)
    assert not watcher.parts.sessions.waiting
    watcher.click(watcher.control("Flip"))
    watcher.now_s += 10
    watcher.wait(2)
    at = watcher.world.iteration
    watcher.press(pygame.K_RIGHT)
    watcher.wait(3)
    assert watcher.parts.fast_forward.held and watcher.world.iteration > at


def test_the_button_is_held_as_well(watcher):
    place = watcher.control("Fast")
    watcher.button(pygame.MOUSEBUTTONDOWN, place)
    watcher.wait(5)
    assert watcher.world.iteration > 100
    watcher.button(pygame.MOUSEBUTTONUP, place)
    now = watcher.session.now
    watcher.wait(3)
    assert watcher.session.now == now


def test_settle_stops_at_the_iteration_from_which_nothing_moves(watcher):
    watcher.key(pygame.K_END)
    go_on(watcher)
    session = watcher.session
    assert at_rest(session.world, session.rule) and same_as_at_own_pace(session)
    assert f"after {session.world.iteration:,} iterations" in watcher.parts.notices.text
    still = session.world.sand
    session.seek(session.now - 1)
    assert not at_rest(session.world, session.rule) and (session.world.sand != still).any()


def test_settled_sand_needs_no_iteration(watcher):
    for _ in range(2):
        watcher.key(pygame.K_END)
        go_on(watcher)
    assert watcher.parts.notices.text == "Nothing can move here."


def test_liquids_that_never_rest_are_stopped_with_a_word_on_what_can_still_happen():
    player = Player("aquarium", size=(700, 560))
    player.session.paused = True
    player.key(pygame.K_END)
    player.wait(4)
    player.key(pygame.K_ESCAPE)
    said = player.parts.notices.text
    assert said.startswith("Stopped after ") and " iterations. Still possible: " in said
    assert said.rpartition(": ")[2].removesuffix(".") == ", ".join(possible_events(player.world, player.session.rule))
    assert player.parts.fast_forward.due() is None
    pygame.display.quit()


def test_the_next_flow_is_the_iteration_at_which_a_grain_passes(watcher):
    session, neck = watcher.session, find_neck(watcher.world)
    for _ in range(3):
        before = neck.grains_above(session.world)
        watcher.key(pygame.K_RIGHT, mod=pygame.KMOD_SHIFT)
        go_on(watcher)
        assert neck.grains_above(session.world) < before and same_as_at_own_pace(session)
        twin = Session(SCENE, 4)
        twin.timeline.run(session.world.iteration - 1)
        assert neck.grains_above(twin.world) == before
        assert session.reached == session.now


def test_a_key_that_went_down_with_shift_is_no_other_when_shift_comes_up_first(watcher):
    neck = find_neck(watcher.world)
    for _ in range(2):
        before = neck.grains_above(watcher.world)
        watcher.press(pygame.K_RIGHT, mod=pygame.KMOD_SHIFT)
        go_on(watcher)
        assert neck.grains_above(watcher.world) < before
        watcher.press(pygame.K_RIGHT)
        assert not watcher.parts.fast_forward.held
        watcher.release(pygame.K_RIGHT)


def test_the_key_comes_up_whatever_else_is_held(watcher):
    watcher.press(pygame.K_RIGHT)
    watcher.release(pygame.K_RIGHT, pygame.KMOD_SHIFT)
    assert not watcher.parts.fast_forward.held


def test_it_is_said_that_nothing_will_pass(watcher):
    watcher.key(pygame.K_END)
    go_on(watcher)
    watcher.key(pygame.K_RIGHT, mod=pygame.KMOD_SHIFT)
    go_on(watcher)
    assert watcher.parts.notices.text == "Nothing more will pass the neck."
    watcher.parts.sessions.load("blank")
    watcher.key(pygame.K_RIGHT, mod=pygame.KMOD_SHIFT)
    assert "no single neck" in watcher.parts.notices.text


def test_an_act_that_moves_sand_past_the_neck_is_no_flow(watcher):
    watcher.key(pygame.K_END)
    go_on(watcher)
    watcher.parts.sessions.do(Flip())
    watcher.parts.fast_forward.await_flow()
    watcher.parts.sessions.do(Flip())
    go_on(watcher)
    assert watcher.parts.notices.text == "Nothing more will pass the neck."


def test_escape_stops_it(watcher):
    watcher.parts.sessions.do(SetRule(Rule.with_p(1e-6, "balanced")))
    watcher.key(pygame.K_END)
    watcher.wait(3)
    assert watcher.world.iteration > 0
    watcher.key(pygame.K_ESCAPE)
    now = watcher.session.now
    watcher.wait(3)
    assert watcher.session.now == now and watcher.parts.running and "Stopped after" in watcher.parts.notices.text


def test_undo_and_replay_agree_with_time_that_ran_ahead(watcher):
    session = watcher.session
    watcher.key(pygame.K_RIGHT, mod=pygame.KMOD_SHIFT)
    go_on(watcher)
    flow = session.now
    watcher.parts.sessions.do(Flip())
    watcher.key(pygame.K_END)
    go_on(watcher)
    end, digest = session.now, session.world.digest()
    session.seek(flow - 1)
    session.seek(end)
    assert session.world.digest() == digest
    session.undo()
    assert session.now == end and same_as_at_own_pace(session)


def test_an_ending_foreseen_is_where_the_flow_ends(watcher):
    ending = find_run_out(watcher.session.timeline.lookahead())
    watcher.session.seek(ending.at - 1)
    watcher.key(pygame.K_RIGHT, mod=pygame.KMOD_SHIFT)
    go_on(watcher)
    assert watcher.session.now == ending.at


def test_another_lattice_ends_the_wait_for_the_flow(watcher):
    watcher.parts.fast_forward.await_flow()
    watcher.parts.sessions.load("blank")
    watcher.frame()
    assert watcher.parts.fast_forward.due() is None


def test_an_act_while_the_iteration_is_looked_for_ends_the_search(watcher):
    watcher.parts.fast_forward.await_flow()
    while watcher.parts.fast_forward.due() != 0:
        watcher.frame()
    watcher.parts.sessions.do(SetRule(Rule.with_p(0.25)))
    watcher.settle()
    assert watcher.parts.fast_forward.due() is None


def without_memory_once(monkeypatch, module, name):
    """Let a module's function find no memory when it is called for the first time."""
    function, rooms = getattr(module, name), [MemoryError]

    def tried(*arguments):
        if rooms:
            raise rooms.pop()
        return function(*arguments)

    monkeypatch.setattr(module, name, tried)


def test_a_plan_for_which_there_was_no_memory_is_made_later(watcher, monkeypatch):
    without_memory_once(monkeypatch, run_out_planner, "find_run_out")
    monkeypatch.setattr(run_out_planner, "AGAIN_S", 0.0)
    for newest in (False, True):
        watcher.parts.planner.ask()
        watcher.settle()
        assert (watcher.parts.planner.newest is not None) == newest
    assert "Not enough memory" in watcher.parts.notices.text


def test_an_iteration_for_which_there_was_no_memory_lets_time_go_on(watcher, monkeypatch):
    without_memory_once(monkeypatch, fast_forward, "first_moment")
    watcher.key(pygame.K_RIGHT, mod=pygame.KMOD_SHIFT)
    go_on(watcher, frames=50)
    assert "Not enough memory" in watcher.parts.notices.text


def test_a_plan_for_what_is_no_longer_so_is_given_up(watcher, monkeypatch):
    given_up, too_long = threading.Event(), time.monotonic() + 20

    def endless(lookahead, cancelled):
        while time.monotonic() < too_long:
            if cancelled():
                given_up.set()
                raise Cancelled
            time.sleep(0.001)

    monkeypatch.setattr(run_out_planner, "PATIENCE_S", 0.0)
    with monkeypatch.context() as context:
        context.setattr(run_out_planner, "find_run_out", endless)
        watcher.parts.planner.ask()
        time.sleep(0.01)
    watcher.parts.sessions.do(Flip())
    for _ in range(2):
        assert watcher.parts.planner.ask() is None
        watcher.settle()
    assert given_up.is_set() and watcher.parts.planner.newest == watcher.parts.planner.ask()


@pytest.mark.parametrize("code", [pygame.K_END, pygame.K_RIGHT])
def test_in_a_comparison_rest_is_that_of_all_worlds(watcher, code):
    watcher.key(pygame.K_h, mod=pygame.KMOD_LSHIFT)
    watcher.press(code)
    for _ in range(600):
        watcher.frame()
        if watcher.session.settled:
            break
    watcher.wait(30)
    worlds = watcher.session.sessions.values()
    assert watcher.session.at_rest and all(at_rest(each.world, each.rule) for each in worlds)
    twins = [Session(each.scene, 4) for each in worlds]
    for twin in twins:
        twin.timeline.run(max(0, watcher.session.now - MOST_TOGETHER))
    assert not all(at_rest(each.world, each.rule) for each in twins)


def test_a_run_to_the_next_flow_and_a_restart_after_it_say_that_time_stands_still(glass):
    glass.press(pygame.K_RIGHT, mod=pygame.KMOD_LSHIFT)
    glass.wait(5)
    glass.settle()
    glass.wait(1)
    assert glass.session.paused and "Space" in glass.parts.notices.text
    glass.key(pygame.K_r)
    assert glass.world.iteration == 0 and "at its start, and time stands still" in glass.parts.notices.text
