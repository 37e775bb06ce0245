"""Laws of scenes of other rules than sand: how files spell them, and that pictures and sessions keep them."""

import json
from dataclasses import fields, replace

import numpy as np
import pytest
from PIL import Image

from game import load_rule
from game.world.files import atomic
from game.world.files.checked_table import CheckedTable
from game.world.rules.definition import rule_names
from game.world.sand.advance import advance
from game.world.sand.fixtures import Fixture
from game.world.scenes import scene_json
from game.world.scenes.scene import CELLS, Scene
from game.world.sessions.session import Session
from tests.cells import strewn
from tests.saved import load_picture
from tests.world.rules.small_rule import TEXT, small_rule, written
from tests.world.scenes.test_picture_file import saved
from tests.world.scenes.test_scene import complaint, loaded

SIZE = "width = 6\nheight = 4\n"
ALCHEMY = load_rule("alchemy")
OWN = "a rule file of one's own"


@pytest.fixture(autouse=True)
def quick_disk(monkeypatch):
    """Do not wait for the disk."""
    monkeypatch.setattr(atomic.os, "fsync", lambda handle: None)


@pytest.fixture(params=[*rule_names(), OWN])
def rule(request, tmp_path):
    """Return a rule with chances and a schedule that are not those of its file."""
    named = small_rule(tmp_path) if request.param == OWN else load_rule(request.param)
    return named.with_chances(**{name: p / 2 for name, p in named.chances.items()}).with_schedule("balanced")


def scene_of(rule, number=1):
    """Return a scene with all materials of a rule, with a tap and a drain."""
    tap = Fixture("tap", 3, 1, 4, 1, 5, material=rule.materials[-1])
    cells = strewn(rule, number, 24, 30).materials
    return Scene("own", "Own", "Look.", cells, rule, 90.0, 5, fixtures=(tap, Fixture("drain", 0, 20, 9, 2)))


def named(scene):
    """Return the name of each cell's material."""
    return np.array(scene.rule.materials)[scene.cells].tolist()


# --- files ---


def test_a_scene_of_a_shipped_rule_names_it(tmp_path):
    scene = loaded(tmp_path, f'rule = "alchemy"\n{SIZE}')
    assert scene.rule == ALCHEMY and not scene.cells.any() and scene.world().codes == ALCHEMY.codes


def test_a_scene_has_chances_and_a_schedule_of_its_own(tmp_path):
    scene = loaded(tmp_path, f'{SIZE}[rule]\nname = "alchemy"\ngrow = 0.125\nschedule = "balanced"')
    assert scene.rule == ALCHEMY.with_chances(grow=0.125).with_schedule("balanced")


@pytest.mark.parametrize(
    "spelled", ['rule = "small"\ncells = "lk"', 'cells = "lk"\n[rule]\nname = "small"\nboil = 0.75']
)
def test_the_rule_may_be_a_file_beside_the_scene(tmp_path, spelled):
    own = small_rule(tmp_path)
    scene = loaded(tmp_path, spelled)
    assert scene.rule == own.with_chances(boil=0.75 if "boil" in spelled else 0.5)
    assert named(scene) == [["lava", "stone"]]


def test_cells_are_written_with_the_letters_of_the_materials(tmp_path, rule):
    letters = [each.letter for each in rule.definition.materials]
    if rule.codes.is_sand:
        letters[1] = "o"
    text = f'cells = """\n{"".join(letters)}\n{"".join(letters[::-1])}"""\nrule = "{rule.definition.name}"'
    scene = loaded(tmp_path, text)
    assert scene.cells.tolist() == [[*range(len(letters))], [*range(len(letters))][::-1]]


def test_a_picture_is_read_by_the_colours_of_the_materials(tmp_path, rule):
    if rule.codes.is_sand:
        pytest.skip("sand has colours of its own")
    cells = strewn(rule, 2, 24, 30).materials
    colours = np.array([each.colour for each in rule.definition.materials], np.uint8)
    pixels = np.dstack([colours[cells], np.full(cells.shape, 255, np.uint8)])
    pixels[0] = 255, 255, 255, 0
    Image.fromarray(pixels).save(tmp_path / "drawn.png")
    scene = loaded(tmp_path, f'picture = "drawn.png"\nrule = "{rule.definition.name}"')
    assert scene.problem is None and (scene.cells[1:] == cells[1:]).all() and not scene.cells[0].any()
    pixels[5, 5] = 255, 0, 255, 255
    Image.fromarray(pixels).save(tmp_path / "drawn.png")
    scene = loaded(tmp_path, f'picture = "drawn.png"\nrule = "{rule.definition.name}"')
    assert "found 1 of 720 cells in no material's colour" in scene.problem and scene.problem.isprintable()


def test_shapes_and_taps_are_of_any_material_of_the_rule(tmp_path, rule):
    material = rule.materials[-1 if rule.materials[-1] != "wall" else 1]
    shape = f"[[shape]]\nkind = 'rectangle'\nmaterial = '{material}'\nwidth = 3\n"
    taps = f"[[tap]]\nx = 4\ny = 1\nmaterial = '{material}'\n[[drain]]\nx = 0\ny = 3\n"
    scene = loaded(tmp_path, f'rule = "{rule.definition.name}"\n{SIZE}{shape}{taps}')
    assert named(scene) == [[material] * 3 + ["air"] * 3] * 4
    assert scene.fixtures == (Fixture("tap", 4, 1, material=material), Fixture("drain", 0, 3))
    world = scene.world()
    poured, swallowed = advance(world, scene.rule, 1)
    assert sum(poured) == 1 and sum(swallowed) == 1


