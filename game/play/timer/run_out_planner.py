"""The planner: works out beside the frames when the sand will be through, anew after every act."""

import time

from game.world.sessions.run_out import Cancelled, find_run_out

PATIENCE_S = 0.5  # a search for what is no longer so is given up after this; a shorter one still tells the pace
AGAIN_S = 5.0  # from a search that failed, for want of memory, to the next


class Planner:
    """Knows the session's RunOut; the newest question wins, and nobody waits."""

    def __init__(self, toy):
        self._toy = toy
        self._found = None  # the last RunOut
        self._of = None  # what it was found for
        self._asked = None  # what the search that goes on is for
        self._since_s = 0.0
        self._not_before_s = 0.0  # the earliest moment of the next search
        self._cancelled = False

    @property
    def newest(self):
        """The RunOut found last for this session, whether it still holds or not, or None."""
        return self._found if self._of is not None and self._of[0] is self._toy.sessions.now.timeline else None

    def ask(self):
        """Return the RunOut from here on, or None while that is being worked out."""
        timeline = self._toy.sessions.now.timeline
        here = timeline, timeline.history.line
        if self._of == here and timeline.now >= self._found.start:
            return self._found
        if self._asked is not None:
            self._cancelled = self._asked != here and time.monotonic() - self._since_s > PATIENCE_S
        elif timeline.goal is None and time.monotonic() >= self._not_before_s:
            self._search(here)
        return None

    def _search(self, here):
        self._asked, self._since_s, self._cancelled = here, time.monotonic(), False
        lookahead = here[0].lookahead()

        def work():
            try:
                return here, find_run_out(lookahead, lambda: self._cancelled or not self._toy.running)
            except Cancelled:
                return None

        self._toy.background.do(work, self._take, self._give_up)

    def _take(self, found):
        self._asked = None
        if found is not None:
            self._of, self._found = found

    def _give_up(self):
        self._asked, self._not_before_s = None, time.monotonic() + AGAIN_S
