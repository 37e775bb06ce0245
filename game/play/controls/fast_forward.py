"""Fast-forward while a key is held, to rest, or to the next flow."""

import time

import pygame

from game.world.sand.block_events import possible_events
from game.world.sand.neck import find_neck
from game.world.sessions.comparison import Comparison
from game.world.sessions.run_out import at_rest, first_moment
from game.world.sessions.session import FRAMES_PER_SECOND, SEEK_NS

MANY = 2**50  # iterations: more than any frame holds
MOST_TOGETHER = 1024  # of a frame that runs several worlds: all may rest sooner, and that is not looked for
MOST_NAMED = 4  # events that a notice names
SHORTEST_S = 0.3  # what takes less needs no word while it goes on

FIRST_STEP, GROWTH = 4, 1.1  # times the usual iterations of a frame at first, and from frame to frame, while held:
# one can see a glass run out, and yet after a second and a half all that a frame holds is computed

HELD, SETTLING, AWAITING = "held", "settling", "awaiting"
RESTING = "resting"  # the key was let go while the iteration was looked for at which all came to rest


class FastForward:
    """Hears the key, and stops at the very iteration that was looked for, however many a frame had run beyond it."""

    def __init__(self, sessions, background, notices, keys):
        self._sessions, self._background, self._notices, self._keys = sessions, background, notices, keys
        self._mode = None
        self._by_button = False  # it is the panel's button that is held
        self._reached = None  # a function of (world, rule) that says whether what is looked for is there
        self._before = None  # the lookahead at the start of this frame
        self._where = None  # the session, its scene and the lattice in which it began
        self._line = None  # the last act before it began
        self._narrowing = False  # the iteration is being looked for among those of the last frame
        self._start = 0  # the iteration at which it began
        self._step = 0.0  # iterations of a frame while the key is held
        self._rested = None  # the last act before all came to rest under the key that is held
        self._since_s = 0.0

    @property
    def held(self):
        """Whether the key is down."""
        return self._mode == HELD

    @property
    def words(self):
        """What the status line says of it, or ""."""
        if self._mode is None or time.monotonic() - self._since_s < SHORTEST_S:
            return ""
        gone = f"{self._sessions.now.now - self._start:,} iterations"
        return {
            HELD: "Fast forward",
            RESTING: "",
            SETTLING: f"Running to rest: {gone}    Esc stops",
            AWAITING: f"Running to the next flow: {gone}    Esc stops",
        }[self._mode]

    def handle_event(self, event):
        """Take in an event and return whether it was meant for this."""
        if event.type not in (pygame.KEYDOWN, pygame.KEYUP):
            return False
        alone = event.type == pygame.KEYUP or not event.mod & ~pygame.KMOD_NUM & ~pygame.KMOD_CAPS
        if event.key == pygame.K_RIGHT and alone:
            return self._hear_key(event)
        if event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE and self._mode in (SETTLING, AWAITING):
            self._notices.say(f"Stopped after {self._sessions.now.now - self._start:,} iterations.{self._possible()}")
            self.stop()
            return True
        return False

    def let_go(self):
        """End what lasts while a key or the panel's button is held."""
        self._by_button = False
        if self.held:
            self._release()

    def hold(self, down):
        """Hear whether the panel's button is down."""
        if down and self._mode is None:
            self._begin(HELD, at_rest)
        elif not down and self._by_button and self.held:
            self._release()
        self._by_button = down

    def settle(self):
        """Run until nothing can move any more."""
        self._begin(SETTLING, at_rest)

    def await_flow(self):
        """Run until a grain next passes the neck."""
        if not self._sessions.ready():
            return
        world = self._sessions.now.world
        neck = find_neck(world)
        if neck is None:
            self._notices.say("This scene has no single neck.")
            return
        now = neck.grains_above(world)
        self._begin(AWAITING, lambda world, rule: neck.grains_above(world) != now)

    def stop(self):
        """Let time go at its own pace again."""
        self._mode = self._before = None
        self._narrowing = False

    def due(self):
        """Return how many iterations this frame is to try, or None where time goes at its own pace."""
        timeline = self._sessions.now.timeline
        if self._mode is None or timeline.goal is not None:
            return None
        if self._narrowing:
            return 0
        if self._mode == HELD and timeline.history.line is self._rested:
            return None
        if self._mode == AWAITING and timeline.history.line is not self._line:
            self._await_anew()
        if self._mode is None:
            return None
        self._before = timeline.lookahead()
        most = MOST_TOGETHER if isinstance(self._sessions.now, Comparison) else MANY
        if self._mode != HELD:
            return most
        self._step *= GROWTH
        return int(min(self._step, most))

    def update(self, now_s):
        """See what a frame has come to."""
        session = self._sessions.now
        if self._mode is None:
            return
        if self._where != _where(session):
            self.stop()
            return
        session.due = session.done  # as many as the frame holds is not too many
        if self._before is None or self._narrowing:
            return
        found = self._reached(session.world, session.rule) if self._mode == AWAITING else session.at_rest
        if found and self._mode != AWAITING and isinstance(session, Comparison):
            self._arrive(session.now)
        elif found:
            self._narrow()
        elif self._mode == AWAITING and session.at_rest:
            self._notices.say("Nothing more will pass the neck.")
            self.stop()

    def _possible(self):
        """Return what can still happen, in words, where rest was looked for under a rule that need not come to any."""
        session = self._sessions.now
        if self._mode != SETTLING or session.rule.codes.is_sand:
            return ""
        names = possible_events(session.world, session.rule)
        more = f" and {len(names) - MOST_NAMED} more" if len(names) > MOST_NAMED else ""
        return f" Still possible: {', '.join(names[:MOST_NAMED])}{more}." if names else ""

    def _hear_key(self, event):
        if event.type == pygame.KEYUP:
            was = self.held
            if was:
                self._release()
            return was
        if self._keys.has_down(pygame.K_RIGHT):
            return False
        if self._mode is None:
            self._begin(HELD, at_rest)
        return self.held

    def _release(self):
        """End what the key held; where all came to rest is still looked for."""
        if self._narrowing:
            self._mode = RESTING
        else:
            self.stop()

    def _begin(self, mode, reached):
        self.stop()
        if self._sessions.ready():
            self._mode, self._reached = mode, reached
            self._rested = None
            self._step = FIRST_STEP * max(1.0, self._sessions.now.clock.speed / FRAMES_PER_SECOND)
            self._start, self._since_s = self._sessions.now.now, time.monotonic()
            self._where = _where(self._sessions.now)
            self._line = self._sessions.now.timeline.history.line

    def _await_anew(self):
        """Count from here on after an act: it may have put sand above the neck, or the neck elsewhere."""
        here = self._where == _where(self._sessions.now)
        self.stop()
        if here:
            self.await_flow()

    def _narrow(self):
        """Find the first iteration of this frame at which it was so, beside the frames that follow."""
        self._narrowing = True
        lookahead, end, reached = self._before, self._sessions.now.now, self._reached
        timeline = self._sessions.now.timeline
        line = timeline.history.line

        def work():
            return first_moment(lookahead, end, lambda world: reached(world, lookahead.moment.rule))

        def take(found):
            if not self._narrowing:
                return
            if self._sessions.now.timeline is timeline and timeline.history.line is line:
                self._arrive(found)
            else:
                self.stop()

        self._background.do(work, take, self.stop)

    def _arrive(self, at):
        """Go back from where the frame had come to, and say what it took."""
        session, took_s = self._sessions.now, time.monotonic() - self._since_s
        session.seek(at, SEEK_NS)
        session.timeline.forget_beyond()
        if self._mode == HELD:
            self._before, self._narrowing, self._rested = None, False, session.timeline.history.line
            return
        if self._mode == RESTING:
            self.stop()
            return
        gone = f"{at - self._start:,} iterations, computed in {took_s:.2f} s."
        said = {SETTLING: "At rest after", AWAITING: "A grain passes the neck after"}[self._mode]
        if self._mode == AWAITING:
            session.paused = True
            gone += " Time stands still: Space lets it go on."
        self._notices.say("Nothing can move here." if at == self._start else f"{said} {gone}")
        self.stop()


def _where(session):
    return session, session.scene, session.world.shape
