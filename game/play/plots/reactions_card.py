"""The card of reactions: each event that makes other materials with its course and how often it comes about."""

import pygame

from game.play.plots import charts
from game.play.ui import draw_list
from game.play.ui import theme as look

COURSE = 0.24  # of the card's width, that a row's curve takes where it has room
LEAST_NAME = 110  # pixels at scale 1: with less room than this the curves are left out
STEADY = 4  # samples whose mean is told: those of about a second
TITLE = "Reactions a second"
NONE = "Nothing has reacted yet."


def reactions_card(theme, rect, nows, reactions, speed):
    """Return the strokes of the card, a row for each event, as many as have room.

    nows: the iterations of the samples. reactions: {name of an event: how often it came about in an iteration before
    each sample}. speed: iterations per second. A row's curve reaches from 0 to its own greatest number.
    """
    strokes, room = charts.card(theme, rect, TITLE, "")
    high = theme.line_height(look.SMALL)
    if not reactions:
        return [*strokes, (draw_list.words, (room.x, room.y, room.width, high), NONE, look.SMALL, look.DIM, 0)]
    lately = [numbers[1:][-STEADY:] for numbers in reactions.values()]
    figures = [figure(speed * sum(each) / max(1, len(each))) for each in lately]
    wide = max(theme.width(f" {each}", look.SMALL) for each in (*figures, "999"))
    course = int(COURSE * room.width)
    if room.width - wide - course < theme.px(LEAST_NAME):
        course = 0
    for number, (name, numbers) in enumerate(list(reactions.items())[: max(1, room.height // high)]):
        row = pygame.Rect(room.x, room.y + number * high, room.width, high)
        strokes.append((draw_list.words, tuple(row), figures[number], look.SMALL, look.TEXT, 1))
        words = (row.x, row.y, row.width - wide - course, high)
        strokes.append((draw_list.words, words, name, look.SMALL, look.DIM, 0))
        if course:
            curve = pygame.Rect(words[0] + words[2] + theme.px(2), row.y + 2, course - theme.px(4), high - 4)
            most = max(numbers[1:], default=0)
            strokes += charts.curves(curve, [(nows, numbers, look.ACCENT)], 0, most or 1)
    return strokes


def figure(number):
    """Return how often something comes about, in at most five characters."""
    if number >= 9_950:
        return f"{number / 1e3:.0f}k"
    return f"{number:.0f}" if number >= 9.95 or not number else f"{number:.1f}"
