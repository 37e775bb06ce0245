"""The time bar: a thin line under the sand, from a session's start to the latest moment known; drag it.

It is measured in lively time: an hour at rest takes no room on it.
"""

import numpy as np
import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.world.sessions.action import Flip, Load, Turn
from game.world.sessions.lively_time import LivelyTime

INSET = 16  # from the area's sides to the ends of the line
TRACK = 3
HANDLE = 5  # radius
ACT = 4  # height of the mark of an act above the line
STRONG = 8  # of a flip or a load
LEFT = 1


class TimeBar:
    """Shows where a session is and where its acts are; says where the pointer wants it to be."""

    def __init__(self):
        self.theme = None
        self.area = pygame.Rect(0, 0, 0, 0)
        self.held = False
        self._hover = False
        self._x = 0  # of the pointer that holds the bar
        self.marks, self._time = Marks(), LivelyTime()

    def place(self, area, theme):
        """Lie in `area` of the window from now on."""
        self.area, self.theme = area, theme

    def handle_event(self, event):
        """Take in an event and return whether it was the bar's."""
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == LEFT and self.area.collidepoint(event.pos):
            self.held, self._x = True, event.pos[0]
        elif event.type == pygame.MOUSEMOTION:
            self._hover = self.area.collidepoint(event.pos)
            self._x = event.pos[0]
            return self.held
        elif event.type == pygame.MOUSEBUTTONUP and event.button == LEFT and self.held:
            self.held = False
            self._x = event.pos[0]
        else:
            self._hover = self._hover and event.type != pygame.WINDOWLEAVE
            return False
        return True

    def let_go(self):
        """Forget the pointer: nobody may hear it let go of the bar."""
        self.held = self._hover = False

    def goal(self, session):
        """Return the iteration under the pointer."""
        track = self.track
        share = max((self._x - track.x) / max(1, track.width - 1), 0.0)
        if share >= 1.0:
            return session.reached
        self._time.follow(session.timeline)
        return min(self._time.now_at(share * self._time.up_to(session.reached)), session.reached)

    def drawing(self, session):
        """Return the strokes of the bar: a value that changes only when the bar looks different."""
        px, track = self.theme.px, self.track
        self._time.follow(session.timeline)
        now, reached = self._time.up_to((session.now, session.reached)).tolist()
        reached = max(reached, 1.0)
        here = track.x + round(min(now / reached, 1.0) * (track.width - 1))
        lively = self.held or self._hover
        groove = look.EDGE if lively else look.GROOVE
        strokes = [(draw_list.fill, tuple(self.area), look.SUNKEN), (draw_list.box, tuple(track), groove, track.height)]
        past = (track.x, track.y, here - track.x, track.height)
        strokes.append((draw_list.box, past, look.ACCENT if lively else look.STONE, track.height))
        self.marks.follow(session.timeline.history)
        for ats, high, colour in ((self.marks.acts, ACT, look.FAINT), (self.marks.strong, STRONG, look.ACCENT)):
            if not ats.size:
                continue
            lively_ats = np.minimum(self._time.up_to(ats), reached)
            for x in np.unique((lively_ats * (track.width - 1) / reached).astype(int)).tolist():
                mark = (track.x + x, track.y - px(2) - px(high), px(1), px(high))
                strokes.append((draw_list.fill, mark, colour))
        radius = px(HANDLE) + (px(1) if lively else 0)
        handle = (here - radius, track.centery - radius, 2 * radius, 2 * radius)
        strokes.append((draw_list.disc, handle, look.BRIGHT_HANDLE if lively else look.HANDLE))
        return strokes

    @property
    def track(self):
        """The rect of the line."""
        px = self.theme.px
        wide = max(1, self.area.width - 2 * px(INSET))
        return pygame.Rect(self.area.x + px(INSET), self.area.bottom - px(8), wide, px(TRACK))


class Marks:
    """Where the acts of a history's present line are, kept from frame to frame: a stroke has thousands of segments."""

    def __init__(self):
        self._last = None
        self._acts, self._strong = [], []
        self.acts = self.strong = np.zeros(0, np.int64)  # iterations since the session began

    def follow(self, history):
        """Take in what was done since the last frame."""
        line = history.line
        if line is self._last:
            return
        new, act = [], line
        while act is not None and act is not self._last:
            new.append(act)
            act = act.before
        if act is None:
            self._acts, self._strong = [], []
        for each in reversed(new):
            if isinstance(each.action, Flip | Turn | Load):
                self._strong.append(each.at)
            elif each.action is not None and not each.join:
                self._acts.append(each.at)
        self._last = line
        self.acts, self.strong = (np.array(ats, np.int64) for ats in (self._acts, self._strong))
