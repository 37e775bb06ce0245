"""Frames: every iteration that is due is run, or is said not to have been."""

import time

import numpy as np
import pytest

from game import Rule, advance, load_scene
from game.world.sessions.action import Clear, Flip, Load, Paint, SetRule, apply, snap
from game.world.sessions.session import Session
from tests.cells import random_world

FRAME_NS = 16_666_667


def test_frames_run_what_the_clock_says_and_nothing_else():
    session = Session(load_scene("paper"))
    done = sum(session.frame(FRAME_NS) for _ in range(120))
    assert done == session.world.iteration == int(120 * FRAME_NS * session.scene.speed) // 10**9


def test_frames_and_one_call_give_the_same_world():
    session, world = Session(load_scene("hourglass"), seed=4), load_scene("hourglass").world(4)
    for _ in range(90):
        session.frame(FRAME_NS, budget_ns=10**9)
    advance(world, session.rule, session.world.iteration)
    assert session.world.digest() == world.digest()


def test_a_pause_holds_the_world():
    session = Session(load_scene("paper"))
    session.paused = True
    before = session.world.digest()
    assert session.frame(FRAME_NS) == 0 and session.world.digest() == before
    session.step()
    assert session.world.iteration == 1


def test_a_full_frame_runs_fewer_iterations_and_says_so(monkeypatch):
    ticks = iter(range(0, 10**15, 5_000_000))  # every look at the time finds 5 ms gone
    monkeypatch.setattr(time, "perf_counter_ns", lambda: next(ticks))
    session = Session(load_scene("paper"))
    session.clock.speed = 600_000
    done = session.frame(FRAME_NS, budget_ns=16_000_000)
    assert 1 <= done == session.done == session.world.iteration < session.due == 10_000
    assert session.frame(0, budget_ns=16_000_000) == 0, "what did not fit is left out, not piled up"


def test_even_a_hopelessly_slow_frame_moves_on(monkeypatch):
    ticks = iter(range(0, 10**15, 50_000_000))
    monkeypatch.setattr(time, "perf_counter_ns", lambda: next(ticks))
    session = Session(load_scene("paper"))
    for _ in range(3):
        assert session.frame(100_000_000, budget_ns=16_000_000) == 1


def test_loading_brings_world_rule_and_pace():
    session = Session(load_scene("hourglass"))
    other = load_scene("paper")
    session.do(Load(other, 3))
    assert session.world.digest() == other.world(3).digest()
    assert session.rule == other.rule and session.clock.speed == other.speed and session.scene is other


def test_every_stroke_paints_the_cells_near_its_line_and_no_others():
    generator = np.random.default_rng(7)
    y, x = np.mgrid[0:40, 0:150] + 0.5
    for number in range(60):
        world = random_world(generator, 40, 150)
        sand, walls = world.sand, world.walls
        material = ("sand", "wall", "erase")[number % 3]
        diameter = int(generator.integers(1, 12))
        over_walls = bool(generator.integers(2))
        start, end = generator.uniform((-10, -10), (160, 50), (2, 2)).tolist()
        apply(Paint(material, tuple(start), tuple(end), diameter, over_walls), world, Rule())
        near = _distance(x, y, snap(start, diameter), snap(end, diameter)) <= diameter / 2 + 1e-6
        painted = near & ~walls if material == "sand" and not over_walls else near
        assert (world.sand == np.where(painted, material == "sand", sand)).all()
        assert (world.walls == np.where(painted, material == "wall", walls)).all()
        _assert_sound(world)


def _distance(x, y, start, end):
    """Return the distance of each (x, y) from the line between two points."""
    (x0, y0), (x1, y1) = start, end
    length = (x1 - x0) ** 2 + (y1 - y0) ** 2
    part = np.clip(((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / length, 0, 1) if length else 0
    return np.hypot(x - x0 - part * (x1 - x0), y - y0 - part * (y1 - y0))


def _assert_sound(world):
    """Assert that a painted world is, plane by plane, what one made from its cells would be."""
    twin = type(world).from_cells(world.sand, world.walls, world.seed)
    assert (twin.planes[4:] == world.planes[4:]).all(), "walls, and their copies for odd x"
    for each in (world, twin):
        each.iteration = 1
        advance(each, Rule.with_p(0.5), 3)
    assert world.digest() == twin.digest()


def test_a_one_cell_brush_paints_the_cell_under_it():
    world = random_world(np.random.default_rng(8), 20, 20, sand=0, walls=0)
    apply(Paint("sand", (7.9, 3.2), (7.9, 3.2), 1), world, Rule())
    assert np.argwhere(world.sand).tolist() == [[3, 7]]


@pytest.mark.parametrize("action", [Flip(), Clear(), SetRule(Rule.with_p(0.5))])
def test_acts_do_what_they_say(action):
    world = random_world(np.random.default_rng(9), 33, 70)
    sand, walls = world.sand, world.walls
    same, rule = apply(action, world, Rule())
    match action:
        case Flip():
            assert (same.sand == sand[::-1, ::-1]).all()
        case Clear():
            assert not same.sand.any() and (same.walls == walls).all()
        case SetRule():
            assert rule == action.rule and (same.sand == sand).all()


def test_what_is_no_action_is_refused():
    with pytest.raises(TypeError, match="not an action"):
        apply("flip", random_world(np.random.default_rng(1), 4, 4), Rule())
