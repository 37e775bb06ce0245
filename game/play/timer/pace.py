"""The pace: which iteration belongs to which second, so that a given one is reached on time; no rounding adds up."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Pace:
    """A straight way from one iteration to another, in seconds of any clock."""

    from_s: float
    start: int  # iteration at from_s
    to_s: float
    end: int  # iteration at to_s

    @property
    def iterations_per_second(self):
        """How fast the sand goes; endless where no time is left."""
        left_s = self.to_s - self.from_s
        return (self.end - self.start) / left_s if left_s > 0 else math.inf

    def at(self, second):
        """Return the iteration that belongs to a second: never `end` before to_s, always after."""
        if second >= self.to_s:
            return self.end
        part = max(0.0, second - self.from_s) / (self.to_s - self.from_s)
        return min(self.start + math.floor(part * (self.end - self.start)), self.end - 1)
