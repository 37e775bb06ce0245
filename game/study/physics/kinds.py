"""The kinds of sand that are held against real sand."""

from typing import NamedTuple

from game import Rule, load_rule


class Kind(NamedTuple):
    """A rule, and how the rows on it are told from those on the paper's sand."""

    name: str
    rule: Rule
    suffix: str = ""  # of the quantities of its rows


SAND = Kind("sand, p = 0.75", Rule.with_p(0.75))
ROLLING = Kind("rolling-sand", load_rule("rolling-sand"), ", rolling-sand")
KINDS = SAND, ROLLING
