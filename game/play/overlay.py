"""What is laid over the sand for a while: the page of keys, and the splash before the first frame."""

import pygame

from game.play.keys import HELP
from game.play.ui import paint
from game.play.ui import theme as look

LINE = 24  # pixels at scale 1
PAD = 22
COLUMN = 290  # width of one column of keys


def draw_help(surface, theme, area):
    """Draw the page that shows every key, in the middle of `area`, in as many columns as fit."""
    px = theme.px
    rows = HELP
    columns = 2 if area.width >= 2 * px(COLUMN) + 3 * px(PAD) else 1
    deep = -(-len(rows) // columns)
    line = min(px(LINE), (area.height - 2 * px(PAD)) // (deep + 1))
    size_of_text = look.BODY if line > theme.line_height(look.SMALL) else look.SMALL
    size = (
        min(columns * px(COLUMN) + (columns + 1) * px(PAD), area.width),
        min((deep + 1) * line + 2 * px(PAD), area.height),
    )
    page = pygame.Rect((0, 0), size)
    page.center = area.center
    paint.box(surface, theme, page, look.EDGE, px(8))
    paint.box(surface, theme, page.inflate(-2, -2), look.GROUND, px(8))
    paint.words(
        surface, theme, (page.x + px(PAD), page.y + px(PAD) // 2, size[0], line), "Keys", look.HEADING, look.TEXT, 0
    )
    wide = (page.width - (columns + 1) * px(PAD)) // columns
    for number, (label, meaning) in enumerate(rows):
        column, row = divmod(number, deep)
        x, y = page.x + px(PAD) + column * (wide + px(PAD)), page.y + px(PAD) + line * (row + 1) - line // 4
        paint.words(surface, theme, (x, y, px(100), line), label, size_of_text, look.ACCENT, 0)
        paint.words(surface, theme, (x + px(108), y, wide - px(108), line), meaning, size_of_text, look.TEXT, 0)


def draw_splash(surface, theme, what, part):
    """Fill the window with the title, what is being made ready, and how much of it is done (0 … 1)."""
    px = theme.px
    width, height = surface.get_size()
    surface.fill(look.SUNKEN)
    middle = height // 2
    paint.words(surface, theme, (0, middle - px(64), width, px(30)), "Sandglass", look.HEADING, look.BRIGHT_ACCENT, 0.5)
    paint.words(surface, theme, (0, middle - px(32), width, px(24)), what, look.BODY, look.DIM, 0.5)
    track = pygame.Rect(0, 0, px(220), px(4))
    track.center = width // 2, middle + px(12)
    surface.fill(look.GROOVE, track)
    surface.fill(look.ACCENT, (track.x, track.y, round(track.width * part), track.height))
