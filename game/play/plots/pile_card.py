"""The card of the pile: the sand that rests below the measured row, drawn to scale, with the slope of its surface."""

import math

import numpy as np
import pygame

from game.play.plots import charts
from game.play.ui import draw_list
from game.play.ui import theme as look

TITLE = "Pile below"
FIGURES = "88,888 "  # room for the figures at the upright axis
AXES = "height, cells", "cells across"


def pile_card(theme, rect, measurements, with_axes):
    """Return the strokes of the card; with_axes: the names of the axes, too."""
    last, pile = measurements.samples[-1], measurements.pile
    strokes, room = charts.card(theme, rect, TITLE, _said(theme, rect, last))
    foot = []
    if with_axes:
        strokes, room = charts.with_name(theme, strokes, room, AXES[0])
    there = np.flatnonzero(pile.heights)
    first, count = (int(there[0]), int(there[-1] - there[0]) + 1) if len(there) else (0, 1)
    if with_axes:
        high = theme.line_height(look.SMALL)
        words = (draw_list.words, (room.x, room.bottom - high, room.width, high), f"{count:,} {AXES[1]}")
        foot = [(*words, look.SMALL, look.FAINT, 1)]
        room = pygame.Rect(room.x, room.y, room.width, room.height - high)
    wide = max(1, room.width - theme.width(FIGURES, look.SMALL))
    top = charts.round_up(max(1, 1.05 * last.height, count * room.height / wide))
    figures, room = charts.scale(theme, room, [(top, charts.figure(top)), (0, "0")], 0, top)
    return [*strokes, *foot, *figures, _profile(room, pile, first, count, room.height / top)]


def _said(theme, rect, last):
    """Return height and slope in words, as fully as there is room for."""
    if math.isnan(last.slope):
        return f"{last.height:,} high"
    error = "" if math.isnan(last.slope_error) else f" ± {last.slope_error:.1f}°"
    full = f"{last.height:,} high, {last.slope:.1f}°{error}"
    room = rect.width - 2 * theme.px(charts.PAD) - theme.width(f"{TITLE} ", look.SMALL)
    return full if theme.width(full, look.SMALL) <= room else f"{last.slope:.1f}°{error}"


def _profile(room, pile, first, count, cell):
    """Return the stroke of the sand of so many columns, `cell` pixels to a cell both ways, in the middle of `room`."""
    heights, surface = (each[first : first + count] for each in pile)
    low = int((surface - heights)[heights > 0].min()) if heights.any() else 0
    left, wide = max(0, round((room.width - count * cell) / 2)), min(room.width, round(count * cell))
    spans = []
    for x in range(wide):
        column = min(int(x / cell), count - 1)
        if heights[column]:
            top, bottom = (
                round(room.height - (edge - low) * cell)
                for edge in (surface[column], surface[column] - heights[column])
            )
            spans.append((left + x, max(0, top), bottom))
    return charts.hill, tuple(room), tuple(spans), look.ACCENT
