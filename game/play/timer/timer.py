"""The timer: an hourglass that is one. Its last grain falls on time by the wall clock, whatever becomes of frames."""

from game.play.timer.chime import chime
from game.play.timer.pace import Pace
from game.play.window.wall_clock import wall_clock
from game.play.window.window import TITLE
from game.world.sand import parameters
from game.world.sand.duration import spell, spell_left
from game.world.sessions.session import SEEK_NS

SLEPT_S = 2.0  # a frame that comes so late was kept from it by more than a busy machine
PATIENCE_S = 5.0  # the longest that the end of the time waits for a plan
LAST_S = 1.0  # a pace for less than this is a rush to the end, and no speed to go on at
SMOOTH = 15  # iterations per second; sand that is slower is seen to jerk
LONG_S = 10.0  # jerky sand is worth a word where it goes on for longer than this
SHARE = 0.6  # of the time, that a machine should need at most to compute what passes in it

OFF, RUNNING, OVER = "off", "running", "over"


class Timer:
    """Counts down, and tells the session how many iterations are due."""

    def __init__(self, toy, clock=wall_clock):
        self._toy = toy
        self.clock = clock  # returns seconds; a test puts its own here
        self.state = OFF
        self.wanted_s = float(parameters.TIMER.default)
        self.said = ""  # how exact the end was
        self.error_s = None  # by how much the last grain was late
        self._began_s = self._frozen_s = None  # the clock's second at which it began, shifted by pauses; while paused
        self._pace = None
        self._was = 0.0  # the time gone by at the last frame
        self._now = 0  # the iteration the last frame came to
        self._asked = self._slept = False  # in this frame; the time passed in sleep
        self._judged = self._told = None  # the plan last judged, and what was found wrong with it
        self._clock = self._speed = None  # the session's clock and the speed given to it
        self._chime = None  # its samples, made beside the frames
        self._own = None  # the clock that goes at the timer's speed, and its own, to be given back

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
        """Want another time; a timer that runs has been running for as long as before."""
        self.wanted_s, self._pace = parameters.TIMER.check(seconds), None

    @property
    def words(self):
        """What there is to say of it in a glance, or ""."""
        return f"{spell_left(self.left_s)} left" if self.state == RUNNING else ""

    def start(self):
        """Start counting down."""
        self.state, self.said, self.error_s = RUNNING, "", None
        self._began_s, self._frozen_s = self.clock(), None
        self._pace, self._was, self._slept = None, 0.0, False
        self._judged = self._told = self._clock = None
        if self._chime is None:
            self._toy.background.do(chime, self._keep_chime)
        self._toy.glow.stop()

    def stop(self):
        """Stop, and give the session its own speed back."""
        self._give_back()
        self.state, self.said = OFF, ""
        self._toy.glow.stop()
        self._toy.display.window.set_title(TITLE)

    @property
    def own_speed(self):
        """The speed of the session's clock, or what it has to get back when the timer ends."""
        clock = self._toy.sessions.now.clock
        return self._own[1] if self._own and self._own[0] is clock else clock.speed

    def turned(self):
        """Hear that the glass was turned over: after the end that starts the time again."""
        if self.state == OVER:
            self.start()

    def due(self):
        """Return how many iterations the session is to run in this frame, or None where its own clock tells."""
        session = self._toy.sessions.now
        if self.state != RUNNING or session.paused:
            return None
        self._asked = True
        ending, holds = self._toy.planner.newest, self._current() is not None
        if ending is None or ending.endless or session.now >= ending.at:
            return None
        gone_s = self.gone_s
        if holds and gone_s >= self.wanted_s and gone_s - self._was > SLEPT_S:
            self._slept = True
            session.seek(ending.at, SEEK_NS)
            return 0
        if self._pace is None or self._pace.end != ending.at or session.now != self._now:
            self._pace = Pace(self._was, session.now, self.wanted_s, ending.at)
        self._set_speed()
        return max(0, self._pace.at(gone_s) - session.now)

    def update(self, now_s):
        """Look at a frame that was shown: let pauses not count, tell the time left, and see whether it is over."""
        if self.state != RUNNING:
            return
        session = self._toy.sessions.now
        self._hold(session.paused)
        if not self._asked:
            self._pace = None
        self._asked, self._now, self._was = False, session.now, self.gone_s
        self._tell_of(self._current())
        if self._is_over():
            self._end(now_s)
        else:
            self._toy.display.window.set_title(f"{spell_left(self.left_s)} – {TITLE}")

    def _set_speed(self):
        """Let the session's speed be what the timer makes it, so that the sand settles at that once it is through."""
        clock = self._toy.sessions.now.clock
        if self._own is None or clock is not self._own[0]:
            self._give_back()
            self._own = clock, clock.speed
        if clock is self._clock and clock.speed != self._speed:
            self._toy.notices.say("The timer sets the pace; T stops it.")
        if self.wanted_s - self._pace.from_s > LAST_S:
            speed = self._pace.iterations_per_second
            speed = round(speed) if speed > SMOOTH else speed
            self._speed = min(max(speed, parameters.SPEED.low), parameters.SPEED.high)
        elif clock is not self._clock:
            self._speed = clock.speed
        self._clock, clock.speed = clock, self._speed

    def _give_back(self):
        """Let the clock that goes at the timer's speed go at its own again; by now another one may be played by."""
        if self._own:
            clock, speed = self._own
            clock.speed, self._own = speed, None

    def _current(self):
        """Return the RunOut that holds, or None while it is being worked out."""
        return self._toy.planner.ask()

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
        ending = self._current()
        if ending is None:
            return self.gone_s > self.wanted_s + PATIENCE_S
        return ending.endless or (
            self._toy.sessions.now.timeline.goal is None and self._toy.sessions.now.now >= ending.at
        )

    def _end(self, now_s):
        toy, gone_s = self._toy, self.gone_s
        self.state, self.error_s = OVER, gone_s - self.wanted_s
        self.said = self._account(self._current(), gone_s)
        self._pace = None
        toy.window.set_title(f"{spell(self.wanted_s)} is over – {TITLE}")
        toy.notices.say(self.said)
        toy.glow.start(now_s)
        if toy.settings["chime"] and self._chime is not None:
            toy.audio.play(self._chime, toy.settings["volume"])

    def _account(self, ending, gone_s):
        """Return how exact the end was, in words."""
        wanted = spell(self.wanted_s)
        if self._slept:
            return f"{wanted} was over {spell(self.error_s)} ago, while the computer slept."
        if ending is None:
            return f"{wanted} is over; when the sand will be through was not found in time."
        if ending.endless:
            return f"{wanted} is over; this sand comes to no end that can be foreseen."
        if ending.iterations == 0 or self._toy.sessions.now.now > ending.at:
            return f"{wanted} is over; {'the sand could not pass' if ending.left else 'no sand was left'} to tell it."
        return f"The last grain fell at {spell(gone_s, 2)}, {self.error_s:.2f} s late."

    def _keep_chime(self, samples):
        self._chime = samples

    def _tell_of(self, ending):
        """Say in one line what is wrong with a new plan, unless the one before had the same fault."""
        if ending is None or ending is self._judged or self.gone_s >= self.wanted_s:
            return
        self._judged = ending
        reason, words = self._doubt(ending) or (None, "")
        if words and reason != self._told:
            self._toy.notices.say(words, holds=lambda: self.state == RUNNING and self._told == reason)
        self._told = reason

    def _doubt(self, ending):
        """Return (reason, line) for a plan that will not do, or None."""
        if ending.endless:
            return "endless", "This sand does not come to an end that can be foreseen: the timer only counts."
        if self._toy.sessions.now.now >= ending.at and ending.left:
            return "stuck", "The sand above the neck cannot pass it: the timer only counts."
        if self._toy.sessions.now.now >= ending.at:
            return "nothing", "No sand is above the neck: turn the glass over (F), or the timer only counts."
        left_s = self.left_s
        pace = (ending.at - self._toy.sessions.now.now) / left_s
        needed_s = (ending.at - self._toy.sessions.now.now) * ending.iteration_ns / 1e9
        if needed_s > SHARE * left_s:
            return "slow", f"This machine needs about {spell(needed_s / SHARE)} for this glass: it will be late."
        if pace < SMOOTH and left_s > LONG_S:
            return "jerky", f"Only {pace:.1f} iterations a second: a larger glass (in the panel) flows evenly."
        if not ending.has_neck:
            return "neckless", "There is no one neck here: the timer ends when all sand lies still."
        return None
