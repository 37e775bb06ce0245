"""Parameters: the default, range, unit and meaning of each, declared once.

Sliders, command-line flags, scene files and error messages all read their knob here.
"""

from dataclasses import dataclass
from numbers import Real


@dataclass(frozen=True)
class Knob:
    """A number that a person may set."""

    name: str
    default: float
    low: float
    high: float
    unit: str
    meaning: str
    whole: bool = False  # takes whole numbers only
    ends: tuple = ()  # what low and high are called, in a word each, where the number alone says little

    def check(self, value):
        """Return `value` as a float (an int for a whole knob), or raise ValueError saying what is wanted."""
        if isinstance(value, bool) or not isinstance(value, Real):
            raise ValueError(f"{self.name} must be {self.wanted}, got {value!r}")
        if not self.low <= value <= self.high:  # not so for NaN either
            raise ValueError(f"{self.name} must be {self.wanted}, got {value}")
        if self.whole and value != int(value):
            raise ValueError(f"{self.name} must be {self.wanted}, got {value}")
        return int(value) if self.whole else float(value)

    def parse(self, text):
        """Return the number that `text` spells, checked; raise ValueError saying what is wanted."""
        try:
            number = int(text) if self.whole else float(text)
        except ValueError:
            raise ValueError(f"{self.name} must be {self.wanted}, got {text!r}") from None
        return self.check(number)

    @property
    def wanted(self):
        """The range in words: 'in [0, 1]', 'a whole number in [1, 16384] cells'."""
        kind = "a whole number in" if self.whole else "in"
        return f"{kind} [{_spelt(self.low)}, {_spelt(self.high)}] {self.unit}".rstrip()


def _spelt(number):
    """Return a number with all its digits where it is a whole one."""
    return str(int(number)) if number == int(number) else f"{number:g}"


PAPER_P = (0.25, 0.5, 0.75, 1.0)  # the four values of the paper
P = Knob("p", 1.0, 0.0, 1.0, "", "how readily grains topple: lower is more friction", ends=("sticky", "runny"))
BIAS = Knob(
    "bias", 0.0, -1.0, 1.0, "", "which side grains favour: left (below 0) or right (above 0)", ends=("left", "right")
)
SIDE = Knob("size", 480, 1, 16384, "cells", "width or height of the lattice", whole=True)
SEED = Knob("seed", 0, 0, 2**64 - 1, "", "seed of the random numbers: each gives another run", whole=True)
SPEED = Knob("speed", 240, 1, 1_000_000, "iterations per second", "how fast the sand runs", ends=("slow", "fast"))
EVERY = Knob(
    "every", 4, 1, 100_000, "iterations", "from one grain of a tap to the next", whole=True, ends=("gushes", "drips")
)
CELL = Knob("cell", 4, 1, 64, "pixels", "width of one cell on the screen", whole=True)
BRUSH = Knob("brush", 6, 1, 200, "cells", "diameter of the brush", whole=True, ends=("fine", "broad"))
UI_SCALE = Knob("ui-scale", 1.0, 0.75, 3.0, "", "size of the panel and its text")
FRAMES = Knob("frames", 240, 1, 1_000_000, "frames", "how many frames to run", whole=True)
ITERATIONS = Knob("iterations", 0, 0, 2**62, "", "how many iterations to run", whole=True)
RUNS = Knob("runs", 10_000, 1, 10**9, "", "how many independent runs a forecast counts", whole=True)
AHEAD = Knob("ahead", 200, 1, 10_000, "iterations", "how far ahead a forecast looks", whole=True, ends=("soon", "late"))
ROW = Knob(
    "row", 0, 0, SIDE.high, "cells", "a row of the lattice, counted from the top", whole=True, ends=("top", "bottom")
)
MOMENT = Knob("at", 0, 0, 2**53, "iterations", "a moment of a session, since its beginning", whole=True)
MEMORY = Knob(
    "memory",
    256,
    1,
    2**20,
    "MB",
    "how much memory the snapshots of the past may take",
    whole=True,
    ends=("little", "much"),
)
TIMER = Knob("timer", 180, 1, 86_400, "seconds", "how long it takes until the last grain falls", ends=("short", "long"))
