"""The swatches: one colour of several, as little fields in a row; a control of a panel as those in `controls` are."""

from itertools import pairwise

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.controls import GAP, ROW

STEPS = {pygame.K_LEFT: -1, pygame.K_UP: -1, pygame.K_RIGHT: 1, pygame.K_DOWN: 1, pygame.K_HOME: -99, pygame.K_END: 99}
BETWEEN = 3  # pixels at scale 1 between two fields


def swatches(ui, name, fields, index, tips):
    """Show fields in a row, each the tuple of RGB colours it is striped with; return the index of the chosen one."""
    px = ui.theme.px
    rect = ui.place(px(ROW), px(GAP))
    edges = [rect.x + rect.width * number // len(fields) for number in range(len(fields) + 1)]
    parts = tuple(pygame.Rect(left, rect.y, right - left, rect.height) for left, right in pairwise(edges))
    pointed = ui.focus.pointed_part(name)
    tip = tips[index if pointed is None else pointed]
    me = ui.claim(name, rect, parts=parts, keys=frozenset(STEPS), tip=tip)
    for act in me.acts:
        if act.kind == "key":
            index = min(max(index + STEPS[act.key], 0), len(fields) - 1)
        elif act.kind == "press" and act.part is not None:
            index = act.part
    for number, (part, stripes) in enumerate(zip(parts, fields, strict=True)):
        chosen, hover = number == index, me.hover and number == pointed
        frame = part.inflate(-px(BETWEEN), -px(BETWEEN))
        ui.stroke(draw_list.box, frame, look.HANDLE if chosen else look.EDGE if hover else look.SUNKEN, px(4))
        inner = frame.inflate(-2 * px(2), -2 * px(2))
        for place, colour in enumerate(stripes):
            top, bottom = (inner.y + inner.height * edge // len(stripes) for edge in (place, place + 1))
            ui.stroke(draw_list.fill, pygame.Rect(inner.x, top, inner.width, bottom - top), colour)
    return index
