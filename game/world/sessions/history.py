"""The history: what was done and when, every undone and forgotten future included. It moves no sand.

Acts form a tree: each knows the act before it. A *line* is a tree's path from the root to one act, a session's whole
story. The lines that a session has had stand in a list, with a cursor at the present one: undo and redo move the
cursor, a new act puts a new line after it, and no line is ever taken off. So nothing is lost: an act done in the past
leaves the old line behind the new one, where redo finds it.
"""

from typing import Any, NamedTuple

# What else than an action an entry may say. Wait: time went on until then. Withdraw: the last act, with all that it is
# joined to, has led back to where it began, and so it is none.
UNDO, REDO, WAIT, WITHDRAW = "undo", "redo", "wait", "withdraw"


class Entry(NamedTuple):
    """One thing a session did, in the order in which it did them."""

    at: int  # iterations since the session began; earlier than in the entry before after a rewind
    what: Any  # an action, or UNDO, REDO, WAIT, WITHDRAW
    join: bool = False  # undone together with the act before


class Act:
    """An action in its place in the tree."""

    __slots__ = ("action", "at", "before", "join", "rest_from", "snapshots")

    def __init__(self, action, at, before, join=False):
        self.action = action
        self.at = at  # iterations since the session began, no fewer than those of the act before
        self.before = before  # None for the root, which is no act
        self.join = join
        self.rest_from = None  # the iteration from which on nothing moves until the next act, once that is known
        self.snapshots = ()  # moments kept between this act and the next; a list once there are any


class History:
    """The lines of a session, and which is the present one."""

    def __init__(self):
        self.root = Act(None, 0, None)
        self._lines = [self.root]  # each line by its last act
        self._cursor = 0
        self._open = None  # the act that a joined one may follow
        self._opened = 0  # how many lines were put in for it and all it is joined to

    @property
    def line(self):
        """The last act of the present line, whether it is in the future or not."""
        return self._lines[self._cursor]

    def latest(self, now):
        """Return the last act of the present line at or before iteration `now`."""
        return _latest(self.line, now)

    def after(self, act):
        """Return the acts that follow `act` in the present line, the nearest last."""
        acts, each = [], self.line
        while each is not act:
            acts.append(each)
            each = each.before
        return acts

    def record(self, action, now, join=False):
        """Put an action at iteration `now` of the present line and return its Act; what came later is another line."""
        here, left = self.latest(now), self.line
        join = join and self.takes_join(now)
        act = self._open = Act(action, now, here, join)
        if join:
            self._lines[self._cursor] = act
        else:
            lines = [act] if here is left else [act, left]
            self._lines[self._cursor + 1 : self._cursor + 1] = lines
            self._cursor, self._opened = self._cursor + 1, len(lines)
        return act

    def takes_join(self, now):
        """Return whether an act at iteration `now` can be joined to the last one."""
        return self.latest(now) is self.line is self._open

    def withdraw(self):
        """Take the last act back with all that it is joined to, as if they had never been."""
        if self._open is None:
            return
        del self._lines[self._cursor : self._cursor + self._opened]
        self._cursor, self._open = self._cursor - 1, None

    def close(self):
        """Let nothing more be joined to the last act."""
        self._open = None

    def undo(self, now):
        """Go back to the line without the last act, by iteration `now`, with all that is joined to it.

        Return the iteration at which the two lines part, or None where there is nothing to take back.
        """
        return self._go(range(self._cursor - 1, -1, -1), now, to_the_end=False)

    def redo(self, now):
        """Go on to the next line that is another by iteration `now`, or to the last; return as `undo` does."""
        return self._go(range(self._cursor + 1, len(self._lines)), now, to_the_end=True)

    def obey(self, entry):
        """Do again what an Entry says was done."""
        if entry.what == UNDO:
            self.undo(entry.at)
        elif entry.what == REDO:
            self.redo(entry.at)
        elif entry.what == WITHDRAW:
            self.withdraw()
        elif entry.what != WAIT:
            self.record(entry.what, entry.at, entry.join)

    def story(self):
        """Return the present line as entries: what a replay needs, without the ways not taken."""
        return [Entry(act.at, act.action, act.join) for act in reversed(self.after(self.root))]

    def _find(self, cursors, now):
        """Return the first of `cursors` whose line is another than the present one by iteration `now`, or None."""
        here = self.latest(now)
        later = set(self.after(here))
        for cursor in cursors:
            if self._lines[cursor] not in later and _latest(self._lines[cursor], now) is not here:
                return cursor
        return None

    def _go(self, cursors, now, to_the_end):
        found = self._find(cursors, now)
        if found is None and to_the_end and cursors:
            found = cursors[-1]
        if found is None:
            return None
        left, self._cursor, self._open = self.line, found, None
        return _parting(left, self.line)


def _latest(act, now):
    while act.at > now and act.before is not None:
        act = act.before
    return act


def _parting(one, other):
    """Return the iteration of the first act that only one of two lines has."""
    past = [one]
    while past[-1].before is not None:
        past.append(past[-1].before)
    shared = set(past)
    parted = []
    while other not in shared:
        parted, other = [other.at], other.before
    at = past.index(other)
    return min(parted + [act.at for act in past[at - 1 : at]] if at else parted, default=one.at)
