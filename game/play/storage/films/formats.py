"""The formats: what a recording can be, by name. GIF is the usual one, for nothing that shows pictures refuses it."""

from game.play.storage.films import mp4
from game.play.storage.films.gif import GifEncoder
from game.play.storage.films.mp4 import Mp4Encoder
from game.play.storage.films.webp import WebpEncoder

ENCODERS = {"gif": GifEncoder, "webp": WebpEncoder, "mp4": Mp4Encoder}


def names():
    """Return the names of the formats that can be written here."""
    return tuple(name for name in ENCODERS if name != "mp4" or mp4.is_there())


def encoder_of(name):
    """Return the encoder of a format, or of the usual one where it cannot be written here any more."""
    return ENCODERS[name if name in names() else "gif"]
