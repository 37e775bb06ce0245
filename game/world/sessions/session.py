"""A session: a scene being played, its clock and its timeline. The window and the headless run play the same frames."""

from game.world.files.atomic import FileError
from game.world.sand import parameters
from game.world.sand.clock import Clock
from game.world.sessions.action import Load
from game.world.sessions.history import REDO, UNDO, WAIT, Entry
from game.world.sessions.run_out import at_rest
from game.world.sessions.timeline import Timeline

FRAMES_PER_SECOND = 60  # shown
BUDGET_NS = 16_000_000  # what a frame may take
SEEK_NS = 30_000_000  # on the way to another moment it may take this long: more than two snapshots are apart


class Session:
    """A world that runs in frames and takes actions, and whose time can be turned back."""

    def __init__(self, scene, seed=0, memory_mb=parameters.MEMORY.default):
        self.timeline = Timeline(scene, seed, memory_mb)
        self.paused = False
        self.clock = Clock(scene.speed)
        self.due = self.done = 0  # iterations of the last frame: wanted, and run
        self.halt_at = None  # the iteration since the session began at which time is to stand still, if any
        self.journal = None  # the Journal that hears of every act, if any
        self.lost_journal = None  # the path of the one that could not be gone on with
        self.trouble = None  # why the journal has stopped, in one line; the sand goes on
        self.streams = None  # the MotionSamples that watch the last iterations of a frame, if any
        self._paced = scene  # whose pace the clock keeps

    @classmethod
    def retold(cls, recording, memory_mb=parameters.MEMORY.default):
        """Return the session of a Recording, at its beginning, with all that was done ahead of it."""
        session = cls(recording.scene, recording.seed, memory_mb)
        session.timeline.retell(recording.entries)
        return session

    @property
    def world(self):
        """The World of this moment: another object after a seek, an undo or a load."""
        return self.timeline.moment.world

    @property
    def rule(self):
        """How sand moves now."""
        return self.timeline.moment.rule

    @property
    def scene(self):
        """The scene loaded last."""
        return self.timeline.moment.scene

    @property
    def seed(self):
        """The seed of the world."""
        return self.world.seed

    @property
    def sessions(self):
        """{name: session} of what is shown side by side: of a comparison several, else this one alone."""
        return {self.scene.title: self}

    @property
    def account(self):
        """The account of grains since the scene was loaded: `account.balanced(world)` must hold."""
        return self.timeline.moment.account

    @property
    def now(self):
        """Iterations since the session began, loads included."""
        return self.timeline.now

    @property
    def reached(self):
        """The latest iteration known: where a slider of time ends."""
        return self.timeline.reached

    def do(self, action, join=False):
        """Apply an action to the world and the rule; `join` makes it one with the act before, for undo.

        Return whether it changed anything, and so is recorded.
        """
        changed = self.timeline.happens(action, join)
        return self._record(action, join, changed, changed and self.timeline.is_back(join))

    def _record(self, action, join, changed, is_back):
        """Record an act that has just happened, as `Timeline.record` does, and return whether it `changed` anything."""
        entry = self.timeline.record(action, join, changed, is_back)
        if entry:
            self._note(entry)
        if isinstance(action, Load):
            self.clock, self._paced = Clock(action.scene.speed), action.scene
        return changed

    def seek(self, now, budget_ns=None):
        """Go to iteration `now` and return whether it is reached; `frame` goes on with what the budget cut off."""
        self.halt_at = None
        arrived = self.timeline.seek(now, budget_ns)
        self._keep_pace()
        return arrived

    @property
    def arrived(self):
        """Whether it is where it should be: no seek is unfinished."""
        return self.timeline.goal is None

    @property
    def at_rest(self):
        """Whether nothing can move any more, for as long as nothing is done."""
        return at_rest(self.world, self.rule)

    @property
    def settled(self):
        """Whether the last iterations have shown that nothing moves any more."""
        return self.world.activity.settled

    def catch_up(self, budget_ns):
        """Go on with an unfinished seek, for about `budget_ns`."""
        self.timeline.catch_up(budget_ns)

    def undo(self, back=False, budget_ns=None):
        """Take back the last act, at this iteration or (`back`) at the act's; return whether there was one."""
        now = self.now
        return self._turn(self.timeline.undo(back, budget_ns), Entry(now, UNDO))

    def redo(self, back=False, budget_ns=None):
        """Bring back the act undone last or the future left last; return whether there was one."""
        now = self.now
        return self._turn(self.timeline.redo(back, budget_ns), Entry(now, REDO))

    def limit_memory(self, memory_mb):
        """Let the snapshots of the past take so much memory at most, in millions of bytes."""
        self.timeline.memory_mb = memory_mb

    def drop_past(self):
        """Drop the snapshots of the past: they form reference cycles, and collecting those is slow."""
        self.timeline.drop_past()

    @property
    def memory_mb(self):
        """The most that the snapshots of the past may take, in millions of bytes."""
        return self.timeline.memory_mb

    @property
    def past_bytes(self):
        """What the snapshots of the past take."""
        return self.timeline.snapshots.bytes

    def frame(self, elapsed_ns, budget_ns=None, due=None):
        """Run the iterations that fell due in `elapsed_ns`, or the `due` ones, paused or not; return their number.

        With a budget, what does not fit in it is left out for good, so that slow frames never pile up; `due` then
        exceeds `done`. Without one the result is a function of the elapsed times alone. While a seek is unfinished the
        frame goes on with it instead.
        """
        if due is None:
            due = 0 if self.paused else self.clock.due(elapsed_ns)
        self.due = due
        if self.timeline.goal is not None:
            before, self.due = self.timeline.moment.now, 0
            self.timeline.catch_up(budget_ns)
            self.done = 0
            return abs(self.timeline.moment.now - before)
        if self.halt_at is not None:
            self.due = min(self.due, max(0, self.halt_at - self.now))
        self.done = self._run(self.due, budget_ns)
        if self.halt_at is not None and self.now >= self.halt_at:
            self.paused, self.halt_at = True, None
        self._keep_pace()
        self._note(Entry(self.now, WAIT))
        return self.done

    def _run(self, iterations, budget_ns):
        if self.streams and self.streams.are_worth(self.world.shape, self.clock.speed):
            return self.streams.run(self.timeline, iterations, budget_ns)
        return self.timeline.run(iterations, budget_ns)

    def step(self):
        """Run one iteration, paused or not."""
        self.timeline.run(1)
        self._keep_pace()

    def _turn(self, turned, entry):
        if turned:
            self._note(entry)
            self._keep_pace()
        return turned

    def _keep_pace(self):
        """Take the pace of the scene that a seek, an undo or a recorded load has brought."""
        if self.scene.speed != self._paced.speed:
            self.clock = Clock(self.scene.speed)
        self._paced = self.scene

    def _note(self, entry):
        """Tell the journal; if it cannot write, let it go and say why, for sand is not lost with it."""
        if self.journal is None:
            return
        try:
            self.journal.note(entry)
        except FileError as error:
            self.trouble, self.lost_journal, self.journal = str(error), self.journal.path, None
