"""A picture of a rule: its materials, and every event before and after, with its probability."""

import io

from PIL import Image, ImageDraw, ImageFont

from game.world.files.atomic import save
from game.world.files.paths import asset

CELL = 22  # pixels
MARGIN = 14
COLUMN = 330  # pixels from one event to the next
ROW = 92
COLUMNS = 3
MOST_STRIPES = 4  # in a cell; with more there is its letter alone
GROUND, INK, PALE, LINE = (38, 33, 28), (236, 228, 214), (168, 158, 144), (74, 66, 58)


def save_picture(rule, path):
    """Draw a rule and save it as PNG in the file at `path`; raise FileError if it cannot be."""
    data = io.BytesIO()
    picture(rule).save(data, "PNG")
    save(path, data.getvalue())


def picture(rule):
    """Return the picture of a rule, an Image."""
    told = rule.definition
    events = told.told_events()
    swatches = -(-len(told.materials) // 6)
    top = 3 * MARGIN + 30 + swatches * 30
    rows = -(-len(events) // COLUMNS)
    image = Image.new("RGB", (2 * MARGIN + COLUMNS * COLUMN, top + rows * ROW + MARGIN), GROUND)
    pen = ImageDraw.Draw(image)
    pen.text((MARGIN, MARGIN), told.title, INK, _font(22))
    for code, each in enumerate(told.materials):
        place = MARGIN + code % 6 * 168, 2 * MARGIN + 30 + code // 6 * 30
        _cell(pen, place, [each.colour])
        pen.text((place[0] + CELL + 8, place[1] + 2), each.name, INK, _font(14))
    for number, event in enumerate(events):
        _draw_event(pen, event, rule, MARGIN + number % COLUMNS * COLUMN, top + number // COLUMNS * ROW)
    return image


def _draw_event(pen, event, rule, x, y):
    pen.text((x, y), event.name, INK, _font(14))
    pen.text((x, y + 18), f"{event.layer}, {event.spoken_chance(rule.chances)}, {event.ways}", PALE, _font(11))
    y += 38
    x = _draw_grid(pen, event.picture.before, event, rule, x, y)
    tip = x + CELL - 6, y + CELL // 2
    pen.line(((x + 4, tip[1]), tip), INK, 2)
    pen.polygon((tip, (tip[0] - 6, tip[1] - 4), (tip[0] - 6, tip[1] + 4)), INK)
    x += CELL
    for number, after in enumerate(event.picture.afters):
        if number:
            pen.text((x + 4, y + 1), "or", PALE, _font(12))
            x += CELL
        x = _draw_grid(pen, after, event, rule, x, y)


def _draw_grid(pen, grid, event, rule, x, y):
    """Draw the cells of one grid and return where the next thing may stand."""
    for down, row in enumerate(grid):
        for right, sign in enumerate(row):
            place = x + right * CELL, y + down * CELL
            colours = [rule.definition.materials[code].colour for code in sorted(event.codes.get(sign, ()))]
            _cell(pen, place, colours if len(colours) <= MOST_STRIPES else [])
            if sign.isupper() or sign == "?":
                middle = place[0] + CELL / 2, place[1] + CELL / 2
                pen.text(middle, sign, INK, _font(13), "mm", stroke_width=2, stroke_fill=GROUND)
    return x + len(grid[0]) * CELL + 4


def _cell(pen, place, colours):
    """Draw a cell in stripes of its colours."""
    x, y = place
    for number, colour in enumerate(colours):
        left, right = (x + CELL * edge / len(colours) for edge in (number, number + 1))
        pen.rectangle((round(left), y, round(right) - 1, y + CELL - 1), colour)
    pen.rectangle((x, y, x + CELL - 1, y + CELL - 1), outline=LINE)


def _font(size):
    return ImageFont.truetype(str(asset("font", "NotoSans-Regular.ttf")), size)
