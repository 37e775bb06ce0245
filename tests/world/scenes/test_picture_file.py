"""Laws of pictures: one saved is the scene, one edited too, and any other becomes walls and sand."""

import json
import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from game import Rule, load_rule
from game.world.files import atomic
from game.world.sand.sand_colours import COLOURS as NAMES
from game.world.sand.sand_colours import DYED
from game.world.scenes import picture_pixels
from game.world.scenes.cell_arrays import SAND_PALETTE
from game.world.scenes.picture_file import (
    THRESHOLD,
    Photo,
    PhotoFilling,
    PictureError,
    nearest_dyes,
    open_picture,
    save_picture,
    thumbnail_of,
)
from game.world.scenes.picture_pixels import CHUNK
from game.world.scenes.scene import load_scene
from game.world.sessions.action import Flip, Load
from game.world.sessions.recording import load_replay
from game.world.sessions.session import Session
from tests.saved import load_picture, save_replay
from tests.world.random_sessions import SCENES, played, plays

DATA = Path(__file__).parents[2] / "data"


def saved(folder, session=None):
    """Return the path of a saved session."""
    save_picture(folder / "some.png", session or Session(SCENES[1], 9))
    return folder / "some.png"


@pytest.fixture(autouse=True)
def quick_disk(monkeypatch):
    """Do not wait for the disk."""
    monkeypatch.setattr(atomic.os, "fsync", lambda handle: None)


@given(plays)
def test_a_saved_picture_is_the_scene(tmp_path, play):
    session = played(play)
    session.clock.speed = 321.0
    scene, seed = load_picture(saved(tmp_path, session))
    assert (scene.sand == session.world.sand).all() and (scene.walls == session.world.walls).all()
    assert (scene.world().colours == session.world.colours).all()
    assert (scene.rule, seed, scene.speed) == (session.rule, session.seed, 321.0)
    assert (scene.title, scene.notice, scene.cell) == (session.scene.title, session.scene.notice, session.scene.cell)


def test_a_picture_shows_the_cells_and_the_colours_of_the_sand(tmp_path):
    world = SCENES[1].world()
    pixels = np.asarray(Image.open(saved(tmp_path)).convert("RGB"))
    dyed = np.array(list(DYED.values()), np.uint8)[world.colours]
    plain = np.array(SAND_PALETTE.colours, np.uint8)[np.where(world.walls, 2, 0)]
    assert (pixels == np.where(world.sand[..., None], dyed, plain)).all()


def test_a_loaded_picture_plays(tmp_path):
    session = Session(SCENES[0])
    session.do(Load(*load_picture(saved(tmp_path))))
    assert session.world.digest() == SCENES[1].world(9).digest() and session.rule == SCENES[1].rule
    session.timeline.run(20)
    assert session.account.balanced(session.world)


@pytest.mark.parametrize("name", ["x.png", "x.bmp", "x.gif", "x.webp"])
def test_cells_survive_a_paint_program_that_drops_the_settings(tmp_path, name):
    Image.open(saved(tmp_path)).convert("RGB").quantize(16).save(tmp_path / name, lossless=True, pnginfo=PngInfo())
    scene, seed = load_picture(tmp_path / name)
    assert (scene.sand == SCENES[1].sand).all() and (scene.walls == SCENES[1].walls).all()
    assert (scene.colours == SCENES[1].colours).all()
    assert seed == 0 and scene.rule == Rule.with_p(0.75, "balanced") and scene.name == "x"


def test_a_photo_becomes_sand_where_it_is_bright_and_walls_where_it_is_half_as_bright(tmp_path):
    grey = np.tile(np.arange(256, dtype=np.uint8), (20, 1))
    Image.fromarray(grey).save(tmp_path / "grey.png")
    scene, _ = load_picture(tmp_path / "grey.png", threshold=0.6)
    assert scene.sand[0].tolist() == (grey[0] >= 0.6 * 255).tolist()
    assert scene.walls[0].tolist() == ((grey[0] >= 0.3 * 255) & (grey[0] < 0.6 * 255)).tolist()
    default, _ = load_picture(tmp_path / "grey.png")
    assert default.sand.sum() == 20 * 128


