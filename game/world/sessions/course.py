"""The course: where a session is headed, computed apart from it and ahead of it, acts still to come included."""

from dataclasses import replace


class Course:
    """A moment of its own, and the acts that its line has ahead."""

    def __init__(self, moment, acts=()):
        """Take over `moment`; acts: history.Act, the nearest last."""
        self.moment = moment
        self._acts = list(acts)

    @property
    def world(self):
        """The world at this point of the course: another object after an act that loads one."""
        return self.moment.world

    @property
    def now(self):
        """Iterations since the session began."""
        return self.moment.now

    @property
    def last_act(self):
        """The iteration of the last act to come, or None."""
        return self._acts[0].at if self._acts else None

    def copy(self):
        """Return a course of its own from the same point."""
        return Course(replace(self.moment, world=self.moment.world.copy()), self._acts)

    def run_to(self, now):
        """Go on to iteration `now`, after the acts at it."""
        while self._acts and self._acts[-1].at <= now:
            act = self._acts.pop()
            self.moment.run(act.at - self.moment.now)
            self.moment.take(act.action)
        self.moment.run(now - self.moment.now)
