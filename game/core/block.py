"""What one block does, 64 blocks at a time: a gate for each event.

A block's corners are a b over c d. Arguments are words whose bit i belongs to block i: a, b, c, d hold sand, oa … od
what is occupied (sand or wall). At most one event is possible in a block.
"""

from game.core.jit import gate


@gate
def falls(upper, lower_occupied):
    """Return where the upper grain of a column is free to fall."""
    return upper & ~lower_occupied


@gate
def topples(upper, lower_occupied, other_upper_occupied, other_lower_occupied):
    """Return where a grain on an occupied cell has the whole other column free."""
    return upper & lower_occupied & ~(other_upper_occupied | other_lower_occupied)


@gate
def events(a, b, oa, ob, oc, od):
    """Return (left falls, right falls, topples left, topples right)."""
    return falls(a, oc), falls(b, od), topples(b, od, oa, oc), topples(a, oc, ob, od)
