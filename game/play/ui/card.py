"""A card: a small panel that lies over the sand for a while, with controls in it."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.widgets import Ui

ANSWERS = {pygame.K_RETURN: True, pygame.K_KP_ENTER: True, pygame.K_ESCAPE: False}
TOP = 8  # pixels at scale 1, below the upper edge of the sand
GUESS = 120  # height in pixels at scale 1, until the controls have been laid out
RADIUS = 8
AWAY, PAD = 18, 8  # pixels at scale 1: of lines from the place that they tell of, and in their card


class Card:
    """Controls in a box that is as high as they need, over the sand, which goes on meanwhile."""

    width = 360  # pixels at scale 1

    def __init__(self, display):
        self._display = display
        self.shown = False
        self.ui = None  # the controls, since it was opened for the first time
        self.rect = pygame.Rect(0, 0, 0, 0)

    def let_go(self):
        """Let go of the control that is held."""
        if self.shown:
            self.ui.let_go()

    def _open(self, name=None):
        """Open it anew, with the keyboard at the control of a name."""
        self.shown, self.ui, self.rect = True, Ui(self._display.theme), pygame.Rect(0, 0, 0, 0)
        self.ui.focus.name = name
        self._display.refresh()

    def _close(self):
        self.shown = False
        self._display.refresh()

    def _lay_out(self, events, now_s, mouse_pos):
        """Begin a frame of controls; return the events left over."""
        theme, area = self._display.theme, self._display.layout.sand
        self.ui.theme = theme
        wide = min(theme.px(self.width), area.width - 2 * theme.px(8))
        high = min(self.ui.focus.scroll.content or theme.px(GUESS), area.height - theme.px(TOP))
        rect = pygame.Rect(area.centerx - wide // 2, area.y + theme.px(TOP), wide, high)
        if events or rect != self.rect:
            self._display.refresh()
        self.rect = rect
        return self.ui.begin(rect, events, now_s, mouse_pos)

    def _answer_row(self, label, events):
        """Put two buttons, `label` and Cancel; return the answer, None as long as there is none, and the other events.

        The answer is True or False, by a click, by Enter or by Escape.
        """
        self.ui.row(2)
        clicked = {True: self.ui.button(label, key="Enter"), False: self.ui.button("Cancel", key="Esc")}
        keys = [ANSWERS[event.key] for event in events if _answers(event)]
        answer = next((each for each, here in clicked.items() if here), keys[0] if keys else None)
        return answer, [event for event in events if not _answers(event)]

    def draw(self, surface, theme, _area):
        """End the frame: draw the box and the controls; return the rects that they cover.

        A card that was opened in this frame is not laid out yet, and shows in the next.
        """
        if not self.rect:
            return []
        covered = draw_box(surface, theme, self.rect)
        self.ui.invalidate()
        self.ui.end(surface)
        return covered


def _answers(event):
    return event.type == pygame.KEYDOWN and event.key in ANSWERS


def box_strokes(theme, rect, room):
    """Return the strokes of an empty card, and of nothing in the rest of its `room`."""
    return [
        (draw_list.fill, tuple(room), theme.colours.ground),
        (draw_list.box, tuple(rect), look.EDGE, theme.px(RADIUS)),
        (draw_list.box, tuple(rect.inflate(-2, -2)), look.GROUND, theme.px(RADIUS)),
    ]


def draw_box(surface, theme, rect):
    """Draw an empty card around `rect`; return the rects that it covers."""
    edge = rect.inflate(2 * theme.px(5), 2 * theme.px(5))
    draw_list.box(surface, theme, edge, look.EDGE, theme.px(RADIUS))
    draw_list.box(surface, theme, edge.inflate(-2, -2), look.GROUND, theme.px(RADIUS))
    return [edge]


def draw_lines_near(surface, theme, area, at, lines):
    """Draw a card of lines, (text, colour), beside a place in `area`; return the rects that it covers."""
    px, high = theme.px, theme.line_height(look.SMALL)
    wide = min(max(theme.width(text, look.SMALL) for text, _ in lines), area.width - 4 * px(PAD))
    rect = pygame.Rect(0, 0, wide + 2 * px(PAD), len(lines) * high + px(PAD))
    x, y = at
    rect.topleft = x + px(AWAY), y + px(AWAY)
    if rect.right > area.right - px(PAD):
        rect.right = x - px(AWAY)
    if rect.bottom > area.bottom - px(PAD):
        rect.bottom = y - px(AWAY)
    rect.clamp_ip(area.inflate(-2 * px(PAD), -2 * px(PAD)))
    covered = draw_box(surface, theme, rect)
    for number, (text, colour) in enumerate(lines):
        row = (rect.x + px(PAD), rect.y + px(PAD) // 2 + number * high, wide, high)
        draw_list.words(surface, theme, row, text, look.SMALL, colour, 0)
    return covered
