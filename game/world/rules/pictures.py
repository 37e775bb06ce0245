"""Pictures: one cell, two cells or 2×2 cells before and after, and the places that they can have in a block.

A block's corners are   a b
                        c d   and a picture laid on it is four signs in this order; '?' is not looked at.
"""

import re
from dataclasses import dataclass

MOST_OUTCOMES = 4
WAYS = ("as drawn", "mirror", "turn")
WANTED = "one cell, two cells or 2×2 cells, the same before -> after (or before -> one after | another)"

# Where each corner takes its sign from: as drawn, mirrored, upside down, turned half, left, right; the two diagonals.
MIRROR = (1, 0, 3, 2)
_SYMMETRIES = {
    "as drawn": ((0, 1, 2, 3),),
    "mirror": ((0, 1, 2, 3), MIRROR),
    "turn": (
        *((0, 1, 2, 3), MIRROR, (2, 3, 0, 1), (3, 2, 1, 0)),
        *((1, 3, 0, 2), (2, 0, 3, 1), (0, 2, 1, 3), (3, 1, 2, 0)),
    ),
}
_SPOTS = {  # (height, width): for each place of the picture the corners that its cells lie on
    (1, 1): ((0,), (1,), (2,), (3,)),
    (1, 2): ((0, 1), (2, 3)),
    (2, 1): ((0, 2), (1, 3)),
    (2, 2): ((0, 1, 2, 3),),
}


class BlockPictureError(ValueError):
    """A picture that cannot be read; its two arguments are what was found and what is wanted."""


@dataclass(frozen=True)
class BlockPicture:
    """What is drawn: a grid before, and the grids after, one for each outcome. Each is a tuple of rows of signs."""

    before: tuple
    afters: tuple

    @property
    def shape(self):
        """Its (height, width) in cells."""
        return len(self.before), len(self.before[0])

    def lines(self):
        """Return the picture as lines of text."""
        rows = zip(self.before, *self.afters, strict=True)
        return [f"{row[0]} {'->' if n == 0 else '  '} {' | '.join(row[1:])}" for n, row in enumerate(rows)]


@dataclass(frozen=True)
class Placement:
    """A picture laid on a block: four signs before, and four for each outcome after."""

    before: tuple
    afters: tuple

    def mirrored(self):
        """Return its left-right mirror image."""
        return _turned(self, MIRROR)


def read_picture(text):
    """Return the BlockPicture that `text` draws; raise BlockPictureError where it draws none."""
    rows = [[part for part in re.split(r"\s+|->|\|", row) if part] for row in text.split("\n") if row.strip()]
    if not 1 <= len(rows) <= 2 or len({len(row) for row in rows}) != 1 or not 2 <= len(rows[0]) <= 1 + MOST_OUTCOMES:
        raise BlockPictureError(
            f"{len(rows)} rows of {', '.join(str(len(row)) for row in rows[:3]) or 'no'} parts", WANTED
        )
    widths = {len(part) for row in rows for part in row}
    if len(widths) != 1 or max(widths) > 2:
        raise BlockPictureError(f"parts of {', '.join(map(str, sorted(widths)[:4]))} cells in a row", WANTED)
    before, *afters = zip(*rows, strict=True)
    picture = BlockPicture(before, tuple(afters))
    _check_signs(picture)
    return picture


def _check_signs(picture):
    before = "".join(picture.before)
    for after in picture.afters:
        for was, becomes in zip(before, "".join(after), strict=True):
            if (was == "?") != (becomes == "?"):
                raise BlockPictureError(
                    f"{was!r} that becomes {becomes!r}", "a cell that is '?' before to be '?' after"
                )
            if becomes.isupper() and becomes not in before:
                raise BlockPictureError(
                    f"{becomes!r} in the after picture alone", "a letter that says which material it is"
                )


def placements(picture, ways):
    """Return the Placements of a picture in the order in which they are tried."""
    found = []
    for symmetry in _SYMMETRIES[ways]:
        for spot in _SPOTS[picture.shape]:
            before, *afters = (_laid(grid, spot) for grid in (picture.before, *picture.afters))
            each = _turned(Placement(before, tuple(afters)), symmetry)
            if each not in found:
                found.append(each)
    return found


def mirrored_order(tried):
    """Return the order in which placements are tried where the block's fair bit is set.

    Each is replaced by its mirror image, if that is one of them.
    """
    return [each.mirrored() if each.mirrored() in tried else each for each in tried]


def _laid(grid, spot):
    signs = ["?"] * 4
    for corner, sign in zip(spot, "".join(grid), strict=True):
        signs[corner] = sign
    return tuple(signs)


def _turned(placement, sources):
    return Placement(
        tuple(placement.before[source] for source in sources),
        tuple(tuple(after[source] for source in sources) for after in placement.afters),
    )
