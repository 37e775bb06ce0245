"""Damaged files of every kind: one line or a whole session, and nothing in between. SANDGLASS_FUZZ sets how many."""

import json
import random

import pytest
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from game.world.scenes.picture_file import PictureError, save_picture
from game.world.scenes.picture_pixels import CHUNK
from game.world.sessions.journal import Journal, JournalError
from game.world.sessions.recording import ReplayError, load_replay, parse
from game.world.sessions.session import Session
from game.world.sessions.session_format import LineWriter
from tests.saved import load_picture, recording_of, to_bytes
from tests.sweeps import sweep
from tests.world.random_sessions import SCENES
from tests.world.sessions.test_recording import sample, values_of

INPUTS = 40, 400  # in a quick run, and in a sweep
FARTHEST = 5000  # iterations: no further is played what a file tells
PIECES = [b"{", b"}", b"[", b"]", b'"', b",", b":", b"\n", b"\0", b"\xff", b"null", b"NaN", b"1e999", b"-1", b"9" * 400]
VALUES = [None, True, -1, 0, 1, 2**53, 2**64, 1e308, float("nan"), "", "sand", "undo", "x" * 300, [], {}, [[]], [1, 2]]


def damaged(data, chance):
    """Return bytes with a few places changed, cut out, doubled or filled with pieces."""
    data = bytearray(data)
    for _ in range(chance.choice((1, 1, 2, 5))):
        at, end = sorted(chance.randrange(len(data) + 1) for _ in range(2))
        end = min(end, at + chance.choice((1, 4, 64, 10**6)))
        pieces = b"", data[at:end] * 2, chance.choice(PIECES), chance.randbytes(end - at), data[end : 2 * end - at]
        data[at:end] = chance.choice(pieces)
    return bytes(data)


def twisted(values, chance):
    """Return a value of JSON with one part, somewhere within, replaced or taken out."""
    if isinstance(values, dict) and values and chance.random() < 0.8:
        key = chance.choice(list(values))
        rest = {name: value for name, value in values.items() if name != key}
        if chance.random() < 0.1:
            return rest
        return rest | {chance.choice((key, key, key, "x")): twisted(values[key], chance)}
    if isinstance(values, list) and values and chance.random() < 0.8:
        at = chance.randrange(len(values))
        return [*values[:at], twisted(values[at], chance), *values[at + 1 :]]
    return chance.choice(VALUES)


def resealed(lines):
    """Return a file of lines whose seals are right whatever they say."""
    pen = LineWriter()
    return b"".join(pen.line(values) for values in lines if isinstance(values, dict))


def twisted_replay(data, chance):
    """Return a session file that is sound as a file and wrong in what it tells."""
    lines = values_of(data)
    at = chance.randrange(len(lines))
    lines[at] = twisted(lines[at], chance)
    if chance.random() < 0.2:
        lines.insert(chance.randrange(len(lines)), chance.choice(lines))
    return resealed(lines)


def check_recording(recording):
    """Assert that a Recording can be played, or at least kept."""
    assert recording.problem is None or recording.problem.isprintable()
    session = Session.retold(recording)
    assert session.world.shape == recording.scene.shape
    if recording.end <= FARTHEST and max((entry.at for entry in recording.entries), default=0) <= FARTHEST:
        session.seek(recording.end)
        assert session.account.balanced(session.world) and not (session.world.sand & session.world.walls).any()


@sweep("inputs", INPUTS, keep=INPUTS[:1])
def test_damaged_replays_are_told_or_kept_in_part(tmp_path, inputs):
    chance, good = random.Random(1), to_bytes(recording_of(sample()))
    outcomes = {"refused": 0, "kept in part": 0, "whole": 0}
    for number in range(2 * inputs):
        data = (damaged, twisted_replay)[number % 2](good, chance)
        try:
            recording, _ = parse(data, "some.sandglass")
        except ReplayError as error:
            assert str(error).isprintable() and str(error).startswith("some.sandglass: line ")
            outcomes["refused"] += 1
            continue
        check_recording(recording)
        outcomes["kept in part" if recording.problem else "whole"] += 1
    assert min(outcomes.values()) > 0
    (tmp_path / "x").write_bytes(damaged(good, chance))
    with pytest.raises(ReplayError):
        load_replay(tmp_path / "none")


@sweep("inputs", INPUTS, keep=INPUTS[:1])
def test_damaged_journals_are_told_or_taken_up_in_part(tmp_path, inputs):
    chance, session, path = random.Random(2), sample(), tmp_path / "journal.sandglass"
    good = to_bytes(recording_of(session))
    good = good[: good.rindex(b"\n", 0, -1) + 1]
    for number in range(inputs):
        path.write_bytes((damaged, twisted_replay)[number % 2](good, chance))
        try:
            journal, recording = Journal.resume(path)
        except JournalError as error:
            assert str(error).isprintable()
            continue
        Session.retold(recording)
        journal.abandon()
        kept, _ = parse(path.read_bytes(), path)
        assert kept.problem is None and len(kept.entries) == len(recording.entries)


@sweep("inputs", INPUTS, keep=INPUTS[:1])
def test_damaged_pictures_are_told_or_loaded_whole(tmp_path, inputs):
    chance, path = random.Random(3), tmp_path / "some.png"
    save_picture(path, Session(SCENES[2], 1))
    good, cells = path.read_bytes(), Image.open(path)
    settings = json.loads(cells.info[CHUNK])
    for number in range(2 * inputs):
        if number % 2:
            chunk = PngInfo()
            chunk.add_text(CHUNK, json.dumps(twisted(settings, chance)))
            cells.save(path, pnginfo=chunk)
        else:
            path.write_bytes(damaged(good, chance))
        try:
            scene, seed = load_picture(path)
        except PictureError as error:
            assert str(error).isprintable()
            continue
        session = Session(scene, seed)
        session.step()
        assert session.account.balanced(session.world)
