"""Notices: one line over the sand that says what happened and goes away."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look

LEAST_S = 4.0
S_PER_LETTER = 0.06  # a longer line takes longer to read
SHORTEST_S = 2.0  # while another line waits
FADE_S = 0.4
HEIGHT = 30  # pixels at scale 1
PAD = 14
MOST_WAITING = 3


class Notices:
    """Lines waiting to be shown, one at a time; what is said twice stays longer."""

    def __init__(self, taken=lambda: 0):
        """`taken`: returns how many pixels at the lower edge of the sand are taken by something else."""
        self._taken = taken
        self._lines = []  # (text, whether it tells of trouble, a function that says whether it holds), the first shown
        self._since_s = None
        self._now_s = 0.0

    def say(self, text, trouble=False, holds=lambda: True):
        """Show a line as long as it holds: at once, unless one that tells of trouble is still to be read."""
        line = str(text), trouble, holds
        if self._lines and self._lines[0][1] and self._lines[0][:2] != line[:2]:
            self._lines = [*self._lines[:MOST_WAITING], line]
        else:
            self._lines, self._since_s = [line], None

    @property
    def text(self):
        """The line that is shown, or None."""
        return self._lines[0][0] if self._lines else None

    @property
    def shown(self):
        """Whether there is a line to draw."""
        return bool(self._lines)

    def pass_time(self, now_s):
        """Let the line age; return whether it looks different now."""
        self._now_s = now_s
        if not self._lines:
            return False
        if self._since_s is None:
            self._since_s = now_s
            return True
        if self._age() > self._stay() + FADE_S or not self._lines[0][2]():
            self._lines, self._since_s = self._lines[1:], None
            return True
        return self._age() > self._stay()

    def draw(self, surface, theme, area):
        """Draw the line above the lower edge of `area`; return the rects that it covers."""
        text, trouble, _ = self._lines[0]
        px = theme.px
        wide = min(theme.width(text, look.BODY) + 2 * px(PAD), area.width - 2 * px(8))
        lines = theme.lines(text, look.BODY, wide - 2 * px(PAD))
        height = px(HEIGHT) + (len(lines) - 1) * theme.line_height(look.BODY)
        sheet = pygame.Surface((wide, height), pygame.SRCALPHA)
        sheet.fill((*theme.rgb(look.RAISED), 0))
        draw_list.box(sheet, theme, (0, 0, wide, height), look.RAISED, px(6))
        row = height // len(lines)
        for number, line in enumerate(lines):
            colour = look.BRIGHT_ACCENT if trouble else look.TEXT
            draw_list.words(
                sheet, theme, (px(PAD), number * row, wide - 2 * px(PAD), row), line, look.BODY, colour, 0.5
            )
        sheet.set_alpha(round(255 * min(1.0, max(0.0, 1 - (self._age() - self._stay()) / FADE_S))))
        return [surface.blit(sheet, (area.centerx - wide // 2, area.bottom - self._taken() - height - px(10)))]

    def _age(self):
        return 0.0 if self._since_s is None else self._now_s - self._since_s

    def _stay(self):
        if len(self._lines) > 1:
            return SHORTEST_S
        return LEAST_S + S_PER_LETTER * len(self._lines[0][0])
