"""Laws of session files: they tell every act, give one world everywhere, and say in one line where they are wrong."""

import base64
import json
import tracemalloc
import zlib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import Rule, cli, headless, load_rule, load_scene
from game.world.files.paths import asset
from game.world.rules.rule_json import encode_rule
from game.world.sand.fixtures import Fixture
from game.world.scenes import scene_json
from game.world.scenes.scene_json import start_digest
from game.world.sessions.action import (
    Clear,
    Draw,
    Fill,
    Flip,
    Load,
    Move,
    Paint,
    Paste,
    Resize,
    SetFixtures,
    SetRule,
    Turn,
    snap,
)
from game.world.sessions.history import Entry
from game.world.sessions.journal import Journal
from game.world.sessions.recording import ReplayError, load_replay, parse
from game.world.sessions.session import Session
from game.world.sessions.session_format import LineWriter
from tests.saved import recording_of, save_replay, to_bytes
from tests.world.random_sessions import SCENES, actions, played, plays, stamp_of, state

ROOT = Path(__file__).parents[3]
GOLDEN = {  # what the demos end in, on every machine; tests/data/make_replays.py makes them
    "builder": "60d7699cedd5fcb7a25b4a1dd7a99b7e",
    "rooms": "da2d9f5265e08ef83b775ed56ed2677e",
    "three-turns": "497cf2bd5914090962d2ee365cc5e971",
}


def sample():
    """Return a Session with every kind of act."""
    session = Session(SCENES[1], seed=2**64 - 1)
    session.timeline.run(10)
    for number in range(6):
        session.do(Paint("wall", (3.2 + number, 4.0), (4.2 + number, 4.0), 5), join=number > 0)
        session.timeline.run(number % 2)
    acts = [Flip(), SetRule(Rule(0.1, 1 / 3, schedule="margolus")), Clear(), Load(load_scene("paper"), 3)]
    acts += [Load(SCENES[2], 4), Load(SCENES[2], 5), Paint("wall", (5, 5), (9.5, 6), 4, True), Flip()]
    acts += [
        Draw("ellipse", "wall", (3, 3), (12.2, 9), 2),
        Fill("sand", (6.5, 6.5)),
        Draw("rectangle", "erase", (5, 1), (1, 4)),
    ]
    acts += [
        Paint("sand", (5, 5), (9.5, 6), 4, shape="diamond", only="wall"),
        Paint("sand", (5, 5), (9, 6), 5, spray=7),
    ]
    acts += [SetFixtures((Fixture("tap", 3, 2, 4, 1, 3), Fixture("drain", -1, 5, 9, 2))), Turn(1), Turn(3)]
    acts += [Move((2, 3), (9, 8), (4, 4), 1, True), Move((1, 1), (5, 5), (7.5, 7.5))]
    acts += [Paste(stamp_of(4), (3, -2)), Paste(stamp_of(4), (9, 5), True), Resize(25, 40, "bottom right")]
    for act in acts:
        session.do(act)
        session.timeline.run(20)
    return session


def told(entries):
    """Return entries that can be compared: scenes are by their digests."""
    return [
        each._replace(what=start_digest(each.what.scene)) if isinstance(each.what, Load) else each for each in entries
    ]


def resealed(lines):
    """Return a file of (dict) lines, each with the seal it should have."""
    pen = LineWriter()
    return b"".join(pen.line(values) for values in lines)


def wall_to_wall(number):
    """Return the record of a large scene with nothing in it, which is short."""
    side, bits = 4096, 2 * 4096 * 4096 // 8
    cells = base64.b64encode(zlib.compress(bytes(bits), 9)).decode()
    values = scene_json.encode(SCENES[0], scene_json.KnownScenes())
    return values | {"name": f"blank{number}", "size": [side, side], "cells": cells, "speed": 50.0 + number}


def test_what_a_file_takes_in_memory_follows_its_size(monkeypatch):
    monkeypatch.setattr(scene_json, "FREE_CELLS", 2 * 4096**2)
    lines = values_of(LineWriter().header(SCENES[0], 0))
    lines += [{"at": number, "do": "load", "seed": number, "scene": wall_to_wall(number)} for number in range(30)]
    tracemalloc.start()
    recording, _ = parse(resealed(lines), "some.sandglass")
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most < 8 * 4096**2 and 1 <= len(recording.entries) <= 3
    assert recording.problem.startswith("some.sandglass: line ") and "scene.size: found 4096×4096" in recording.problem
    assert "more in a file of this size; the " in recording.problem


