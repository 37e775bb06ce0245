"""Laws of scene files: each shipped one loads and plays, each bad one is told in one line."""

import os
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from game.world.files import checked_table
from game.world.files.paths import asset
from game.world.rules.definition import rule_names
from game.world.rules.rule import Rule
from game.world.sand.advance import advance
from game.world.sand.fixtures import MOST
from game.world.scenes.cell_arrays import SAND_PALETTE
from game.world.scenes.scene import SceneError, load_scene, scene_names, scene_title
from game.world.sessions.moment import account_of
from tests.sweeps import sweep

SIZE = "width = 6\nheight = 4\n"
NAMED = f"wanted one of {', '.join(rule_names())}, or the name of a rule file beside the scene, without .toml"


def loaded(folder, text, size=None):
    """Return the scene in a file that holds `text`, str or bytes."""
    path = folder / "some.toml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return load_scene(path, size)


def complaint(folder, text, size=None):
    """Return what is said about a file that holds `text`, without the file's name."""
    with pytest.raises(SceneError) as caught:
        loaded(folder, text, size)
    line = str(caught.value)
    assert line.isprintable()
    return line.removeprefix(f"{folder / 'some.toml'}: ")


def drawn(scene):
    """Return the scene's cells as rows of characters."""
    return ["".join(row) for row in np.where(scene.walls, "#", np.where(scene.sand, "o", "."))]


# --- the shipped scenes ---


def test_hourglass_is_the_first_scene():
    assert scene_names()[0] == "hourglass"
    assert set(scene_names()) >= {"hourglass", "paper", "funnel", "galton", "sandpile", "ledges", "blank", "fullhd"}


@sweep("name", scene_names(), keep=["hourglass", "fountain", "kitchen"])
def test_no_grain_of_a_shipped_scene_is_made_or_lost(name):
    scene = load_scene(name)
    world = scene.world(seed=3)
    account = account_of(world, scene.rule).passed(advance(world, scene.rule, 500))
    assert scene.name == name
    assert scene.title == scene_title(name) and scene.notice.endswith(".")
    assert world.shape == scene.shape
    assert account.balanced(world) and (account.expected == world.grains or not scene.rule.codes.is_sand)
    assert (world.walls == scene.walls).all()
    assert name == "blank" or (world.materials != scene.world().materials).any()


@sweep("name", [name for name in scene_names() if name != "fullhd"], keep=["hourglass", "tower", "city"])
def test_shipped_scenes_fit_a_small_window_beside_the_panel(name):
    scene = load_scene(name)
    height, width = scene.shape
    assert width * scene.cell <= 980 and height * scene.cell <= 800


def test_hourglass_drains_to_the_last_grain_in_about_a_minute():
    scene = load_scene("hourglass")
    world = scene.world()
    advance(world, scene.rule, int(50 * scene.speed))
    assert world.sand[:120].any()
    advance(world, scene.rule, int(20 * scene.speed))
    assert not world.sand[:120].any()


def test_paper_glass_is_the_same_in_every_run():
    scene = load_scene("paper")
    worlds = [scene.world(seed) for seed in (1, 2)]
    for world in worlds:
        advance(world, scene.rule, 500)
    assert scene.rule == Rule() and scene.shape == (61, 61)
    assert (worlds[0].sand == worlds[1].sand).all()


def test_slopes_of_the_paper_glass_take_turns():
    scene = load_scene("paper")
    world = scene.world()
    lean = []
    for _ in range(60):
        advance(world, scene.rule, 10)
        pile = world.sand[31:]
        lean.append(int(pile[:, 31:].sum()) - int(pile[:, :30].sum()))
    assert min(lean[40:]) <= -8 and max(lean[40:]) == 0


