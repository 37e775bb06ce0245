"""Lively time: where nothing moves, it stands still."""

import numpy as np

from game.world.sand.fixtures import Fixture
from game.world.sessions.action import Paint, SetFixtures
from game.world.sessions.lively_time import LivelyTime
from game.world.sessions.session import Session
from tests.world.random_sessions import scene_of

DROP = Paint("sand", (5.0, 2.0), (5.0, 2.0), 3)


def followed(session):
    time = LivelyTime()
    time.follow(session.timeline)
    return time


def rested(*columns):
    """Return a Session in which a drop falls into each column, long after all has come to rest, and when it fell."""
    session, fell = Session(scene_of(0)), []
    for column in columns:
        session.timeline.run(5000)
        fell.append(session.now)
        session.do(Paint("sand", (column, 2.0), (column, 2.0), 3))
    session.timeline.run(5000)
    return session, fell


def test_hours_at_rest_take_no_room_and_what_moves_does():
    session, fell = rested(4.0, 12.0, 20.0)
    time = followed(session)
    lively = time.up_to(np.array([0, *fell, session.now]))
    assert (np.diff(lively) >= 4).all() and lively[-1] < 600
    longer = lively[-1]
    session.timeline.run(100_000)
    assert followed(session).up_to(session.now) == longer


def test_a_place_on_the_bar_is_a_moment_and_back():
    session, fell = rested(4.0, 12.0)
    time = followed(session)
    for now in (0, 3, *fell, fell[0] + 4, fell[1] + 2):
        assert time.now_at(time.up_to(now)) == now


def test_without_any_rest_it_is_the_iteration():
    session = Session(scene_of(0))
    session.do(SetFixtures((Fixture("tap", 3, 0, 9), Fixture("drain", -5, 22, 60, 2))))
    session.timeline.run(500)
    assert followed(session).up_to(session.now) == 500


def test_a_future_that_is_left_leaves_no_rest_behind():
    session, (first, _) = rested(4.0, 12.0)
    session.seek(first + 1)
    session.do(Paint("sand", (20.0, 2.0), (22.0, 2.0), 3))
    session.timeline.run(2)
    lively = followed(session).up_to(np.array([first, session.now]))
    assert lively[1] - lively[0] == 3
