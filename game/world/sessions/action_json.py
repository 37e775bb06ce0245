"""Entries of a session as dicts for JSON, and back with every value checked, by one table of fields."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

from game.world.files.checked_table import CheckedTable, shown
from game.world.rules.materials import NAME
from game.world.rules.rule_json import decode_rule, encode_rule
from game.world.sand import parameters
from game.world.sand.parameters import Knob
from game.world.sand.sand_colours import AMBER, DYES
from game.world.scenes import hourglass_spec, scene_json, stamp_json
from game.world.scenes.fixture_tables import read_fixtures
from game.world.sessions.action import (
    ANCHORS,
    FIGURES,
    SHAPES,
    USUAL_SHAPE,
    Clear,
    Draw,
    Fill,
    Flip,
    Load,
    Move,
    Paint,
    Paste,
    Reshape,
    Resize,
    SetFixtures,
    SetRule,
    Turn,
    snap,
)
from game.world.sessions.history import REDO, UNDO, WAIT, WITHDRAW, Entry

PLACE = Knob("place", 0.0, -1e6, 1e6, "cells", "a distance from the left or upper side of the lattice")
SPRAY = Knob("spray", 0, 0, 2**53, "", "which cells a spray picks; 0 picks all", whole=True)
EDGE = Knob(
    "edge", 0, 0, parameters.BRUSH.high, "cells", "drawn inwards from a figure's outline; 0 draws all", whole=True
)
QUARTERS = Knob("quarters", 1, 1, 3, "", "of a turn, clockwise", whole=True)
LONGEST_STROKE = 100_000  # segments
ALWAYS = object()  # the default of what is always spelled out


class Field(NamedTuple):
    """One value of an act."""

    key: str  # in the dict
    attribute: str  # of the act
    read: Callable  # (table, scenes known) -> the value
    spell: Callable  # (value, scenes known) -> the value for JSON
    default: Any = ALWAYS  # left out of the dict


def _read_flag(table, key):
    value = table.values.get(key, False)
    if not isinstance(value, bool):
        raise table.error(key, shown(value), "true or false")
    return value


def _read_material(table, key):
    value = table.values.get(key, "")
    if not isinstance(value, str) or not NAME.fullmatch(value):
        raise table.error(key, shown(value), "the name of a material")
    return value


def _plain(key, read, default=ALWAYS):
    return Field(key, key, lambda table, known: read(table, key), lambda value, known: value, default)


def _choice(key, options, default=ALWAYS):
    return _plain(key, lambda table, key: table.choice(key, tuple(options)), default)


def _number(key, knob, default=ALWAYS):
    return _plain(key, lambda table, key: table.number(key, knob), default)


def _place(key, attribute):
    return Field(key, attribute, lambda table, known: _read_place(table, key), lambda place, known: _short(place))


def _flag(key):
    return _plain(key, _read_flag, False)


MATERIAL, COLOUR, OVER_WALLS = _plain("material", _read_material), _choice("colour", DYES, AMBER), _flag("over_walls")
FROM, TO = _place("from", "start"), _place("to", "end")
BRUSH = (
    MATERIAL,
    _number("diameter", parameters.BRUSH),
    OVER_WALLS,
    _choice("shape", SHAPES, USUAL_SHAPE),
    _plain("only", _read_material, ""),
    _number("spray", SPRAY, 0),
    COLOUR,
)
GLASS = Field(
    "glass",
    "glass",
    lambda table, known: hourglass_spec.read(table.table("glass")),
    lambda glass, known: glass.as_dict(),
)
FIXTURES = Field(
    "fixtures",
    "fixtures",
    lambda table, known: read_fixtures(table),
    lambda fixtures, known: [each.as_dict() for each in fixtures],
)
RULE = Field(
    "rule", "rule", lambda table, known: decode_rule(table.table("rule")), lambda rule, known: encode_rule(rule)
)
SCENE = Field("scene", "scene", lambda table, known: scene_json.decode(table.table("scene"), known), scene_json.encode)
STAMP = Field("stamp", "stamp", lambda table, known: stamp_json.decode(table.table("stamp"), known), stamp_json.encode)
ACTS = {  # what an entry is told to do: the act, and its fields in the order in which they are spelled
    "paint": (Paint, (*BRUSH, FROM, TO)),
    "stroke": (Paint, BRUSH),  # of which the path says where
    "draw": (Draw, (_choice("figure", FIGURES), MATERIAL, FROM, TO, _number("edge", EDGE, 0), OVER_WALLS, COLOUR)),
    "fill": (Fill, (MATERIAL, _place("place", "place"), COLOUR)),
    "paste": (Paste, (STAMP, _place("place", "place"), _flag("air"))),
    "move": (Move, (FROM, TO, _place("place", "place"), _number("quarters", QUARTERS, 0), _flag("mirrored"))),
    "resize": (
        Resize,
        (_number("width", parameters.SIDE), _number("height", parameters.SIDE), _choice("anchor", ANCHORS)),
    ),
    "turn": (Turn, (_number("quarters", QUARTERS),)),
    "reshape": (Reshape, (GLASS, _flag("refill"))),
    "fixtures": (SetFixtures, (FIXTURES,)),
    "rule": (SetRule, (RULE,)),
    "load": (Load, (SCENE, _number("seed", parameters.SEED))),
    "flip": (Flip, ()),
    "clear": (Clear, ()),
}
NAMES = {act: name for name, (act, _) in ACTS.items() if name != "stroke"}


def encode(entry, known):
    """Return an Entry as a dict; known: the scenes told of so far in the file, {start digest: scene}, added to."""
    what = _snapped(entry.what) if isinstance(entry.what, Paint) else entry.what
    name = what if isinstance(what, str) else NAMES[type(what)]
    fields = () if isinstance(what, str) else ACTS[name][1]
    return {"at": entry.at, "do": name, **_spelled(what, fields, known), **_joined(entry)}


def decode(table, known):
    """Return the entries, one or more, that a CheckedTable records; raise TableError where it records none."""
    at = table.number("at", parameters.MOMENT)
    name = table.choice("do", (*ACTS, UNDO, REDO, WAIT, WITHDRAW))
    joined = _read_flag(table, "join")
    if name == "stroke":
        return _decode_stroke(table, at, joined)
    act, fields = ACTS.get(name, (None, ()))
    table.allow(("at", "do", "join", *(each.key for each in fields)))
    values = _read(table, fields, known)
    return [Entry(at, act(**values) if act else name, joined)]


def _spelled(act, fields, known):
    """Return the dict of an act's fields, without those that have their defaults."""
    values = [(each, getattr(act, each.attribute)) for each in fields]
    return {each.key: each.spell(value, known) for each, value in values if value != each.default}


