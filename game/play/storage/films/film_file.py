"""The film file: a film written frame by frame, of each only what changed since the one before."""

import os
from contextlib import contextmanager
from typing import NamedTuple

import numpy as np

from game.world.files.atomic import Part, trouble


class FilmFile:
    """Writes a temporary file, and moves it into place in one step when it is complete. Raises FileError."""

    def __init__(self, name_of, encoder):
        """`name_of`: gives the paths it may have, as those of `new_name`. `encoder`: of one of the formats."""
        self.size = 0  # bytes written so far
        self._name_of, self._encoder = name_of, encoder
        self._shown = self._next = None  # the last frame written, the one to write: (h, w) uint8
        self._next_ms = 0.0
        self._part = None
        with self._named():
            self._part = Part(name_of(1).parent, "recording")

    def add(self, pixels, ms):
        """Show a frame, (h, w) uint8 indices into the encoder's colours, for `ms` milliseconds."""
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
            if self._shown is None:
                raise OSError("nothing was recorded")
            self._encoder.end()
            if not replace:
                return self._part.put_as_new(self._name_of)
            self._part.put(self._name_of(1))
            return self._name_of(1)

    def drop(self):
        """Leave nothing behind."""
        self._encoder.drop()
        self._part.drop()

    @contextmanager
    def _named(self):
        """Say of an OSError which file it is about, and remove the temporary file."""
        try:
            yield
        except OSError as error:
            if self._part:
                self.drop()
            raise trouble(self._name_of(1), "cannot write the recording", error) from None

    def _write_next(self):
        unit_ms = self._encoder.unit_ms
        whole_ms = unit_ms * round(self._next_ms / unit_ms)
        with self._named():
            if self._shown is None:
                self._encoder.begin(self._part, self._next.shape)
            self._encoder.write(self._shown, self._next, max(whole_ms, unit_ms))
            self.size = max(self._part.file.tell(), os.fstat(self._part.file.fileno()).st_size)
        self._shown, self._next, self._next_ms = self._next, None, self._next_ms - whole_ms


class Change(NamedTuple):
    """What changes from one frame to the next, inside the smallest rectangle that holds it."""

    left: int
    top: int
    pixels: np.ndarray  # (h, w) uint8
    unchanged: int | None  # the index that stands for what stays as it is, if any does


def patch(before, now):
    """Return the Change that makes `now` of the frame `before`, another one; all of it where that is None."""
    if before is None:
        return Change(0, 0, now, None)
    differs = before != now
    rows, columns = np.flatnonzero(differs.any(axis=1)), np.flatnonzero(differs.any(axis=0))
    room = slice(rows[0], rows[-1] + 1), slice(columns[0], columns[-1] + 1)
    pixels, differs = now[room].copy(), differs[room]
    free = np.flatnonzero(np.bincount(pixels[differs], minlength=256) == 0)
    if len(free):
        pixels[~differs] = free[0]
    return Change(int(columns[0]), int(rows[0]), pixels, int(free[0]) if len(free) else None)


def enlarged(pixels, zoom):
    """Return pixels with each of them `zoom` wide and high."""
    return pixels if zoom == 1 else pixels.repeat(zoom, axis=0).repeat(zoom, axis=1)
