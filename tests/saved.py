"""Files of sessions and pictures, written and read in one call."""

from itertools import pairwise

from game.world.files.atomic import save
from game.world.scenes.picture_file import THRESHOLD, Photo, open_picture
from game.world.sessions import action_json
from game.world.sessions.recording import Recording
from game.world.sessions.session_format import LineWriter


def recording_of(session):
    """Return the Recording of a session's present line, up to the present moment."""
    history, now = session.timeline.history, session.now
    session.timeline.catch_up()
    entries = [entry for entry in history.story() if entry.at <= now]
    scene, seed = session.timeline.start
    return Recording(scene, seed, entries, now, session.world.digest())


def to_bytes(recording):
    """Return the file of a Recording that has an end."""
    pen = LineWriter()
    header = pen.header(recording.scene, recording.seed)
    told = drawn_together(action_json.encode(entry, pen.known) for entry in recording.entries)
    return header + b"".join(map(pen.line, told)) + pen.end(recording.end, recording.digest)


def drawn_together(told):
    """Yield the dicts of entries, the joined segments of a line drawn with one brush as one stroke."""
    stroke = []
    for values in told:
        if stroke and not (
            values.get("join") and _goes_on(stroke[-1], values) and len(stroke) < action_json.LONGEST_STROKE
        ):
            yield _stroke(stroke)
            stroke = []
        if values["do"] == "paint":
            stroke.append(values)
        else:
            yield values
    if stroke:
        yield _stroke(stroke)


def _goes_on(before, values):
    """Return whether a segment is joined to the one before, starts where that ended, and is of the same brush."""
    if values["do"] != "paint" or "join" not in values:
        return False
    return values["from"] == before["to"] and _brush(values) == _brush(before)


def _brush(values):
    return {key: value for key, value in values.items() if key not in ("at", "do", "from", "to", "join")}


def _stroke(segments):
    """Return segments as one: the path's points as [iterations since the point before, x, y], start first."""
    first, *others = segments
    if not others:
        return first
    waits = [0, *(each["at"] - before["at"] for before, each in pairwise(segments))]
    path = [[0, *first["from"]], *([wait, *each["to"]] for wait, each in zip(waits, segments, strict=True))]
    joined = {"join": True} if first.get("join") else {}
    return {"at": first["at"], "do": "stroke", **_brush(first), "path": path, **joined}


def save_replay(path, session):
    """Write the session's present line to a file."""
    save(path, to_bytes(recording_of(session)))


def load_picture(path, threshold=THRESHOLD.default):
    """Return the (scene, seed) in a picture file; a photo becomes sand where it is at least that bright."""
    found = open_picture(path)
    return found.picture(threshold) if isinstance(found, Photo) else found
