"""The rule: seven probabilities, one for each event a block can have, and the schedule of partitions."""

from dataclasses import asdict, dataclass, fields, replace

from game.world.sand import parameters

# The offset (x, y) of the blocks' upper left corner, in cells, iteration by iteration, repeated.
SCHEDULES = {
    "margolus": ((0, 0), (1, 1)),
    "paper": ((0, 0), (1, 1), (0, 1), (1, 0)),
    "balanced": ((0, 0), (1, 1), (1, 0), (0, 1)),
}


@dataclass(frozen=True)
class Rule:
    """How sand moves. Each probability is in [0, 1]; the kernels honour it to the nearest 2**-32.

    left and right: for a fall the column of the falling grain, for a topple the direction of the move.
    Raises ValueError for a probability outside [0, 1] or an unknown schedule.
    Source: Devlin & Schuster 2020, transitions (c)-(j).
    """

    topple_left: float = 1.0
    topple_right: float = 1.0
    fall_pair: float = 1.0
    fall_low_left: float = 1.0
    fall_low_right: float = 1.0
    fall_full_left: float = 1.0
    fall_full_right: float = 1.0
    schedule: str = "paper"

    def __post_init__(self):
        for each in parameters.PROBABILITIES:
            object.__setattr__(self, each.name, each.check(getattr(self, each.name)))
        if not isinstance(self.schedule, str) or self.schedule not in SCHEDULES:
            raise ValueError(f"schedule must be one of {', '.join(SCHEDULES)}, got {self.schedule!r}")

    @classmethod
    def with_p(cls, p, schedule="paper", bias=0.0):
        """Return the paper's rule: grains topple with probability p, leaning by `bias` in [-1, 1], and always fall.

        Topples go right with p·min(1, 1 + bias) and left with p·min(1, 1 - bias).
        """
        p, bias = parameters.P.check(p), parameters.BIAS.check(bias)
        return cls(topple_left=p * min(1.0, 1.0 - bias), topple_right=p * min(1.0, 1.0 + bias), schedule=schedule)

    def leaning(self, bias):
        """Return the rule with the same p whose topples lean by `bias`."""
        topples = Rule.with_p(self.p, bias=bias)
        return replace(self, topple_left=topples.topple_left, topple_right=topples.topple_right)

    @property
    def probabilities(self):
        """The seven probabilities as a tuple, in the order of the fields."""
        return tuple(getattr(self, each.name) for each in parameters.PROBABILITIES)

    @property
    def offsets(self):
        """The schedule's offsets (x, y), in order."""
        return SCHEDULES[self.schedule]

    @property
    def p(self):
        """The larger topple probability: what the p slider shows."""
        return max(self.topple_left, self.topple_right)

    @property
    def bias(self):
        """The lean in [-1, 1] that, with p, gives the two topple probabilities."""
        if self.p == 0.0:
            return 0.0
        if self.topple_right < self.topple_left:
            return self.topple_right / self.p - 1.0
        return 1.0 - self.topple_left / self.p

    def as_dict(self):
        """The fields by name, as a scene file spells them."""
        return asdict(self)


FIELDS = tuple(field.name for field in fields(Rule))
