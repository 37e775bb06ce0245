"""The mark of a stamp: its cells in the colours of their materials, as they would lie on the sand."""

from typing import NamedTuple

import numpy as np
import pygame


class PieceMark(NamedTuple):
    """A picture over the sand, like a `Mark`; opaque where it has cells, so that it may be drawn over itself."""

    points: tuple  # the pixel of its upper left corner, alone
    picture: pygame.Surface

    @property
    def rect(self):
        """What it covers of the window."""
        return self.picture.get_rect(topleft=self.points[0])

    def draw(self, surface, theme):
        """Draw it."""
        surface.blit(self.picture, self.rect)


def piece_mark(pixels, box, view, area):
    """Return the PieceMark of (H, W, 4) uint8 cells in a box of the lattice seen through `view`, or None.

    area: the part of the window in which the view shows the lattice; what lies beyond is left out.
    """
    left, top, right, bottom = box
    columns, across = _seen(left, right, lambda column: view.pixel(column, 0)[0], area.left, area.right)
    rows, down = _seen(top, bottom, lambda row: view.pixel(0, row)[1], area.top, area.bottom)
    if not len(columns) or not len(rows):
        return None
    shown = np.ascontiguousarray(pixels[rows[:, None] - top, columns - left])
    picture = pygame.image.frombytes(shown.tobytes(), shown.shape[1::-1], "RGBA")
    return PieceMark(((across, down),), picture)


def _seen(first, last, pixel_of, low, high):
    """Return the cell under each pixel between two ends of a span of cells, as an array, and the first pixel."""
    start, end = pixel_of(first), pixel_of(last)
    begin, stop = max(round(start), low), min(max(round(end), round(start) + 1), high)
    places = (np.arange(begin, stop) + 0.5 - start) * (last - first) / (end - start)
    return np.clip(places.astype(int), 0, last - first - 1) + first, begin
