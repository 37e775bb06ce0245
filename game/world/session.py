"""A scene being played: world, rule and clock. The window and the headless run go through the same frames."""

import time

from game.world.action import Load, apply
from game.world.advance import advance
from game.world.clock import Clock

BUDGET_NS = 16_000_000  # what a frame may take, 60 of them being shown in a second
SLICE_NS = 1_000_000  # how much work is done between two looks at the time; more overruns the budget, less costs calls


class Session:
    """A world that runs in frames and takes actions."""

    def __init__(self, scene, seed=0):
        self.scene = scene
        self.seed = seed
        self.paused = False
        self.clock = Clock(scene.speed)
        self.world, self.rule = scene.world(seed), scene.rule
        self.due = self.done = 0  # iterations of the last frame: wanted, and run
        self._iteration_ns = 0.0  # what one iteration took lately

    def do(self, action):
        """Apply an action to the world and the rule."""
        if isinstance(action, Load):
            self.scene, self.seed, self.clock = action.scene, action.seed, Clock(action.scene.speed)
        self.world, self.rule = apply(action, self.world, self.rule)

    def frame(self, elapsed_ns, budget_ns=None):
        """Run the iterations that fell due in `elapsed_ns` and return their number.

        With a budget, what does not fit in it is left out for good, so that slow frames never pile up; `due` then
        exceeds `done`. Without one the result is a function of the elapsed times alone.
        """
        self.due = 0 if self.paused else self.clock.due(elapsed_ns)
        self.done = self.due if budget_ns is None else 0
        if budget_ns is None:
            advance(self.world, self.rule, self.due)
        elif self.due:
            self._run_within(budget_ns)
        return self.done

    def step(self):
        """Run one iteration, paused or not."""
        advance(self.world, self.rule, 1)

    def _run_within(self, budget_ns):
        start = now = time.perf_counter_ns()
        while self.done < self.due and (not self.done or now - start + self._iteration_ns < budget_ns):
            fitting = int(SLICE_NS / self._iteration_ns) if self._iteration_ns else 1
            some = min(max(fitting, 1), self.due - self.done)
            advance(self.world, self.rule, some)
            before, now = now, time.perf_counter_ns()
            self._iteration_ns = (now - before) / some
            self.done += some