def test_nothing_is_written_that_is_not_read(monkeypatch, tmp_path):
    monkeypatch.setattr(scene_json, "FREE_CELLS", 3000)
    monkeypatch.setattr(scene_json, "CELLS_PER_BYTE", 0)
    session = Session(SCENES[0])
    session.journal = Journal.begin(SCENES[0], 0, tmp_path)
    session.do(Load(SCENES[1], 0))
    assert parse(to_bytes(recording_of(session)), "file")[0].problem is None
    session.do(Load(SCENES[2], 0))
    session.do(Load(replace(SCENES[1], speed=9.0), 0))
    assert session.journal is None and "full" in session.trouble
    assert parse(to_bytes(recording_of(session)), "file")[0].problem
    kept = load_replay(session.lost_journal)
    assert [entry.what.scene.name for entry in kept.entries] == ["scene1", "scene2"]


@pytest.mark.parametrize("where", ["the scene", "an act"])
def test_a_shipped_rule_that_has_changed_since_is_refused_when_it_is_read(where):
    lines, rule = values_of(to_bytes(recording_of(sample()))), encode_rule(load_rule("water-and-oil"))
    rule |= {"digest": "0123456789abcdef"}
    if where == "the scene":
        lines[0]["scene"]["rule"] = rule
    else:
        lines.insert(1, {"at": 0, "do": "rule", "rule": rule})
    pen, other = LineWriter(), "5f20e90f3f5d434d: this water-and-oil is another"
    told = f"rule.digest: found '0123456789abcdef', wanted {other}"
    data = b"".join(map(pen.line, lines))
    if where == "the scene":
        with pytest.raises(ReplayError) as refused:
            parse(data, "some.sandglass")
        assert str(refused.value) == f"some.sandglass: line 1: scene.{told}"
    else:
        recording, _ = parse(data, "some.sandglass")
        assert recording.problem.startswith(f"some.sandglass: line 2: {told}") and not recording.entries


def values_of(data):
    """Return the lines of a file as dicts, without their seals."""
    return [{key: value for key, value in json.loads(line).items() if key != "sum"} for line in data.splitlines()]


@pytest.mark.parametrize("name", sorted(GOLDEN))
def test_demos_end_in_the_same_world_on_every_machine(name):
    path = asset("replays", f"{name}.sandglass")
    recording = load_replay(path)
    report = headless.replay(recording)
    assert recording.problem is None and path.stat().st_size < 5000
    assert report["digest"] == recording.digest == GOLDEN[name]
    assert headless.replay_status(report) == 0
    assert report["grains_end"] == report["grains_start"] + report["grains_painted"] - report["grains_erased"]


@given(plays)
def test_a_file_gives_back_the_session(play):
    session = played(play)
    recording, _ = parse(to_bytes(recording_of(session)), "file")
    assert recording.problem is None and recording.digest == session.world.digest()
    told = Session.retold(recording)
    told.seek(recording.end)
    assert state(told) == state(session)
    story = [entry for entry in session.timeline.history.story() if entry.at <= session.now]
    assert [(entry.at, entry.join) for entry in recording.entries] == [(entry.at, entry.join) for entry in story]


@given(st.integers(0, 2**40), actions, st.booleans())
def test_an_act_is_written_and_read_without_loss(at, action, join):
    header, pen = LineWriter().header(SCENES[0], 0), LineWriter()
    data = pen.header(SCENES[0], 0) + pen.entry(Entry(at, action, join))
    recording, _ = parse(data, "file")
    entry = recording.entries[0]
    assert recording.problem is None and data.startswith(header)
    if isinstance(action, Paint):
        ends = (snap(place, action.diameter) for place in (action.start, action.end))
        action = replace(action, **dict(zip(("start", "end"), ends, strict=True)))
    if isinstance(action, Load):
        assert (entry.what.scene.sand == action.scene.sand).all() and entry.what.seed == action.seed
        assert (entry.what.scene.walls == action.scene.walls).all() and entry.what.scene.rule == action.scene.rule
    else:
        assert entry == Entry(at, action, join)


