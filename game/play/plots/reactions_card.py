"""The card of reactions: each event that makes other materials with its course and how often it comes about."""

import pygame

from game.play.plots import charts
from game.play.ui import draw_list
from game.play.ui import theme as look

COURSE = 0.24  # of the card's width, that a row's curve takes where it has room
STEADY = 4  # samples whose mean is told: those of about a second
TITLE, SHORT = "Reactions a second", "Reactions/s"
NONE = "Nothing has reacted yet."


def reactions_card(theme, rect, nows, reactions, speed):
    """Return the strokes of the card, a row for each event, as many as have room; curves only beside whole names.

    nows: the iterations of the samples. reactions: {name of an event: how often it came about in an iteration before
    each sample}. speed: iterations per second. A row's curve reaches from 0 to its own greatest number.
    """
    high, room = theme.line_height(look.SMALL), charts.room_in(theme, rect)
    if not reactions:
        return charts.card(theme, rect, TITLE, "", SHORT)[0] + charts.lines(theme, room, NONE)
    lately = [numbers[1:][-STEADY:] for numbers in reactions.values()]
    figures = [figure(speed * sum(each) / max(1, len(each))) for each in lately]
    wide = max(theme.width(f" {each}", look.SMALL) for each in (*figures, "999"))
    course = int(COURSE * room.width)
    if any(theme.width(name, look.SMALL) > room.width - wide - course for name in reactions):
        course = 0
    strokes, shown, row = [], 0, pygame.Rect(room.x, room.y, room.width, high)
    for (name, numbers), spelt in zip(reactions.items(), figures, strict=True):
        words = charts.lines(theme, pygame.Rect(row.x, row.y, row.width - wide - course, high), name)
        if shown and row.y + len(words) * high > room.bottom:
            break
        strokes += [*words, (draw_list.words, tuple(row), spelt, look.SMALL, look.TEXT, 1)]
        if course:
            curve = pygame.Rect(row.right - wide - course + theme.px(2), row.y + 2, course - theme.px(4), high - 4)
            most = max(numbers[1:], default=0)
            strokes += charts.curves(curve, [(nows, numbers, look.ACCENT)], 0, most or 1)
        shown, row = shown + 1, row.move(0, len(words) * high)
    return charts.card(theme, rect, TITLE, charts.part(shown, len(reactions)), SHORT)[0] + strokes


def figure(number):
    """Return how often something comes about, in at most five characters."""
    if number >= 9_950:
        return f"{number / 1e3:.0f}k"
    return f"{number:.0f}" if number >= 9.95 or not number else f"{number:.1f}"