def test_beans_fall_into_the_shape_of_a_bell():
    scene = load_scene("galton")
    world = scene.world(seed=5)
    advance(world, scene.rule, 16_000)
    beans = np.bincount(np.nonzero(world.sand[142:])[1] // 8, minlength=17)
    assert beans.sum() == world.grains
    bins = np.arange(17)
    mean = (bins * beans).sum() / beans.sum()
    assert mean == pytest.approx(8, abs=0.2)
    assert 2.3 < ((bins - mean) ** 2 * beans).sum() / beans.sum() < 3.5
    assert (np.diff(beans[:7]) >= 0).all() and (np.diff(beans[10:]) <= 0).all()


def test_table_of_the_sandpile_keeps_a_hill_of_45_degrees():
    scene = load_scene("sandpile")
    world = scene.world()
    advance(world, scene.rule, 10_000)
    heights = world.sand[:134, 78:152].sum(axis=0)
    assert not world.sand[:70].any()
    assert np.abs(np.diff(heights)).max() <= 2 and heights.max() >= 35
    assert world.sand[138:].any()


# --- the same scene on another lattice ---


@pytest.mark.parametrize("finer", [0.5, 2, 3])
def test_a_finer_lattice_holds_the_same_part_of_sand(finer):
    height, width = load_scene("hourglass").shape
    other = load_scene("hourglass", (int(width * finer), int(height * finer)))
    assert other.shape == (height * finer, width * finer)
    assert other.sand.mean() == pytest.approx(load_scene("hourglass").sand.mean(), rel=0.03)
    assert (other.walls == other.walls[::-1, ::-1]).all()


@sweep("name", scene_names(), keep=["hourglass", "maze", "city"])
def test_any_scene_can_be_made_very_small_or_of_odd_size(name):
    for size in [(96, 54), (77, 103)]:
        scene = load_scene(name, size)
        assert scene.shape == size[::-1]
        assert scene.world().grains == np.isin(scene.cells, list(scene.rule.codes.filled)).sum()


def test_drawn_cells_are_resampled(tmp_path):
    scene = loaded(tmp_path, 'cells = """\n.o\n#.\n"""', (4, 2))
    assert drawn(scene) == ["..oo", "##.."]


@pytest.mark.parametrize("size", [(0, 5), (16385, 5), (2.5, 5), (5, float("nan"))])
def test_a_bad_size_is_told(size):
    with pytest.raises(ValueError, match=re.escape("size must be a whole number in [1, 16384] cells, got")):
        load_scene("blank", size)


# --- where cells come from ---


def test_cells_may_be_written(tmp_path):
    scene = loaded(tmp_path, 'cells = """\r\n..o\r\n#o#\r\n"""')
    assert drawn(scene) == ["..o", "#o#"]
    assert (scene.title, scene.notice, scene.rule, scene.speed, scene.cell) == ("some", "", Rule(), 240, 4)


def test_cells_may_be_a_picture(tmp_path):
    picture = np.array([[SAND_PALETTE.colours[0], (250, 180, 90)], [SAND_PALETTE.colours[2], (0, 0, 0)]], np.uint8)
    Image.fromarray(picture).save(tmp_path / "some.png")
    assert drawn(loaded(tmp_path, 'picture = "some.png"')) == [".o", "#."]
    assert drawn(loaded(tmp_path, 'picture = "some.png"\nwidth = 4\nheight = 2')) == ["..oo", "##.."]


def test_what_is_clear_in_a_picture_is_empty(tmp_path):
    picture = np.array([[(*SAND_PALETTE.colours[1], 0), (*SAND_PALETTE.colours[1], 255)]], np.uint8)
    Image.fromarray(picture).save(tmp_path / "some.png")
    assert drawn(loaded(tmp_path, 'picture = "some.png"')) == [".o"]


@pytest.mark.parametrize(
    ("shape", "rows"),
    [
        ('kind = "rectangle"\nx = 1\ny = 1\nwidth = 3\nheight = 2', [".....", ".ooo.", ".ooo.", ".....", "....."]),
        ('kind = "rectangle"\nheight = 1', ["ooooo", ".....", ".....", ".....", "....."]),
        ('kind = "ellipse"', [".ooo.", "ooooo", "ooooo", "ooooo", ".ooo."]),
        ('kind = "line"\npoints = [[0.5, 0.5], [4.5, 4.5]]', ["o....", ".o...", "..o..", "...o.", "....o"]),
        ('kind = "line"\npoints = [[0, 2.5], [5, 2.5]]\nthickness = 3', [".....", "ooooo", "ooooo", "ooooo", "....."]),
        ('kind = "polygon"\npoints = [[0, 0], [5, 0], [2.5, 2.5]]', ["ooooo", ".ooo.", "..o..", ".....", "....."]),
        ('kind = "bars"\nsize = 1\nacross = 2', ["o.o.o"] * 5),
        ('kind = "pegs"\nsize = 3\nacross = 4\ndown = 3', ["..o..", ".ooo.", "..o..", "o...o", "oo.oo"]),
    ],
)
def test_a_shape_covers_the_cells_whose_centres_it_holds(tmp_path, shape, rows):
    assert drawn(loaded(tmp_path, f'width = 5\nheight = 5\n[[shape]]\nmaterial = "sand"\n{shape}')) == rows


def test_later_shapes_lie_over_earlier_ones(tmp_path):
    text = 'width = 3\nheight = 1\n[[shape]]\nkind = "rectangle"\nmaterial = "wall"\n'
    text += '[[shape]]\nkind = "rectangle"\nmaterial = "sand"\nx = 1\n[[shape]]\n'
    text += 'kind = "rectangle"\nmaterial = "empty"\nx = 2'
    assert drawn(loaded(tmp_path, text)) == ["#o."]


@pytest.mark.parametrize("kind", ["rectangle", "line"])
def test_a_thin_wall_survives_on_a_coarser_lattice(tmp_path, kind):
    where = "y = 7\nheight = 1" if kind == "rectangle" else "points = [[0, 7.5], [16, 7.5]]"
    text = f'width = 16\nheight = 16\n[[shape]]\nkind = "{kind}"\nmaterial = "wall"\n{where}'
    for side in range(1, 16):
        assert loaded(tmp_path, text, (side, side)).walls.any(axis=0).all()


def test_cells_of_a_scene_cannot_be_written_to():
    scene = load_scene("blank")
    with pytest.raises(ValueError, match="read-only"):
        scene.cells[0, 0] = 1


# --- the rule ---


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("", Rule()),
        ("p = 0.5", Rule.with_p(0.5)),
        ('p = 0.5\nbias = -0.5\nschedule = "balanced"', Rule.with_p(0.5, "balanced", -0.5)),
        ("bias = 1", Rule.with_p(1, bias=1)),
        ("topple_left = 0.25\nfall_pair = 0", Rule(topple_left=0.25, fall_pair=0)),
        ("p = 0.5\nfall_low_left = 0.1", Rule(0.5, 0.5, fall_low_left=0.1)),
    ],
)
def test_a_rule_is_p_and_bias_or_the_probabilities(tmp_path, text, rule):
    assert loaded(tmp_path, f"{SIZE}[rule]\n{text}").rule == rule


