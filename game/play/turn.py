"""The turn of the glass: half a second in which time stands still and the old picture goes round."""

import math

from game.core.pixels import draw_turned

TURN_S = 0.45


class Turn:
    """The picture of the lattice before the flip, on its way round."""

    def __init__(self, picture, now_s):
        self._picture = picture  # (h, w) uint32
        self._start_s = now_s

    def over(self, now_s):
        """Say whether the turn has come to its end."""
        return now_s - self._start_s >= TURN_S

    def draw(self, pixels, ground, frame, now_s):
        """Draw the picture as far round as it is into `frame` (left, top, width, height) of `pixels`."""
        part = min(max((now_s - self._start_s) / TURN_S, 0.0), 1.0)
        angle = math.pi * (1 - math.cos(math.pi * part)) / 2  # starts and ends gently
        left, top, width, height = frame
        draw_turned(self._picture, ground, math.cos(angle), math.sin(angle), pixels, top, left, height, width)
