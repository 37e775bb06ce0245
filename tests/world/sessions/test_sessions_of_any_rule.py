"""Laws of time hold whatever the cells are: acts, undo, redo, files and journals end in the same cells."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import advance, load_rule
from game.world.files import atomic
from game.world.scenes.scene import Scene
from game.world.sessions import timeline as timelines
from game.world.sessions.journal import Journal
from game.world.sessions.recording import Recording, load_replay, parse
from game.world.sessions.session import Session
from tests.cells import strewn
from tests.saved import recording_of, to_bytes
from tests.sweeps import swept
from tests.world.random_sessions import (
    SCENES,
    actions_of,
    fixtures_of,
    obey,
    plain_world,
    played,
    plays_of,
    state,
    tools_of,
)

NAMES = "alchemy", "rolling-sand"


def scene_of(name):
    """Return a small scene with all materials of a shipped rule."""
    rule = load_rule(name)
    return Scene(name, name, "", strewn(rule, 1, 24, 30, lumps=2).materials, rule, 90.0, 4)


def plays_with(scene):
    """Return what makes plays with the materials of a scene, its rule's chances, and now and then sand alone."""
    rule = scene.rule
    usual, first = st.just(rule), next(iter(rule.chances))
    set_rules = st.one_of(usual, st.just(rule.with_chances(**{first: 0.25})), st.just(SCENES[1].rule))
    tools, fixtures = tools_of(rule.materials[1:]), fixtures_of(rule.materials)
    actions = actions_of(tools, fixtures, set_rules, [scene, scene, SCENES[1]])
    return plays_of(st.one_of(tools, actions))


OWN = {name: scene_of(name) for name in NAMES}
PLAYS = {name: plays_with(scene) for name, scene in OWN.items()}


@pytest.fixture(autouse=True, params=swept(["no snapshot", "snapshots everywhere"], keep=["snapshots everywhere"]))
def spacing(request, monkeypatch):
    """Let every law hold whatever snapshots there are, and do not wait for the disk."""
    monkeypatch.setattr(atomic.os, "fsync", lambda handle: None)
    if request.param != "no snapshot":
        for name, value in (("SPACING_NS", 0), ("SLICE_NS", 1), ("SHARE", 0)):
            monkeypatch.setattr(timelines, name, value)


@pytest.mark.parametrize("name", NAMES)
@given(data=st.data())
def test_the_present_is_what_the_acts_make_of_the_start_and_the_account_knows_it(name, data):
    session = played([], OWN[name])
    for command in data.draw(PLAYS[name]):
        obey(session, command)
        assert session.account.balanced(session.world)
    world, rule = plain_world(*session.timeline.start, session.timeline.history.story(), session.now)
    assert session.world.digest() == world.digest() and session.rule == rule


@pytest.mark.parametrize("name", NAMES)
@given(data=st.data())
def test_undo_redo_and_rewinding_come_back_to_the_same_cells(name, data):
    session = played(data.draw(PLAYS[name]), OWN[name])
    before = state(session)
    session.seek(min(data.draw(st.integers(0, 150)), session.now))
    session.timeline.run(before[0] - session.now)
    assert state(session) == before
    steps = 0
    while session.undo():
        steps += 1
    scene, seed = session.timeline.start
    world = scene.world(seed)
    advance(world, scene.rule, session.now)
    assert session.world.digest() == world.digest() and session.rule == scene.rule
    for _ in range(steps):
        assert session.redo()
    assert state(session) == before


@pytest.mark.parametrize("name", NAMES)
@given(data=st.data())
def test_replays_and_journals_tell_the_same_session(name, data, tmp_path):
    session = Session(OWN[name], 5)
    session.journal = Journal.begin(OWN[name], 5, tmp_path)
    for command in data.draw(PLAYS[name]):
        obey(session, command)
    session.journal.abandon()
    recording, _ = parse(to_bytes(recording_of(session)), "file")
    assert recording.problem is None and recording.digest == session.world.digest()
    told = [Session.retold(recording)]
    if session.journal.path.exists():
        journal = load_replay(session.journal.path)
        told.append(Session.retold(Recording(*session.timeline.start, journal.entries)))
    for each in told:
        each.seek(session.now)
        assert state(each) == state(session)
