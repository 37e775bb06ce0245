"""The turn of the table: half a second in which time stands still and the old picture goes round."""

import math

from game.world.looks.painter import draw_turned

TURN_S = 0.45


class TurnAnimation:
    """The picture of the lattice before the turn, on its way round by quarters, growing to `growth` its size."""

    def __init__(self, picture, now_s, quarters=2, growth=1.0):
        self._picture = picture  # (h, w) uint32
        self._angle = math.pi / 2 * (quarters if quarters < 3 else -1)
        self._growth = growth
        self._start_s = now_s

    def over(self, now_s):
        """Say whether the turn has come to its end."""
        return now_s - self._start_s >= TURN_S

    def draw(self, pixels, ground, frame, now_s):
        """Draw the picture as far round as it is into `frame` (left, top, width, height) of `pixels`."""
        part = min(max((now_s - self._start_s) / TURN_S, 0.0), 1.0)
        part = (1 - math.cos(math.pi * part)) / 2  # starts and ends gently
        draw_turned(self._picture, ground, part * self._angle, self._growth**-part, pixels, frame)
