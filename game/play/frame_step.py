"""The frame step: the iterations of one frame, forwards, or on the way to another moment."""

import time
from functools import partial

from game.play.view.frame_stats import own_ns
from game.world.looks.motion_samples import MotionSamples
from game.world.looks.themes import substances_of
from game.world.sessions.session import BUDGET_NS, SEEK_NS

AIM_NS = BUDGET_NS - 3_000_000  # the rest is for what takes longer than foreseen
# How much of what a frame took beside the sand is foreseen for the next: some work comes now and then.
REMEMBERED = 0.97
LEAST_STEPPING_NS = 2_000_000  # left to the sand even where the rest of a frame has spent the budget
LONG_WAY_S = 0.3  # a way to another moment that takes longer is shown


class FrameStep:
    """Moves the session by what a frame's time is worth, within what the frame's other work leaves of its budget."""

    def __init__(self, sessions, display, settings, time_bar, rewind, pacers):
        """`pacers`: the first whose due() is not None tells how many iterations are due, else the session's clock."""
        self._sessions, self._display, self._settings = sessions, display, settings
        self._time_bar, self._rewind, self._pacers = time_bar, rewind, pacers
        self.moving_ns = 0  # the work of this thread that moved sand in this frame
        self._remembered_ns = 0  # the most of this thread's other work lately
        self._own_ns = self._other_ns = 0  # what stepping took in this frame, and anything else lately
        self._streams = MotionSamples()
        self._way_since_s = None  # since when another moment is being computed

    @property
    def words(self):
        """What the status line says while another moment is being computed that did not fit one frame, or ""."""
        timeline = self._sessions.now.timeline
        if self._way_since_s is None or not timeline.goal:
            return ""
        return f"Computing the sand: {100 * timeline.moment.now // timeline.goal} %"

    def step(self, elapsed_ns, now_s):
        """Run what is due; while the glass turns, time stands still."""
        start, worked = time.perf_counter_ns(), own_ns()
        self._run(elapsed_ns, now_s)
        if self._way_since_s is None and self._sessions.now.timeline.goal is not None:
            self._way_since_s = now_s
        self._own_ns, self.moving_ns = time.perf_counter_ns() - start, own_ns() - worked

    def note(self, work_ns, own_work_ns):
        """Take in what the whole frame took, by the wall and of this thread's own work."""
        remembered_ns = min(REMEMBERED * self._remembered_ns, AIM_NS)
        self._remembered_ns = max(own_work_ns - self.moving_ns, remembered_ns)
        self._other_ns = max(work_ns - self._own_ns, self._remembered_ns)

    def passing(self, now_s):
        """Return whether the moment that is computed is one on the way, passed too quickly to be worth a look."""
        if self._sessions.now.timeline.goal is None:
            self._way_since_s = None
            return False
        return now_s - self._way_since_s < LONG_WAY_S

    def _run(self, elapsed_ns, now_s):
        session, view = self._sessions.now, self._display.sand_view
        session.timeline.rewinding = self._rewind.held
        if self._time_bar.held or self._rewind.held:
            if view.turn:
                view.end_turn()
            self._go_to_another_moment(session, elapsed_ns)
            return
        if view.turn:
            if not view.turn.over(now_s):
                return
            view.end_turn()
        drawn = self._settings["smooth_streams"] and not self._display.window.hidden
        session.streams = self._streams_of(session.rule) if drawn else None
        budget_ns, due = max(AIM_NS - self._other_ns, LEAST_STEPPING_NS), self._due()
        frame = partial(session.frame, elapsed_ns, budget_ns, due)
        of_clock = 0 if session.paused else 1 + int(session.clock.speed * elapsed_ns / 1e9)
        if session.timeline.meets(of_clock if due is None else due):
            session.due = session.done = 0
            self._sessions.slowly("Doing again what was done …", frame)
        else:
            frame()

    def _streams_of(self, rule):
        """Return the samples of what falls under a rule, begun anew for other materials."""
        substances = substances_of(rule.definition.materials)
        if substances != self._streams.substances:
            self._streams = MotionSamples(substances)
        return self._streams

    def _due(self):
        for each in self._pacers:
            due = each.due()
            if due is not None:
                return due
        return None

    def _go_to_another_moment(self, session, elapsed_ns):
        """Follow the time bar's handle or the rewind."""
        timeline = session.timeline
        session.due = session.done = 0
        if self._time_bar.held:
            goal = self._time_bar.goal(session)
        else:  # where the last frame did not get, this one goes first
            goal = self._rewind.goal(session, elapsed_ns) if timeline.goal is None else timeline.goal
        if goal == timeline.goal:
            timeline.catch_up(SEEK_NS)
        elif goal != session.now:
            self._sessions.slowly("Computing the sand …", partial(session.seek, goal, SEEK_NS))
