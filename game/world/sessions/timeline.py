"""The timeline: any moment of a session, reached by computing forward from the nearest snapshot."""

import time
from collections import deque
from dataclasses import replace

from game.world.sand import parameters
from game.world.sessions.action import IN_PLACE
from game.world.sessions.history import WITHDRAW, Entry, History
from game.world.sessions.moment import Lookahead, Moment
from game.world.sessions.run_out import at_rest
from game.world.sessions.snapshots import MEGABYTE, Snapshot, SnapshotStore, nearest

# Work between two snapshots: a seek computes no more than that. Half as much doubles the memory for ten minutes of a
# full screen (280 KB each); three times as much makes a rewind stutter.
SPACING_NS = 20_000_000
CLOSE_NS = 4_000_000  # work between two snapshots of the trail: each frame of a rewind computes no more than that
LONGEST_TRAIL = 16  # snapshots; a rewind needs those between here and the nearest one of the store
SHARE = 20  # a snapshot costs at most one part in so many of the work: on a huge lattice it takes long to copy
KEEPING_NS_A_BYTE = 1  # about; a first snapshot of a huge lattice must not hold up the opening of its scene
SLICE_NS = 1_000_000  # work between two looks at the time; more overruns a frame's budget, less costs calls
LONGEST_SLICE = 2048  # iterations: sand at rest costs nothing, and may start to move at any time


