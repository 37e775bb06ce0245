"""The GIF writer: writes a GIF frame by frame, of each only what changed since the one before."""

import os
import tempfile
from pathlib import Path

import numpy as np

from game.world.files.atomic import trouble

FOR_EVER = b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00"  # repeat for ever
TRAILER = b";"
UNIT_MS = 10  # in which a GIF counts time


class GifWriter:
    """Writes a temporary file, and moves it into place in one step when it is complete. Raises FileError."""

    def __init__(self, path, colours):
        """`colours`: the RGB bytes of the palette."""
        self.path = Path(path)
        self._colours = colours
        self._shown = self._next = None  # the last frame written, the one to write: (h, w) uint8
        self._next_ms = 0.0
        try:
            handle, self._part = tempfile.mkstemp(prefix=".recording-", suffix=".part", dir=self.path.parent)
            self._file = open(handle, "wb")  # noqa: SIM115 - it stays open until close()
        except OSError as error:
            raise trouble(self.path, "cannot write", error) from None

    def add(self, pixels, ms):
        """Show a frame, (h, w) uint8 indices into the palette, for `ms` milliseconds."""
        if self._next is not None and not np.array_equal(self._next, pixels):
            self._write_next()
        if self._next is None:
            self._next = pixels
        self._next_ms += ms

    def close(self):
        """Write the end and put the file in its place."""
        try:
            if self._next is not None:
                self._write_next()
            self._file.write(TRAILER)
            self._file.close()
            os.chmod(self._part, 0o644)
            os.replace(self._part, self.path)
        except OSError as error:
            self.drop()
            raise trouble(self.path, "cannot write", error) from None

    def drop(self):
        """Remove the temporary file."""
        self._file.close()
        Path(self._part).unlink(missing_ok=True)

    def _write_next(self):
        from PIL import GifImagePlugin

        whole = UNIT_MS * round(self._next_ms / UNIT_MS)
        left, top, part = _changed(self._shown, self._next)
        image = self._image(part)
        how = {"duration": max(whole, UNIT_MS), "disposal": 1, "include_color_table": False}
        blocks = GifImagePlugin.getdata(image, (left, top), **how)
        try:
            if self._shown is None:
                self._file.write(b"".join(GifImagePlugin.getheader(image)[0]) + FOR_EVER)
            self._file.writelines(blocks)
        except OSError as error:
            self.drop()
            raise trouble(self.path, "cannot write", error) from None
        self._shown, self._next, self._next_ms = self._next, None, self._next_ms - whole

    def _image(self, pixels):
        from PIL import Image

        image = Image.fromarray(pixels, "P")
        image.putpalette(self._colours)
        return image


def _changed(before, now):
    """Return (left, top, pixels) of the smallest rectangle that holds all that changed."""
    if before is None:
        return 0, 0, now
    differs = before != now
    rows, columns = np.flatnonzero(differs.any(axis=1)), np.flatnonzero(differs.any(axis=0))
    top, left = int(rows[0]), int(columns[0])
    return left, top, np.ascontiguousarray(now[top : rows[-1] + 1, left : columns[-1] + 1])