def test_a_stroke_is_one_line_and_a_known_scene_is_told_once():
    lines = values_of(to_bytes(recording_of(sample())))
    assert [line.get("do") for line in lines].count("stroke") == 1
    scenes = [line["scene"] for line in lines if "scene" in line]
    assert "cells" in scenes[0] and set(scenes[1]) == {"name", "size", "start"}
    assert "cells" in scenes[2] and set(scenes[3]) == {"again"}


def test_a_file_cut_anywhere_keeps_its_whole_lines_and_says_so():
    data = to_bytes(recording_of(sample()))
    whole = parse(data, "file")[0]
    first = data.index(b"\n") + 1
    for length in range(0, len(data), 31):
        if length < first:
            with pytest.raises(ReplayError, match="line 1: found"):
                parse(data[:length], "file")
            continue
        kept = parse(data[:length], "file")[0]
        assert kept.problem is None and kept.digest is None
        assert told(kept.entries) == told(whole.entries)[: len(kept.entries)]


def test_any_edit_is_noticed_and_what_is_before_it_kept():
    data = bytearray(to_bytes(recording_of(sample())))
    generator = np.random.default_rng(1)
    first = data.index(b"\n") + 1
    for at in generator.integers(first, len(data), 300).tolist():
        edited = bytearray(data)
        edited[at] ^= 1 << int(generator.integers(7))
        kept = parse(bytes(edited), "file")[0]
        line = data[:at].count(b"\n") + 1
        if kept.problem:
            assert f"line {line}" in kept.problem and f"{line - 1} lines before it were kept" in kept.problem
        else:
            assert kept.digest is None and at == len(data) - 1, "the end of the last line was taken away"


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        ({"at": -1}, "at: found -1, wanted a whole number in [0, 9007199254740992] iterations"),
        ({"at": True}, "at: found True"),
        ({"at": float("nan")}, "at: found nan"),
        ({"do": "dance"}, "do: found 'dance', wanted one of paint, stroke"),
        ({"do": ["paint"]}, "do: found an array of 1"),
        ({"material": "Glue!"}, "material: found 'Glue!', wanted the name of a material"),
        ({"diameter": 1e9}, "diameter: found 1000000000.0, wanted a whole number in [1, 200] cells"),
        ({"from": [1]}, "from: found an array of 1, wanted a place [x, y]"),
        ({"to": [1, "2"]}, "to.y: found '2'"),
        ({"to": [1, 10**400]}, "to.y: found a huge number"),
        ({"over_walls": 1}, "over_walls: found 1, wanted true or false"),
        ({"join": "yes"}, "join: found 'yes'"),
        ({"colour": 3}, "colour: found 3, wanted one of amber"),
        ({"hue": 3}, "hue: found an unknown key"),
    ],
)
def test_bad_values_are_named(edit, words):
    paint = {"at": 5, "do": "paint", "material": "sand", "diameter": 4, "from": [3, 3], "to": [4, 4]}
    header = values_of(LineWriter().header(SCENES[0], 0))[0]
    recording = parse(resealed([header, paint, paint | edit, paint]), "some.sandglass")[0]
    assert len(recording.entries) == 1 and recording.problem.startswith("some.sandglass: line 3: ")
    assert words in recording.problem and recording.problem.isprintable()


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        ({"name": "nowhere"}, "name: found 'nowhere'"),
        ({"size": [61, 0]}, "size: found an array of 2, wanted [width, height]"),
        ({"size": 61}, "size: found 61"),
        ({"start": "0" * 16}, "this paper is another"),
        ({"size": [62, 61]}, "this paper is another"),
        ({"cells": "AAAA"}, "an unknown key"),
    ],
)
def test_a_bad_start_is_refused(edit, words):
    header = values_of(LineWriter().header(load_scene("paper"), 0))[0]
    header["scene"] |= edit
    with pytest.raises(ReplayError) as caught:
        parse(resealed([header]), "some.sandglass")
    assert words in str(caught.value) and str(caught.value).startswith("some.sandglass: line 1: ")


