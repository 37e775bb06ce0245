"""The comparison: one world under all three schedules at once, told the same things at the same iterations."""

import time
from dataclasses import replace

from game.world.rules.rule import SCHEDULES
from game.world.sand import parameters
from game.world.sessions.action import Load, SetRule
from game.world.sessions.session import Session

SHARE = len(SCHEDULES)  # of the memory, and of the time for a seek, each world gets one part in so many


class Comparison(Session):
    """The session of one schedule, which leads, and those of the others, which follow it through all that it does.

    Only the leading one is recorded: the others are a function of it.
    """

    def __init__(self, scene, seed=0, memory_mb=parameters.MEMORY.default):
        super().__init__(scene, seed, _share(memory_mb))
        self._memory_mb = memory_mb
        self.schedule = scene.rule.schedule
        self.others = {
            schedule: Session(_under(scene, schedule), seed, _share(memory_mb))
            for schedule in SCHEDULES
            if schedule != self.schedule
        }

    @property
    def sessions(self):
        """The session of each schedule, by name, in the order of SCHEDULES."""
        return {each: self if each == self.schedule else self.others[each] for each in SCHEDULES}

    def do(self, action, join=False):
        """Apply an action to all worlds and return whether it changed any, and so is recorded in all.

        A rule that it sets leaves each one its own schedule.
        """
        self.keep_up()
        acts = [(session, _kept(action, schedule)) for schedule, session in self.sessions.items()]
        changed = any([session.timeline.happens(act, join) for session, act in acts])
        is_back = changed and all(session.timeline.is_back(join) for session, _ in acts)
        for session, act in acts:
            session._record(act, join, changed, is_back)
        return changed

    def seek(self, now, budget_ns=None):
        """Go to iteration `now` in all worlds and return whether the leading one is there."""
        for other in self.others.values():
            other.timeline.rewinding = self.timeline.rewinding
            other.seek(now, _part(budget_ns))
        return super().seek(now, _part(budget_ns))

    @property
    def arrived(self):
        """Whether all worlds are where they should be: no seek is unfinished."""
        return super().arrived and all(other.arrived for other in self.others.values())

    @property
    def at_rest(self):
        """Whether nothing can move any more in any world."""
        return super().at_rest and all(other.at_rest for other in self.others.values())

    @property
    def settled(self):
        """Whether nothing moves any more in any world."""
        return super().settled and all(other.settled for other in self.others.values())

    def catch_up(self, budget_ns):
        """Go on with unfinished seeks, for about `budget_ns` in all."""
        for session in self.sessions.values():
            session.timeline.catch_up(_part(budget_ns))

    def undo(self, back=False, budget_ns=None):
        """Take back the last act in all worlds; return whether there was one."""
        self.keep_up(_part(budget_ns))
        for other in self.others.values():
            other.undo(back, _part(budget_ns))
        return super().undo(back, _part(budget_ns))

    def redo(self, back=False, budget_ns=None):
        """Bring back in all worlds the act undone last or the future left last; return whether there was one."""
        self.keep_up(_part(budget_ns))
        for other in self.others.values():
            other.redo(back, _part(budget_ns))
        return super().redo(back, _part(budget_ns))

    def limit_memory(self, memory_mb):
        """Let the pasts of all worlds take so much memory together (MB), at least as much as a single one may have."""
        self._memory_mb = parameters.MEMORY.check(memory_mb)
        super().limit_memory(_share(memory_mb))
        for other in self.others.values():
            other.limit_memory(_share(memory_mb))

    def drop_past(self):
        """Drop the snapshots of all pasts."""
        super().drop_past()
        for other in self.others.values():
            other.drop_past()

    @property
    def memory_mb(self):
        """The most that the pasts of all worlds may take together, in millions of bytes."""
        return self._memory_mb

    @property
    def past_bytes(self):
        """What the snapshots of all pasts take."""
        return super().past_bytes + sum(other.past_bytes for other in self.others.values())

    def frame(self, elapsed_ns, budget_ns=None, due=None):
        """Run what is due in the leading world, and as much in the others; return by how much that is."""
        self.streams = None  # the worlds shall look alike
        if self.arrived:
            return super().frame(elapsed_ns, budget_ns, due)
        done = super().frame(elapsed_ns, _part(budget_ns), due if self.timeline.goal is not None else 0)
        self.keep_up(_part(budget_ns))
        return done

    def _run(self, iterations, budget_ns):
        """Run all worlds side by side, in rounds that double: one may rest while the others have much to move."""
        start, done = time.perf_counter_ns(), 0
        some = iterations if budget_ns is None else 1
        while done < iterations and some > 0:
            begun, some = time.perf_counter_ns(), min(some, iterations - done)
            self.timeline.run(some)
            self.keep_up()
            done += some
            now = time.perf_counter_ns()
            iteration_ns = max(1, (now - begun) / some)
            some = min(2 * some, int(((budget_ns or 0) - now + start) / iteration_ns))
        return done

    def step(self):
        """Run one iteration in all worlds, paused or not."""
        super().step()
        self.keep_up()

    def keep_up(self, budget_ns=None):
        """Bring the others to where the leading one is; with a budget (ns) a long way is left for later."""
        for other in self.others.values():
            if other.now != self.now or other.timeline.goal is not None:
                if other.timeline.goal is None and other.now < self.now and budget_ns is None:
                    other.timeline.run(self.now - other.now)
                else:
                    other.seek(self.now, budget_ns)


def _under(scene, schedule):
    """Return the scene under a schedule; where that is its own, the scene itself."""
    if scene.rule.schedule == schedule:
        return scene
    return replace(scene, rule=replace(scene.rule, schedule=schedule), shipped=False)


def _kept(action, schedule):
    """Return the action as it is done to the world of a schedule."""
    if isinstance(action, SetRule):
        return SetRule(replace(action.rule, schedule=schedule))
    if isinstance(action, Load):
        return Load(_under(action.scene, schedule), action.seed)
    return action


def _share(memory_mb):
    """Return what each world may take of the memory for all pasts."""
    return max(parameters.MEMORY.low, int(memory_mb) // SHARE)


def _part(budget_ns):
    return None if budget_ns is None else budget_ns // SHARE


def present(session):
    """Return the scene that starts as a session's world is now."""
    world, scene = session.world, session.scene
    cells = world.materials
    cells.flags.writeable = False
    return replace(
        scene,
        cells=cells,
        colours=world.colours if world.coloured else None,
        rule=session.rule,
        fixtures=world.fixtures,
        speed=session.clock.speed,
        shipped=False,
    )
