"""Charts: strokes for curves and profiles in a card, as in ui.draw_list."""

import math

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look

HEAD = 18  # height of a card's title at scale 1
PAD = 8
ROUND = 1, 1.5, 2, 3, 4, 5, 6, 8, 10  # the figures at which a scale may end, times a power of ten


def curve(surface, theme, rect, points, colour):
    """Draw a line through points, in pixels from the rect's upper left corner; a single point is a dot."""
    at = [(rect[0] + x, rect[1] + y) for x, y in points]
    if len(at) > 1:
        pygame.draw.lines(surface, theme.rgb(colour), False, at, max(1, theme.px(1)))
    elif at:
        surface.fill(theme.rgb(colour), (*at[0], theme.px(1), theme.px(1)))


def hill(surface, theme, rect, spans, colour):
    """Fill columns (x, top, bottom) of pixels, counted from the rect's upper left corner."""
    for x, top, bottom in spans:
        surface.fill(theme.rgb(colour), (rect[0] + x, rect[1] + top, 1, bottom - top))


def card(theme, rect, title, value, short=None):
    """Return (strokes, the rect left for the chart) of a card with a title and what it says now.

    short: the title where there is no room for the other beside the value.
    """
    px = theme.px
    room = rect.inflate(-2 * px(PAD), -2 * px(PAD // 2))
    head = pygame.Rect(room.x, room.y, room.width, px(HEAD))
    left = pygame.Rect(head.x, head.y, max(0, head.width - theme.width(f"{value} ", look.SMALL)), head.height)
    if short and theme.width(title, look.SMALL) > left.width:
        title = short
    strokes = [
        (draw_list.box, tuple(rect), look.GROUND, px(4)),
        (draw_list.words, tuple(left), title, look.SMALL, look.DIM, 0),
        (draw_list.words, tuple(head), value, look.SMALL, look.TEXT, 1),
    ]
    return strokes, room_in(theme, rect)


def room_in(theme, rect):
    """Return the rect that the head of a card leaves for the chart."""
    px = theme.px
    room = rect.inflate(-2 * px(PAD), -2 * px(PAD // 2))
    return pygame.Rect(room.x, room.y + px(HEAD) + px(2), room.width, room.height - px(HEAD) - px(4))


def part(shown, number):
    """Return what a card says where it has no room for all that it would show."""
    return f"{shown} of {number}" if shown < number else ""


def lines(theme, rect, text):
    """Return the strokes of a text in as many lines as it takes."""
    high, rows = theme.line_height(look.SMALL), theme.lines(text, look.SMALL, rect.width)
    return [
        (draw_list.words, (rect.x, rect.y + number * high, rect.width, high), row, look.SMALL, look.DIM, 0)
        for number, row in enumerate(rows)
    ]


def round_up(number):
    """Return the next round figure from `number`, 0 or above, on."""
    if number == 0:
        return 0
    power = 10.0 ** math.floor(math.log10(number))
    return next(each * power for each in ROUND if each * power >= number * (1 - 1e-9))


def figure(number):
    """Return a round figure as it is written at a scale."""
    return f"{number:,.10g}"


def scale(theme, room, marks, low, high):
    """Return (strokes of figures at the left, the rect left for the chart), without figures where there is no room.

    marks: [(number between low and high, its words)]. Of two that would touch, the first is written.
    """
    line, wide = theme.line_height(look.SMALL), max(theme.width(words, look.SMALL) for _, words in marks)
    if room.height < 2 * line or 3 * wide > room.width:
        return [], room
    places, strokes = [], []
    for number, words in marks:
        level = room.bottom - round((number - low) / (high - low) * room.height)
        place = pygame.Rect(room.x, min(max(level - line // 2, room.y), room.bottom - line), wide, line)
        if place.collidelist(places) < 0:
            places.append(place)
            strokes.append((draw_list.words, tuple(place), words, look.SMALL, look.FAINT, 1))
    wide += theme.px(PAD // 2)
    return strokes, pygame.Rect(room.x + wide, room.y, room.width - wide, room.height)


def curves(rect, series, low, high):
    """Return the strokes of series [(rising xs, numbers, colour)] between `low` and `high`; NaN leaves a gap."""
    ends = [x for xs, _, _ in series for x in (*xs[:1], *xs[-1:])]
    first = min(ends, default=0)
    span, strokes = max(max(ends, default=0) - first, 1e-9), []
    for xs, numbers, colour in series:
        run = []
        for x, number in [*zip(xs, numbers, strict=True), (0, math.nan)]:
            if not math.isnan(number):
                share = min(max((number - low) / max(high - low, 1e-9), 0.0), 1.0)
                place = round((x - first) / span * (rect.width - 1)), round((1 - share) * (rect.height - 1))
                if not run or place != run[-1]:
                    run.append(place)
            elif run:
                strokes.append((curve, tuple(rect), tuple(run), colour))
                run = []
    return strokes


def with_foot(theme, room, nows):
    """Return (the room above a line with the iterations at both ends, the line's strokes)."""
    high = theme.line_height(look.SMALL)
    if room.height < 3 * high or not nows:
        return room, []
    foot = (room.x, room.bottom - high, room.width, high)
    ends = ((f"{nows[0]:,}", 0), (f"iteration {nows[-1]:,}", 1))
    strokes = [(draw_list.words, foot, text, look.SMALL, look.FAINT, align) for text, align in ends]
    return pygame.Rect(room.x, room.y, room.width, room.height - high - 2), strokes


def with_name(theme, strokes, room, name):
    """Return strokes with the name of the upright axis above it, and the rect left below that."""
    high = theme.line_height(look.SMALL)
    if room.height < 4 * high:
        return strokes, room
    words = (draw_list.words, (room.x, room.y, room.width, high), name, look.SMALL, look.FAINT, 0)
    return [*strokes, words], pygame.Rect(room.x, room.y + high, room.width, room.height - high)