def test_what_is_see_through_is_empty(tmp_path):
    pixels = np.full((9, 12, 4), 255, np.uint8)
    pixels[3:, :, 3] = 0
    Image.fromarray(pixels).save(tmp_path / "clear.png")
    scene, _ = load_picture(tmp_path / "clear.png")
    assert scene.sand[:3].all() and not scene.sand[3:].any() and not scene.walls.any()


def test_a_large_photo_is_made_to_fit(tmp_path):
    Image.effect_noise((1600, 900), 80).save(tmp_path / "large.jpg")
    scene, _ = load_picture(tmp_path / "large.jpg")
    assert scene.shape == (360, 640) and scene.sand.any() and scene.walls.any()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{", "broken JSON"),
        ("[]", "found no object"),
        ('{"sandglass": 2}', "a newer Sandglass wrote it"),
        ('{"sandglass": 1, "weather": 3}', "weather: found an unknown key"),
        ('{"sandglass": 1}', "rule.topple_left: found nothing"),
        ("[" * 10**5, "broken JSON"),
    ],
)
def test_damaged_settings_are_refused_in_one_line(tmp_path, text, words):
    chunk = PngInfo()
    chunk.add_text(CHUNK, text)
    Image.new("P", (5, 5)).save(tmp_path / "bad.png", pnginfo=chunk)
    with pytest.raises(PictureError) as caught:
        load_picture(tmp_path / "bad.png")
    assert words in str(caught.value) and str(caught.value).isprintable()


@pytest.mark.parametrize("seed", [-1, 2**64, "1"])
def test_settings_are_checked(tmp_path, seed):
    settings = json.loads(Image.open(saved(tmp_path)).info[CHUNK]) | {"seed": seed}
    chunk = PngInfo()
    chunk.add_text(CHUNK, json.dumps(settings))
    Image.new("P", (5, 5)).save(tmp_path / "bad.png", pnginfo=chunk)
    with pytest.raises(PictureError, match="seed: found"):
        load_picture(tmp_path / "bad.png")


def test_what_is_no_picture_is_refused_in_one_line(tmp_path):
    (tmp_path / "text.png").write_text("not a picture")
    Image.new("1", (16385, 2)).save(tmp_path / "wide.png")
    for name, words in (
        ("text.png", "unreadable"),
        ("none.png", "no such file"),
        (".", "folder"),
        ("wide.png", "16385×2"),
    ):
        with pytest.raises(PictureError, match=words):
            load_picture(tmp_path / name)


def test_a_photo_in_colours_has_the_dye_that_each_grain_looks_like():
    dyes = np.array(list(DYED.values()), np.uint8)
    numbers = np.random.default_rng(3).integers(len(dyes), size=(40, 30))
    pixels = np.dstack([dyes[numbers], np.full(numbers.shape, 255, np.uint8)])
    pixels[5:9, :, 3] = 0
    photo = Photo(Path("photo.png"), pixels)
    scene = photo.picture(0.3, in_colours=True).scene
    assert (scene.colours[scene.sand] == numbers[scene.sand]).all() and scene.sand.sum() == 36 * 30
    plain = photo.picture(0.6).scene
    coloured = photo.picture(0.6, in_colours=True).scene
    assert plain.colours is None and (plain.sand == coloured.sand).all() and (plain.walls == coloured.walls).all()


def grey(levels):
    """Return a photo of grey levels, (H, W) of 0 … 255."""
    return Photo(
        Path("photo.png"), np.dstack([np.asarray(levels, np.uint8)] * 3 + [np.full(np.shape(levels), 255, np.uint8)])
    )


