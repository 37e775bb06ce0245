"""Snapshots: moments kept so that seeking is fast. Where memory is short, the older ones lie further apart."""

from dataclasses import replace

import numpy as np

from game.core.planes import PLANES, WALLS, empty
from game.world.sand.world import World

MEGABYTE = 10**6
LIKENESSES = 4  # how many of the newest different walls a new snapshot looks through to share its own; more cost time


class Snapshot:
    """A Moment at rest. What moves in the planes is copied, the walls are shared with snapshots that have the same."""

    __slots__ = (
        *("act", "codes", "fields", "fixtures", "layout", "moving", "now", "seed", "walls", "work_ns"),
        "world_iteration",
    )

    def __init__(self, moment, act, known_walls=()):
        world = moment.world
        self.act = act  # the last act that this moment has seen
        self.now, self.work_ns = moment.now, moment.work_ns
        self.fields = replace(moment, world=None)
        self.layout, self.world_iteration, self.seed = world.layout, world.iteration, world.seed
        self.fixtures, self.codes = world.fixtures, world.codes
        still = slice(WALLS, PLANES if world.codes.is_sand else WALLS)
        self.moving = np.concatenate([world.planes[: still.start], world.planes[still.stop :]])
        walls = world.planes[still]
        same = (known for known in known_walls if np.array_equal(known, walls))
        self.walls = next(same, None)
        if self.walls is None:
            self.walls = walls.copy()

    def moment(self):
        """Return the moment kept, with a world of its own."""
        planes = empty(self.layout, len(self.moving) + len(self.walls))
        np.concatenate([self.moving[:WALLS], self.walls, self.moving[WALLS:]], out=planes)
        world = World(planes, self.layout, self.codes, self.world_iteration, self.seed, self.fixtures)
        return replace(self.fields, world=world)


def nearest(act, now):
    """Return the latest Snapshot from which iteration `now` after `act` is reached by computing forward, or None."""
    while act is not None:
        before = [each for each in act.snapshots if each.now <= now]
        if before:
            return max(before, key=lambda each: each.now)
        now, act = act.at, act.before
    return None


class SnapshotStore:
    """Snapshots, never more than `budget` bytes of them."""

    def __init__(self, budget):
        self.bytes = 0
        self.budget = budget
        self.kept = {}  # snapshots as keys, in the order they were taken
        self._walls = {}  # id: [walls, how many snapshots share them], in the order of first use

    def __len__(self):
        return len(self.kept)

    def keep(self, moment, act, line):
        """Keep a moment that has seen `act`, in favour of the past of `line`, if the budget has room for it at all."""
        known = [walls for walls, _ in list(self._walls.values())[-LIKENESSES:]]
        snapshot = Snapshot(moment, act, known)
        if snapshot.moving.nbytes + snapshot.walls.nbytes > self.budget:
            return
        while self.bytes + self._cost(snapshot) > self.budget:
            self._drop(next(self._least_missed(line, snapshot.work_ns)))
        self.bytes += self._cost(snapshot)
        self.kept[snapshot] = None
        self._walls.setdefault(id(snapshot.walls), [snapshot.walls, 0])[1] += 1
        if not act.snapshots:
            act.snapshots = []
        act.snapshots.append(snapshot)

    def fit(self, budget, line):
        """Change the budget, and drop what no longer fits."""
        self.budget = budget
        while self.bytes > budget:
            for snapshot in self._least_missed(line):  # many at a time, since to find one takes as long
                self._drop(snapshot)
                if self.bytes <= budget:
                    break

    def empty(self):
        """Drop all snapshots."""
        for snapshot in list(self.kept):
            self._drop(snapshot)

    def _cost(self, snapshot):
        return snapshot.moving.nbytes + (0 if id(snapshot.walls) in self._walls else snapshot.walls.nbytes)

    def _drop(self, snapshot):
        del self.kept[snapshot]
        snapshot.act.snapshots.remove(snapshot)
        share = self._walls[id(snapshot.walls)]
        share[1] -= 1
        if not share[1]:
            del self._walls[id(snapshot.walls)]
        self.bytes -= self._cost(snapshot)

    def _least_missed(self, line, newest_ns=0):
        """Yield snapshots to drop: those of other lines, else those that leave the smallest gaps for their age.

        Of two neighbours only one is yielded, since the gap that the other leaves is then a larger one.
        """
        own = past_of(line)
        others = self.kept.keys() - own
        if others:
            yield from [each for each in self.kept if each in others]
            return
        newest_ns = max(newest_ns, own[-1].work_ns)
        work = [0, *(each.work_ns for each in own), newest_ns]

        def gap(number):
            return (work[number + 2] - work[number]) / (newest_ns - work[number + 1] + newest_ns / len(work))

        yielded = set()
        for number in sorted(range(len(own)), key=gap):
            if not yielded & {number - 1, number + 1}:
                yielded.add(number)
                yield own[number]


def past_of(act):
    """Return the snapshots that lie on the way to `act` and beyond, the earliest first."""
    found, latest = [], None
    while act is not None:
        usable = [each for each in act.snapshots if latest is None or each.now <= latest]
        found += sorted(usable, key=lambda each: each.now, reverse=True)
        latest, act = act.at, act.before
    return found[::-1]
