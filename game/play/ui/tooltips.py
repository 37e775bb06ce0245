"""Tips: when the person has rested on a control for long enough, and the drawing of its tip."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look

LATER_S = 0.5  # the pointer or the keyboard rests this long on a control before its tip shows
INSET, EDGE = 8, 5  # from the box to the words, sideways and above, at scale 1


class Rest:
    """Since when the person has been on the same control."""

    def __init__(self):
        self._name, self._since_s, self._now_s, self._hushed = None, 0.0, 0.0, False

    def on(self, name, now_s, busy):
        """Note the control that the person is on, or None; `busy` with it, no tip will show until it is left."""
        if name != self._name:
            self._name, self._since_s, self._hushed = name, now_s, False
        self._now_s = now_s
        self._hushed = self._hushed or busy

    @property
    def name(self):
        """The control whose tip is to show now, or None."""
        return self._name if not self._hushed and self._now_s - self._since_s >= LATER_S else None


def strokes(theme, slot, view):
    """Yield the drawing of a control's tip: below it, or above where there is no room, inside `view`."""
    px, height = theme.px, theme.line_height(look.SMALL)
    inset, edge, margin = px(INSET), px(EDGE), px(4)
    lines = theme.lines(slot.tip, look.SMALL, view.width - 2 * (inset + 2 * margin))
    width = max(theme.width(line, look.SMALL) for line in lines) + 2 * inset
    box = pygame.Rect(slot.rect.x, slot.rect.bottom + margin, width, len(lines) * height + 2 * edge)
    if box.bottom > view.bottom - margin:
        box.bottom = slot.rect.top - margin
    box.clamp_ip(view.inflate(-2 * margin, -2 * margin))
    yield draw_list.box, box.inflate(2 * px(1), 2 * px(1)), look.EDGE, px(5)
    yield draw_list.box, box, look.SUNKEN, px(4)
    for index, line in enumerate(lines):
        row = pygame.Rect(box.x + inset, box.y + edge + index * height, box.width - 2 * inset, height)
        yield draw_list.words, row, line, look.SMALL, look.TEXT, 0
