"""Where a value sits on its slider, how it steps from there, and how it is spelled."""

import math
from typing import NamedTuple

from game.world.sand.parameters import Knob

STEPS = 100  # arrow presses from one end of a slider to the other, about
UNITS = {"cells": " cells", "iterations": " it.", "iterations per second": " it./s", "MB": " MB"}  # as they are short
DIGITS = 9  # decimals kept: removes the noise of binary fractions, so that 0.25 is exactly 0.25


class SliderScale(NamedTuple):
    """A knob as a slider sees it: linear, or by equal ratios if `log` (then `low` must be above 0)."""

    knob: Knob
    log: bool = False
    step: float | None = None  # between neighbouring values of a linear scale; None: about 1/100 of the range

    @property
    def pace(self):
        """The step of a linear scale: 1 for a whole knob, else 1, 2 or 5 times a power of ten."""
        return self.step or (1 if self.knob.whole else _round_number((self.knob.high - self.knob.low) / STEPS))

    def fraction(self, value):
        """Return where `value` sits, from 0 (low) to 1 (high)."""
        low, high = self.knob.low, self.knob.high
        value = min(max(value, low), high)
        return math.log(value / low) / math.log(high / low) if self.log else (value - low) / (high - low)

    def at(self, fraction):
        """Return the value at a fraction of the way, rounded to its step; the ends are exactly low and high."""
        low, high = self.knob.low, self.knob.high
        if not 0.0 < fraction < 1.0:
            return self._kind(low if fraction <= 0.0 else high)
        if self.log:
            return self._tidy(low * (high / low) ** fraction, STEPS)
        return self._on_grid(round((low + fraction * (high - low)) / self.pace), self.pace)

    def stepped(self, value, steps, shift=False):
        """Return the value `steps` steps on; shift makes steps ten times finer, or coarser for a whole linear knob."""
        if self.log:
            return self._log_stepped(value, steps, STEPS * 10 if shift else STEPS)
        pace = self.pace * (10 if self.knob.whole else 0.1) if shift else self.pace
        place = round(value / pace, 6)
        return self._on_grid((math.floor(place) if steps > 0 else math.ceil(place)) + steps, pace)

    def spell(self, value):
        """Return the value with its unit, short enough for a slider's row."""
        return f"{self._digits(value)}{self.unit(value)}"

    def unit(self, value):
        """Return the unit of the value as it follows the digits, or ""."""
        return " cell" if self.knob.unit == "cells" and value == 1 else UNITS.get(self.knob.unit, "")

    def _digits(self, value):
        if self.log and value >= 10_000:
            return f"{value / 1e6:.3g} M" if value >= 1e6 else f"{value / 1e3:.3g} k"
        if self.knob.whole:
            return str(value)
        if self.log:
            return f"{value:.0f}" if value >= 100 else f"{value:.3g}"
        decimals = max(0, -math.floor(math.log10(self.pace)))
        decimals += abs(round(value, decimals) - value) > 1e-6  # one more after a fine step
        return f"{value:.{decimals}f}".replace("-", "–")  # the font has no minus sign; its dash looks like one

    def _log_stepped(self, value, steps, per_range):
        ratio = (self.knob.high / self.knob.low) ** (steps / per_range)
        moved = self._tidy(value * ratio, per_range)
        if moved == value:  # a whole number too small for the ratio to move
            moved = value + (1 if steps > 0 else -1)
        return self._kind(min(max(moved, self.knob.low), self.knob.high))

    def _tidy(self, value, per_range):
        """Round to as many leading digits as tell one step of a log scale from the next."""
        ratio = (self.knob.high / self.knob.low) ** (1 / per_range)
        digits = 1 + math.ceil(-math.log10(ratio - 1))
        tidy = round(value, digits - 1 - math.floor(math.log10(value)))
        return self._kind(min(max(tidy, self.knob.low), self.knob.high))

    def _on_grid(self, count, pace):
        return self._kind(min(max(round(count * pace, DIGITS), self.knob.low), self.knob.high))

    def _kind(self, value):
        return round(value) if self.knob.whole else float(value)


def _round_number(limit):
    """Return the largest 1, 2 or 5 times a power of ten that is not above `limit`."""
    power = 10.0 ** math.floor(math.log10(limit) + 1e-9)
    return next(round(m * power, DIGITS) for m in (5, 2, 1) if m * power <= limit * (1 + 1e-9))
