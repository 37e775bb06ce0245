"""The GIF writer: writes a GIF frame by frame, of each only what changed since the one before."""

from contextlib import contextmanager

import numpy as np

from game.world.files.atomic import Part, trouble

FOR_EVER = b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00"  # repeat for ever
TRAILER = b";"
UNIT_MS = 10  # in which a GIF counts time


class GifWriter:
    """Writes a temporary file, and moves it into place in one step when it is complete. Raises FileError."""

    def __init__(self, name_of, colours):
        """`name_of`: gives the paths it may have, as those of `new_name`. `colours`: the RGB bytes of the palette."""
        self._name_of = name_of
        self._colours = colours
        self._shown = self._next = None  # the last frame written, the one to write: (h, w) uint8
        self._next_ms = 0.0
        self._part = None
        with self._named():
            self._part = Part(name_of(1).parent, "recording")

    def add(self, pixels, ms):
        """Show a frame, (h, w) uint8 indices into the palette, for `ms` milliseconds."""
        if self._next is not None and not np.array_equal(self._next, pixels):
            self._write_next()
        if self._next is None:
            self._next = pixels
        self._next_ms += ms

    def close(self, replace=False):
        """Write the end, put the file in its place and return that.

        replace: the place is the first of its names, whatever is there.
        """
        if self._next is not None:
            self._write_next()
        with self._named():
            self._part.file.write(TRAILER)
            if not replace:
                return self._part.put_as_new(self._name_of)
            self._part.put(self._name_of(1))
            return self._name_of(1)

    def drop(self):
        """Remove the temporary file."""
        self._part.drop()

    @contextmanager
    def _named(self):
        """Say of an OSError which file it is about, and remove the temporary file."""
        try:
            yield
        except OSError as error:
            if self._part:
                self._part.drop()
            raise trouble(self._name_of(1), "cannot write the recording", error) from None

    def _write_next(self):
        from PIL import GifImagePlugin

        whole = UNIT_MS * round(self._next_ms / UNIT_MS)
        left, top, part = _changed(self._shown, self._next)
        image = self._image(part)
        how = {"duration": max(whole, UNIT_MS), "disposal": 1, "include_color_table": False}
        blocks = GifImagePlugin.getdata(image, (left, top), **how)
        with self._named():
            if self._shown is None:
                self._part.file.write(b"".join(GifImagePlugin.getheader(image)[0]) + FOR_EVER)
            self._part.file.writelines(blocks)
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
