"""The lean: the bias of the rule as a tilt of the table, in steps, told in words and shown as a frame that leans."""

import math

from game.play.ui import theme as look
from game.play.view.outlines import Mark
from game.world.sessions.action import SetRule

STEP = 0.1  # of bias
MOST = math.radians(4)  # how far the frame leans at a bias of 1
AROUND = 4  # pixels from the lattice, or from what is in sight of it, to the upright frame


def tilted(rule, way):
    """Return the SetRule that leans the table a step to the left (-1) or right (1), or None where it cannot."""
    if rule.p == 0.0:
        return None
    steps = round(rule.bias / STEP, 6)
    steps = math.floor(steps) + 1 if way > 0 else math.ceil(steps) - 1
    return SetRule(rule.leaning(min(max(steps * STEP, -1.0), 1.0)))


def told(bias):
    """Return the words for a table that leans by `bias`."""
    if bias == 0.0:
        return "The table is upright: bias 0"
    return f"The table leans to the {'left' if bias < 0 else 'right'}: bias {bias:+.2g}"


def marks(rule, view):
    """Return the Marks that show how `rule` leans: none where it is upright."""
    if rule.bias == 0.0:
        return ()
    left, top, width, height = view.frame or (view.left, view.top, view.width, view.height)
    around = -AROUND if view.frame else AROUND
    middle = left + width / 2, top + height / 2
    wide, high = width / 2 + around, height / 2 + around
    cosine, sine = math.cos(rule.bias * MOST), math.sin(rule.bias * MOST)
    corners = ((-wide, -high), (wide, -high), (wide, high), (-wide, high))
    turned = ((middle[0] + x * cosine - y * sine, middle[1] + x * sine + y * cosine) for x, y in corners)
    return (Mark(tuple((round(x), round(y)) for x, y in turned), look.EDGE),)
