"""The cells of an hourglass, symmetric about both axes."""

import math

import numpy as np

from game.world.sand.parameters import Knob

NECK = Knob("neck", 2.0, 1, 1000, "cells", "width of the neck", ends=("narrow", "wide"))
CURVE = Knob("curve", 1.0, 0, 1, "", "how round the bulbs are: 0 gives straight cones", ends=("cone", "round"))
THICKNESS = Knob("wall", 3.0, 1, 100, "cells", "thickness of the glass", ends=("thin", "thick"))
FILL = Knob("fill", 0.75, 0, 1, "", "part of the upper bulb's height that is full of sand", ends=("empty", "full"))

# Parts of a bulb's height that are rounded at curve = 1, chosen by eye. What they leave straight bounds the width of
# the bulbs: larger parts make a slimmer glass, because the funnel must not be flatter than 45 degrees.
THROAT, BELLY, SHOULDER = 0.16, 0.46, 0.17
SHOULDER_REACH = 1.7  # how far a shoulder reaches inwards, as a multiple of its height
HAIR = 1e-6  # cells: what is rounded over less than this is sharp


def hourglass(height, width, neck, curve, wall, fill):
    """Return (sand, walls), two (height, width) bool arrays: a glass between two plates, its upper bulb part filled.

    neck: cells the sand passes between, rounded to the nearest number as odd or even as `width`, at least 1 or 2.
    curve: 0 for straight cones with sharp shoulders … 1 for round bulbs. wall: thickness of the glass in cells, along
    its normal, at least 1. fill: part of the upper bulb's height that sand fills, to a level surface.
    A glass too wide for its height gets narrower bulbs, so that no grain can rest on its funnels.
    """
    if min(height, width) < 5:
        raise ValueError(f"an hourglass must be at least 5×5 cells, got {width}×{height}")
    wall = max(1.0, min(wall, (min(height, width) - 1) / 4))
    plate = max(math.floor(wall), min(round(2 * wall), height // 8))
    middle = np.abs(np.arange(height) + 0.5 - height / 2)  # each row's distance from the middle of the neck
    axis = np.abs(np.arange(width) + 0.5 - width / 2)
    overhang = curve * min(2 * wall, width / 16)  # straight cones end where the plates end
    inner = _bulb(middle, height / 2 - plate, width / 2 - wall - overhang, _neck(neck, width, wall) / 2, curve)
    in_bulb = middle < height / 2 - plate
    inner[~in_bulb] = 0.0
    solid = np.minimum(_thicken(inner, wall), width / 2)
    solid[~in_bulb] = min(inner.max() + wall + overhang, width / 2)
    solid[(middle > height / 2 - plate) & (middle < height / 2 - plate / 2)] -= overhang / 2
    inside = axis < inner[:, None]
    walls = (axis < solid[:, None]) & ~inside
    surface = height / 2 - fill * (height / 2 - plate)
    rows = np.arange(height) + 0.5
    return inside & ((rows > surface) & (rows < height / 2))[:, None], walls


def _neck(neck, width, wall):
    """Return the neck in whole cells: as odd or even as `width`, so that it stands on the axis, and fitting in."""
    parity = width % 2
    widest = width - 2 * math.ceil(wall)
    nearest = 2 * math.floor((neck - parity) / 2 + 0.5) + parity
    return max(2 - parity, min(nearest, widest - (widest - parity) % 2))


def _bulb(distance, height, radius, neck, curve):
    """Return the inner radius of a bulb at each distance from the neck, a quarter round at each end of a straight cone.

    The slope (cells of radius per cell of height) rises to its largest over the throat, stays, and falls to 0 over the
    belly; then the shoulder turns inwards.
    """
    throat, belly, shoulder = (part * curve * height for part in (THROAT, BELLY, SHOULDER))
    widest = height - shoulder
    slope = min(1.0, max(0.0, radius - neck) / (widest - (throat + belly) / 2))
    along = np.minimum(distance, widest)
    inner = neck + slope * (_eased(along, throat) - _eased(along - (widest - belly), belly))
    reach = min(SHOULDER_REACH * shoulder, inner.max() - neck)
    turn = np.clip((distance - widest) / max(shoulder, HAIR), 0.0, 1.0)
    return inner - reach * (1.0 - np.sqrt(1.0 - turn**2))


def _eased(distance, ease):
    """Return `distance`, started gently: its slope rises from 0 to 1 over the first `ease` cells; 0 below 0."""
    distance = np.maximum(distance, 0.0)
    return np.where(distance < ease, distance**2 / max(2 * ease, HAIR), distance - ease / 2)


def _thicken(inner, wall):
    """Return the radius outside a glass `wall` thick: the largest reach of a disc of radius `wall` along the inside."""
    outer = np.zeros_like(inner)
    for shift in range(-math.floor(wall), math.floor(wall) + 1):
        shifted = np.roll(inner, shift)  # the ends that come round are plates, whose inner radius is 0
        reach = math.sqrt(wall**2 - shift**2)
        outer = np.maximum(outer, np.where(shifted > 0.0, shifted + reach, 0.0))
    return outer