# --- what is wrong with a file ---

SIDE = "a whole number in [1, 16384] cells"
TOML = "key = value, [table] or [[shape]]"
KEYS = "title, notice, height, width, cells, picture, shape, tap, drain, walls, rule, speed, cell"
KINDS = "hourglass, rectangle, ellipse, line, polygon, bars, pegs, slats"
POINTS = "points [x, y], numbers in [-16384, 16384] cells"
PICTURE = "a PNG, GIF, BMP, JPEG, WEBP of at most 67108864 pixels and 16384 a side"


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("", f"width: found nothing, wanted {SIDE}"),
        ("width = 6", f"height: found nothing, wanted {SIDE}"),
        ("width = 0\nheight = 4", f"width: found 0, wanted {SIDE}"),
        ("width = 6.5\nheight = 4", f"width: found 6.5, wanted {SIDE}"),
        ("width = 16385\nheight = 4", f"width: found 16385, wanted {SIDE}"),
        ("width = inf\nheight = 4", f"width: found inf, wanted {SIDE}"),
        ("width = true\nheight = 4", f"width: found True, wanted {SIDE}"),
        ("width = '6'\nheight = 4", f"width: found '6', wanted {SIDE}"),
        ("width = []\nheight = 4", f"width: found an array of 0, wanted {SIDE}"),
        (f"width = 1{'0' * 400}\nheight = 4", f"width: found a huge number, wanted {SIDE}"),
        (f"width = 0x{'f' * 9000}\nheight = 4", f"width: found a huge number, wanted {SIDE}"),
        (
            f"width = 1{'0' * 9000}",
            "TOML: found a number or a nesting out of bounds, wanted ordinary numbers and tables",
        ),
        (f"a = {'[' * 5000}", "TOML: found a number or a nesting out of bounds, wanted ordinary numbers and tables"),
        ("widht = 6", "widht: found an unknown key, wanted width"),
        ("zzz = 6", f"zzz: found an unknown key, wanted one of {KEYS}"),
        ("'a\\nb' = 6", f"a\\nb: found an unknown key, wanted one of {KEYS}"),
        ('"a\\nb" = 6', f"a b: found an unknown key, wanted one of {KEYS}"),
        (f"{SIZE}speed = nan", "speed: found nan, wanted in [1, 1000000] iterations per second"),
        (f"{SIZE}speed = 0", "speed: found 0, wanted in [1, 1000000] iterations per second"),
        (f"{SIZE}cell = 65", "cell: found 65, wanted a whole number in [1, 64] pixels"),
        (f"{SIZE}cell = 1979-05-27", "cell: found datetime.date(1979, 5, 27), wanted a whole number in [1, 64] pixels"),
        (f"{SIZE}title = 3", "title: found 3, wanted one line of text, at most 200 characters"),
        (f'{SIZE}title = "a\\nb"', "title: found 'a\\nb', wanted one line of text, at most 200 characters"),
        (f"{SIZE}rule = 3", "rule: found 3, wanted a table [rule]"),
        (f"{SIZE}[rule]\nrule = 'alchemy'", "rule.rule: found an unknown key, wanted schedule"),
        (f"rule = 'gold'\n{SIZE}", "rule.name: found 'gold', " + NAMED),
        (f"{SIZE}[rule]\np = 1.5", "rule.p: found 1.5, wanted in [0, 1]"),
        (f"{SIZE}[rule]\nbias = -2", "rule.bias: found -2, wanted in [-1, 1]"),
        (f"{SIZE}[rule]\nfall_pair = -inf", "rule.fall_pair: found -inf, wanted in [0, 1]"),
        (f"{SIZE}[rule]\nfallpair = 1", "rule.fallpair: found an unknown key, wanted fall_pair"),
        (
            f"{SIZE}[rule]\np = 1\ntopple_left = 1",
            "rule.topple_left: found it beside p or bias, wanted only one of the two ways",
        ),
        (f"{SIZE}[rule]\nschedule = 'papre'", "rule.schedule: found 'papre', wanted one of margolus, paper, balanced"),
        (f"{SIZE}[rule]\nschedule = []", "rule.schedule: found an array of 0, wanted one of margolus, paper, balanced"),
        ("width = \n", f"line 1, column 9: found broken TOML (Invalid value), wanted {TOML}"),
        (
            f"{SIZE}[rule",
            f"end of document: found broken TOML (Expected ']' at the end of a table declaration), wanted {TOML}",
        ),
        (b"width = 6\n# caf\xe9", "line 2: found the byte 0xe9, wanted a text file in UTF-8"),
        ("cells = 3", 'cells: found 3, wanted rows of characters . o # between """'),
        ("cells = ''", f"cells: found 0 columns, wanted {SIDE}"),
        ("cells = '''\n..\n...\n'''", "cells: found 3 characters in row 2, wanted 2 as in row 1"),
        (
            "cells = '''\n..\n.x\n'''",
            "cells: found 'x' in row 2, column 2, wanted only . (empty), o (sand), # (wall), 1 to 7 (sand of a colour)",
        ),
        (
            "cells = '''\n..\n .\n'''",
            "cells: found ' ' in row 2, column 1, wanted only . (empty), o (sand), # (wall), 1 to 7 (sand of a colour)",
        ),
        (
            "cells = '.é'",
            "cells: found 'é' in row 1, column 2, wanted only . (empty), o (sand), # (wall), 1 to 7 (sand of a colour)",
        ),
        (f"cells = '{'.' * 16385}'", f"cells: found 16385 columns, wanted {SIDE}"),
        ("cells = '..'\nwidth = 3", "width: found 3, wanted 2 as in cells, or to leave it out"),
        ("cells = '.'\npicture = 'a.png'", "picture: found it beside cells, wanted only one of cells, picture, shape"),
        ("picture = '../a.png'", "picture: found '../a.png', wanted the name of a file beside the scene"),
        ("picture = 3", "picture: found 3, wanted one line of text, at most 200 characters"),
        ("picture = 'some.toml'", f"picture: found an unreadable 'some.toml', wanted {PICTURE}"),
        (f"{SIZE}shape = 3", "shape: found 3, wanted tables [[shape]]"),
        (f"{SIZE}shape = [3]", "shape: found an array of 1, wanted tables [[shape]]"),
        (f"{SIZE}[[shape]]", f"shape 1.kind: found nothing, wanted one of {KINDS}"),
        (f"{SIZE}[[shape]]\nkind = 'disc'", f"shape 1.kind: found 'disc', wanted one of {KINDS}"),
        (
            f"{SIZE}[[shape]]\nkind = 'ellipse'",
            "shape 1 (ellipse).material: found nothing, wanted one of empty, sand, wall, dye",
        ),
        (
            f"{SIZE}[[shape]]\nkind = 'hourglass'\n[[shape]]\nkind = 'rectangle'\nmaterial = 'wall'",
            "shape 1 (hourglass).width: found 6×4 cells, wanted at least 5×5 for an hourglass",
        ),
        (
            "width = 9\nheight = 9\n[[shape]]\nkind = 'hourglass'\n[[shape]]\nkind = 'line'\nmaterial = 'wall'",
            f"shape 2 (line).points: found nothing, wanted 2 to 1000 {POINTS}",
        ),
        (
            f"{SIZE}[[shape]]\nkind = 'line'\nmaterial = 'wall'\npoints = [[1, 2], [1, nan]]",
            f"shape 1 (line).points: found an array of 2, wanted 2 to 1000 {POINTS}",
        ),
        (
            f"{SIZE}[[shape]]\nkind = 'polygon'\nmaterial = 'wall'\npoints = [[1, 2], [1, 3]]",
            f"shape 1 (polygon).points: found an array of 2, wanted 3 to 1000 {POINTS}",
        ),
        (
            f"{SIZE}[[shape]]\nkind = 'rectangle'\nmaterial = 'wall'\nwidth = -1",
            "shape 1 (rectangle).width: found -1, wanted in [0.01, 16384] cells",
        ),
        (
            f"{SIZE}[[shape]]\nkind = 'hourglass'\nx = 3",
            "shape 1 (hourglass).width: found 3 + 6, wanted a glass within the 6 cells of the scene",
        ),
        (
            f"{SIZE}[[shape]]\nkind = 'hourglass'\nmaterial = 'wall'",
            "shape 1 (hourglass).material: found an unknown key, "
            "wanted one of kind, x, y, width, height, neck, curve, wall, fill, colour",
        ),
        (f"{SIZE}[[shape]]\nkind = 'hourglass'\nfill = 2", "shape 1 (hourglass).fill: found 2, wanted in [0, 1]"),
    ],
)
def test_a_bad_file_is_told_in_one_line(tmp_path, text, line):
    assert complaint(tmp_path, text) == line


