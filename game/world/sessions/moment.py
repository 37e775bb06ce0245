"""A moment of a session: all that its future depends on, the account of its grains, and a look ahead of it."""

import time
from dataclasses import dataclass, replace

from game.world.rules.rule import Rule
from game.world.sand.advance import NO_TRAFFIC, advance
from game.world.sand.grain_account import GrainAccount
from game.world.sand.material_codes import SAND, SAND_NAME
from game.world.sand.sand_colours import COLOURS
from game.world.sand.world import World
from game.world.scenes.hourglass_maker import scene_of
from game.world.scenes.scene import Scene
from game.world.sessions.action import Load, Reshape, perform
from game.world.sessions.patch import alike


@dataclass
class Moment:
    """A world in play, changed in place by `run` and `take`."""

    world: World
    rule: Rule
    scene: Scene
    account: GrainAccount
    loaded_at: int = 0  # iterations of the session before the world was loaded
    work_ns: int = 0  # what it took to compute the way from the session's start to here

    @classmethod
    def start(cls, scene, seed):
        """Return the first moment of a session."""
        world = scene.world(seed)
        return cls(world, scene.rule, scene, account_of(world, scene.rule))

    @property
    def now(self):
        """Iterations since the session began."""
        return self.loaded_at + self.world.iteration

    def same(self):
        """Return another Moment that is what this one is, until its world's planes change."""
        return replace(self, world=self.world.same())

    def is_as(self, other):
        """Return whether a player finds the same here as in another moment: what it took to get there is no matter."""
        if (self.now, self.rule) != (other.now, other.rule):
            return False
        glass = self.scene.glass
        same_scene = self.scene.is_like(other.scene) or (glass is not None and glass == other.scene.glass)
        return same_scene and alike(self.world, other.world)

    def run(self, iterations):
        """Run iterations and return what they took, in nanoseconds."""
        start = time.perf_counter_ns()
        traffic = advance(self.world, self.rule, iterations)
        took = time.perf_counter_ns() - start
        self.work_ns += took
        if traffic is not NO_TRAFFIC:
            self.account = self.account.passed(traffic)
        return took

    def take(self, action):
        """Let an act happen and return whether it changed anything."""
        start, now = time.perf_counter_ns(), self.now
        outcome = perform(action, self.world, self.rule)
        scene, account = self._told(action, outcome)
        changed = outcome.changed or (scene, account) != (self.scene, self.account)
        if changed:
            self.world, self.rule, self.scene, self.account = outcome.world, outcome.rule, scene, account
            if isinstance(action, Load):
                self.loaded_at = now
        self.work_ns += time.perf_counter_ns() - start
        return changed

    def _told(self, action, outcome):
        """Return the scene and the account after an act."""
        if isinstance(action, Load):
            scene = self.scene if action.scene.is_like(self.scene) else action.scene
            return scene, account_of(outcome.world, outcome.rule)
        if outcome.rule.definition.source != self.rule.definition.source:
            numbers = _kinds_under(outcome.rule.codes, self.world.codes)
            return self.scene, self.account.ruled(_kept_by(outcome.rule), numbers, self.world.amounts)
        scene = self.scene
        if isinstance(action, Reshape) and action.glass != scene.glass:
            scene = scene_of(action.glass, self.rule, scene.speed)
        return scene, self.account.booked(outcome.grains) if any(outcome.grains) else self.account


def account_of(world, rule):
    """Return the GrainAccount of a world from now on: what the rule's books say is kept, of sand each colour."""
    return GrainAccount(world.amounts, _kept_by(rule))


def _kept_by(rule):
    """Return the kinds that each sum has which a rule keeps."""
    kinds = rule.definition.kept
    if rule.codes.is_sand:
        return tuple((kind,) for kind in range(len(COLOURS))) if (SAND,) in kinds else ()
    return kinds


def _kinds_under(codes, before):
    """Return which kind each one of a world with the MaterialCodes `before` is in one with others; None for none."""
    names = (SAND_NAME,) * len(COLOURS) if before.is_sand else before.names
    if codes == before:
        return tuple(range(len(names)))
    if codes.is_sand:
        return tuple(0 if name == SAND_NAME else None for name in names)
    return tuple(codes.code(name) for name in names)


class Lookahead:
    """Where a session is headed: a moment apart from it, run ahead of it through the acts still to come."""

    def __init__(self, moment, acts=()):
        """Take over `moment`; acts: history.Act, the nearest last."""
        self.moment = moment
        self._acts = list(acts)

    @property
    def world(self):
        """The world at this point: another object after an act that loads one."""
        return self.moment.world

    @property
    def now(self):
        """Iterations since the session began."""
        return self.moment.now

    @property
    def last_act(self):
        """The iteration of the last act to come, or None."""
        return self._acts[0].at if self._acts else None

    def copy(self):
        """Return an independent copy from the same point."""
        return Lookahead(replace(self.moment, world=self.moment.world.copy()), self._acts)

    def run_to(self, now):
        """Go on to iteration `now`, after the acts at it."""
        while self._acts and self._acts[-1].at <= now:
            act = self._acts.pop()
            self.moment.run(act.at - self.moment.now)
            self.moment.take(act.action)
        self.moment.run(now - self.moment.now)
