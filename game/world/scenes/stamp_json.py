"""A stamp in a session file: its cells with the names of their materials, told once."""

import hashlib

from game.core.planes import DEPTH
from game.world.files.checked_table import shown
from game.world.rules.materials import NAME
from game.world.sand.material_codes import EMPTY, SAND_NAME
from game.world.sand.stamp import Stamp
from game.world.scenes.fixture_tables import read_fixtures
from game.world.scenes.packed_cells import bits_of, cells_of_bits, packed, unpacked
from game.world.scenes.scene_json import check_room, read_size

MOST_NAMES = 64  # of materials
KEYS = ("size", "materials", "cells", "colours", "fixtures")


def encode(stamp, known):
    """Return the record of a Stamp as a dict for JSON; known: the KnownScenes of the file so far, added to."""
    values = {
        "size": list(stamp.shape[::-1]),
        "materials": list(stamp.names),
        "cells": packed(bits_of(stamp.cells, _depth(stamp.names))),
        **({"colours": packed(bits_of(stamp.colours, DEPTH))} if stamp.colours is not None else {}),
        **({"fixtures": [each.as_dict() for each in stamp.fixtures]} if stamp.fixtures else {}),
    }
    digest = _digest(values)
    if digest in known.stamps:
        return {"again": digest}
    known.stamps[digest] = stamp
    known.charge(values)
    return values


def decode(table, known):
    """Return the Stamp that a CheckedTable records; raise TableError if it is none."""
    if "again" in table:
        table.allow(("again",))
        return known.stamps[table.choice("again", tuple(known.stamps) or ("a stamp told of before",))]
    table.allow(KEYS)
    width, height = read_size(table)
    check_room(table, known, width, height)
    names = _names(table)
    cells = cells_of_bits(unpacked(table, "cells", width, height, _depth(names)))
    if cells.max() >= len(names):
        raise table.error("cells", f"code {cells.max()}, which no material has", f"cells of {', '.join(names)}")
    stamp = Stamp(names, cells, _colours(table, names, cells), read_fixtures(table))
    known.stamps[_digest(table.values)] = stamp
    return stamp


def _names(table):
    names = table.values.get("materials")
    if (
        not isinstance(names, list)
        or not 1 < len(names) <= MOST_NAMES
        or not all(isinstance(name, str) and NAME.fullmatch(name) for name in names)
    ):
        raise table.error("materials", shown(names), f"2 to {MOST_NAMES} names of materials")
    return tuple(names)


def _colours(table, names, cells):
    """Return the colours of the sand, uint8, that the record tells of, or None."""
    if "colours" not in table:
        return None
    colours = cells_of_bits(unpacked(table, "colours", *cells.shape[::-1], DEPTH))
    sand = names.index(SAND_NAME) if SAND_NAME in names else EMPTY
    if (colours[cells != sand] > 0).any() or sand == EMPTY:
        raise table.error("colours", "a colour where there is no sand", "colours of the sand in cells")
    return colours


def _depth(names):
    """Return how many bits a cell has."""
    return (len(names) - 1).bit_length()


def _digest(values):
    return hashlib.blake2b(repr(sorted(values.items())).encode(), digest_size=8).hexdigest()
