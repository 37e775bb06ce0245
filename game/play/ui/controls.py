"""The single controls of a panel: each takes its place, handles its events, leaves its strokes, and returns its value.

They are the methods of widgets.Ui, whose place() gives them room and whose claim() gives them their events.
`name` tells a control from others with the same label, or keeps its focus while its label changes.
"""

import itertools

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.input import ENTER, key_name

ROW = 28  # height of a control at scale 1
GAP = 6  # below a control with a filled body
INSET, LEAST_INSET = 8, 3  # from the edge of a body to the text in it, and where that leaves the text no room
ASIDE = 10  # from a button's label to its key

PUSH_KEYS = frozenset({ENTER, pygame.K_SPACE})
SEGMENT_KEYS = {pygame.K_LEFT: -1, pygame.K_UP: -1, pygame.K_RIGHT: 1, pygame.K_DOWN: 1}
END_KEYS = frozenset({pygame.K_HOME, pygame.K_END})


def heading(ui, label):
    """Begin a section."""
    px = ui.theme.px
    ui.skip(px(8) if ui.begun else 0)
    rect = ui.place(px(ROW), 0)
    ui.stroke(draw_list.words, rect, label, look.HEADING, look.HANDLE, 0)


def text(ui, paragraph, dim=False):
    """Write a paragraph, wrapped."""
    height = ui.theme.line_height(look.SMALL)
    lines = ui.theme.lines(paragraph, look.SMALL, ui.width)
    rect = ui.place(height * len(lines), ui.theme.px(GAP))
    for index, line in enumerate(lines):
        row = pygame.Rect(rect.x, rect.y + index * height, rect.width, height)
        ui.stroke(draw_list.words, row, line, look.SMALL, look.DIM if dim else look.TEXT, 0)


def button(ui, label, key="", tip="", name=None, enabled=True):
    """Show a button, with its shortcut `key` if there is room; return whether it was pressed."""
    rect = ui.place(ui.theme.px(ROW), ui.theme.px(GAP))
    key = key_name(key)
    tip = f"{tip or label}  ({key})" if key else tip
    me = ui.claim(name or label, rect, keys=PUSH_KEYS, tip=tip, live=enabled)
    body(ui, rect, me, enabled)
    _button_words(ui, rect, label, key, look.TEXT if enabled else look.FAINT)
    return pushes(me, rect) > 0


def pushes(me, rect):
    """Count how often a control was clicked (pressed and released inside `rect`) or pushed by key."""
    return sum(
        (event.kind == "key" and event.key in PUSH_KEYS) or (event.kind == "release" and rect.collidepoint(event.pos))
        for event in me.events
    )


def body(ui, rect, me, enabled=True):
    """Draw the raised or pressed body of a button."""
    colour = look.PRESSED if me.held else look.HOVER if me.hover and enabled else look.RAISED
    ui.stroke(draw_list.box, rect, colour, ui.theme.px(4))


def _button_words(ui, rect, label, key, colour):
    """Write the label in the middle, or where there is room for the key at the left and the key at the right."""
    px, width = ui.theme.px, ui.theme.width
    hint, wide = width(key, look.SMALL), width(label, look.BODY)
    inner = rect.inflate(-2 * px(INSET if wide + 2 * px(INSET) <= rect.width else LEAST_INSET), 0)
    if key and wide + px(ASIDE) + hint <= inner.width:
        ui.stroke(draw_list.words, inner, key, look.SMALL, look.FAINT, 1)
        inner = pygame.Rect(inner.x, inner.y, wide, inner.height)
    ui.stroke(draw_list.words, inner, label, look.BODY, colour, 0.5)


def fits(ui, label, width):
    """Return whether a label has room on a button so many pixels wide."""
    return ui.theme.width(label, look.BODY) + 2 * ui.theme.px(LEAST_INSET) <= width


