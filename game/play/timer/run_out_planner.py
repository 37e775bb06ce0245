"""The run-out planner: works out beside the frames when the sand will have run out, anew after every act."""

import time

from game.world.sessions.run_out import Cancelled, find_run_out

PATIENCE_S = 0.5  # a search that is out of date is cancelled after this; a shorter one still tells the pace
AGAIN_S = 5.0  # from a search that failed for lack of memory to the next


class RunOutPlanner:
    """Knows the session's RunOut. Asking for it never waits."""

    def __init__(self, sessions, background, clock=time.monotonic):
        self._sessions, self._background, self._clock = sessions, background, clock
        self._found = self._of = None  # the last RunOut, and the (timeline, line) that it was found for
        self._searched = None  # the (timeline, line) that a search goes on for
        self._since_s = 0.0
        self._not_before_s = 0.0  # the earliest moment of the next search
        self._cancelled = self._closed = False

    @property
    def newest(self):
        """The RunOut found last for this session, whether it still holds or not, or None."""
        return self._found if self._of is not None and self._of[0] is self._sessions.now.timeline else None

    def ask(self):
        """Return the RunOut from here on, or None while that is being worked out."""
        timeline = self._sessions.now.timeline
        here = timeline, timeline.history.line
        if self._of == here and timeline.now >= self._found.start:
            return self._found
        if self._searched is not None:
            self._cancelled = self._searched != here and self._clock() - self._since_s > PATIENCE_S
        elif timeline.goal is None and self._clock() >= self._not_before_s:
            self._search(here)
        return None

    def close(self):
        """Cancel the search that goes on, and any that follows."""
        self._closed = True

    def _search(self, here):
        self._searched, self._since_s, self._cancelled = here, self._clock(), False
        lookahead = here[0].lookahead()

        def work():
            try:
                return here, find_run_out(lookahead, lambda: self._cancelled or self._closed)
            except Cancelled:
                return None

        self._background.do(work, self._take, self._give_up)

    def _take(self, found):
        self._searched = None
        if found is not None:
            self._of, self._found = found

    def _give_up(self):
        self._searched, self._not_before_s = None, self._clock() + AGAIN_S
