"""Laws of the shipped scenes: what their sentences promise is so."""

import tomllib

import numpy as np
import pytest

from game.world.files.paths import asset
from game.world.sand.advance import advance
from game.world.scenes.scene import load_scene


def test_no_sand_of_the_silo_is_outside_of_its_hopper():
    silo = load_scene("silo")
    assert not (silo.sand & np.maximum.accumulate(silo.walls, axis=0)).any()


@pytest.mark.parametrize("name", ["aquarium", "kitchen", "volcano", "forest-fire", "winter-pond", "acid-cave"])
def test_water_fills_its_basin_up_to_the_shores(name):
    world = load_scene(name).world(0)
    water, air = (np.pad(world.where(material), 1) for material in ("water", "air"))
    assert water.any()
    for rows, columns in ((0, 1), (0, -1), (1, 0)):
        assert not (np.roll(water, (rows, columns), (0, 1)) & air).any()


def test_sand_covers_every_roof_of_the_city_and_lies_in_every_room_and_only_the_spire_looks_out():
    city = load_scene("city")
    world = city.world(0)
    advance(world, city.rule, 15_000)
    top = np.flatnonzero(world.sand.any(axis=1))[0]
    boxes = [each for each in tomllib.loads(asset("scenes", "city.toml").read_text())["shape"] if "x" in each]
    roofs = [each for each in boxes if each["material"] == "wall"]
    rooms = [each for each in boxes if each["material"] == "empty" and each["x"] != 160 and each["width"] > 2]
    assert len(roofs) == len(rooms) == 7
    for each in roofs:
        assert world.sand[each["y"] - 1, each["x"] : each["x"] + each["width"]].all()
    for each in rooms:
        for floor in range(each["repeat"][1]):
            rows = slice(each["y"] + 14 * floor, each["y"] + 14 * floor + each["height"])
            held = world.sand[rows, each["x"] : each["x"] + each["width"]]
            assert held.mean() > 0.12 and held[-1, 0] and held[-1, -1]
    assert city.walls[: top - 20, 162:184].any() and not city.walls[72 : top - 20, :162].any()


def test_the_steam_engine_keeps_going():
    engine = load_scene("steam-engine")
    world, seen = engine.world(0), []
    advance(world, engine.rule, 10_000)
    for _ in range(10):
        advance(world, engine.rule, 200)
        seen.append(world.where("steam").sum())
    assert np.mean(seen) > 12 and world.where("lava").sum() > 100