def _read(table, fields, known):
    """Return an act's values by attribute."""
    return {
        each.attribute: each.read(table, known) if each.key in table or each.default is ALWAYS else each.default
        for each in fields
    }


def _joined(entry):
    return {"join": True} if entry.join else {}


def _snapped(paint):
    """Return the stroke between the places where its brush is centred, which are short to write."""
    return replace(paint, start=snap(paint.start, paint.diameter), end=snap(paint.end, paint.diameter))


def _short(place):
    return [int(part) if part == int(part) else part for part in place]


def _decode_stroke(table, at, joined):
    table.allow(("at", "do", "join", *(each.key for each in BRUSH), "path"))
    brush = _read(table, BRUSH, {})
    path = table.values.get("path")
    wanted = f"2 to {LONGEST_STROKE + 1} points [iterations, x, y]"
    if not isinstance(path, list) or not 2 <= len(path) <= LONGEST_STROKE + 1:
        raise table.error("path", shown(path), wanted)
    entries, before = [], None
    for point in path:
        if not isinstance(point, list) or len(point) != 3:
            raise table.error("path", shown(point), wanted)
        numbers = CheckedTable(table.file, dict(zip(("wait", "x", "y"), point, strict=True)), f"{table.where}path.")
        at = at + numbers.number("wait", parameters.MOMENT)
        place = numbers.number("x", PLACE), numbers.number("y", PLACE)
        if before:
            what = Paint(start=before, end=place, **brush)
            entries.append(Entry(at, what, joined or bool(entries)))
        before = place
    if at > parameters.MOMENT.high:
        raise table.error("path", "a stroke without end", parameters.MOMENT.wanted)
    return entries


def _read_place(table, key):
    value = table.values.get(key)
    if not isinstance(value, list) or len(value) != 2:
        raise table.error(key, shown(value), "a place [x, y]")
    numbers = CheckedTable(table.file, dict(zip("xy", value, strict=True)), f"{table.where}{key}.")
    return numbers.number("x", PLACE), numbers.number("y", PLACE)
