"""Marks: fine lines over the sand that show what a tool would reach, each with a dark seam to be seen on any ground."""

import math
from typing import NamedTuple

import pygame

from game.play.ui import theme as look

LEAST_RADIUS = 2  # pixels: a smaller outline would hide under the pointer
MARGIN = 6  # pixels that a line may be wide on each side, at the largest scale
FEWEST, MOST = 12, 96  # corners of a circle


class Mark(NamedTuple):
    """A line through points in pixels, closed or not."""

    points: tuple
    colour: str = look.TEXT  # a role
    closed: bool = True

    @property
    def rect(self):
        """What it covers of the window."""
        left, right = min(x for x, _ in self.points), max(x for x, _ in self.points)
        top, bottom = min(y for _, y in self.points), max(y for _, y in self.points)
        return pygame.Rect(left, top, right - left + 1, bottom - top + 1).inflate(2 * MARGIN, 2 * MARGIN)

    def draw(self, surface, theme):
        """Draw it."""
        wide = theme.px(1)
        pygame.draw.lines(surface, theme.rgb(look.SUNKEN), self.closed, self.points, 3 * wide)
        pygame.draw.lines(surface, theme.rgb(self.colour), self.closed, self.points, wide)


def mark(outline, view, colour=look.TEXT):
    """Return the Mark of an outline, places (column, row) in the lattice, seen through `view`."""
    points = [view.pixel(*place) for place in outline]
    middle_x, middle_y = (sum(parts) / len(points) for parts in zip(*points, strict=True))
    reach = max(max(abs(x - middle_x), abs(y - middle_y)) for x, y in points)
    stretch = max(1.0, LEAST_RADIUS / max(reach, 1e-6))
    return Mark(
        tuple(
            (round(middle_x + stretch * (x - middle_x)), round(middle_y + stretch * (y - middle_y))) for x, y in points
        ),
        colour,
    )


def brush_outline(shape, diameter, place):
    """Return the outline of a brush of a shape at a place, in cells."""
    radius, (x, y) = diameter / 2, place
    if shape == "square":
        return box_outline(x - radius, y - radius, x + radius, y + radius)
    if shape == "diamond":
        return [(x, y - radius), (x + radius, y), (x, y + radius), (x - radius, y)]
    return ellipse_outline(x - radius, y - radius, x + radius, y + radius)


def box_outline(left, top, right, bottom):
    """Return the outline of a rectangle."""
    return [(left, top), (right, top), (right, bottom), (left, bottom)]


def ellipse_outline(left, top, right, bottom):
    """Return the outline of the ellipse in a rectangle."""
    corners = int(min(max(FEWEST, 4 * math.sqrt((right - left) * (bottom - top))), MOST))
    angles = [2 * math.pi * number / corners for number in range(corners)]
    middle_x, middle_y = (left + right) / 2, (top + bottom) / 2
    wide, high = (right - left) / 2, (bottom - top) / 2
    return [(middle_x + wide * math.cos(angle), middle_y + high * math.sin(angle)) for angle in angles]


def hull(points):
    """Return the corners of the least convex outline around points (Andrew's monotone chain)."""
    points = sorted(set(points))
    halves = []
    for way in (points, points[::-1]):
        half = []
        for point in way:
            while len(half) > 1 and _turns_right(half[-2], half[-1], point):
                half.pop()
            half.append(point)
        halves += half[:-1]
    return halves or points


def _turns_right(one, two, three):
    return (two[0] - one[0]) * (three[1] - one[1]) <= (two[1] - one[1]) * (three[0] - one[0])
