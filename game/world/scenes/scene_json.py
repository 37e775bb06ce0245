"""A scene in a session file: a shipped one by name, size and digest, any other with its cells."""

import hashlib
from dataclasses import fields
from functools import lru_cache

import numpy as np

from game.core.planes import DEPTH
from game.world.files.checked_table import shown
from game.world.looks.themes import WALL_LOOKS
from game.world.rules.rule_json import decode_rule, encode_rule
from game.world.sand import parameters
from game.world.sand.material_codes import SAND
from game.world.scenes import hourglass_spec
from game.world.scenes.fixture_tables import read_fixtures
from game.world.scenes.packed_cells import bits_of, cells_of_bits, packed, unpacked
from game.world.scenes.scene import Scene, load_scene, scene_names

SHIPPED = ("name", "size", "start")
EMBEDDED = (
    *("name", "title", "notice", "size", "cells", "colours", "walls", "rule", "speed", "cell"),
    *("fixtures", "glass", "neck"),
)
BESIDE_CELLS = [each.name for each in fields(Scene) if each.name not in ("cells", "colours", "problem")]
NECK = parameters.Knob("neck", 0, 0, parameters.SIDE.high, "", "the row in the middle of a glass", whole=True)


FREE_CELLS = 2**29  # that the scenes of one file may have, however short it is: two lattices of the largest size …
CELLS_PER_BYTE = 64  # … and so many more for each byte of packed cells: what a file takes in memory follows its size


class KnownScenes(dict):
    """The scenes that a file has told of so far, {start digest: scene}, its `stamps`, and `room`.

    That is how many cells more of both may have.
    """

    def __init__(self):
        super().__init__()
        self.room = FREE_CELLS
        self.stamps = {}  # {digest: Stamp}

    @property
    def are_too_many(self):
        """Whether more was told of than anybody reads."""
        return self.room < 0

    def charge(self, values):
        """Take the cells of a scene or a stamp, as its record tells of them, from the room."""
        width, height = values["size"]
        told = values.get("cells", "")
        self.room += CELLS_PER_BYTE * (len(told) if isinstance(told, str) else 0) - width * height


def start_digest(scene):
    """Return 16 hex digits that name a scene's size, cells, rule and fixtures."""
    digest = hashlib.blake2b(f"{scene.shape} {encode_rule(scene.rule)} ".encode(), digest_size=8)
    digest.update("".join(f"{each} " for each in scene.fixtures).encode())
    for cells in (*bits_of(scene.cells, _depth(scene.rule)), *bits_of(scene.colours, DEPTH)):
        digest.update(np.packbits(cells).tobytes())
    return digest.hexdigest()


def encode(scene, known):
    """Return the record of a scene as a dict for JSON; known: the KnownScenes of the file so far, added to."""
    start = start_digest(scene)
    if start in known and all(getattr(known[start], field) == getattr(scene, field) for field in BESIDE_CELLS):
        return {"again": start}
    known[start] = scene
    values = _spelled(scene, start)
    known.charge(values)
    return values


def _spelled(scene, start):
    size = list(scene.shape[::-1])
    if scene.shipped:
        return {"name": scene.name, "size": size, "start": start}
    return {
        "name": scene.name,
        "title": scene.title,
        "notice": scene.notice,
        "size": size,
        "cells": packed(bits_of(scene.cells, _depth(scene.rule))),
        **({"colours": packed(bits_of(scene.colours, DEPTH))} if scene.colours is not None else {}),
        "walls": scene.made_of,
        "rule": encode_rule(scene.rule),
        "speed": scene.speed,
        "cell": scene.cell,
        **({"fixtures": [each.as_dict() for each in scene.fixtures]} if scene.fixtures else {}),
        **({"glass": scene.glass.as_dict()} if scene.glass else {}),
        **({"neck": scene.neck} if scene.neck is not None else {}),
    }


def decode(table, known):
    """Return the Scene that a CheckedTable records; raise TableError if it is none, or a shipped scene has changed."""
    if "again" in table:
        table.allow(("again",))
        start = table.choice("again", tuple(known) or ("a scene told of before",))
        return known[start]
    check_room(table, known, *read_size(table))
    scene = _embedded(table) if "cells" in table else _shipped(table)
    known[start_digest(scene)] = scene
    return scene


def check_room(table, known, width, height):
    """Take the cells that a record tells of from the room; raise TableError where there is none left."""
    known.charge(table.values)
    if known.are_too_many:
        wanted = f"at most {known.room + width * height} more in a file of this size"
        raise table.error("size", f"{width}×{height} cells", wanted)


def read_size(table):
    """Return the (width, height) at `size`."""
    value = table.values.get("size")
    try:
        width, height = (parameters.SIDE.check(side) for side in value)
    except (TypeError, ValueError, OverflowError):
        raise table.error("size", shown(value), f"[width, height], each {parameters.SIDE.wanted}") from None
    return width, height


def _shipped(table):
    table.allow(SHIPPED)
    name, size = table.choice("name", scene_names()), read_size(table)
    scene = _load(name, size)
    if table.values.get("start") != start_digest(scene):
        raise table.error("start", shown(table.values.get("start")), f"{start_digest(scene)}: this {name} is another")
    return scene


@lru_cache(maxsize=4)
def _load(name, size):
    return load_scene(name, size)


def _embedded(table):
    table.allow(EMBEDDED)
    width, height = read_size(table)
    rule = decode_rule(table.table("rule"))
    cells = cells_of_bits(unpacked(table, "cells", width, height, _depth(rule)))
    if cells.max() >= len(rule.materials):
        wanted = f"{width}×{height} cells, each of one of {', '.join(rule.materials)}"
        raise table.error("cells", f"code {cells.max()}, which no material has", wanted)
    colours = _colours(table, cells) if "colours" in table and rule.codes.is_sand else None
    return Scene(
        name=table.line("name", "scene"),
        title=table.line("title", ""),
        notice=table.line("notice", ""),
        cells=cells,
        colours=colours,
        rule=rule,
        speed=table.number("speed", parameters.SPEED),
        cell=table.number("cell", parameters.CELL),
        made_of=table.choice("walls", WALL_LOOKS, WALL_LOOKS[0]),
        fixtures=read_fixtures(table),
        glass=hourglass_spec.read(table.table("glass")) if "glass" in table else None,
        neck=table.number("neck", NECK) if "neck" in table else None,
    )


def _colours(table, cells):
    """Return the colours of the sand, uint8, that the record tells of."""
    colours = cells_of_bits(unpacked(table, "colours", *cells.shape[::-1], DEPTH))
    if (colours[cells != SAND] > 0).any():
        raise table.error("colours", "a colour where there is no sand", "colours of the sand in cells")
    return colours


def _depth(rule):
    """Return how many bits a cell has."""
    return rule.table.bits
