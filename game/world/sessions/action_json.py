"""The record of an entry: what a session did, as a dict for JSON, and back with every value checked."""

from itertools import pairwise

from game.world.files.checked_table import CheckedTable, shown
from game.world.sand import parameters
from game.world.sand.parameters import Knob
from game.world.sand.sand_colours import AMBER, DYES
from game.world.scenes import hourglass_spec, scene_json
from game.world.scenes.fixture_tables import read_fixtures
from game.world.sessions.action import (
    FIGURES,
    KINDS,
    MATERIALS,
    SHAPES,
    USUAL_SHAPE,
    Clear,
    Draw,
    Fill,
    Flip,
    Load,
    Paint,
    Reshape,
    SetFixtures,
    SetRule,
    Turn,
    snap,
)
from game.world.sessions.history import REDO, UNDO, WAIT, Entry

PLACE = Knob("place", 0.0, -1e6, 1e6, "cells", "a distance from the left or upper side of the lattice")
PLAIN = {"flip": Flip, "clear": Clear, UNDO: UNDO, REDO: REDO, WAIT: WAIT}  # entries that say no more
SPRAY = Knob("spray", 0, 0, 2**53, "", "which cells a spray picks; 0 picks all", whole=True)
EDGE = Knob(
    "edge", 0, 0, parameters.BRUSH.high, "cells", "drawn inwards from a figure's outline; 0 draws all", whole=True
)
QUARTERS = Knob("quarters", 1, 1, 3, "", "of a turn, clockwise", whole=True)
BRUSH = ("material", "diameter", "over_walls", "shape", "only", "spray", "colour")
FIGURE = ("figure", "material", "from", "to", "edge", "over_walls", "colour")
LONGEST_STROKE = 100_000  # segments


def encode(entry, known):
    """Return an Entry as a dict; known: the scenes told of so far in the file, {start digest: scene}, added to."""
    values = {"at": entry.at, "do": None}
    match entry.what:
        case Paint() as paint:
            values |= {"do": "paint", **_brush(paint)}
            values |= {"from": _place(paint.start, paint.diameter), "to": _place(paint.end, paint.diameter)}
        case Draw() as draw:
            values |= {"do": "draw", **_figure(draw)}
        case Fill(material, place) as fill:
            values |= {"do": "fill", "material": material, "place": _short(place), **_colour(fill)}
        case Turn(quarters):
            values |= {"do": "turn", "quarters": quarters}
        case Reshape(glass, refill):
            values |= {"do": "reshape", "glass": glass.as_dict()} | ({"refill": True} if refill else {})
        case SetFixtures(fixtures):
            values |= {"do": "fixtures", "fixtures": [each.as_dict() for each in fixtures]}
        case SetRule(rule):
            values |= {"do": "rule", "rule": rule.as_dict()}
        case Load(scene, seed):
            values |= {"do": "load", "scene": scene_json.encode(scene, known), "seed": seed}
        case Flip() | Clear():
            values["do"] = type(entry.what).__name__.lower()
        case _:
            values["do"] = entry.what
    return values | ({"join": True} if entry.join else {})


def encode_story(entries, known):
    """Yield entries as dicts, the joined segments of a line drawn with one brush as one stroke."""
    stroke = []
    for entry in entries:
        if stroke and not (entry.join and _continues(stroke[-1].what, entry.what) and len(stroke) < LONGEST_STROKE):
            yield _encode_stroke(stroke, known)
            stroke = []
        if isinstance(entry.what, Paint):
            stroke.append(entry)
        else:
            yield encode(entry, known)
    if stroke:
        yield _encode_stroke(stroke, known)


