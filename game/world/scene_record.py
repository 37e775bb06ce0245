"""A scene in a session file: a shipped one by name, size and digest, any other with its cells."""

import base64
import binascii
import hashlib
import zlib
from functools import lru_cache

import numpy as np

from game.world import fixture, knob
from game.world.colours import WALL_LOOKS
from game.world.rule import FIELDS, SCHEDULES, Rule
from game.world.scene import Scene, load_scene, scene_names
from game.world.table import shown

SHIPPED = ("name", "size", "start")
EMBEDDED = ("name", "title", "notice", "size", "cells", "walls", "rule", "speed", "cell", "fixtures")


def start_digest(scene):
    """Return 16 hex digits that name a scene's size, cells, rule and fixtures."""
    digest = hashlib.blake2b(f"{scene.shape} {scene.rule.as_dict()} ".encode(), digest_size=8)
    digest.update("".join(f"{each} " for each in scene.fixtures).encode())
    for cells in (scene.sand, scene.walls):
        digest.update(np.packbits(cells).tobytes())
    return digest.hexdigest()


def encode(scene, known):
    """Return the record of a scene as a dict for JSON; known: {start digest: scene} of the file so far, added to."""
    start = start_digest(scene)
    if start in known and (known[start].name, known[start].made_of) == (scene.name, scene.made_of):
        return {"again": start}
    known[start] = scene
    size = list(scene.shape[::-1])
    if scene.shipped:
        return {"name": scene.name, "size": size, "start": start}
    bits = np.packbits(scene.sand).tobytes() + np.packbits(scene.walls).tobytes()
    return {
        "name": scene.name,
        "title": scene.title,
        "notice": scene.notice,
        "size": size,
        "cells": base64.b64encode(zlib.compress(bits, 9)).decode(),
        "walls": scene.made_of,
        "rule": scene.rule.as_dict(),
        "speed": scene.speed,
        "cell": scene.cell,
        **({"fixtures": [each.as_dict() for each in scene.fixtures]} if scene.fixtures else {}),
    }


def decode(table, known):
    """Return the Scene of a record, a Table; raise SceneError where it is not one, or a shipped scene has changed."""
    if "again" in table:
        table.allow(("again",))
        start = table.choice("again", tuple(known) or ("a scene told of before",))
        return known[start]
    scene = _embedded(table) if "cells" in table else _shipped(table)
    known[start_digest(scene)] = scene
    return scene


def decode_rule(table):
    """Return the Rule that a Table spells out in full."""
    table.allow(FIELDS)
    numbers = {each.name: table.number(each.name, each) for each in knob.PROBABILITIES}
    return Rule(**numbers, schedule=table.choice("schedule", tuple(SCHEDULES)))


def _size(table):
    value = table.values.get("size")
    try:
        width, height = (knob.SIDE.check(side) for side in value)
    except (TypeError, ValueError, OverflowError):
        raise table.error("size", shown(value), f"[width, height], each {knob.SIDE.wanted}") from None
    return width, height


def _shipped(table):
    table.allow(SHIPPED)
    name, size = table.choice("name", scene_names()), _size(table)
    scene = _load(name, size)
    if table.values.get("start") != start_digest(scene):
        raise table.error("start", shown(table.values.get("start")), f"{start_digest(scene)}: this {name} is another")
    return scene


@lru_cache(maxsize=4)
def _load(name, size):
    return load_scene(name, size)


def _embedded(table):
    table.allow(EMBEDDED)
    width, height = _size(table)
    sand, walls = _cells(table, width, height)
    return Scene(
        name=table.line("name", "scene"),
        title=table.line("title", ""),
        notice=table.line("notice", ""),
        sand=sand,
        walls=walls,
        rule=decode_rule(table.table("rule")),
        speed=table.number("speed", knob.SPEED),
        cell=table.number("cell", knob.CELL),
        made_of=table.choice("walls", WALL_LOOKS, WALL_LOOKS[0]),
        fixtures=fixture.read_all(table),
    )


def _cells(table, width, height):
    """Return sand and walls, (height, width) bool arrays that are not writable."""
    length = -(-width * height // 8)  # bytes
    wanted = f"{2 * length} bytes, packed, of {width}×{height} cells that are sand or wall, not both"
    unpacker = zlib.decompressobj()
    try:
        bits = unpacker.decompress(base64.b64decode(table.values["cells"], validate=True), 2 * length + 1)
    except (TypeError, ValueError, binascii.Error, zlib.error):
        raise table.error("cells", "damaged ones", wanted) from None
    if len(bits) != 2 * length or not unpacker.eof:
        raise table.error("cells", "another number of them", wanted)
    both = [np.frombuffer(part, np.uint8) for part in (bits[:length], bits[length:])]
    sand, walls = (np.unpackbits(part, count=width * height).reshape(height, width).view(np.bool_) for part in both)
    if (both[0] & both[1]).any():
        raise table.error("cells", "a cell that is both", wanted)
    sand.flags.writeable = walls.flags.writeable = False
    return sand, walls
