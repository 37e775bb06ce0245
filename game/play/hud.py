"""The HUD: one line under the sand that says how fast it runs."""

from collections import deque

import pygame

from game.play.ui import paint
from game.play.ui import theme as look
from game.world.session import BUDGET_NS

HEIGHT = 30  # pixels at scale 1
REFRESH_S = 0.25  # the figures are means over this time, so that they can be read


class Hud:
    """Gathers what frames took and shows it."""

    def __init__(self, theme):
        self.theme = theme
        self._frames = deque()  # of the current stretch: (work in ns, iterations due, iterations done)
        self._since_s = None
        self._left, self._late = "", False

    def count(self, work_ns, due, done, grains, now_s):
        """Take in one frame: the time it worked, its iterations, and the grains (a function) at time now_s."""
        self._frames.append((work_ns, due, done))
        self._since_s = now_s if self._since_s is None else self._since_s
        stretch = now_s - self._since_s
        if stretch >= REFRESH_S:
            self._refresh(stretch, grains())
            self._frames.clear()
            self._since_s = now_s

    def _refresh(self, stretch, grains):
        work, due, done = (sum(column) for column in zip(*self._frames, strict=True))
        frame_ms = work / len(self._frames) / 1e6
        self._late = done < due
        pace = f"{done / stretch:,.0f} iterations/s"
        if self._late:
            pace = f"{done / stretch:,.0f} of {due / stretch:,.0f} iterations/s: the frame is full"
        fps = f"{len(self._frames) / stretch:.0f} fps"
        self._left = f"{fps}    {frame_ms:.1f} of {BUDGET_NS / 1e6:.0f} ms    {pace}    {grains:,} grains"

    def drawing(self, rect, paused):
        """Return the strokes of the line in `rect`: a value that changes only when the line does."""
        px = self.theme.px
        words = pygame.Rect(rect).inflate(-2 * px(12), 0)
        said = f"Paused    {self._left.split('    ')[-1]}" if paused else self._left
        colour = look.ACCENT if self._late and not paused else look.DIM
        key = "F1  all keys"
        line = [
            (paint.fill, tuple(rect), look.SUNKEN),
            (paint.words, tuple(words), said, look.SMALL, colour, 0),
        ]
        if self.theme.width(said, look.SMALL) + px(24) + self.theme.width(key, look.SMALL) <= words.width:
            line.append((paint.words, tuple(words), key, look.SMALL, look.FAINT, 1))
        return line
