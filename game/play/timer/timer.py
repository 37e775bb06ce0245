"""The timer: makes the last grain of an hourglass fall on time by the wall clock, however long frames take."""

import math
from dataclasses import dataclass

from game.play.timer.speed_guard import SpeedGuard
from game.play.window.wall_clock import wall_clock
from game.play.window.window import TITLE
from game.world.sand import parameters
from game.world.sand.duration import spell, spell_left
from game.world.sessions.session import SEEK_NS

SLEPT_S = 2.0  # a frame that comes so late was delayed by sleep, not by a busy machine
PATIENCE_S = 5.0  # the longest that the end of the time waits for a plan
LAST_S = 1.0  # a pace for less than this is a rush to the end, and no speed for the time after it
SMOOTH = 15  # iterations per second; sand that is slower is seen to jerk
LONG_S = 10.0  # jerky sand is worth a notice where it goes on for longer than this
SHARE = 0.6  # of the time left that computing the sand may take; where it takes more, frames are late

OFF, RUNNING, OVER = "off", "running", "over"


@dataclass(frozen=True)
class Pace:
    """An even pace from one iteration to another, in seconds of any clock; rounding does not add up."""

    from_s: float
    start: int  # iteration at from_s
    to_s: float
    end: int  # iteration at to_s

    @property
    def iterations_per_second(self):
        """How fast the sand goes; infinite where no time is left."""
        left_s = self.to_s - self.from_s
        return (self.end - self.start) / left_s if left_s > 0 else math.inf

    def at(self, second):
        """Return the iteration that belongs to a second: never `end` before to_s, always from then on."""
        if second >= self.to_s:
            return self.end
        part = max(0.0, second - self.from_s) / (self.to_s - self.from_s)
        return min(self.start + math.floor(part * (self.end - self.start)), self.end - 1)


