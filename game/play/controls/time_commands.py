"""The commands for time: how fast it goes, where it stops, and what is undone."""

from game.play.timer.timer import RUNNING
from game.world.sand import parameters
from game.world.sand.duration import spell_left
from game.world.sessions.session import SEEK_NS

HALT = parameters.Knob("t", 200, 1, 1_000_000, "", "iteration at which time stands still", True, ("early", "late"))
FASTER = 2**0.5  # what one press of + does to the speed


class TimeCommands:
    """The keys and buttons of time."""

    def __init__(self, sessions, notices, keys, fast_forward, timer):
        self._sessions, self._notices, self._keys = sessions, notices, keys
        self._fast_forward, self._timer = fast_forward, timer
        self.halt_at = HALT.default  # the iteration of the world that `run_to` goes to
        self.undo_goes_back = False  # undo goes to the moment of the act that it undoes

    def pause(self):
        """Hold time, or let it go on."""
        session = self._sessions.now
        session.paused, session.halt_at = not session.paused, None

    def step(self):
        """Run one iteration and hold time."""
        self._sessions.now.paused = True
        self._sessions.slowly("Running one iteration …", self._step)

    def faster(self):
        """Speed time up by half."""
        self._change_speed(FASTER)

    def slower(self):
        """Slow time down by a third."""
        self._change_speed(1 / FASTER)

    def settle(self):
        """Run until nothing can move any more."""
        self._fast_forward.settle()

    def await_flow(self):
        """Run until a grain next passes the neck."""
        self._sessions.slowly("Looking for the neck …", self._fast_forward.await_flow)

    def run_to(self):
        """Run to an iteration of the world, or go back to it, and hold time there."""
        session = self._sessions.now
        if self._sessions.ready():
            at = session.now - session.world.iteration + self.halt_at
            if at > session.now:
                session.paused, session.halt_at = False, at
            else:
                session.paused = True
                self._sessions.slowly("Computing the sand …", lambda: session.seek(at, SEEK_NS))

    def toggle_timer(self):
        """Start the timer, or stop it."""
        if self._timer.state == RUNNING:
            self._notices.say(f"The timer was stopped with {spell_left(self._timer.left_s)} left.")
            self._timer.stop()
        else:
            self._timer.start()

    def undo(self):
        """Undo the last act; where a session has none left, go back to the one it was opened over.

        Only a key pressed anew does that, not one held.
        """
        repeats = self._keys.repeats
        self._sessions.slowly("Undoing …", lambda: self._undo(repeats))

    def redo(self):
        """Bring back what was undone last, or the future that was left."""
        self._sessions.slowly("Redoing …", self._redo)

    def _step(self):
        if self._sessions.ready():
            self._sessions.now.step()

    def _undo(self, repeats):
        if self._sessions.now.undo(self.undo_goes_back, SEEK_NS):
            return
        if repeats or not self._sessions.leave():
            self._notices.say("Nothing to undo.")

    def _redo(self):
        if not self._sessions.now.redo(self.undo_goes_back, SEEK_NS):
            self._notices.say("Nothing to redo.")

    def _change_speed(self, factor):
        clock = self._sessions.now.clock
        clock.speed = min(max(clock.speed * factor, parameters.SPEED.low), parameters.SPEED.high)