def decode(table, known):
    """Return the entries, one or more, that a record tells of, a CheckedTable; raise TableError where it is none."""
    at = table.number("at", parameters.MOMENT)
    kind = table.choice(
        "do", ("paint", "stroke", "draw", "fill", "turn", "reshape", "fixtures", "rule", "load", *PLAIN)
    )
    joined = _flag(table, "join")
    if kind == "stroke":
        return _decode_stroke(table, at, joined)
    if kind == "paint":
        table.allow(("at", "do", "join", *BRUSH, "from", "to"))
        start, end = (_decode_place(table, key) for key in ("from", "to"))
        what = Paint(start=start, end=end, **_decode_brush(table))
    elif kind == "draw":
        table.allow(("at", "do", "join", *FIGURE))
        what = _decode_figure(table)
    elif kind == "fill":
        table.allow(("at", "do", "join", "material", "place", "colour"))
        what = Fill(table.choice("material", tuple(MATERIALS)), _decode_place(table, "place"), _decode_colour(table))
    elif kind == "turn":
        table.allow(("at", "do", "join", "quarters"))
        what = Turn(table.number("quarters", QUARTERS))
    elif kind == "reshape":
        table.allow(("at", "do", "join", "glass", "refill"))
        what = Reshape(hourglass_spec.read(table.table("glass")), _flag(table, "refill"))
    elif kind == "fixtures":
        table.allow(("at", "do", "join", "fixtures"))
        what = SetFixtures(read_fixtures(table))
    elif kind == "rule":
        table.allow(("at", "do", "join", "rule"))
        what = SetRule(scene_json.decode_rule(table.table("rule")))
    elif kind == "load":
        table.allow(("at", "do", "join", "scene", "seed"))
        what = Load(scene_json.decode(table.table("scene"), known), table.number("seed", parameters.SEED))
    else:
        table.allow(("at", "do", "join"))
        what = PLAIN[kind] if isinstance(PLAIN[kind], str) else PLAIN[kind]()
    return [Entry(at, what, joined)]


def _brush(paint):
    values = {"material": paint.material, "diameter": paint.diameter}
    values |= {"over_walls": True} if paint.over_walls else {}
    values |= {"shape": paint.shape} if paint.shape != USUAL_SHAPE else {}
    values |= {"only": paint.only} if paint.only else {}
    return values | ({"spray": paint.spray} if paint.spray else {}) | _colour(paint)


def _colour(act):
    return {"colour": act.colour} if act.colour != AMBER else {}


def _figure(draw):
    values = {"figure": draw.figure, "material": draw.material}
    values |= {"from": _short(draw.start), "to": _short(draw.end)}
    values |= {"edge": draw.edge} if draw.edge else {}
    return values | ({"over_walls": True} if draw.over_walls else {}) | _colour(draw)


def _place(place, diameter):
    """Return a place as short as it can be written: the middle that a brush of that diameter takes there."""
    return _short(snap(place, diameter))


def _short(place):
    return [int(part) if part == int(part) else part for part in place]


def _continues(before, paint):
    """Return whether a segment goes on where the one before ended, with the same brush."""
    if not isinstance(paint, Paint) or _brush(before) != _brush(paint):
        return False
    return _place(before.end, before.diameter) == _place(paint.start, paint.diameter)


def _encode_stroke(entries, known):
    """Return the record of segments: the path's points as [iterations since the point before, x, y], start first."""
    if len(entries) == 1:
        return encode(entries[0], known)
    first = entries[0]
    diameter = first.what.diameter
    path = [[0, *_place(first.what.start, diameter)], [0, *_place(first.what.end, diameter)]]
    path += [[each.at - before.at, *_place(each.what.end, diameter)] for before, each in pairwise(entries)]
    values = {"at": first.at, "do": "stroke", **_brush(first.what), "path": path}
    return values | ({"join": True} if first.join else {})


def _decode_stroke(table, at, joined):
    table.allow(("at", "do", "join", *BRUSH, "path"))
    brush = _decode_brush(table)
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


def _decode_brush(table):
    """Return the fields of a Paint beside its places."""
    return {
        "material": table.choice("material", tuple(MATERIALS)),
        "diameter": table.number("diameter", parameters.BRUSH),
        "over_walls": _flag(table, "over_walls"),
        "shape": table.choice("shape", tuple(SHAPES), USUAL_SHAPE),
        "only": table.choice("only", tuple(KINDS)) if "only" in table else "",
        "spray": table.number("spray", SPRAY, SPRAY.default),
        "colour": _decode_colour(table),
    }


def _decode_colour(table):
    return table.choice("colour", DYES, AMBER)


def _decode_figure(table):
    return Draw(
        table.choice("figure", tuple(FIGURES)),
        table.choice("material", tuple(MATERIALS)),
        *(_decode_place(table, key) for key in ("from", "to")),
        table.number("edge", EDGE, EDGE.default),
        _flag(table, "over_walls"),
        _decode_colour(table),
    )


def _decode_place(table, key):
    value = table.values.get(key)
    if not isinstance(value, list) or len(value) != 2:
        raise table.error(key, shown(value), "a place [x, y]")
    numbers = CheckedTable(table.file, dict(zip("xy", value, strict=True)), f"{table.where}{key}.")
    return numbers.number("x", PLACE), numbers.number("y", PLACE)


def _flag(table, key):
    value = table.values.get(key, False)
    if not isinstance(value, bool):
        raise table.error(key, shown(value), "true or false")
    return value
