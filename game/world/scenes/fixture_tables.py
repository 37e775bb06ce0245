"""Taps and drains as the tables of a file spell them."""

from game.world.sand import parameters
from game.world.sand.fixtures import DRAIN, FIRST_CELL, MOST, SIDE, TAP, Fixture
from game.world.sand.material_codes import SAND_NAME
from game.world.sand.sand_colours import AMBER, DYES

KEYS = {
    DRAIN: ("x", "y", "width", "height", "every"),
    TAP: ("x", "y", "width", "height", "every", "colour", "material"),
}


def read_fixture(table, kind, codes=None):
    """Return the Fixture of a kind that a CheckedTable spells; raise TableError where it spells none.

    codes: the MaterialCodes of the world that it is for, if they are known.
    """
    sizes = (table.number(key, SIDE, SIDE.default) for key in ("width", "height"))
    x, y = table.number("x", FIRST_CELL), table.number("y", FIRST_CELL)
    every, colour = table.number("every", parameters.EVERY, 1), table.choice("colour", DYES, AMBER)
    if codes is None:
        material = table.line("material", SAND_NAME)
    else:
        material = table.choice("material", [codes.names[code] for code in sorted(codes.filled)], codes.usual)
    return Fixture(kind, x, y, *sizes, every, colour, material if kind == TAP else SAND_NAME)


def read_fixtures(table, key="fixtures"):
    """Return the tuple of fixtures in the array at `key` of a CheckedTable, spelled as `Fixture.as_dict` does."""
    found = []
    for each in table.tables(key):
        kind = each.choice("kind", (TAP, DRAIN))
        each.allow(("kind", *KEYS[kind]))
        found.append(read_fixture(each, kind))
    return checked_number(found, table, key)


def checked_number(found, table, key):
    """Return fixtures as a tuple; raise TableError at `key` where there are too many."""
    if len(found) > MOST:
        raise table.error(key, f"{len(found)} fixtures", f"at most {MOST}")
    return tuple(found)
