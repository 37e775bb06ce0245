"""The grids: one choice of several, as buttons in rows or as colours in one row."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.controls import GAP, PUSH_KEYS, ROW, part_there

INSET = 6  # from the edge of a button to its word
BETWEEN = 3  # pixels at scale 1 between two swatches
SWATCH = 9  # before a word
NEAR = 4  # from the edge to a swatch, and from there to the word


def grid(ui, name, options, index, columns, tips, colours=None, on_again=None):
    """Show options in rows of `columns`; return the index of the chosen one. The tip is that of the one pointed at.

    colours: of a swatch before each option, or None where it has none. on_again: called without arguments when the
    chosen option is pressed, or pushed by key.
    """
    px = ui.theme.px
    aside, inset = (px(SWATCH) + px(NEAR), px(NEAR)) if colours else (0, px(INSET))
    widest = max(ui.theme.width(option, look.BODY) for option in options) + 2 * inset + aside
    columns = max(1, min(columns, ui.width // widest))
    me, parts, index, pointed = _claim(ui, name, columns, columns, index, tips, on_again)
    ui.stroke(draw_list.box, parts[0].unionall(parts[1:]), look.SUNKEN, px(4))
    for number, (part, option) in enumerate(zip(parts, options, strict=True)):
        if number == index:
            ui.stroke(draw_list.box, part.inflate(-2 * px(2), -2 * px(2)), look.EDGE if me.hover else look.HOVER, px(3))
        colour = look.HANDLE if number == index else look.TEXT if me.hover and number == pointed else look.DIM
        words = part.inflate(-2 * px(3), 0)
        if colours:
            if colours[number]:
                side = px(SWATCH)
                place = pygame.Rect(part.x + px(NEAR), part.centery - side // 2, side, side)
                ui.stroke(draw_list.box, place.inflate(2, 2), look.EDGE, px(3))
                ui.stroke(draw_list.box, place, colours[number], px(2))
            words = pygame.Rect(part.x + inset + aside, part.y, part.width - inset - aside, part.height)
        ui.stroke(draw_list.words, words, option, look.BODY, colour, 0 if colours else 0.5)
    return index


def swatches(ui, name, fields, index, tips):
    """Show fields in a row, each the tuple of RGB colours it is striped with; return the index of the chosen one."""
    px = ui.theme.px
    me, parts, index, pointed = _claim(ui, name, len(fields), 1, index, tips)
    for number, (part, stripes) in enumerate(zip(parts, fields, strict=True)):
        chosen, hover = number == index, me.hover and number == pointed
        frame = part.inflate(-px(BETWEEN), -px(BETWEEN))
        ui.stroke(draw_list.box, frame, look.HANDLE if chosen else look.EDGE if hover else look.SUNKEN, px(4))
        inner = frame.inflate(-2 * px(2), -2 * px(2))
        for place, colour in enumerate(stripes):
            top, bottom = (inner.y + inner.height * edge // len(stripes) for edge in (place, place + 1))
            ui.stroke(draw_list.fill, pygame.Rect(inner.x, top, inner.width, bottom - top), colour)
    return index


def _claim(ui, name, columns, down, index, tips, on_again=None):
    """Claim a part for each tip, in rows of `columns`; return (claim, parts, chosen index, index pointed at or None).

    down: how far the arrow down goes.
    """
    count, height = len(tips), ui.theme.px(ROW)
    rect = ui.place(height * -(-count // columns), ui.theme.px(GAP))
    parts = tuple(_part(rect, place, columns, height) for place in range(count))
    steps = {pygame.K_LEFT: -1, pygame.K_RIGHT: 1, pygame.K_UP: -down, pygame.K_DOWN: down}
    steps |= {pygame.K_HOME: -count, pygame.K_END: count}
    pointed = part_there(ui.focus.pointed_part(name), count)
    keys = frozenset(steps) | (PUSH_KEYS if on_again else frozenset())
    me = ui.claim(name, rect, parts=parts, keys=keys, tip=tips[index if pointed is None else pointed])
    for event in me.events:
        if on_again and _is_again(event, index):
            on_again()
        elif event.kind != "key" or event.key in steps:
            index = _chosen(event, steps, index, count)
    return me, parts, index, pointed


def _part(rect, place, columns, height):
    row, column = divmod(place, columns)
    left, right = (rect.x + rect.width * edge // columns for edge in (column, column + 1))
    return pygame.Rect(left, rect.y + row * height, right - left, height)


def _is_again(event, index):
    return event.key in PUSH_KEYS if event.kind == "key" else event.kind == "press" and event.part == index


def _chosen(event, steps, index, count):
    if event.kind == "key":
        goal = index + steps[event.key]
        far = event.key in (pygame.K_HOME, pygame.K_END)
        return min(max(goal, 0), count - 1) if far or 0 <= goal < count else index
    part = part_there(event.part, count) if event.kind == "press" else None
    return index if part is None else part