class Timer:
    """Counts down, and tells the session how many iterations are due."""

    def __init__(self, sessions, planner, notices, set_title, glow, chime, clock=wall_clock):
        self._sessions, self._planner, self._notices = sessions, planner, notices
        self._set_title, self._glow, self._chime = set_title, glow, chime
        self._guard = SpeedGuard(sessions)
        self.clock = clock  # returns seconds; a test puts its own here
        self.state = OFF
        self.wanted_s = float(parameters.TIMER.default)
        self.said = ""  # how accurate the end was
        self.error_s = None  # by how much the last grain was late
        self._ended_in = None  # the scene in which the time was over
        self._began_s = None  # when it began by the clock, shifted by the pauses since
        self._frozen_s = None  # when the pause began, while it is paused
        self._pace = None
        self._before_s = 0.0  # gone_s at the last frame
        self._now = 0  # the iteration at the last frame
        self._asked = self._slept = False  # for what is due in this frame; the time ran out in sleep
        self._judged = self._told = None  # the plan last judged, and what was found wrong with it

    @property
    def gone_s(self):
        """The seconds gone by since the start, without pauses."""
        return (self.clock() if self._frozen_s is None else self._frozen_s) - self._began_s

    @property
    def left_s(self):
        """The seconds that are left."""
        return max(0.0, self.wanted_s - self.gone_s)

    @property
    def iterations_per_second(self):
        """How fast the sand goes, or None while that is not known."""
        return self._pace.iterations_per_second if self._pace else None

    def set(self, seconds):
        """Set another time; what is gone of it stays gone."""
        self.wanted_s, self._pace = parameters.TIMER.check(seconds), None

    @property
    def words(self):
        """The time left, in words, while it runs, or ""."""
        return f"{self.clock_words} left" if self.state == RUNNING else ""

    @property
    def clock_words(self):
        """The time left, as on a clock."""
        return spell_left(self.left_s)

    def start(self):
        """Start counting down."""
        self.state, self.said, self.error_s = RUNNING, "", None
        self._began_s, self._frozen_s = self.clock(), None
        self._pace, self._before_s, self._slept = None, 0.0, False
        self._judged = self._told = None
        self._guard.begin()
        self._chime.prepare()
        self._glow.stop()

    def stop(self):
        """Stop, and give the session its own speed back."""
        self._guard.release()
        self.state, self.said = OFF, ""
        self._glow.stop()
        self._set_title(TITLE)

    @property
    def own_speed(self):
        """The speed of the session's clock, or what it has to get back when the timer ends."""
        return self._guard.own_speed

    def turned(self):
        """Start the time again if it is over: the glass was turned over."""
        if self.state == OVER:
            self.start()

    def due(self):
        """Return how many iterations the session is to run in this frame, or None where its own clock tells."""
        session = self._sessions.now
        if self.state != RUNNING or session.paused:
            return None
        self._asked = True
        run_out, holds = self._planner.newest, self._current() is not None
        if run_out is None or run_out.endless or session.now >= run_out.at:
            return None
        gone_s = self.gone_s
        if holds and gone_s >= self.wanted_s and gone_s - self._before_s > SLEPT_S:
            self._slept = True
            session.seek(run_out.at, SEEK_NS)
            return 0
        if self._pace is None or self._pace.end != run_out.at or session.now != self._now:
            self._pace = Pace(self._before_s, session.now, self.wanted_s, run_out.at)
        self._set_speed()
        return max(0, self._pace.at(gone_s) - session.now)

    def update(self, now_s):
        """After a frame, leave pauses out, show the time left in the title, and end if the time is over.

        A time that is over is forgotten in another scene.
        """
        if self.state == OVER and self._sessions.now.scene is not self._ended_in:
            self.stop()
        if self.state != RUNNING:
            return
        session = self._sessions.now
        self._hold(session.paused)
        if not self._asked:
            self._pace = None
        self._asked, self._now, self._before_s = False, session.now, self.gone_s
        self._tell_of(self._current())
        if self._is_over():
            self._end(now_s)
        else:
            self._set_title(f"{spell_left(self.left_s)} – {TITLE}")

    def _set_speed(self):
        """Let the session go at the timer's speed, so that the sand settles at that once the time is over."""
        speed = None  # as before
        if self.wanted_s - self._pace.from_s > LAST_S:
            speed = self._pace.iterations_per_second
            speed = round(speed) if speed > SMOOTH else speed
            speed = min(max(speed, parameters.SPEED.low), parameters.SPEED.high)
        if self._guard.hold(speed):
            self._notices.say("The timer sets the speed; T stops it.")

    def _current(self):
        """Return the RunOut that holds, or None while it is being worked out."""
        return self._planner.ask()

    def _hold(self, paused):
        if paused and self._frozen_s is None:
            self._frozen_s = self.clock()
        elif not paused and self._frozen_s is not None:
            self._began_s += self.clock() - self._frozen_s
            self._frozen_s = None

    def _is_over(self):
        """Return whether the time is up and the last grain has fallen, if there is any to wait for."""
        if self.gone_s < self.wanted_s:
            return False
        run_out = self._current()
        if run_out is None:
            return self.gone_s > self.wanted_s + PATIENCE_S
        session = self._sessions.now
        return run_out.endless or (session.timeline.goal is None and session.now >= run_out.at)

    def _end(self, now_s):
        gone_s = self.gone_s
        self.state, self.error_s, self._ended_in = OVER, gone_s - self.wanted_s, self._sessions.now.scene
        self.said = self._account(self._current(), gone_s)
        self._pace = None
        self._set_title(f"{spell(self.wanted_s)} is over – {TITLE}")
        self._notices.say(self.said)
        self._glow.start(now_s)
        self._chime.ring()

    def _account(self, run_out, gone_s):
        """Return how accurate the end was, in words."""
        wanted = spell(self.wanted_s)
        if self._slept:
            return f"{wanted} ended {spell(self.error_s)} ago, while the computer slept."
        if run_out is None:
            return f"{wanted} is over. When the glass would run out was not found in time."
        if run_out.endless:
            return f"{wanted} is over. No end of this can be foreseen."
        if run_out.iterations == 0 or self._sessions.now.now > run_out.at:
            return f"{wanted} is over. {'The sand was stuck.' if run_out.left else 'No sand was left to fall.'}"
        return f"The last grain fell at {spell(gone_s, 2)}, {self.error_s:.2f} s late."

    def _tell_of(self, run_out):
        """Say what is wrong with a new plan, unless the same was wrong with the one before."""
        if run_out is None or run_out is self._judged or self.gone_s >= self.wanted_s:
            return
        self._judged = run_out
        reason, words = self._doubt(run_out) or (None, "")
        if words and reason != self._told:
            self._notices.say(words, holds=lambda: self.state == RUNNING and self._told == reason)
        self._told = reason

    def _doubt(self, run_out):
        """Return (reason, line) for a plan that will not do, or None."""
        now, left_s = self._sessions.now.now, self.left_s
        if run_out.endless:
            return "endless", "No end of this can be foreseen: the timer only counts down."
        if now >= run_out.at and not run_out.has_neck:
            return "rest", "All is at rest, and nothing is above a neck: the timer only counts down."
        if now >= run_out.at and run_out.left:
            return "stuck", "What is above the neck is stuck: the timer only counts down."
        if now >= run_out.at:
            return "nothing", "Nothing is above the neck. Turn the glass over (F), or the timer only counts down."
        pace = (run_out.at - now) / left_s
        needed_s = (run_out.at - now) * run_out.iteration_ns / 1e9
        if needed_s > SHARE * left_s:
            return "slow", f"This computer needs about {spell(needed_s / SHARE)} for this glass: it will be late."
        if pace < SMOOTH and left_s > LONG_S:
            return "jerky", f"Only {pace:.1f} iterations a second: a larger glass (in the panel) flows more evenly."
        if not run_out.has_neck:
            return "neckless", "There is no single neck here: the timer ends when all is at rest."
        return None