@pytest.mark.parametrize(("dark", "light"), [(20, 90), (120, 250), (200, 255), (3, 9)])
def test_a_photo_begins_with_the_threshold_that_parts_dark_from_light(dark, light):
    generator = np.random.default_rng(8)
    is_light = generator.random((40, 60)) < 0.3
    levels = np.where(is_light, light, dark) + generator.integers(-2, 3, is_light.shape)
    photo = grey(np.clip(levels, 0, 255))
    assert (dark + 2) / 256 <= photo.threshold <= (light - 1) / 256 or photo.threshold == THRESHOLD.low
    assert (photo.picture().scene.sand == is_light).all() or photo.threshold == THRESHOLD.low


def test_a_photo_of_one_brightness_begins_with_the_usual_threshold():
    assert grey(np.full((9, 9), 77)).threshold == THRESHOLD.default
    clear = grey(np.arange(81).reshape(9, 9))
    clear.pixels[..., 3] = 0
    assert clear.threshold == THRESHOLD.default and not clear.picture().scene.cells.any()


def test_a_photo_becomes_the_materials_that_are_chosen_for_bright_and_half_as_bright():
    rule = load_rule("alchemy")
    photo = grey(np.repeat([[10, 120, 250]], 4, axis=0))
    scene = photo.picture(0.8, filling=PhotoFilling(rule, "water", "plant")).scene
    names = [rule.materials[code] for code in scene.world().materials[0]]
    assert names == ["air", "plant", "water"] and scene.rule == rule


@pytest.mark.parametrize(
    ("colour", "dye"), [((200, 90, 70), "terracotta"), ((90, 110, 210), "indigo"), ((250, 250, 245), "ivory")]
)
def test_a_dye_is_found_by_its_look(colour, dye):
    assert NAMES[nearest_dyes(np.array([[colour]], np.uint8))[0, 0]] == dye


def test_a_scene_as_large_as_a_lattice_may_be_is_opened_again(tmp_path, monkeypatch):
    monkeypatch.setattr(picture_pixels, "MOST_PIXELS", 100)
    scene, _ = load_picture(saved(tmp_path))
    assert (scene.sand == SCENES[1].sand).all() and (scene.walls == SCENES[1].walls).all()
    Image.open(tmp_path / "some.png").convert("RGB").save(tmp_path / "photo.png")
    with pytest.raises(PictureError, match="pixels, wanted at most"):
        load_picture(tmp_path / "photo.png")


def test_a_scene_whose_palette_was_put_in_another_order_is_the_same(tmp_path):
    path = saved(tmp_path)
    with Image.open(path) as picture:
        text = PngInfo()
        text.add_text(CHUNK, picture.info[CHUNK])
        order = list(range(len(SAND_PALETTE.colours)))[::-1]
        picture.remap_palette(order).save(tmp_path / "other.png", pnginfo=text)
    scene, _ = load_picture(tmp_path / "other.png")
    assert (scene.sand == SCENES[1].sand).all() and (scene.walls == SCENES[1].walls).all()


def test_a_photo_stands_as_the_camera_was_held(tmp_path):
    pixels = np.zeros((30, 60, 3), np.uint8)
    pixels[:, :20] = 255  # the left third is bright, which orientation 6 turns to the top
    held = Image.Exif()
    held[0x0112] = 6
    Image.fromarray(pixels).save(tmp_path / "photo.png", exif=held)
    scene, _ = load_picture(tmp_path / "photo.png", threshold=0.5)
    assert scene.shape == (60, 30) and scene.sand[:20].all() and not scene.sand[20:].any()


def test_a_photo_in_sixteen_bits_is_as_bright_as_in_eight(tmp_path):
    grey = np.random.default_rng(7).integers(0, 256, (40, 50), np.uint16)
    Image.fromarray(grey.astype(np.uint8)).save(tmp_path / "eight.png")
    Image.fromarray(grey * 257).save(tmp_path / "sixteen.png")
    eight, sixteen = (load_picture(tmp_path / f"{name}.png", threshold=0.5).scene for name in ("eight", "sixteen"))
    assert (eight.sand == sixteen.sand).all() and (eight.walls == sixteen.walls).all() and not eight.sand.all()


