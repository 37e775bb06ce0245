"""Durations as people write them, and as they are shown."""

import math
import re

from game.world.sand import parameters

WITH_UNITS = re.compile(r"(?:(\d+(?:\.\d+)?)h)?(?:(\d+(?:\.\d+)?)m)?(?:(\d+(?:\.\d+)?)s)?")
WITH_COLONS = re.compile(r"(?:(\d+):)?(\d+):([0-5]\d(?:\.\d+)?)")


def parse_duration(text):
    """Return the seconds that text such as '90', '90s', '3m', '1h30m' or '1:30' spells; raise ValueError for others."""
    plain = text.strip().lower().replace(" ", "")
    wanted = (
        f"a time such as 90, 90s, 3m, 1:30 or 1h, from {spell(parameters.TIMER.low)} to {spell(parameters.TIMER.high)}"
    )
    seconds = _seconds(plain)
    if seconds is None or not parameters.TIMER.low <= seconds <= parameters.TIMER.high:
        raise ValueError(f"{parameters.TIMER.name} must be {wanted}, got {text!r}")
    return seconds


def _seconds(plain):
    """Return the seconds of text without blanks, or None where it spells none."""
    if re.fullmatch(r"\d+(\.\d+)?", plain):
        return float(plain)
    found = WITH_COLONS.fullmatch(plain) or (WITH_UNITS.fullmatch(plain) if plain else None)
    if found is None:
        return None
    hours, minutes, seconds = (float(part or 0) for part in found.groups())
    return 3600 * hours + 60 * minutes + seconds


def spell(seconds, digits=0):
    """Return a time as '3:00' or '1:00:00', rounded to so many digits after the point."""
    parts = round(seconds * 10**digits)
    whole, fraction = divmod(parts, 10**digits)
    minutes, rest = divmod(whole, 60)
    hours, minutes = divmod(minutes, 60)
    text = f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
    return f"{text}.{fraction:0{digits}}" if digits else text


def spell_short(seconds):
    """Return a time in few letters: '10 s', '2:30', from an hour on '1:30 h'."""
    whole = round(seconds)
    if whole < 60:
        return f"{seconds:.3g} s"
    return spell(whole) if whole < 3600 else f"{spell(round(whole / 60))} h"


def spell_left(seconds):
    """Return the time that is left as '2:31', so that 0:00 is shown only once it is over."""
    return spell(math.ceil(max(0.0, seconds)))
