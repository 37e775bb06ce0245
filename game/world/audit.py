"""The audit: a world's grains are those of its start, and those painted and poured, less those erased and swallowed."""

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Account:
    """The books of a world's grains since it was loaded."""

    start: int
    painted: int = 0
    erased: int = 0
    poured: int = 0  # by taps
    swallowed: int = 0  # by drains

    @property
    def expected(self):
        """How many grains there must be now."""
        return self.start + self.painted - self.erased + self.poured - self.swallowed

    @property
    def lines(self):
        """The books as [(sign, word, grains)], what there must be now last; taps and drains where they worked."""
        lines = [("", "at the start", self.start), ("+", "painted", self.painted), ("-", "erased", self.erased)]
        if self.poured or self.swallowed:
            lines += [("+", "poured", self.poured), ("-", "swallowed", self.swallowed)]
        return [*lines, ("=", "now", self.expected)]

    def booked(self, change):
        """Return the account after an act that changed the number of grains by `change`."""
        if change > 0:
            return replace(self, painted=self.painted + change)
        return replace(self, erased=self.erased - change)

    def passed(self, traffic):
        """Return the account after the Traffic of some iterations."""
        return replace(self, poured=self.poured + traffic.poured, swallowed=self.swallowed + traffic.swallowed)

    def balanced(self, world):
        """Return whether `world` holds the grains that it must: none was made or lost on the way."""
        return world.grains == self.expected
