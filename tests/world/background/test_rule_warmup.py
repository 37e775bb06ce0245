"""Rules made ready: what a session file leads to can be played without a pause."""

from game import Rule, load_rule, load_scene
from game.core.compiler import rule_pass
from game.world.background.rule_warmup import make_recording_ready
from game.world.rules.definition import definition_of_texts
from game.world.sessions.action import Load, SetRule
from game.world.sessions.recording import Recording
from game.world.sessions.session import Session


def test_no_moment_of_a_recording_that_was_made_ready_compiles_a_rule(monkeypatch):
    own = load_rule("rolling-sand").definition
    again = Rule(definition=definition_of_texts(own.name, own.texts))  # as a file tells it
    session = Session(load_scene("aquarium", (60, 40)), seed=1)
    for what in (SetRule(again), Load(load_scene("three-sands", (90, 30)), 2)):
        session.timeline.run(5)
        session.do(what)
    recording = Recording(session.timeline.start[0], 1, session.timeline.history.story(), session.now)
    rule_pass._passes.cache_clear()
    rule_pass._compiled.cache_clear()
    make_recording_ready(recording)
    monkeypatch.setattr(rule_pass, "MachineCode", None)  # would not be called in vain
    retold = Session.retold(recording)
    for now in (session.now, 7, 0, 12):
        retold.seek(now)
        retold.timeline.run(1)
    assert retold.seek(session.now) and retold.world.digest() == session.world.digest()


def test_a_rule_that_a_file_tells_again_is_compiled_once():
    shipped = load_rule("water-and-oil").definition
    assert definition_of_texts(shipped.name, shipped.texts).table is shipped.table
