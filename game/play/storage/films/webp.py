"""Animated WebP: the same pixels as a GIF in a third of its size, for what plays it.

Source: https://developers.google.com/speed/webp/docs/riff_container
"""

import io
import struct

import numpy as np

from game.play.storage.films.film_file import enlarged, patch

RIFF = 12  # bytes of the head of a RIFF file
ANIMATED, TRANSPARENT = 0x02, 0x10  # flags of the chunk VP8X
BLENDED = 0x00  # a frame is laid over the one before, which stays
METHOD = 2  # of 0 (fast) to 6 (small): from here on files hardly shrink


class WebpEncoder:
    """Writes frames as chunks of a WebP without loss; what stays as it is between two is transparent."""

    suffix = ".webp"
    unit_ms = 1

    def __init__(self, colours, zoom=1):
        """`colours`: the RGB bytes of the palette. `zoom`: pixels across a pixel of the frames."""
        palette = np.full((256, 4), 255, np.uint8)
        palette[: len(colours) // 3, :3] = np.frombuffer(colours, np.uint8).reshape(-1, 3)
        self._palette, self._zoom, self._file = palette, zoom, None

    def begin(self, part, shape):
        """Write to a Part."""
        self._file = part.file
        height, width = (side * self._zoom for side in shape)
        flags = struct.pack("<I", ANIMATED | TRANSPARENT)
        self._file.write(b"RIFF\0\0\0\0WEBP" + _chunk(b"VP8X", flags + _three(width - 1) + _three(height - 1)))
        self._file.write(_chunk(b"ANIM", struct.pack("<IH", 0, 0)))  # on nothing, for ever

    def write(self, before, now, ms):
        """Write a frame, which follows another or None."""
        left, top, pixels, unchanged = patch(before, now)
        colours = self._palette.copy()
        if unchanged is not None:
            colours[unchanged] = 0
        image = enlarged(colours[pixels], self._zoom)
        left, top = left * self._zoom, top * self._zoom
        aside, above = left % 2, top % 2  # a frame begins at even pixels
        image = np.pad(image, ((above, 0), (aside, 0), (0, 0)))
        place = _three((left - aside) // 2) + _three((top - above) // 2)
        size = _three(image.shape[1] - 1) + _three(image.shape[0] - 1)
        head = place + size + _three(min(ms, 0xFFFFFF)) + bytes([BLENDED])
        self._file.write(_chunk(b"ANMF", head + _still(image)))

    def end(self):
        """Write what is known only after the last frame."""
        size = self._file.tell()
        self._file.seek(4)
        self._file.write(struct.pack("<I", size - 8))

    def drop(self):
        """Leave nothing behind."""


def _still(image):
    """Return the chunk of pixels of a WebP of one (h, w, 4) uint8 image."""
    from PIL import Image

    file = io.BytesIO()
    Image.fromarray(image, "RGBA").save(file, "WEBP", lossless=True, method=METHOD, quality=50)
    return file.getvalue()[RIFF:]


def _three(number):
    return struct.pack("<I", number)[:3]


def _chunk(name, data):
    return name + struct.pack("<I", len(data)) + data + b"\0" * (len(data) % 2)
