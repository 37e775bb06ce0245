"""The speed guard: lets the session's clock go at the timer's speed, and gives it its own back."""


class SpeedGuard:
    """Holds the clock of the session that is played, until it is released or another session takes its place."""

    def __init__(self, sessions):
        self._sessions = sessions
        self._own = None  # (the clock that is held, its own speed)
        self._given = None, None  # the clock and the speed that it was given last

    @property
    def own_speed(self):
        """The speed of the session's clock, or what it will be given back."""
        clock = self._sessions.now.clock
        return self._own[1] if self._own and self._own[0] is clock else clock.speed

    def begin(self):
        """Take whatever speed the clock has for given."""
        self._given = None, None

    def hold(self, speed=None):
        """Give the clock a speed, or the one before; return whether somebody else has changed it meanwhile."""
        clock, (before, given) = self._sessions.now.clock, self._given
        if self._own is None or clock is not self._own[0]:
            self.release()
            self._own = clock, clock.speed
        if clock is not before:
            given = clock.speed
        changed = clock.speed != given
        clock.speed = given if speed is None else speed
        self._given = clock, clock.speed
        return changed

    def release(self):
        """Give the clock that is held its own speed back, whichever session is played by now."""
        if self._own:
            clock, speed = self._own
            clock.speed, self._own = speed, None
