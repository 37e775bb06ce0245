"""The account of a world's grains: those at the start, plus painted and poured, less erased and swallowed.

It is kept for each kind of `World.amounts`: for each colour of sand, or for each material. A grain painted over with
another kind counts as erased and as painted. A rule may make one material of another, but leaves sums alone: its books.
"""

from dataclasses import dataclass, fields, replace
from itertools import zip_longest

NO_GRAINS = ()  # a tally: numbers of grains of each kind, 0 for those that are left out


def added(one, other):
    """Return the sum of two tallies."""
    return tuple(mine + its for mine, its in zip_longest(one, other, fillvalue=0))


def split(change):
    """Return the tallies of the grains that came and of those that went."""
    change = tuple(change)
    return tuple(max(each, 0) for each in change), tuple(max(-each, 0) for each in change)


@dataclass(frozen=True)
class GrainAccount:
    """What happened to a world's grains since it was loaded: tallies by kind, and their sums as plain numbers."""

    start_by_kind: tuple
    kept: tuple  # of tuples of kinds: each of these together are neither made nor lost by the rule
    painted_by_kind: tuple = NO_GRAINS
    erased_by_kind: tuple = NO_GRAINS
    poured_by_kind: tuple = NO_GRAINS  # by taps
    swallowed_by_kind: tuple = NO_GRAINS  # by drains
    formed_by_kind: tuple = NO_GRAINS  # by the rule's reactions, as far as `met` has seen; on balance
    used_by_kind: tuple = NO_GRAINS
    formed_before_by_kind: tuple = NO_GRAINS  # of these, what reactions did under the rules before this one
    used_before_by_kind: tuple = NO_GRAINS

    @property
    def start(self):
        """How many grains there were."""
        return sum(self.start_by_kind)

    @property
    def painted(self):
        """How many grains were painted."""
        return sum(self.painted_by_kind)

    @property
    def erased(self):
        """How many grains were erased."""
        return sum(self.erased_by_kind)

    @property
    def poured(self):
        """How many grains taps have poured."""
        return sum(self.poured_by_kind)

    @property
    def swallowed(self):
        """How many grains drains have swallowed."""
        return sum(self.swallowed_by_kind)

    @property
    def expected(self):
        """How many grains there must be now."""
        return sum(self.expected_by_kind)

    @property
    def expected_by_kind(self):
        """How many grains of each kind there must be now, by what is in the account."""
        came = added(added(self.start_by_kind, self.painted_by_kind), added(self.poured_by_kind, self.formed_by_kind))
        gone = added(added(self.erased_by_kind, self.swallowed_by_kind), self.used_by_kind)
        return added(came, (-lost for lost in gone))

    @property
    def lines(self):
        """The account as [(sign, word, grains)], what must be there now last; fixtures only where they acted."""
        lines = [("", "at the start", self.start), ("+", "painted", self.painted), ("-", "erased", self.erased)]
        if self.poured or self.swallowed:
            lines += [("+", "poured", self.poured), ("-", "swallowed", self.swallowed)]
        if any(self.formed_by_kind) or any(self.used_by_kind):
            lines += [("+", "formed", sum(self.formed_by_kind)), ("-", "used up", sum(self.used_by_kind))]
        return [*lines, ("=", "now", self.expected)]

    @property
    def rows(self):
        """The account of each kind that ever was.

        It is [(its number, start, painted, erased, poured, swallowed, formed, used, now)].
        """
        columns = (
            self.start_by_kind,
            self.painted_by_kind,
            self.erased_by_kind,
            self.poured_by_kind,
            self.swallowed_by_kind,
            self.formed_by_kind,
            self.used_by_kind,
            self.expected_by_kind,
        )
        return [(number, *row) for number, row in enumerate(zip_longest(*columns, fillvalue=0)) if any(row)]

    @property
    def mixed(self):
        """Whether there ever were grains of another kind than the first."""
        return any(row[0] for row in self.rows)

    def booked(self, change):
        """Return the account after an act that changed the number of grains of each kind by `change`, a tally."""
        came, went = split(change)
        return replace(
            self,
            painted_by_kind=added(self.painted_by_kind, came),
            erased_by_kind=added(self.erased_by_kind, went),
        )

    def passed(self, traffic):
        """Return the account after the Traffic of some iterations."""
        return replace(
            self,
            poured_by_kind=added(self.poured_by_kind, traffic.poured),
            swallowed_by_kind=added(self.swallowed_by_kind, traffic.swallowed),
        )

    def met(self, amounts):
        """Return the account where so many grains of each kind are there, with what reactions have made of others.

        Kinds that the rule keeps one by one are left as they are: there is nothing that could have made them.
        """
        alone = {kinds[0] for kinds in self.kept if len(kinds) == 1}
        before = self._unreacted()
        left = added(amounts, (-each for each in before.expected_by_kind))
        formed, used = split(0 if kind in alone else each for kind, each in enumerate(left))
        return replace(
            before,
            formed_by_kind=added(before.formed_by_kind, formed),
            used_by_kind=added(before.used_by_kind, used),
        )

    def ruled(self, kept, numbers, amounts):
        """Return the account as it goes on under another rule, where so many grains of each kind are there.

        kept: as in `GrainAccount`. numbers: for each kind which one it is under that rule, or None where it is gone.
        """
        met = self.met(amounts)
        tallies = {each.name: _renumbered(getattr(met, each.name), numbers) for each in fields(self)[2:]}
        tallies["formed_before_by_kind"] = tallies["formed_by_kind"]
        tallies["used_before_by_kind"] = tallies["used_by_kind"]
        return GrainAccount(_renumbered(met.start_by_kind, numbers), kept, **tallies)

    def balanced(self, world):
        """Return whether `world` holds the grains that it must, in each sum that is kept: none was made or lost."""
        return self.agrees(world.amounts)

    def agrees(self, amounts):
        """Return whether there may be so many grains of each kind."""
        gone = added(self._unreacted().expected_by_kind, (-each for each in amounts))
        return all(sum(gone[kind] for kind in kinds) == 0 for kinds in self.kept)

    def _unreacted(self):
        """Return the account without what the reactions of this rule have formed and used."""
        return replace(self, formed_by_kind=self.formed_before_by_kind, used_by_kind=self.used_before_by_kind)


def _renumbered(tally, numbers):
    """Return a tally by other kinds: for each of its own the number of the one that it is, or None."""
    kinds = [None if kind >= len(numbers) else numbers[kind] for kind in range(len(tally))]
    found = [0] * (1 + max((kind for kind in kinds if kind is not None), default=-1))
    for kind, grains in zip(kinds, tally, strict=True):
        if kind is not None:
            found[kind] += grains
    return tuple(found)