class Timeline:
    """A session's moments. The present one is `moment`; the others are a `seek` away."""

    def __init__(self, scene, seed=0, memory_mb=parameters.MEMORY.default):
        self.history = History()
        self.moment = Moment.start(scene, seed)
        self.snapshots = SnapshotStore(memory_mb * MEGABYTE)
        self.goal = None  # the iteration of an unfinished seek
        self.reached = 0  # the last iteration known of the present line
        self.start = scene, seed  # what the session began with
        self.rests = 0  # after how many acts, of all lines, it is known when all came to rest
        self._settled = False  # nothing moved in the last iterations, and what that means is known
        self._here = self.history.root  # the last act that the moment has seen
        self._ahead = []  # acts of the line yet to come, the nearest last
        self._before = None  # the moment before the last act and all that it is joined to, and what was reached then
        self.rewinding = False  # time runs backwards, every frame is an earlier moment: leave a trail on the way there
        self._trail = deque(maxlen=LONGEST_TRAIL)  # snapshots beside those of the store, the earliest first
        self._keeping_ns = 0  # what it took to keep the last snapshot
        self._kept_work_ns = 0  # the moment's work when the last snapshot was kept
        self._iteration_ns = float(SLICE_NS)  # what one took lately; until it is known, they go one by one
        self._slice = 1  # iterations that went together last

    @property
    def now(self):
        """Where the session is, or will be when it has caught up: iterations since it began."""
        return self.moment.now if self.goal is None else self.goal

    @property
    def memory_mb(self):
        """The most that snapshots may take, in millions of bytes."""
        return self.snapshots.budget / MEGABYTE

    @memory_mb.setter
    def memory_mb(self, most):
        self.snapshots.fit(parameters.MEMORY.check(most) * MEGABYTE, self.history.line)

    def drop_past(self):
        """Drop all snapshots: the past is computed anew from the start."""
        self.snapshots.empty()
        self._trail.clear()

    def run(self, iterations, budget_ns=None):
        """Run forward and return by how many iterations; with a budget by fewer, but one at least, where they are slow.

        Acts that the line has on the way happen at their iterations.
        """
        self.catch_up()
        start = self.moment.now
        self._run_to(start + parameters.ITERATIONS.check(iterations), budget_ns)
        return self.moment.now - start

    def do(self, action, join=False):
        """Let an act happen now and return its Entry, or None for one that changes nothing and is not recorded.

        join: undo takes it back together with the act before. In the past a new future begins.
        """
        changed = self.happens(action, join)
        return self.record(action, join, changed, changed and self.is_back(join))

    def happens(self, action, join=False):
        """Let an act happen now and return whether it changed anything; it is still to be recorded."""
        self.catch_up()
        if not (join and self.history.takes_join(self.moment.now)):
            self._before = self.moment.same(), self.reached
        if isinstance(action, IN_PLACE):
            self._before = None
        return self.moment.take(action)

    def is_back(self, join):
        """Return whether the act that has just happened has led back to before the acts that it is to be joined to."""
        joins = join and self._before is not None and self.history.takes_join(self.moment.now)
        return joins and self.moment.is_as(self._before[0])

    def record(self, action, join, changed, is_back):
        """Record the act that has just happened, as `do` does, if it `changed` anything.

        is_back: all that it is joined to comes to nothing with it, and is withdrawn.
        """
        if is_back:
            return self._withdraw()
        if not changed:
            if not join:
                self.history.close()
            return None
        now = self.reached = self.moment.now
        act = self.history.record(action, now, join)
        self._ahead = []
        self._have_seen(act)
        return Entry(now, action, act.join)

    def seek(self, now, budget_ns=None):
        """Go to iteration `now` of the line, after the acts at it; return whether that is done.

        With a budget (ns) a long way is left for `catch_up` to finish.
        """
        self.goal = parameters.MOMENT.check(now)
        self._start_towards(self.goal)
        return self.catch_up(budget_ns)

    def catch_up(self, budget_ns=None):
        """Go on with an unfinished seek, for about `budget_ns`; return whether the session is where it should be."""
        if self.goal is None:
            return True
        if self._run_to(self.goal, budget_ns):
            self.goal = None
        return self.goal is None

    def meets(self, iterations):
        """Return whether an act of the line lies on so many iterations ahead."""
        return bool(self._ahead) and self._ahead[-1].at <= self.moment.now + iterations

    def forget_beyond(self):
        """Let this moment be the latest known, unless the line has acts still to come."""
        self.reached = max(self.now, self.history.line.at)

    def lookahead(self):
        """Return the Lookahead from here on, to be computed apart from the session."""
        self.catch_up()
        return Lookahead(self.moment, self._ahead).copy()

    def undo(self, back=False, budget_ns=None):
        """Take back the last act and return whether there was one; `seek` tells what `budget_ns` does.

        The iteration stays, and the sand is as it would have been; with `back` time goes back to the act as well.
        """
        now = self.now
        parted = self.history.undo(now)
        if parted is not None:
            self._change_line(min(parted, now) if back else now, budget_ns)
        return parted is not None

    def redo(self, back=False, budget_ns=None):
        """Bring back what was undone last, or a future that was left, and return whether there was one.

        With `back` time goes forward to an act that is still to come.
        """
        now = self.now
        parted = self.history.redo(now)
        if parted is not None:
            self._change_line(max(parted, now) if back else now, budget_ns)
        return parted is not None

    def retell(self, entries):
        """Take over the history that entries tell, as a session that has just begun."""
        for entry in entries:
            self.history.obey(entry)
            self.reached = max(self.reached, entry.at)
        self._ahead = self.history.after(self._here)

    def _withdraw(self):
        """Be where the acts joined last began, and return the Entry of that."""
        before, self.reached = self._before
        self.moment, self._before = replace(before, work_ns=self.moment.work_ns), None
        self.history.withdraw()
        self._have_seen(self.history.latest(self.moment.now))
        self._ahead = self.history.after(self._here)
        return Entry(self.moment.now, WITHDRAW)

    def _change_line(self, now, budget_ns):
        self.reached = max(self.reached, self.history.line.at)
        self.seek(now, budget_ns)

    def _start_towards(self, now):
        """Make the present moment the one to compute `now` from: this one, or the nearest snapshot."""
        self._before = None
        target = self.history.latest(now)
        snapshot = self._on_trail(now) or nearest(target, now)
        if not self._leads_to(target, now) or (snapshot and snapshot.now > self.moment.now):
            self.moment = snapshot.moment() if snapshot else Moment.start(*self.start)
            self._here, self._settled = snapshot.act if snapshot else self.history.root, False
            self._kept_work_ns = self.moment.work_ns
        self._ahead = self.history.after(self._here)

    def _leads_to(self, act, now):
        """Return whether iteration `now` after `act` is reached by computing forward from the present moment."""
        while act is not self._here and act.at >= self.moment.now and act.before:
            act = act.before
        return act is self._here and self.moment.now <= now

    def _run_to(self, end, budget_ns=None):
        """Run to iteration `end` and meet the acts on the way; return whether the budget was enough."""
        start, begun = time.perf_counter_ns(), False
        while True:
            while self._ahead and self._ahead[-1].at <= self.moment.now:
                self._meet(self._ahead.pop())
            if self.moment.now >= end:
                break
            spent_ns = time.perf_counter_ns() - start if budget_ns is not None else 0
            if begun and budget_ns is not None and spent_ns + self._iteration_ns >= budget_ns:
                break
            self._run_slice(min(end, self._ahead[-1].at) if self._ahead else end)
            begun = True
        self.reached = max(self.reached, self.moment.now)
        return self.moment.now >= end

    def _run_slice(self, end):
        self._before = None
        wanted = min(LONGEST_SLICE, 2 * self._slice, int(SLICE_NS / self._iteration_ns))
        self._slice = some = min(end - self.moment.now, max(1, wanted))
        self._iteration_ns = max(1.0, self.moment.run(some) / some)
        self._note_rest()
        self._keep_now_and_then()

    def _meet(self, act):
        self.moment.take(act.action)
        self._have_seen(act)

    def _note_rest(self):
        """Note that nothing moves any more until the next act, where the last iterations have shown it first."""
        world, before = self.moment.world, self._settled
        self._settled = world.activity.settled
        if not self._settled or before or self._here.rest_from is not None:
            return
        if not world.fixtures or at_rest(world, self.moment.rule):
            self._here.rest_from = self.moment.now
            self.rests += 1

    def _have_seen(self, act):
        self._here, self._settled = act, False
        self._iteration_ns, self._slice = float(SLICE_NS), 1  # what rested may move now
        self._keep_now_and_then()

    def _keep_now_and_then(self):
        """Keep a snapshot where the last one is far, unless the line has one near."""
        self._leave_trail()
        foreseen_ns = KEEPING_NS_A_BYTE * self.moment.world.planes.nbytes
        spacing_ns = max(SPACING_NS, SHARE * max(self._keeping_ns, foreseen_ns))
        if self.moment.work_ns - self._kept_work_ns < spacing_ns:
            return
        before = nearest(self._here, self.moment.now)
        if before and self.moment.work_ns - before.work_ns < spacing_ns:
            self._kept_work_ns = before.work_ns
            return
        start = time.perf_counter_ns()
        self.snapshots.keep(self.moment, self._here, self.history.line)
        self._keeping_ns = time.perf_counter_ns() - start
        self._kept_work_ns = self.moment.work_ns

    def _on_trail(self, now):
        """Return the latest snapshot of the trail that leads to iteration `now`, or None; those after it are let go."""
        while self._trail:
            last = self._trail[-1]
            act = self.history.latest(last.now)
            while act is not last.act and act.at >= last.now and act.before:
                act = act.before
            if last.now <= now and act is last.act:
                return last
            self._trail.pop()
        return None

    def _leave_trail(self):
        if not self.rewinding:
            self._trail.clear()
            return
        behind_ns = self._trail[-1].work_ns if self._trail else self._kept_work_ns
        if self.moment.work_ns - behind_ns >= CLOSE_NS:
            self._trail.append(Snapshot(self.moment, self._here, [each.walls for each in self._trail]))