@pytest.mark.parametrize("name", ["at 1.23.45\u202fPM", "a" * 210, "nbsp\u00a0x", "fam\u200dily"])
def test_whatever_a_photo_is_called_sessions_and_pictures_of_it_can_be_read(tmp_path, name):
    Image.fromarray(np.random.default_rng(3).integers(0, 255, (20, 30, 3), np.uint8)).save(tmp_path / f"{name}.png")
    scene, seed = load_picture(tmp_path / f"{name}.png")
    session = Session(SCENES[0])
    session.do(Load(scene, seed))
    session.do(Flip())
    save_replay(tmp_path / "some.sandglass", session)
    recording = load_replay(tmp_path / "some.sandglass")
    assert recording.problem is None and len(recording.entries) == 2
    assert load_picture(saved(tmp_path, session)).scene.title == scene.title


@pytest.mark.parametrize(("strange", "kind"), [(0.01, "cells"), (0.04, "a photo"), (0.3, "a photo")])
def test_a_picture_is_cells_only_if_nearly_all_pixels_have_their_colours(tmp_path, strange, kind):
    pixels = np.full((100, 100, 3), SAND_PALETTE.colours[0], np.uint8)
    pixels[: round(100 * strange)] = 255, 0, 255
    Image.fromarray(pixels).save(tmp_path / "some.png")
    assert isinstance(open_picture(tmp_path / "some.png"), Photo) == (kind == "a photo")


def test_a_scene_that_was_saved_as_a_jpeg_is_still_walls_and_sand(tmp_path):
    world = SCENES[1].world()
    cells = np.kron(np.asarray(Image.open(saved(tmp_path)).convert("RGB")), np.ones((4, 4, 1), np.uint8))
    Image.fromarray(cells).save(tmp_path / "sent.jpg", quality=85, subsampling=0)
    scene, _ = load_picture(tmp_path / "sent.jpg")
    assert scene.shape == cells.shape[:2]
    assert (scene.sand[2::4, 2::4] == world.sand).all() and (scene.walls[2::4, 2::4] == world.walls).all()


