"""Laws of the start: a scene is found by name, by its file, or in a picture, and what is saved starts again."""

import numpy as np
import pytest
from PIL import Image

from game import load_scene
from game.cli import main
from game.world.scenes.open_scene import load_start
from game.world.scenes.picture_file import PictureError, save_picture
from game.world.scenes.scene import SceneError
from game.world.sessions.session import Session


@pytest.fixture
def saved(tmp_path):
    """Return the path of a saved scene with fixtures and colours."""
    session = Session(load_scene("fountain"), 12)
    session.timeline.run(500)
    save_picture(tmp_path / "some.png", session)
    return tmp_path / "some.png", session


def test_a_saved_scene_starts_where_and_as_it_was_saved(saved):
    path, session = saved
    scene, seed = load_start(path)
    world = scene.world(seed)
    assert seed == 12 and (world.sand == session.world.sand).all() and (world.walls == session.world.walls).all()
    assert world.fixtures == session.world.fixtures and scene.rule == session.rule


def test_a_saved_scene_starts_on_another_lattice(saved):
    path, session = saved
    height, width = session.world.shape
    scene, _ = load_start(path, (2 * width, 3 * height))
    assert (scene.sand == session.world.sand.repeat(3, axis=0).repeat(2, axis=1)).all()
    assert scene.fixtures == tuple(each.scaled(2, 3) for each in session.world.fixtures)


def test_names_and_scene_files_start_as_ever():
    assert load_start("paper", (50, 40)).scene.shape == (40, 50)
    assert load_start("paper").scene.sand.sum() == load_scene("paper").sand.sum()


@pytest.mark.parametrize("name", ["gone.png", "gone.JPG", "", "gone.toml"])
def test_what_is_not_there_is_named_in_one_line(name):
    with pytest.raises((PictureError, SceneError), match=r"^[^\n]*no such file[^\n]*$"):
        load_start(name)


def test_a_photo_and_a_saved_scene_are_played_from_the_command_line(tmp_path, saved, capsys):
    Image.fromarray(np.random.default_rng(2).integers(0, 255, (30, 40, 3), np.uint8)).save(tmp_path / "photo.png")
    assert load_start(tmp_path / "photo.png").scene.colours is not None
    for path in (tmp_path / "photo.png", saved[0]):
        assert main(["headless", "--scene", str(path), "--frames", "20"]) == 0
        assert path.stem in capsys.readouterr().out


def test_a_photo_to_start_with_begins_with_the_threshold_that_suits_it(tmp_path):
    pixels = np.full((40, 60), 30, np.uint8)
    pixels[10:30, 20:40] = 90
    Image.fromarray(pixels).save(tmp_path / "dark.jpg", quality=95)
    scene = load_start(tmp_path / "dark.jpg").scene
    assert scene.sand[11:29, 21:39].all() and not scene.sand[:8].any() and not scene.sand[:, :18].any()
