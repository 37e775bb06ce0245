"""Laws of films: a file plays what was recorded, however it is written, and is small; what fails leaves nothing."""

import os
import stat
import sys

import numpy as np
import pytest
from PIL import Image

from game.play.storage.films import formats
from game.play.storage.films.film import Film
from game.play.storage.films.film_file import FilmFile
from game.play.storage.films.gif import GifEncoder
from game.play.storage.films.mp4 import Mp4Encoder
from game.play.storage.films.webp import WebpEncoder
from game.world.files.atomic import FileError
from game.world.files.paths import numbered
from game.world.looks.themes import NIGHT
from game.world.sand.advance import advance
from game.world.scenes.scene import load_scene
from tests.sweeps import sweep

MOST = 1_500_000  # bytes of ten seconds
FFMPEG = """#!{python}
import sys
frames = sys.stdin.buffer.read()
open(sys.argv[-1], "wb").write(frames)
print(" ".join(sys.argv), file=sys.stderr)
"""
BROKEN = """#!{python}
import sys
sys.stdin.buffer.read(100)
print("first line\\nUnknown encoder 'libx264'", file=sys.stderr)
sys.exit(1)
"""


def ffmpeg(folder, monkeypatch, text):
    """Put a program of that text on PATH in the place of ffmpeg."""
    (folder / "bin").mkdir()
    path = folder / "bin" / "ffmpeg"
    path.write_text(text.format(python=sys.executable))
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", str(path.parent))


def colours(count, rng):
    return np.unique(rng.integers(0, 256, (4 * count, 3), np.uint8), axis=0)[:count]


def written(path, encoder, frames, ms=40):
    film = FilmFile(numbered(path), encoder)
    for pixels in frames:
        film.add(pixels, ms)
    return film.close()


def small_changes(rng, shape, count):
    """Yield frames of which each differs from the one before in a few places, anywhere."""
    frame = rng.integers(0, count, shape, np.uint8)
    for _ in range(12):
        yield frame
        frame = frame.copy()
        for _ in range(rng.integers(1, 5)):
            row, column = (rng.integers(0, side) for side in shape)
            frame[row, column] = (int(frame[row, column]) + 1) % count


@pytest.mark.parametrize("encoder", [GifEncoder, WebpEncoder])
@pytest.mark.parametrize("count", [2, 60, 256])
@pytest.mark.parametrize("zoom", [1, 3])
def test_a_film_shows_every_pixel_of_every_frame_for_its_time(tmp_path, encoder, count, zoom):
    rng = np.random.default_rng(count)
    palette = colours(count, rng)
    frames = [*small_changes(rng, (31, 43), count), rng.integers(0, count, (31, 43), np.uint8)]
    frames.append(np.roll(np.arange(31 * 43) % count, 1).reshape(31, 43).astype(np.uint8))
    path = written(tmp_path / f"film{encoder.suffix}", encoder(palette.tobytes(), zoom), frames)
    with Image.open(path) as image:
        assert image.n_frames == len(frames) and image.info.get("loop") == 0
        for number, wanted in enumerate(frames):
            image.seek(number)
            found = np.asarray(image.convert("RGB"))
            assert (found == palette[wanted].repeat(zoom, 0).repeat(zoom, 1)).all()
            assert image.info["duration"] == 40


@sweep(("encoder", "most"), [(GifEncoder, MOST), (WebpEncoder, MOST // 3)], keep=[(GifEncoder, MOST)])
def test_ten_seconds_of_the_first_scene_are_small(tmp_path, encoder, most):
    scene = load_scene("hourglass")
    film, world = Film(scene.shape, scene.cell, NIGHT, scene.made_of), scene.world()
    advance(world, scene.rule, 4000)

    def frames():
        for number in range(250):
            advance(world, scene.rule, 6 + number % 5 // 3)
            yield film.frame(world)

    path = written(tmp_path / f"film{encoder.suffix}", encoder(film.colours, film.zoom), frames())
    with Image.open(path) as image:
        assert image.n_frames > 200 and image.size == (540, 720)
    assert path.stat().st_size < most


def test_ffmpeg_is_handed_every_frame_for_as_long_as_it_is_shown(tmp_path, monkeypatch):
    ffmpeg(tmp_path, monkeypatch, FFMPEG)
    rng = np.random.default_rng(1)
    palette, frames = colours(60, rng), [*small_changes(rng, (5, 7), 60)]
    path = written(tmp_path / "film.mp4", Mp4Encoder(palette.tobytes(), 2), frames, ms=80)
    found = np.frombuffer(path.read_bytes(), np.uint8).reshape(-1, 10, 14, 3)
    assert len(found) == 2 * len(frames) and "mp4" in formats.names()
    for number, wanted in enumerate(frames):
        assert (found[2 * number : 2 * number + 2] == palette[wanted].repeat(2, 0).repeat(2, 1)).all()


def test_what_ffmpeg_complains_of_is_told_in_one_line_and_leaves_nothing(tmp_path, monkeypatch):
    ffmpeg(tmp_path, monkeypatch, BROKEN)
    os.mkdir(tmp_path / "films")
    frames = (np.full((720, 540), number % 60, np.uint8) for number in range(100))
    with pytest.raises(FileError, match=r"film.mp4: cannot write the recording: ffmpeg: unknown encoder 'libx264'$"):
        written(tmp_path / "films" / "film.mp4", Mp4Encoder(bytes(768)), frames)
    assert os.listdir(tmp_path / "films") == []


def test_without_ffmpeg_a_recording_that_was_to_be_mp4_is_a_gif(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    assert formats.names() == ("gif", "webp") and formats.encoder_of("mp4") is GifEncoder


def test_a_film_without_frames_is_none(tmp_path):
    with pytest.raises(FileError, match="nothing was recorded"):
        written(tmp_path / "film.gif", GifEncoder(bytes(768)), [])
    assert os.listdir(tmp_path) == []