def test_a_missing_picture_is_told(tmp_path):
    assert complaint(tmp_path, "picture = 'a.png'") == f"picture: found no file 'a.png', wanted a picture in {tmp_path}"


@pytest.mark.parametrize(("name", "size"), [("long", (20000, 1)), ("large", (9000, 9000))])
def test_a_large_picture_is_told_before_it_is_decoded(tmp_path, monkeypatch, name, size):
    Image.new("1", size).save(tmp_path / "a.png")
    monkeypatch.setattr(Image.Image, "convert", lambda *_: pytest.fail("decoded"))
    found = f"{size[0]}×{size[1]} pixels"
    wanted = "at most 67108864 pixels and 16384 a side"
    assert complaint(tmp_path, "picture = 'a.png'") == f"picture: found {found}, wanted {wanted}"


def test_a_damaged_picture_is_told(tmp_path):
    Image.effect_noise((40, 40), 50).save(tmp_path / "a.png")
    whole = (tmp_path / "a.png").read_bytes()
    (tmp_path / "a.png").write_bytes(whole[: len(whole) // 2])
    assert complaint(tmp_path, "picture = 'a.png'") == f"picture: found an unreadable 'a.png', wanted {PICTURE}"


@pytest.mark.parametrize("name", ["nope", "nope.toml", "no/pe", "a\0b", "", "..", "x" * 5000])
def test_a_file_that_is_not_there_is_told_with_the_scenes_that_are(name):
    with pytest.raises(SceneError) as caught:
        load_scene(name)
    assert str(caught.value).isprintable()
    assert "scene: found no such file, wanted a scene" in str(caught.value)
    assert str(caught.value).endswith(f"or one of {', '.join(scene_names())}")


def test_a_folder_is_told(tmp_path):
    with pytest.raises(SceneError, match="file: found a folder, wanted a text file in UTF-8"):
        load_scene(tmp_path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
def test_a_pipe_is_told_and_not_waited_for(tmp_path):
    os.mkfifo(tmp_path / "pipe.toml")
    with pytest.raises(SceneError, match="file: found no ordinary file, wanted a text file in UTF-8"):
        load_scene(tmp_path / "pipe.toml")


def test_a_file_that_may_not_be_read_is_told(tmp_path, monkeypatch):
    def refuse(*_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(checked_table, "open", refuse, raising=False)
    assert complaint(tmp_path, SIZE) == "file: found permission denied, wanted a text file in UTF-8"


def test_a_huge_file_is_told(tmp_path, monkeypatch):
    monkeypatch.setattr(checked_table, "LARGEST_FILE", 100)
    assert complaint(tmp_path, "#" * 101) == "file: found a larger file, wanted at most 100 bytes"


WHOLE = (asset("scenes") / "ledges.toml").read_text(encoding="utf-8").splitlines()[:40]
NUMBERS = ["nan", "-inf", "1e308", "1e-320", "-1", "0", "16384", "0x" + "f" * 99, "true", "1979-05-27"]
TEXTS = ['""', '"\\u0000"', '"pegs"', '"hourglass"', '"wall"']
LISTS = ["[]", "{}", "[[]]", "[[0, 0], [0, 0], [0, 0]]", "[[1e-320, 0], [9, 9], [0, 1e-320]]"]
VALUES = st.sampled_from(NUMBERS + TEXTS + LISTS)


@given(st.data())
def test_a_damaged_file_raises_scene_error_or_loads(tmp_path, data):
    lines = list(WHOLE)
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(lines) - 1))
        key = lines[at].partition("=")[0]
        lines[at] = data.draw(st.one_of(VALUES, st.text(max_size=9), st.just(lines[at - 1])))
        lines[at] = f"{key}= {lines[at]}" if data.draw(st.booleans()) else lines[at]
    try:
        loaded(tmp_path, "\n".join(lines).encode("utf-8", "surrogateescape"), (12, 9)).world()
    except SceneError as error:
        assert str(error).isprintable()


@given(st.integers(0, 600), st.binary(max_size=3))
def test_damaged_bytes_raise_scene_error_or_load(tmp_path, at, damage):
    raw = "\n".join(WHOLE).encode()
    try:
        loaded(tmp_path, raw[:at] + damage + raw[at + 2 :], (12, 9)).world()
    except SceneError as error:
        assert str(error).isprintable()


def test_a_scene_loaded_again_shares_its_cells():
    one, other = load_scene("rainbow"), load_scene("rainbow")
    assert one.cells is other.cells and one.colours is other.colours


def test_no_scene_has_more_fixtures_than_a_session_can_tell_of(tmp_path):
    taps = "".join(f"[[tap]]\nx = {number % 60}\ny = {number // 60}\n" for number in range(MOST + 1))
    (tmp_path / "taps.toml").write_text(f"width = 60\nheight = 40\n{taps}")
    with pytest.raises(SceneError, match=f"tap and drain: found {MOST + 1} fixtures, wanted at most {MOST}"):
        load_scene(tmp_path / "taps.toml")


def test_the_neck_is_in_the_middle_of_the_glass_wherever_that_stands(tmp_path):
    shape = '[[shape]]\nkind = "hourglass"\ny = 20\nheight = 60\nwidth = 40\n'
    (tmp_path / "low.toml").write_text(f"width = 40\nheight = 100\n{shape}")
    scene, half = load_scene(tmp_path / "low.toml"), load_scene(tmp_path / "low.toml", (20, 50))
    assert (scene.neck, half.neck) == (50, 25)
