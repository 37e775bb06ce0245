"""Laws of shapes that repeat, and of slats."""

import numpy as np
import pytest

from game.world.files.checked_table import read_table
from game.world.files.paths import asset
from game.world.sand.parameters import SIDE
from game.world.scenes import scene
from game.world.scenes.cell_arrays import palette_of
from game.world.scenes.scene import load_scene
from game.world.scenes.shapes import MOST_WORK, Scale, read_shapes, work_of
from tests.sweeps import sweep
from tests.world.scenes.test_scene import SIZE, complaint, drawn, loaded


@pytest.mark.parametrize(
    ("shape", "rows"),
    [
        ('"rectangle"\nwidth = 1\nheight = 2\nrepeat = [3, 2]\nstep = [2, 3]', "o.o.o o.o.o ..... o.o.o o.o.o"),
        ('"rectangle"\nx = 4\nwidth = 1\nheight = 1\nrepeat = [5, 1]\nstep = [-1, 0]', "ooooo ..... ..... ..... ....."),
        ('"line"\npoints = [[0.5, 0.5], [1.5, 0.5]]\nrepeat = [1, 3]\nstep = [9, 2]', "oo... ..... oo... ..... oo..."),
    ],
)
def test_a_shape_can_be_repeated(tmp_path, shape, rows):
    text = f"width = 5\nheight = 5\n[[shape]]\nmaterial = 'sand'\nkind = {shape}"
    assert drawn(loaded(tmp_path, text)) == rows.split()


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("repeat = 3", "repeat: found 3, wanted [x, y], each a whole number in [1, 1000]"),
        ("repeat = [2, 0]", "repeat: found an array of 2, wanted [x, y], each a whole number in [1, 1000]"),
        ("repeat = [100, 11]", "repeat: found 100·11, wanted 1000 at most in all"),
        ("step = [nan, 0]", "step: found an array of 2, wanted [x, y], each in [-16384, 16384] cells"),
        ("repeat = [3, 1]\nstep = [9999, 0]", "x: found 19998.0, wanted in [-16384, 16384] cells"),
        ("repeat = [3, 1]\nx = 'a'", "x: found 'a', wanted in [-16384, 16384] cells"),
    ],
)
def test_a_bad_repeat_is_told_in_one_line(tmp_path, text, line):
    said = complaint(tmp_path, f"{SIZE}[[shape]]\nkind = 'rectangle'\nmaterial = 'wall'\n{text}")
    assert said == f"shape 1 (rectangle).{line}"


def slats(folder, share, seed=1):
    """Return the squares, (80, 8, 8) bool, of slats from corner to corner of squares of 8×8 cells."""
    text = "width = 80\nheight = 64\n[[shape]]\nkind = 'slats'\nmaterial = 'wall'\nsize = 8"
    walls = loaded(folder, f"{text}\nshare = {share}\nseed = {seed}").walls
    return walls.reshape(8, 8, 10, 8).swapaxes(1, 2).reshape(80, 8, 8)


def test_slats_join_the_corners_of_their_squares_to_either_side(tmp_path):
    diagonal = np.eye(8, dtype=bool)
    falls = [(each == diagonal).all() for each in slats(tmp_path, 1)]
    rises = [(each == diagonal[::-1]).all() for each in slats(tmp_path, 1)]
    assert np.all(np.add(falls, rises) == 1) and 25 <= sum(falls) <= 55


def test_as_many_squares_have_a_slat_as_is_asked_for(tmp_path):
    some = slats(tmp_path, 0.5).any(axis=(1, 2))
    assert not slats(tmp_path, 0).any() and 25 <= some.sum() <= 55
    assert (slats(tmp_path, 1)[some] == slats(tmp_path, 0.5)[some]).all()


def test_another_seed_gives_another_pattern(tmp_path):
    assert (slats(tmp_path, 1, 1) != slats(tmp_path, 1, 2)).any()


def test_the_work_of_a_scene_is_bounded_whatever_its_shapes(tmp_path, monkeypatch):
    painted = []
    monkeypatch.setattr(scene, "paint", lambda cells, shape, scale: painted.append(shape))
    points = [[x % 2 * 16000, x] for x in range(1000)]
    many = f"points = {points}"
    for kind in (f"kind = 'polygon'\n{many}", f"kind = 'line'\nthickness = 9000\n{many}", "kind = 'slats'\nsize = 3"):
        path = tmp_path / "some.toml"
        path.write_text(f"width = 16384\nheight = 16384\n[[shape]]\n{kind}\nmaterial = 'sand'\nrepeat = [1000, 1]\n")
        with pytest.raises(scene.SceneError, match=r"shape 1\.kind: found more to paint, wanted shapes that come over"):
            scene.load_scene(path)
        assert not painted  # it is refused before any of it is painted


@sweep("name", scene.scene_names(), keep=["hourglass", "garden", "city"])
def test_every_shipped_scene_can_be_painted_on_the_largest_lattice(name):
    table = read_table(asset("scenes", f"{name}.toml"))
    scale = Scale(
        table.values["width"],
        table.values["height"],
        SIDE.high,
        SIDE.high,
        palette_of(load_scene(name).rule.definition),
    )
    assert (
        sum(work_of(shape, scale) for each in table.tables("shape") for shape in read_shapes(each, scale)) < MOST_WORK
    )
