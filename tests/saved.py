"""Files of sessions and pictures, written and read in one call."""

from game.world.files.atomic import save
from game.world.scenes.picture_file import THRESHOLD, Photo, open_picture
from game.world.sessions.recording import recording_of, to_bytes


def save_replay(path, session):
    """Write the session's present line to a file."""
    save(path, to_bytes(recording_of(session)))


def load_picture(path, threshold=THRESHOLD.default):
    """Return the (scene, seed) in a picture file; a photo becomes sand where it is at least that bright."""
    found = open_picture(path)
    return found.picture(threshold) if isinstance(found, Photo) else found