def toggle(ui, label, on, tip="", name=None):
    """Show a switch; return whether it is on."""
    px = ui.theme.px
    rect = ui.place(px(ROW), 0)
    me = ui.claim(name or label, ui.bleed(rect), keys=PUSH_KEYS, tip=tip)
    on = bool(on) != bool(pushes(me, ui.bleed(rect)) % 2)
    height = 2 * px(8)
    pill = pygame.Rect(rect.right - 2 * height + px(3), rect.centery - height // 2, 2 * height - px(3), height)
    words = pygame.Rect(rect.x, rect.y, pill.x - rect.x - px(INSET), rect.height)
    ui.stroke(draw_list.words, words, label, look.BODY, look.TEXT, 0)
    ui.stroke(draw_list.box, pill, look.ACCENT if on else look.EDGE if me.hover else look.GROOVE, height)
    edge = px(2)
    knob = pygame.Rect(pill.right - height + edge if on else pill.x + edge, pill.y + edge, *[height - 2 * edge] * 2)
    bright = look.BRIGHT_HANDLE if me.hover else look.HANDLE
    ui.stroke(draw_list.disc, knob, bright if on else look.TEXT if me.hover else look.DIM)
    return on


def fold(ui, label, is_open, tip="", name=None):
    """Show the header of a section that folds away; return whether it is open."""
    px = ui.theme.px
    rect = ui.place(px(ROW), 0)
    me = ui.claim(name or label, ui.bleed(rect), keys=PUSH_KEYS | {pygame.K_LEFT, pygame.K_RIGHT}, tip=tip)
    is_open = bool(is_open) != bool(pushes(me, ui.bleed(rect)) % 2)
    for event in me.events:
        if event.kind == "key" and event.key in (pygame.K_LEFT, pygame.K_RIGHT):
            is_open = event.key == pygame.K_RIGHT
    size = px(10)
    chevron = pygame.Rect(rect.x, rect.centery - size // 2, size, size)
    points = draw_list.CHEVRON_DOWN if is_open else draw_list.CHEVRON_RIGHT
    ui.stroke(draw_list.polygon, chevron, points, look.ACCENT if me.hover else look.DIM)
    words = pygame.Rect(rect.x + size + px(INSET), rect.y, rect.width - size - px(INSET), rect.height)
    ui.stroke(draw_list.words, words, label, look.BODY, look.TEXT, 0)
    return is_open


def segmented(ui, label, options, index, tip="", name=None):
    """Show a few options side by side; return the index of the chosen one."""
    px = ui.theme.px
    wanted = len(options) * (max(ui.theme.width(each, look.BODY) for each in options) + 2 * px(INSET))
    label_width = ui.label_width
    inline = label_width + wanted <= ui.width
    rect = ui.place(px(ROW) * (1 if inline else 2), px(GAP))
    bar = pygame.Rect(rect.x, rect.bottom - px(ROW), rect.width, px(ROW))
    words = pygame.Rect(rect.x, rect.y, label_width if inline else rect.width, px(ROW))
    if inline:
        bar.x, bar.width = rect.x + label_width, rect.width - label_width
    edges = [bar.x + bar.width * i // len(options) for i in range(len(options) + 1)]
    parts = [pygame.Rect(x, bar.y, right - x, bar.height) for x, right in itertools.pairwise(edges)]
    me = ui.claim(name or label, rect, ring=bar, parts=tuple(parts), keys=END_KEYS | set(SEGMENT_KEYS), tip=tip)
    for event in me.events:
        index = _segment(event, parts, index)
    ui.stroke(draw_list.words, words, label, look.BODY, look.TEXT, 0)
    ui.stroke(draw_list.box, bar, look.SUNKEN, px(4))
    for i, (part, option) in enumerate(zip(parts, options, strict=True)):
        if i == index:
            ui.stroke(draw_list.box, part.inflate(-2 * px(2), -2 * px(2)), look.EDGE if me.hover else look.HOVER, px(3))
        colour = look.HANDLE if i == index else look.TEXT if me.hover else look.DIM
        ui.stroke(draw_list.words, part.inflate(-2 * px(3), 0), option, look.BODY, colour, 0.5)
    return index


def _segment(event, parts, index):
    if event.kind == "key" and event.key in END_KEYS:
        return 0 if event.key == pygame.K_HOME else len(parts) - 1
    if event.kind == "key":
        return min(max(index + SEGMENT_KEYS[event.key], 0), len(parts) - 1)
    part = part_there(event.part, len(parts)) if event.kind == "press" else None
    return index if part is None else part


def part_there(part, count):
    """Return the number of a part that an event of the last frame names, or None if there is no such part any more."""
    return part if part is not None and part < count else None
