"""The film: turns worlds of one shape into frames of few colours."""

import itertools

import numpy as np

from game.world.looks.painter import Painter
from game.world.looks.themes import NIGHT, SAND, palette
from game.world.looks.view import View

LARGEST = 960, 720  # pixels: a larger lattice is shown at every so many cells


class Film:
    """Frames are (h, w) uint8 indices into `colours`, the RGB bytes of 256; each is `zoom` pixels wide in a file."""

    def __init__(self, shape, cell, colours=NIGHT, walls="stone", substances=SAND):
        height, width = self.shape = shape
        scale = min(cell, LARGEST[0] / width, LARGEST[1] / height)
        self.zoom = max(1, int(scale))
        size = shape if scale >= 1 else (max(1, round(height * scale)), max(1, round(width * scale)))
        self.colours = rgb(palette(colours, walls, substances=substances).reshape(1, -1)).tobytes()
        places = itertools.count()
        self._painter = Painter(
            View(shape, 0, 0, *size[::-1]), colours, walls, lambda *_: next(places), False, substances
        )
        self._pixels = np.zeros(size, np.uint32)

    def frame(self, world):
        """Return the frame that shows `world`."""
        self._painter.draw(world, self._pixels)
        return self._pixels.astype(np.uint8)


def rgb(pixels):
    """Return 0xRRGGBB values as (..., 3) uint8."""
    return np.stack([pixels >> 16 & 255, pixels >> 8 & 255, pixels & 255], axis=-1).astype(np.uint8)
