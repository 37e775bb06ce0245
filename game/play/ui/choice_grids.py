"""The grid: one choice of several, as buttons in rows; a control of a panel as those in `controls` are."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.controls import GAP, ROW

INSET = 6  # from the edge of a button to its word


def grid(ui, name, options, index, columns, tips=()):
    """Show options in rows of `columns`; return the index of the chosen one. The tip is that of the one pointed at."""
    px = ui.theme.px
    widest = max(ui.theme.width(option, look.BODY) for option in options) + 2 * px(INSET)
    columns = max(1, min(columns, ui.width // widest))
    rows = -(-len(options) // columns)
    rect = ui.place(px(ROW) * rows, px(GAP))
    parts = tuple(_part(rect, place, columns, px(ROW)) for place in range(len(options)))
    steps = {pygame.K_LEFT: -1, pygame.K_RIGHT: 1, pygame.K_UP: -columns, pygame.K_DOWN: columns}
    steps |= {pygame.K_HOME: -len(options), pygame.K_END: len(options)}
    pointed = ui.focus.pointed_part(name)
    tip = tips[index if pointed is None else pointed] if tips else ""
    me = ui.claim(name, rect, parts=parts, keys=frozenset(steps), tip=tip)
    for act in me.acts:
        index = _chosen(act, steps, index, len(options))
    ui.stroke(draw_list.box, rect, look.SUNKEN, px(4))
    for number, (part, option) in enumerate(zip(parts, options, strict=True)):
        if number == index:
            ui.stroke(draw_list.box, part.inflate(-2 * px(2), -2 * px(2)), look.EDGE if me.hover else look.HOVER, px(3))
        colour = look.HANDLE if number == index else look.TEXT if me.hover and number == pointed else look.DIM
        ui.stroke(draw_list.words, part.inflate(-2 * px(3), 0), option, look.BODY, colour, 0.5)
    return index


def _part(rect, place, columns, height):
    row, column = divmod(place, columns)
    left, right = (rect.x + rect.width * edge // columns for edge in (column, column + 1))
    return pygame.Rect(left, rect.y + row * height, right - left, height)


def _chosen(act, steps, index, count):
    if act.kind == "key":
        goal = index + steps[act.key]
        far = act.key in (pygame.K_HOME, pygame.K_END)
        return min(max(goal, 0), count - 1) if far or 0 <= goal < count else index
    return act.part if act.kind == "press" and act.part is not None else index
