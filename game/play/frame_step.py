"""Stepping: the iterations of one frame, forwards, or on the way to another moment."""

import time

from game.play.view.frame_stats import own_ns
from game.world.looks.motion_samples import MotionSamples
from game.world.sessions.session import BUDGET_NS, SEEK_NS

LEAST_STEPPING_NS = 2_000_000  # left to the sand even where the rest of a frame has spent the budget
LONG_WAY_S = 0.3  # a way to another moment that takes longer is shown


class Stepping:
    """Moves the session by what a frame's time is worth, within what the frame's other work leaves of its budget."""

    def __init__(self, toy):
        self._toy = toy
        self.frame_ns = 0  # what the whole of the last frame took
        self.moving_ns = 0  # the work of this thread that moved sand in this frame
        self._own_ns = self._other_ns = 0  # what stepping took in this frame, and anything else in the last one
        self._streams = MotionSamples()
        self._way_since_s = None  # since when another moment is being computed

    @property
    def on_the_way(self):
        """Whether another moment is being computed, and not all of it fitted one frame."""
        return self._way_since_s is not None and bool(self._toy.sessions.now.timeline.goal)

    def step(self, elapsed_ns, now_s):
        """Run what is due; while the glass turns, time stands still."""
        start, worked = time.perf_counter_ns(), own_ns()
        self._run(elapsed_ns, now_s)
        self._own_ns, self.moving_ns = time.perf_counter_ns() - start, own_ns() - worked

    def note(self, work_ns):
        """Take in what the whole frame took."""
        self.frame_ns, self._other_ns = work_ns, work_ns - self._own_ns

    def passing(self, now_s):
        """Return whether the moment that is computed is one on the way, passed too quickly to be worth a look."""
        if self._toy.sessions.now.timeline.goal is None:
            self._way_since_s = None
            return False
        if self._way_since_s is None:
            self._way_since_s = now_s
        return now_s - self._way_since_s < LONG_WAY_S

    def _run(self, elapsed_ns, now_s):
        toy, stage = self._toy, self._toy.display.stage
        toy.sessions.now.timeline.rewinding = toy.rewind.held
        if toy.time_bar.held or toy.rewind.held:
            if stage.turn:
                stage.end_turn()
            self._go_to_another_moment(elapsed_ns)
            return
        if stage.turn:
            if not stage.turn.over(now_s):
                return
            stage.end_turn()
        toy.sessions.now.streams = self._streams if toy.settings["smooth_streams"] else None
        budget_ns = max(BUDGET_NS - self._other_ns, LEAST_STEPPING_NS)
        due = toy.ahead.due()
        toy.sessions.now.frame(elapsed_ns, budget_ns, toy.timer.due() if due is None else due)

    def _go_to_another_moment(self, elapsed_ns):
        """Follow the time bar's handle or the rewind."""
        toy, session, timeline = self._toy, self._toy.sessions.now, self._toy.sessions.now.timeline
        session.due = session.done = 0
        if toy.time_bar.held:
            goal = toy.time_bar.goal(session)
        else:  # where the last frame did not get, this one goes first
            goal = toy.rewind.goal(session, elapsed_ns) if timeline.goal is None else timeline.goal
        if goal == timeline.goal:
            timeline.catch_up(SEEK_NS)
        elif goal != session.now:
            session.seek(goal, SEEK_NS)
