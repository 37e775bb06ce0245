"""The brush in hand: pointer events in, strokes out."""

import pygame

from game.world import knob
from game.world.action import Paint, snap

TOOLS = ("sand", "wall", "erase")
LEFT, RIGHT = 1, 3


class Brush:
    """What the pointer paints with, and the stroke that it is drawing."""

    def __init__(self):
        self.material = "sand"
        self.diameter = knob.BRUSH.default
        self.over_walls = False
        self._last = None  # where the stroke has come to, (column, row) in cells; None while no button is down
        self._button = None

    @property
    def painting(self):
        """Whether a stroke is being drawn."""
        return self._last is not None

    def resize(self, steps):
        """Grow or shrink the brush by about a tenth, and by one cell at least, for each step."""
        change = max(1, self.diameter // 10) * steps
        self.diameter = int(min(max(self.diameter + change, knob.BRUSH.low), knob.BRUSH.high))

    def hear(self, event, view):
        """Return the strokes that a pointer event draws on the lattice that `view` shows."""
        if event.type == pygame.MOUSEBUTTONDOWN and event.button in (LEFT, RIGHT) and not self.painting:
            self._button, self._last = event.button, view.place(*event.pos)
            return [self._stroke(self._last)]
        if event.type == pygame.MOUSEMOTION and self.painting:
            return [self._stroke(view.place(*event.pos))]
        if event.type == pygame.MOUSEBUTTONUP and event.button == self._button:
            strokes = [self._stroke(view.place(*event.pos))]
            self.let_go()
            return strokes
        return []

    def pour(self):
        """Return the stroke of a brush that is held where it is, so that sand keeps coming."""
        return [self._stroke(self._last)] if self.painting else []

    def let_go(self):
        """End the stroke."""
        self._last = self._button = None

    def outline(self, place, view):
        """Return (x, y, radius) in pixels of the brush at a place in the lattice."""
        return *view.pixel(*snap(place, self.diameter)), self.diameter / 2 * view.cell

    def _stroke(self, place):
        material = "erase" if self._button == RIGHT else self.material
        start, self._last = self._last, place
        return Paint(material, start, place, self.diameter, self.over_walls)
