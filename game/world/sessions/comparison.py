"""The comparison: one world in variants side by side, told the same things at the same iterations."""

import time
from dataclasses import dataclass, replace

from game.world.rules.rule import SCHEDULES, Rule
from game.world.sand import parameters
from game.world.sessions.action import Load, SetRule
from game.world.sessions.session import Session

MOST = 4  # worlds that are compared


@dataclass(frozen=True)
class Variant:
    """The one thing in which a world of a comparison differs from the others; what is None is left as it is."""

    title: str
    schedule: str | None = None
    p: float | None = None
    later: int = 0  # added to the seed
    played: Rule | None = None  # whatever is set

    def rule(self, rule):
        """Return a rule as this variant has it."""
        if self.played is not None:
            return self.played
        if self.p is not None and rule.leans:
            rule = rule.toppling(self.p, rule.bias)
        return rule.with_schedule(self.schedule) if self.schedule else rule

    def seed(self, seed):
        """Return the seed that this variant has in place of one."""
        return (seed + self.later) % 2**64

    def scene(self, scene):
        """Return a scene under this variant; where that changes nothing, the scene itself."""
        rule = self.rule(scene.rule)
        if rule == scene.rule:
            return scene
        cells = scene.cells if rule.codes == scene.rule.codes else scene.world().of(rule.codes).materials
        colours = scene.colours if rule.codes.is_sand else None
        return replace(scene, rule=rule, cells=cells, colours=colours, shipped=False)


def by_schedule(_, schedules=tuple(SCHEDULES)):
    """Return the Variants of schedules, by title."""
    return {each.capitalize(): Variant(each.capitalize(), schedule=each) for each in schedules}


def by_friction(_, values=parameters.PAPER_P):
    """Return the Variants of values of p, by title."""
    return {f"p = {p:g}": Variant(f"p = {p:g}", p=p) for p in values}


def by_seed(seed, number=MOST):
    """Return the Variants of so many seeds, by title, the session's own first."""
    variants = [Variant(f"Seed {(seed + later) % 2**64}", later=later) for later in range(number)]
    return {each.title: each for each in variants}


def by_rule(_, rules):
    """Return the Variants of {title: Rule}, by title."""
    return {title: Variant(title, played=rule) for title, rule in rules.items()}


class Comparison(Session):
    """The session of one variant, which leads, and those of the others, which follow it through all that it does.

    Only the leading one is recorded: the others are a function of it.
    """

    def __init__(self, scene, seed=0, memory_mb=parameters.MEMORY.default, subject=by_schedule):
        """subject: what the worlds differ in, `by_schedule` or another: a function of the seed."""
        self.variants = subject(seed)
        same = (name for name, each in self.variants.items() if each.scene(scene) is scene and not each.later)
        self.lead = next(same, next(iter(self.variants)))
        self._memory_mb = memory_mb
        lead = self.variants[self.lead]
        super().__init__(lead.scene(scene), lead.seed(seed), self._share(memory_mb))
        self.others = {
            name: Session(each.scene(scene), each.seed(seed), self._share(memory_mb))
            for name, each in self.variants.items()
            if name != self.lead
        }

    @property
    def sessions(self):
        """The session of each variant, by name."""
        return {each: self if each == self.lead else self.others[each] for each in self.variants}

    def do(self, action, join=False):
        """Apply an action to all worlds and return whether it changed any, and so is recorded in all.

        What it sets leaves each one what it differs in.
        """
        self.keep_up()
        acts = [(session, _kept(action, self.variants[name])) for name, session in self.sessions.items()]
        changed = any([session.timeline.happens(act, join) for session, act in acts])
        is_back = changed and all(session.timeline.is_back(join) for session, _ in acts)
        for session, act in acts:
            session._record(act, join, changed, is_back)
        return changed

    def seek(self, now, budget_ns=None):
        """Go to iteration `now` in all worlds and return whether the leading one is there."""
        for other in self.others.values():
            other.timeline.rewinding = self.timeline.rewinding
            other.seek(now, self._part(budget_ns))
        return super().seek(now, self._part(budget_ns))

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
            session.timeline.catch_up(self._part(budget_ns))

    def undo(self, back=False, budget_ns=None):
        """Take back the last act in all worlds; return whether there was one."""
        self.keep_up(self._part(budget_ns))
        for other in self.others.values():
            other.undo(back, self._part(budget_ns))
        return super().undo(back, self._part(budget_ns))

    def redo(self, back=False, budget_ns=None):
        """Bring back in all worlds the act undone last or the future left last; return whether there was one."""
        self.keep_up(self._part(budget_ns))
        for other in self.others.values():
            other.redo(back, self._part(budget_ns))
        return super().redo(back, self._part(budget_ns))

    def limit_memory(self, memory_mb):
        """Let the pasts of all worlds take so much memory together (MB), at least as much as a single one may have."""
        self._memory_mb = parameters.MEMORY.check(memory_mb)
        super().limit_memory(self._share(memory_mb))
        for other in self.others.values():
            other.limit_memory(self._share(memory_mb))

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
        done = super().frame(elapsed_ns, self._part(budget_ns), due if self.timeline.goal is not None else 0)
        self.keep_up(self._part(budget_ns))
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

    def _share(self, memory_mb):
        """Return what each world may take of the memory for all pasts."""
        return max(parameters.MEMORY.low, int(memory_mb) // len(self.variants))

    def _part(self, budget_ns):
        """Return what each world may take of the time for a seek."""
        return None if budget_ns is None else budget_ns // len(self.variants)


def _kept(action, variant):
    """Return the action as it is done to the world of a variant."""
    if isinstance(action, SetRule):
        return SetRule(variant.rule(action.rule))
    if isinstance(action, Load):
        return Load(variant.scene(action.scene), variant.seed(action.seed))
    return action


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