@pytest.mark.parametrize(
    ("cells", "words"),
    [
        ("!", "damaged"),
        (7, "damaged"),
        ("AAAA", "damaged"),
        ("eJwDAAAAAAE=", "another number"),
        ("both", "code 3, which no material has"),
        ("bomb", "another number"),
    ],
)
def test_bad_cells_are_refused_before_they_fill_the_memory(cells, words):
    import base64

    made = {"both": b"\xff" * 180, "bomb": bytes(10**7)}
    if cells in made:
        cells = base64.b64encode(zlib.compress(made[cells])).decode()
    header = values_of(LineWriter().header(SCENES[0], 0))[0]
    header["scene"]["cells"] = cells
    with pytest.raises(ReplayError, match=words):
        parse(resealed([header]), "file")


def test_a_newer_file_is_told_and_what_is_understood_is_kept():
    lines = values_of(to_bytes(recording_of(sample())))
    lines[0] |= {"sandglass": 2, "weather": "fine"}
    lines.insert(3, {"at": 12, "do": "wind", "force": 9})
    recording = parse(resealed(lines), "file")[0]
    assert "found version 2, wanted 1: a newer Sandglass wrote it; 3 lines of it were understood" in recording.problem
    assert len(recording.entries) == 7


def test_a_line_after_the_end_is_told():
    lines = values_of(to_bytes(recording_of(sample())))
    recording = parse(resealed([*lines, lines[1]]), "file")[0]
    assert "found a line, wanted none after the end" in recording.problem and recording.digest


def test_a_replay_ends_at_the_present_moment_of_the_present_line(tmp_path):
    session = Session(SCENES[1])
    session.timeline.run(10)
    session.do(Flip())
    session.timeline.run(10)
    session.do(Clear())
    session.seek(15)
    save_replay(tmp_path / "x.sandglass", session)
    recording = load_replay(tmp_path / "x.sandglass")
    assert [entry.what for entry in recording.entries] == [Flip()] and recording.end == 15
    assert session.reached == 20, "saving changes nothing"


def test_headless_replays_a_file(tmp_path, capsys):
    demo = asset("replays", "builder.sandglass")
    status = cli.main(["headless", "--replay", str(demo), "--json"])
    report = json.loads(capsys.readouterr().out)
    assert status == 0 and report["digest"] == GOLDEN["builder"] and report["same"] is True
    cut = tmp_path / "cut.sandglass"
    cut.write_bytes(demo.read_bytes()[:-30])
    status, said = cli.main(["headless", "--replay", str(cut)]), capsys.readouterr()
    assert status == 1 and said.err.count("\n") == 1 and "it was cut short" in said.err
    assert "not as recorded" in said.out


@pytest.mark.parametrize(("name", "words"), [("none.sandglass", "no such file"), (".", "wanted an ordinary file")])
def test_headless_refuses_what_is_no_replay_in_one_line(name, words, tmp_path, capsys):
    with pytest.raises(SystemExit, match="2"):
        cli.main(["headless", "--replay", str(tmp_path / name)])
    said = capsys.readouterr()
    assert said.out == "" and words in said.err and said.err.count("\n") == 1


def test_fixtures_beyond_the_lattice_are_told_of_as_any():
    session = Session(load_scene("blank", (16384, 16)))
    session.do(SetFixtures((Fixture("tap", 10**6, 3, 6), Fixture("drain", -(10**6), -20_000))))
    session.do(Turn(1))
    session.do(Flip())
    recording = parse(to_bytes(recording_of(session)), "file")[0]
    assert recording.problem is None and told(recording.entries) == told(recording_of(session).entries)


def test_a_scene_that_differs_in_anything_is_told_of_anew():
    scene = replace(SCENES[1], neck=7)
    variants = [scene, replace(scene, speed=5000), replace(scene, title="Another"), replace(scene, neck=None)]
    session = Session(scene)
    for each in variants * 2:
        session.do(Load(each, 1))
    read = [each.what.scene for each in parse(to_bytes(recording_of(session)), "file")[0].entries]
    seen = [(each.speed, each.title, each.neck) for each in read]
    assert seen == [(each.speed, each.title, each.neck) for each in variants * 2]
