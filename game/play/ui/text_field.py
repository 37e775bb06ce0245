"""The text field: a label, and a line of text that is typed where the keyboard is on it."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.controls import GAP, INSET, ROW
from game.play.ui.text_line import TYPING_KEYS

CARET = "|"


def text_field(ui, label, line, tip=""):
    """Show a field with a TextLine; return it as it has been typed."""
    px = ui.theme.px
    rect, label_width = ui.place(px(ROW), px(GAP)), ui.label_width
    body = pygame.Rect(rect.x + label_width, rect.y, rect.width - label_width, rect.height)
    me = ui.claim(label, rect, ring=body, keys=TYPING_KEYS, tip=tip, typed=True)
    for event in me.events:
        if event.kind == "key":
            line = line.typed(event.key, event.text)
        elif event.kind == "press":
            line = line._replace(fresh=not event.again and line.fresh)
    writes, inner = ui.focus.name == me.name, body.inflate(-2 * px(INSET), 0)
    ui.stroke(draw_list.words, pygame.Rect(rect.x, rect.y, label_width, rect.height), label, look.BODY, look.TEXT, 0)
    ui.stroke(draw_list.box, body, look.EDGE if me.hover else look.SUNKEN, px(4))
    if writes and line.fresh and line.text:
        marked = pygame.Rect(inner.x - px(2), inner.y + px(4), 0, inner.height - 2 * px(4))
        marked.width = min(ui.theme.width(line.text, look.BODY), inner.width) + 2 * px(2)
        ui.stroke(draw_list.box, marked, look.HOVER, px(3))
    shown = _end_of(ui.theme, line.text + CARET * (writes and not line.fresh), inner.width)
    ui.stroke(draw_list.words, inner, shown, look.BODY, look.HANDLE, 0)
    return line


def _end_of(theme, text, width):
    """Return as much of the end of a text as there is room for."""
    while len(text) > 1 and theme.width(text, look.BODY) > width:
        text = text[1:]
    return text
