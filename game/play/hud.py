"""The HUD: one line under the sand that says how fast it runs, and whether every grain is there."""

from collections import deque

import pygame

from game.play.ui import paint
from game.play.ui import theme as look
from game.world.session import BUDGET_NS
from game.world.snapshot import MEGABYTE

HEIGHT = 30  # pixels at scale 1
REFRESH_S = 0.25  # the figures are means over this time, so that they can be read
GAP = "    "
KEY = "F1  all keys"


class Hud:
    """Gathers what frames took and shows it."""

    def __init__(self, theme):
        self.theme = theme
        self._frames = deque()  # of the current stretch: (work in ns, iterations due, iterations done)
        self._since_s = None
        self._pace, self._books, self._late = [], [], False

    def count(self, work_ns, session, now_s):
        """Take in one frame of `session`: the time it worked, at time now_s."""
        self._frames.append((work_ns, session.due, session.done))
        self._since_s = now_s if self._since_s is None else self._since_s
        stretch = now_s - self._since_s
        if stretch >= REFRESH_S:
            self._refresh(stretch)
            self._books = _books(session)
            self._frames.clear()
            self._since_s = now_s

    def _refresh(self, stretch):
        work, due, done = (sum(column) for column in zip(*self._frames, strict=True))
        frame_ms = work / len(self._frames) / 1e6
        self._late = done < due
        pace = f"{done / stretch:,.0f} iterations/s"
        if self._late:
            pace = f"{done / stretch:,.0f} of {due / stretch:,.0f} iterations/s: the frame is full"
        fps = f"{len(self._frames) / stretch:.0f} fps"
        self._pace = [fps, f"{frame_ms:.1f} of {BUDGET_NS / 1e6:.0f} ms", pace]

    def drawing(self, rect, session, said="", aside=""):
        """Return the strokes of the line in `rect`: a value that changes only when the line does.

        said: goes first, and is to be noticed. aside: goes first where nothing is said.
        """
        px = self.theme.px
        words = pygame.Rect(rect).inflate(-2 * px(12), 0)
        first = [said or aside] if said or aside else []
        if session.now < session.reached:
            first.append(f"{session.now:,} of {session.reached:,}")
        text = self._fitting(first + (["Paused"] if session.paused else self._pace), words.width)
        colour = look.ACCENT if said or (self._late and not session.paused) else look.DIM
        line = [
            (paint.fill, tuple(rect), look.SUNKEN),
            (paint.words, tuple(words), text, look.SMALL, colour, 0),
        ]
        if self.theme.width(text, look.SMALL) + px(24) + self.theme.width(KEY, look.SMALL) <= words.width:
            line.append((paint.words, tuple(words), KEY, look.SMALL, look.FAINT, 1))
        return line

    def _fitting(self, first, room):
        """Return as much of the line as there is room for: the books shortest before they are left out."""
        tries = [[*first, *books] for books in self._books] or [first]
        if first:
            tries += [[*first[:-1], self._books[-1][0]] if self._books else first, first, first[:1]]
        lines = [GAP.join(each) for each in tries]
        return next((line for line in lines if self.theme.width(line, look.SMALL) <= room), lines[-1])


def _books(session):
    """Return what there is to say of grains and memory, from the most to the least of it."""
    account, shelf, now = session.account, session.timeline.shelf, session.world.grains_by_colour  # counted once
    grains, sign = sum(now), "=" if now == account.expected_by_colour else "is not"
    came, went = account.painted + account.poured, account.erased + account.swallowed
    audit = f"{account.start:,} + {came:,} - {went:,} {sign} {grains:,} grains"
    memory = f"past {shelf.bytes / MEGABYTE:.1f} of {shelf.budget / MEGABYTE:,.0f} MB"
    return [audit, memory], [audit], [f"{grains:,} grains"]