def test_a_tap_that_names_no_material_pours_sand_or_else_the_first(tmp_path):
    assert loaded(tmp_path, f'rule = "alchemy"\n{SIZE}[[tap]]\nx = 1\ny = 1').fixtures[0].material == "sand"
    written(tmp_path)
    assert loaded(tmp_path, f'rule = "small"\n{SIZE}[[tap]]\nx = 1\ny = 1').fixtures[0].material == "lava"


POURED = ", ".join(name for name in ALCHEMY.materials if name not in ("air", "wall"))
LEGEND = "w (water), o (oil)"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('rule = "alchemie"\n' + SIZE, "rule.name: found 'alchemie', wanted one of sand, alchemy, "),
        ('rule = "../small"\n' + SIZE, "rule.name: found '../small', wanted one of sand, alchemy, "),
        ('rule = ""\n' + SIZE, "rule.name: found ''"),
        (SIZE + "[rule]\nname = 3", "rule.name: found 3, wanted "),
        (SIZE + "[rule]\nname = 'alchemy'\ngrowth = 1", "rule.growth: found an unknown key, wanted grow"),
        (SIZE + "[rule]\nname = 'alchemy'\ngrow = 1.5", "rule.grow: found 1.5, wanted in [0, 1]"),
        (SIZE + "[rule]\nname = 'alchemy'\np = 1", "rule.p: found an unknown key"),
        (SIZE + "[rule]\nname = 'alchemy'\nschedule = 'quick'", "rule.schedule: found 'quick', wanted one of margolus"),
        (
            SIZE + "[rule]\nname = 'small'\nboil = 1",
            "rule.event 'lava and water': chance: found 1.25 in all, wanted at most 1 in all",
        ),
        ('rule = "broken"\n' + SIZE, "broken.toml:"),
        ('rule = "water-and-oil"\ncells = "w1"', "cells: found '1' in row 1, column 2, wanted only . (empty), "),
        ('rule = "water-and-oil"\ncells = "wkw"', LEGEND),
        (f'rule = "alchemy"\n{SIZE}[[tap]]\nx = 1\ny = 1\nmaterial = "gold"', f"wanted one of {POURED}"),
        (
            f'rule = "alchemy"\n{SIZE}[[tap]]\nx = 1\ny = 1\nmaterial = "wall"',
            f"tap 1.material: found 'wall', wanted one of {POURED}",
        ),
        (
            f'rule = "alchemy"\n{SIZE}[[drain]]\nx = 1\ny = 1\nmaterial = "oil"',
            "drain 1.material: found an unknown key",
        ),
        (
            f'rule = "alchemy"\n{SIZE}[[shape]]\nkind = "rectangle"\nmaterial = "gold"',
            "material: found 'gold', wanted one of empty, ",
        ),
        (
            f'rule = "alchemy"\n{SIZE}[[shape]]\nkind = "rectangle"\nmaterial = "dye"',
            "material: found 'dye', wanted one of empty, ",
        ),
    ],
)
def test_what_a_rule_has_not_is_told_in_one_line(tmp_path, text, words):
    written(tmp_path)
    (tmp_path / "broken.toml").write_text(TEXT.replace("X? -> M?", "X? -> Q?"))
    line = complaint(tmp_path, text)
    assert words in line


# --- pictures and sessions ---


def is_same(scene, other):
    """Return whether two scenes are one in all but their names and what was odd about their files."""
    told = [each.name for each in fields(Scene) if each.name not in (*CELLS, "problem", "name")]
    return (scene.cells == other.cells).all() and all(getattr(scene, each) == getattr(other, each) for each in told)


def test_a_saved_picture_is_the_scene(tmp_path, rule):
    scene = scene_of(rule)
    found, seed = load_picture(saved(tmp_path, Session(scene, 9)))
    assert seed == 9 and found.problem is None and is_same(found, scene)
    assert found.world(9).digest() == scene.world(9).digest()


def test_a_saved_picture_of_materials_of_one_colour_is_the_scene(tmp_path):
    own = small_rule(tmp_path, ("#94918c", "#f2561d"))
    scene = scene_of(own)
    found, _ = load_picture(saved(tmp_path, Session(scene)))
    assert found.problem is None and is_same(found, scene)


def test_a_recorded_scene_is_the_scene(rule):
    scene = scene_of(rule)
    record = json.loads(json.dumps(scene_json.encode(scene, scene_json.KnownScenes())))
    known = scene_json.KnownScenes()
    found = scene_json.decode(CheckedTable("file", record), known)
    assert is_same(found, scene) and found.name == scene.name
    assert scene_json.start_digest(found) == scene_json.start_digest(scene)
    again = scene_json.encode(scene, known)
    assert scene_json.decode(CheckedTable("file", again), known) is found


def test_scenes_that_differ_in_their_rule_alone_are_told_apart(rule):
    scene, known = scene_of(rule), scene_json.KnownScenes()
    other = replace(scene, rule=rule.with_schedule("paper"))
    assert [("again" in scene_json.encode(each, known)) for each in (scene, other, scene)] == [False, False, True]


def test_a_rule_of_ones_own_is_on_file_in_its_words(tmp_path):
    scene = scene_of(small_rule(tmp_path))
    record = json.dumps(scene_json.encode(scene, scene_json.KnownScenes()))
    path = saved(tmp_path, Session(scene))
    (tmp_path / "small.toml").unlink()
    found = scene_json.decode(CheckedTable("file", json.loads(record)), scene_json.KnownScenes())
    assert found.rule == load_picture(path).scene.rule == scene.rule and found.rule.definition.texts == (TEXT,)
