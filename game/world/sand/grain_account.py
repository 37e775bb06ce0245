"""The account of a world's grains: those at the start, plus painted and poured, less erased and swallowed.

It is kept for each colour. A grain painted over with another colour counts as erased and as painted.
"""

from dataclasses import dataclass, replace
from operator import add

NO_GRAINS = (0,) * 8  # a tally: numbers of grains of each colour


def added(one, other):
    """Return the sum of two tallies."""
    return tuple(map(add, one, other))


def split(change):
    """Return the tallies of the grains that came and of those that went."""
    return tuple(max(each, 0) for each in change), tuple(max(-each, 0) for each in change)


@dataclass(frozen=True)
class GrainAccount:
    """What happened to a world's grains since it was loaded: tallies by colour, and their sums as plain numbers."""

    start_by_colour: tuple
    painted_by_colour: tuple = NO_GRAINS
    erased_by_colour: tuple = NO_GRAINS
    poured_by_colour: tuple = NO_GRAINS  # by taps
    swallowed_by_colour: tuple = NO_GRAINS  # by drains

    @property
    def start(self):
        """How many grains there were."""
        return sum(self.start_by_colour)

    @property
    def painted(self):
        """How many grains were painted."""
        return sum(self.painted_by_colour)

    @property
    def erased(self):
        """How many grains were erased."""
        return sum(self.erased_by_colour)

    @property
    def poured(self):
        """How many grains taps have poured."""
        return sum(self.poured_by_colour)

    @property
    def swallowed(self):
        """How many grains drains have swallowed."""
        return sum(self.swallowed_by_colour)

    @property
    def expected(self):
        """How many grains there must be now."""
        return sum(self.expected_by_colour)

    @property
    def expected_by_colour(self):
        """How many grains of each colour there must be now."""
        came = added(added(self.start_by_colour, self.painted_by_colour), self.poured_by_colour)
        gone = added(self.erased_by_colour, self.swallowed_by_colour)
        return tuple(have - lost for have, lost in zip(came, gone, strict=True))

    @property
    def lines(self):
        """The account as [(sign, word, grains)], what must be there now last; fixtures only where they acted."""
        lines = [("", "at the start", self.start), ("+", "painted", self.painted), ("-", "erased", self.erased)]
        if self.poured or self.swallowed:
            lines += [("+", "poured", self.poured), ("-", "swallowed", self.swallowed)]
        return [*lines, ("=", "now", self.expected)]

    @property
    def rows(self):
        """The account of each colour that ever was: [(its number, start, painted, erased, poured, swallowed, now)]."""
        columns = (
            self.start_by_colour,
            self.painted_by_colour,
            self.erased_by_colour,
            self.poured_by_colour,
            self.swallowed_by_colour,
            self.expected_by_colour,
        )
        return [(number, *row) for number, row in enumerate(zip(*columns, strict=True)) if any(row)]

    @property
    def coloured(self):
        """Whether there ever was sand of another colour than the first."""
        return any(row[0] for row in self.rows)

    def booked(self, change):
        """Return the account after an act that changed the number of grains of each colour by `change`, a tally."""
        came, went = split(change)
        return replace(
            self,
            painted_by_colour=added(self.painted_by_colour, came),
            erased_by_colour=added(self.erased_by_colour, went),
        )

    def passed(self, traffic):
        """Return the account after the Traffic of some iterations."""
        return replace(
            self,
            poured_by_colour=added(self.poured_by_colour, traffic.poured),
            swallowed_by_colour=added(self.swallowed_by_colour, traffic.swallowed),
        )

    def balanced(self, world):
        """Return whether `world` holds the grains that it must, of each colour: none was made or lost."""
        return world.grains_by_colour == self.expected_by_colour
