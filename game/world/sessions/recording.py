"""A session as a file (.sandglass), from which any machine can compute every moment of it again."""

from dataclasses import dataclass, field

from game.world.files.atomic import FileError, load
from game.world.files.checked_table import TableError
from game.world.scenes.scene import Scene
from game.world.sessions.session_format import LARGEST_FILE, VERSION, LineReader, LineWriter, ReplayError

__all__ = ["SUFFIX", "Recording", "ReplayError", "load_replay", "parse", "recording_of", "replay_bytes"]

SUFFIX = ".sandglass"


@dataclass
class Recording:
    """What a session file tells."""

    scene: Scene
    seed: int
    entries: list = field(default_factory=list)  # Entry by Entry, in the order of doing
    end: int = 0  # the iteration the session had come to
    digest: str | None = None  # the world's digest there, "" if not known; None where the file tells no end
    problem: str | None = None  # what is wrong with the rest of the file, in one line


def recording_of(session):
    """Return the Recording of all that is known of a session's present line."""
    timeline = session.timeline
    scene, seed = timeline.start
    at_end = timeline.goal is None and timeline.now == timeline.reached
    return Recording(scene, seed, timeline.history.story(), timeline.reached, session.world.digest() if at_end else "")


def replay_bytes(recording):
    """Return the file of a Recording that has an end; raise FileError where it tells of more than anybody reads."""
    pen = LineWriter()
    lines = [pen.header(recording.scene, recording.seed), *map(pen.entry, recording.entries)]
    data = b"".join([*lines, pen.end(recording.end, recording.digest)])
    if pen.known.are_too_many or len(data) > LARGEST_FILE:
        raise ReplayError(f"replay: found a session too large for a file, wanted at most {LARGEST_FILE} bytes")
    return data


def load_replay(path):
    """Return the Recording in a file; what is wrong with its rest, if anything, is told in its `problem`.

    Raises ReplayError, with one line to show, where not even its start can be used.
    """
    recording, _ = parse(load(path, LARGEST_FILE, ReplayError), path)
    if recording.problem is None and recording.digest is None:
        recording.problem = f"{path}: found no end, wanted a whole file: it was cut short; what there is was kept"
    return recording


def parse(data, file):
    """Return the Recording in the bytes of a file, and (bytes of whole lines, checksum, known scenes) to go on from.

    A last line that was not written to its end is left out without a word. Raises ReplayError as `load_replay` does.
    """
    reader = LineReader(file)
    lines = data.split(b"\n")
    torn = lines.pop()
    if not lines:
        found = "a line without end" if torn else "nothing"
        raise ReplayError(f"{reader.file}: line 1: found {found}, wanted the first line of a session file")
    try:
        recording = Recording(*reader.header(lines[0]))
    except TableError as error:
        raise ReplayError(error) from None
    kept = len(lines[0]) + 1
    try:
        for line in lines[1:]:
            _add(recording, reader, line)
            kept += len(line) + 1
    except FileError as error:
        recording.problem = f"{error}; the {reader.number - 1} lines before it were kept"
    if reader.version > VERSION:
        recording.problem = (
            f"{reader.file}: line 1: found version {reader.version}, wanted {VERSION}: a newer Sandglass wrote it; "
            f"{reader.number if recording.problem is None else reader.number - 1} lines of it were understood"
        )
    return recording, (kept, reader.checksum, reader.known)


def _add(recording, reader, line):
    if recording.digest is not None:
        reader.number += 1
        raise ReplayError(f"{reader.file}: line {reader.number}: found a line, wanted none after the end")
    told = reader.entries(line)
    if isinstance(told, tuple):
        recording.end, recording.digest = told
    else:
        recording.entries += told
        recording.end = told[-1].at
