"""The cards of worlds of several materials: how much there is of each, and the sums that their rule keeps."""

import pygame

from game.play.plots import charts
from game.play.ui import draw_list
from game.play.ui import theme as look

SWATCH = 9  # pixels at scale 1
ENTRY = 104  # the least width of a name with its number
MOST_LEGEND = 0.5  # of the card's height, that names may take
BOOKS = "to the cell"
NO_BOOKS = "This rule names no sum that it keeps."


def amounts_card(theme, rect, samples, names, colours):
    """Return the strokes of the card of the amounts of materials against time.

    samples: of (iteration, cells of each material). names: {name: the codes that are counted as it}. colours: by code.
    """
    series = {
        name: ([sum(amounts[code] for code in codes) for _, amounts in samples], colours[codes[0]])
        for name, codes in names.items()
    }
    series = {name: each for name, each in series.items() if any(each[0])}
    order = sorted(series, key=lambda name: -series[name][0][-1])
    entries = [(name, f"{series[name][0][-1]:,}", series[name][1]) for name in order]
    names_of, room, shown = legend(theme, charts.room_in(theme, rect), entries)
    strokes, _ = charts.card(theme, rect, "Cells of each material", charts.part(shown, len(order)), "Cells")
    high = charts.round_up(max([1, *(max(numbers) for numbers, _ in series.values())]))
    figures, room = charts.scale(theme, room, [(high, charts.figure(high)), (0, "0")], 0, high)
    lines = [([now for now, _ in samples], *each) for each in series.values()]
    return strokes + names_of + figures + charts.curves(room, lines, 0, high)


def legend(theme, room, entries, wide=None):
    """Return the strokes of (name, figure, colour), as many as have room, the rect below them, and how many these are.

    wide: pixels that an entry takes at least; ENTRY if None.
    """
    px, high = theme.px, theme.line_height(look.SMALL)
    across = max(1, room.width // (wide or px(ENTRY)))
    rows = min(-(-len(entries) // across), max(1, int(MOST_LEGEND * room.height) // high))
    wide, side, strokes = room.width // across, px(SWATCH), []
    for number, (name, figure, colour) in enumerate(entries[: rows * across]):
        down, right = divmod(number, across)
        place = pygame.Rect(room.x + right * wide, room.y + down * high, wide - px(6), high)
        strokes.append((draw_list.box, (place.x, place.centery - side // 2, side, side), colour, px(2)))
        words = pygame.Rect(place.x + side + px(4), place.y, place.width - side - px(4), high)
        strokes.append((draw_list.words, tuple(words), figure, look.SMALL, look.TEXT, 1))
        words.width -= theme.width(f" {figure}", look.SMALL)
        strokes.append((draw_list.words, tuple(words), name, look.SMALL, look.DIM, 0))
    top = rows * high + px(4)
    below = pygame.Rect(room.x, room.y + top, room.width, max(1, room.height - top))
    return strokes, below, min(len(entries), rows * across)


def books_card(theme, rect, account, amounts, books):
    """Return the strokes of the card of the sums that no event may change, or only some; books: Books of a rule."""
    lines = [(each, *_sum(account, each.codes), sum(amounts[code] for code in each.codes)) for each in books]
    lines = [line for line in lines if any(line[1:])] or lines  # of what is there and was
    right = all(start + came - gone + other == now for book, start, came, gone, other, now in lines if not book.but)
    said, room = BOOKS if right and lines else "" if right else "not kept", charts.room_in(theme, rect)
    if not lines:
        return charts.card(theme, rect, "Conserved", said)[0] + charts.lines(theme, room, NO_BOOKS)
    strokes, shown, left = [], 0, room
    for book, *numbers in lines:
        entry, left = _entry(theme, left, _words(book), _spelt(*numbers, book.but))
        if left.height < 0:
            break
        strokes, shown = strokes + entry, shown + 1
    part = charts.part(shown, len(lines))
    title, short = (f"Conserved ({part} shown)", f"{part} sums") if part else ("Conserved", None)
    return charts.card(theme, rect, title, said, short)[0] + strokes


def _entry(theme, room, words, spelt):
    """Return the strokes of a sum at the top of `room`, its words and then its figures, and the rect left below."""
    high = theme.line_height(look.SMALL)
    words, spelt = _fitting(theme, words, room.width), _fitting(theme, spelt, room.width)
    strokes = charts.lines(theme, room, words)
    one = theme.width(f"{words}  {spelt}", look.SMALL) <= room.width
    taken = high * (1 if one else len(strokes) + 1)
    place = (room.x, room.y + taken - high, room.width, high)
    strokes.append((draw_list.words, place, spelt, look.SMALL, look.TEXT, 1))
    return strokes, pygame.Rect(room.x, room.y + taken, room.width, room.height - taken)


def _words(book):
    """Return what may be said of a book, the longest first: its materials, and the events that may change the sum."""
    if not book.but:
        return (book.words,)
    count = len(book.but)
    named = f"{book.words}, but {' and '.join(book.but)}"
    return named, f"{book.words}, but {count} event{'s' * (count > 1)}", book.words


def _spelt(start, came, gone, other, now, but):
    """Return a sum in figures, the longest first: with the terms that are 0, without them, and without words.

    It is what there was at the start, was put in and taken out, what events that may did, and what is there.
    other: what events under other rules before did.
    """
    by_events = now - (start + came - gone) if but else other
    kept = start + came - gone + by_events
    wrong = "" if kept == now else f", but {now:,} are there"
    found = []
    for zeros, words in ((True, " by events"), (False, " by events"), (False, "")):
        terms = [f"+ {came:,}"] * bool(came or zeros) + [f"– {gone:,}"] * bool(gone or zeros)
        if by_events or (but and zeros):
            terms.append(f"{'–' if by_events < 0 else '+'} {abs(by_events):,}{words}")
        found.append(" ".join([f"{start:,}", *terms, f"= {kept:,}"]) + wrong)
    return tuple(found)


def _fitting(theme, texts, width):
    """Return the first of some texts that there is room for, or the last."""
    return next((text for text in texts if theme.width(text, look.SMALL) <= width), texts[-1])


def _sum(account, codes):
    """Return how much of some materials there was at the start, has been put in, and has been taken out.

    Then how much events under other rules before made of them, on balance.
    """
    tallies = (
        (account.start_by_kind,),
        (account.painted_by_kind, account.poured_by_kind),
        (account.erased_by_kind, account.swallowed_by_kind),
        (account.formed_before_by_kind, [-each for each in account.used_before_by_kind]),
    )
    return tuple(sum(tally[code] for tally in group for code in codes if code < len(tally)) for group in tallies)
