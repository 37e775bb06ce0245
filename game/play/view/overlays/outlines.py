"""Marks: fine lines over the sand that show tools, fixtures and the tilt of the table.

Each has a dark seam, to be seen on any ground.
"""

import math
from typing import NamedTuple

import pygame

from game.play.ui import theme as look
from game.world.sand.fixtures import TAP

LEAST_RADIUS = 2  # pixels: a smaller outline would hide under the pointer
MARGIN = 6  # pixels that a line may be wide on each side, at the largest scale
FEWEST, MOST = 12, 96  # corners of a circle
LEAST_SYMBOL = 8  # pixels at scale 1: the least width of a fixture's symbol
STEM = 4  # pixels at scale 1: from a fixture's symbol to its handle
MOST_TILT = math.radians(4)  # of the frame, at a bias of 1
AROUND = 4  # pixels from the lattice, or from what is in sight of it, to the frame


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


def fixture_marks(fixtures, view, px):
    """Return the Marks of fixtures seen through `view`: a lid with a handle is a tap, a basin with a foot a drain.

    px: what a size at scale 1 is in pixels of the screen.
    """
    return tuple(_symbol(each, view, px) for each in fixtures)


def _symbol(fixture, view, px):
    left, top, right, bottom = fixture.box
    (x0, y0), (x1, y1) = view.pixel(left, top), view.pixel(right, bottom)
    middle, half = (x0 + x1) / 2, max(x1 - x0, px(LEAST_SYMBOL)) / 2
    x0, x1, lip = middle - half, middle + half - 1, min(half, max(px(2), y1 - y0))
    far, near, way = (y0 - px(2), y0 + lip, -px(STEM)) if fixture.kind == TAP else (y1 + px(1), y1 - lip, px(STEM))
    stem, handle = (middle, far + way), min(half, px(STEM))
    points = [(x0, near), (x0, far), (middle, far), stem, (middle - handle, stem[1]), (middle + handle, stem[1])]
    points += [stem, (middle, far), (x1, far), (x1, near)]
    colour = look.BRIGHT_ACCENT if fixture.kind == TAP else look.RING
    return Mark(tuple((math.floor(x), math.floor(y)) for x, y in points), colour, closed=False)


def tilt_marks(bias, view):
    """Return the Marks of a table tilted by `bias`: a frame around the lattice, or none where the table is level."""
    if bias == 0.0:
        return ()
    left, top, width, height = view.frame or (view.left, view.top, view.width, view.height)
    around = -AROUND if view.frame else AROUND
    middle = left + width / 2, top + height / 2
    wide, high = width / 2 + around, height / 2 + around
    cosine, sine = math.cos(bias * MOST_TILT), math.sin(bias * MOST_TILT)
    corners = ((-wide, -high), (wide, -high), (wide, high), (-wide, high))
    turned = ((middle[0] + x * cosine - y * sine, middle[1] + x * sine + y * cosine) for x, y in corners)
    return (Mark(tuple((round(x), round(y)) for x, y in turned), look.EDGE),)


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