def test_a_saved_scene_with_one_bit_flipped_is_the_same_or_is_said_to_be_damaged(tmp_path):
    path, other = saved(tmp_path), tmp_path / "other.png"
    good, whole = path.read_bytes(), load_picture(path).scene
    for bit in range(0, 8 * len(good), 13):
        flipped = bytearray(good)
        flipped[bit // 8] ^= 1 << bit % 8
        other.write_bytes(flipped)
        try:
            scene = load_picture(other).scene
        except PictureError:
            continue
        same = (scene.sand == whole.sand).all() and (scene.walls == whole.walls).all()
        assert scene.problem or (same and scene.rule == whole.rule)


def test_cells_that_are_not_those_that_were_saved_are_told(tmp_path):
    path = saved(tmp_path)
    assert load_picture(path).scene.problem is None
    with Image.open(path) as picture:
        text, pixels = picture.info[CHUNK], np.asarray(picture).copy()
        palette = picture.getpalette()
    pixels[0, 0] = (pixels[0, 0] + 1) % 3
    save_with(path, pixels, palette, text)
    assert "found other cells than were saved" in load_picture(path).scene.problem


def test_a_scene_saved_without_a_checksum_is_opened(tmp_path):
    path = saved(tmp_path)
    with Image.open(path) as picture:
        values, pixels, palette = json.loads(picture.info[CHUNK]), np.asarray(picture), picture.getpalette()
    del values["cells"]
    save_with(path, pixels, palette, json.dumps(values))
    scene, seed = load_picture(path)
    assert (scene.sand == SCENES[1].sand).all() and seed == 9 and scene.problem is None


def save_with(path, pixels, palette, text):
    """Save materials with a palette and a text of settings."""
    picture, chunk = Image.fromarray(pixels, "P"), PngInfo()
    picture.putpalette(palette)
    chunk.add_text(CHUNK, text)
    picture.save(path, pnginfo=chunk)


def test_cells_that_a_lossy_copy_leaves_in_doubt_are_counted_and_told():
    whole, copy = (open_picture(DATA / f"saved-rainbow{end}").scene for end in (".png", "-95.jpg"))
    wrong = (whole.sand != copy.sand) | (whole.walls != copy.walls)
    assert wrong.any() and whole.problem is None
    assert "found 936 of 43,200 cells in no material's colour: the nearest was guessed" in copy.problem


def deep_png(path, levels, kind, clear=None, orientation=1):
    """Write (H, W, channels) numbers of sixteen bits as a PNG; kind: 0 grey, 2 colours, 4 grey and alpha."""
    held = Image.Exif()
    held[0x0112] = orientation
    head = struct.pack(">IIBBBBB", levels.shape[1], levels.shape[0], 16, kind, 0, 0, 0)
    rows = b"".join(b"\0" + row.astype(">u2").tobytes() for row in levels)
    clear = [(b"tRNS", struct.pack(f">{len(clear)}H", *clear))] if clear else []
    chunks = [(b"IHDR", head), *clear, (b"eXIf", held.tobytes()[6:]), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")]
    sealed = [(len(data), name + data, zlib.crc32(name + data)) for name, data in chunks]
    parts = [struct.pack(">I", size) + body + struct.pack(">I", checksum) for size, body, checksum in sealed]
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(parts))
    return path


@pytest.mark.parametrize(("kind", "channels"), [(0, 1), (2, 3)])
def test_a_picture_in_sixteen_bits_keeps_what_is_see_through_and_how_it_was_held(tmp_path, kind, channels):
    levels = np.zeros((20, 40, channels), np.uint16)
    levels[:, :10] = 60000  # the left quarter is bright, which orientation 6 turns to the top
    levels[:5] = 50000  # and the upper quarter, which it turns to the right, is clear
    path = deep_png(tmp_path / "deep.png", levels, kind, (50000,) * channels, 6)
    scene = load_picture(path, threshold=0.5).scene
    assert scene.shape == (40, 20)
    assert scene.sand[:10, :15].all() and not scene.sand[10:].any() and not scene.sand[:, 15:].any()


@pytest.mark.parametrize("name", ["grey16.png", "exif6.jpg"])
def test_a_scene_reads_its_picture_as_a_dropped_one_is_read(tmp_path, name):
    (tmp_path / name).write_bytes((DATA / name).read_bytes())
    (tmp_path / "some.toml").write_text(f'picture = "{name}"')
    pixels = np.asarray(Image.open(DATA / name))
    eight = np.rot90(pixels, -1) if pixels.ndim == 3 else np.dstack([(pixels >> 8).astype(np.uint8)] * 3)
    Image.fromarray(np.ascontiguousarray(eight)).save(tmp_path / "plain.png")
    (tmp_path / "plain.toml").write_text('picture = "plain.png"')
    scene, plain = load_scene(tmp_path / "some.toml"), load_scene(tmp_path / "plain.toml")
    assert scene.shape == plain.shape and (scene.walls == plain.walls).all() and (scene.sand == plain.sand).all()
    assert scene.walls.any() and "the nearest was guessed" in scene.problem


def test_a_picture_that_is_not_opened_is_not_listed_either(tmp_path):
    Image.new("1", (9000, 9000)).save(tmp_path / "large.png")
    for read in (open_picture, lambda path: thumbnail_of(path, (64, 64))):
        with pytest.raises(PictureError, match="9000×9000 pixels, wanted at most"):
            read(tmp_path / "large.png")
    assert thumbnail_of(saved(tmp_path), (640, 480))[0] == SCENES[1].shape[::-1]
