"""The slider: label, track with a round handle and named ends, value; and its kin with a picture of a block."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.controls import ROW
from game.play.ui.slider_scale import SliderScale

HANDLE = 7  # radius at scale 1
TALL_ROW = 40  # a slider in two lines: words above, track below
VALUE_WIDTH = 50  # of a probability, beside its picture; one of many figures is small
WITH_UNIT = 68  # of any value
ENDS_ROW = 32  # of a slider in one line whose ends have names
UP, DOWN = 10, 6  # from the track of such a row up to its top, and down to the words at its ends
CELL = 11  # of a picture
NARROW = 230  # a column narrower than this has no room for words and track in one line

STEP_KEYS = {
    pygame.K_LEFT: -1,
    pygame.K_DOWN: -1,
    pygame.K_RIGHT: 1,
    pygame.K_UP: 1,
    pygame.K_PAGEDOWN: -10,
    pygame.K_PAGEUP: 10,
}
RESET_KEYS = frozenset({pygame.K_DELETE, pygame.K_BACKSPACE})
SLIDER_KEYS = RESET_KEYS | {pygame.K_HOME, pygame.K_END} | set(STEP_KEYS)


def slider(
    ui, label, knob, value, default=None, marks=(), log=False, step=None, tip=None, name=None, picture=None, spell=None
):
    """Show a slider for a knob; return its value, as it came unless the person moved it.

    default: what a double click or Delete brings back; the knob's own if None. tip: the knob's meaning if None.
    log: equal ratios instead of equal differences. step: see SliderScale. picture: see slider_with_picture.
    spell: returns the text of a value; the scale's way if None.
    """
    scale = SliderScale(knob, log, step)
    spell = spell or scale.spell
    row, words, track, number, lines = _lay_out(
        ui, label, picture, ui.theme.px(VALUE_WIDTH if picture else WITH_UNIT), knob.ends
    )
    top = words.bottom if words.bottom < track.y else row.y
    zone = pygame.Rect(track.x, top, track.width, row.bottom - top).inflate(2 * ui.theme.px(HANDLE), 0)
    me = ui.claim(name or label, ui.bleed(row), parts=(zone,), keys=SLIDER_KEYS, tip=_tip(knob) if tip is None else tip)
    for event in me.events:
        value = _moved(scale, value, event, track, knob.default if default is None else default)
    for place, line, size in lines:
        ui.stroke(draw_list.words, place, line, size, look.TEXT, 0)
    written = spell(value)
    size = look.BODY if ui.theme.width(written, look.BODY) <= number.width else look.SMALL
    ui.stroke(draw_list.words, number, written, size, look.TEXT if me.hover else look.DIM, 1)
    if picture:
        _draw_picture(ui, row, picture)
    _draw_track(ui, track, scale, value, marks, me)
    if knob.ends:
        _draw_ends(ui, track, knob.ends)
    return value


def slider_with_picture(ui, label, knob, value, before, after, **how):
    """Show a slider beside cells before and after, at most 2×2 of them, as `draw_list.cells` draws them."""
    return slider(ui, label, knob, value, picture=(before, after), **how)


def _tip(knob):
    meaning = knob.meaning[:1].upper() + knob.meaning[1:]
    return f"{meaning} ({knob.unit})" if knob.unit else meaning


def _moved(scale, value, event, track, default):
    if event.kind == "press" and event.again:
        return default
    if event.kind in ("press", "drag") and event.part is not None and not event.again:
        return scale.at((event.pos[0] - track.x) / max(1, track.width))
    if event.kind != "key":
        return value
    if event.key in RESET_KEYS:
        return default
    if event.key in STEP_KEYS:
        return scale.stepped(value, STEP_KEYS[event.key], event.shift)
    return scale.at(0.0 if event.key == pygame.K_HOME else 1.0)


def _lay_out(ui, label, picture, value_width, ends):
    """Return the rects of the row, the words, the track (as far as the handle's centre goes) and the number.

    With them return the label's lines, as (rect, text, size): one that is too long is small and in several.
    """
    px = ui.theme.px
    handle, label_width = px(HANDLE), ui.label_width
    if not picture and ui.width >= px(NARROW):
        row, high = ui.place(px(ENDS_ROW if ends else ROW), 0), px(2 * UP if ends else ROW)
        words = pygame.Rect(row.x, row.y, label_width - px(4), high)
        number = pygame.Rect(row.right - value_width, row.y, value_width, high)
        left = row.x + label_width + handle
        track = pygame.Rect(left, words.centery, number.x - handle - left, 0)
        return row, words, track, number, [(words, label, look.BODY)]
    aside, line = _picture_width(px) + px(10) if picture else 0, px(22)
    lines, size, high = (label,), look.BODY, line
    room = ui.width - aside - value_width
    if ui.theme.width(label, look.BODY) > room:
        lines, size, high = ui.theme.lines(label, look.SMALL, room), look.SMALL, ui.theme.line_height(look.SMALL)
    more = max(0, len(lines) * high - line)
    below = px(ENDS_ROW - 2 * UP) if ends else 0
    row = ui.place(px(TALL_ROW) + more + below, px(4))
    left = row.x + aside
    number = pygame.Rect(row.right - value_width, row.y, value_width, line)
    words = pygame.Rect(left, row.y, number.x - left, line + more)
    track = pygame.Rect(left + handle, row.y + more + px(30), row.right - 2 * handle - left, 0)
    written = [
        (pygame.Rect(words.x, words.y + place * high, words.width, high), text, size)
        for place, text in enumerate(lines)
    ]
    return row, words, track, number, written


def _picture_width(px):
    return 2 * _block_width(px) + px(18)


def _block_width(px):
    return 2 * px(CELL) + 3 * px(1)


def _draw_picture(ui, row, picture):
    px = ui.theme.px
    block, arrow = _block_width(px), px(10)
    y = row.centery - block // 2
    before = pygame.Rect(row.x, y, block, block)
    after = pygame.Rect(row.x + block + px(18), y, block, block)
    middle = (before.right + after.x) // 2
    ui.stroke(draw_list.cells, before, picture[0])
    head = pygame.Rect(middle - arrow // 2, row.centery - arrow // 2, arrow, arrow)
    ui.stroke(draw_list.polygon, head, draw_list.ARROW, look.DIM)
    ui.stroke(draw_list.cells, after, picture[1])


def _draw_track(ui, track, scale, value, marks, me):
    px = ui.theme.px
    half, radius = px(2), px(HANDLE)
    x = _x(track, scale.fraction(value))
    groove = pygame.Rect(track.x - radius, track.y - half, track.width + 2 * radius, 2 * half)
    from_x = _x(track, scale.fraction(0.0)) if scale.knob.low < 0.0 < scale.knob.high else groove.x
    filled = pygame.Rect(min(x, from_x), groove.y, abs(x - from_x), 2 * half)
    ui.stroke(draw_list.box, groove, look.EDGE if me.hover else look.GROOVE, half)
    for mark in marks:
        tick = pygame.Rect(_x(track, scale.fraction(mark)) - px(1) // 2, track.y + half + px(3), px(1), px(3))
        ui.stroke(draw_list.fill, tick, look.FAINT)
    ui.stroke(draw_list.box, filled, look.BRIGHT_ACCENT if me.hover else look.ACCENT, half)
    handle = pygame.Rect(x - radius, track.y - radius, 2 * radius, 2 * radius)
    ui.stroke(draw_list.disc, handle, look.BRIGHT_HANDLE if me.hover else look.HANDLE)


def _draw_ends(ui, track, ends):
    """Write what the ends of the track are called below it, each word in its half."""
    radius, high = ui.theme.px(HANDLE), ui.theme.line_height(look.SMALL)
    half = track.width // 2 + radius
    top = track.y + ui.theme.px(DOWN)
    for number, word in enumerate(ends):
        place = pygame.Rect(track.x - radius + number * half, top, half, high)
        ui.stroke(draw_list.words, place, word, look.SMALL, look.FAINT, number)


def _x(track, fraction):
    return track.x + round(fraction * track.width)
