"""Pictures as scenes: a PNG that holds a scene and all its settings, and any picture as sand and walls."""

import hashlib
import io
import json
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import numpy as np

from game.world.files.atomic import FileError, save
from game.world.files.checked_table import CheckedTable, TableError
from game.world.looks.colour_space import oklab
from game.world.looks.themes import WALL_LOOKS
from game.world.rules.rule import Rule
from game.world.rules.rule_json import decode_rule, encode_rule
from game.world.sand import parameters
from game.world.sand.parameters import Knob
from game.world.sand.sand_colours import DYED
from game.world.scenes.cell_arrays import (
    EMPTY,
    SAND,
    SAND_PALETTE,
    WALL,
    cells_of,
    guesses,
    joined,
    nearest_cells,
    palette_of,
    parted,
    resampled,
    told_guesses,
)
from game.world.scenes.fixture_tables import read_fixtures
from game.world.scenes.picture_pixels import CHUNK, is_saved, opened, rgba, thumbnail, upright
from game.world.scenes.scene import Scene

VERSION = 1
THRESHOLD = Knob(
    "threshold",
    0.5,
    0.02,
    1.0,
    "",
    "how bright a picture must be to become sand; half of it: walls",
    ends=("more sand", "less"),
)
LEVELS = 256  # of brightness
OPAQUE = 128  # of 255: what is more transparent is air
LUMA = np.array([0.299, 0.587, 0.114], np.float32)  # how bright red, green and blue look (ITU-R BT.601)
PURE = 0.98  # part of the pixels that must be near the colours of cells for a picture to count as drawn cells
NEAR = 24  # of 255: how far a colour may be from a cell's in each channel; what saving as JPEG does to flat colours
LARGEST_PHOTO = 640, 480  # cells: a larger photo is scaled down to fit


class PictureError(FileError):
    """What is wrong with a picture, as one line."""


class SeededScene(NamedTuple):
    """What a picture holds."""

    scene: Scene
    seed: int


def save_picture(path, session):
    """Write the PNG of a session to a file, in one step; raise FileError where that fails."""
    save(path, picture_bytes(session))


def picture_bytes(session):
    """Return a PNG with the session's cells, rule, seed and settings."""
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo

    world, scene = session.world, session.scene
    palette = palette_of(session.rule.definition)
    materials = joined(world.materials, world.colours if world.coloured else None, palette)
    picture = Image.fromarray(materials, "P")
    picture.putpalette([part for colour in palette.colours for part in colour])
    settings = {
        "sandglass": VERSION,
        "title": scene.title,
        "notice": scene.notice,
        "walls": scene.made_of,
        "rule": encode_rule(session.rule),
        "seed": session.seed,
        "speed": session.clock.speed,
        "cell": scene.cell,
        "cells": _checksum(materials),
    }
    if world.fixtures:
        settings["fixtures"] = [each.as_dict() for each in world.fixtures]
    text = PngInfo()
    text.add_text(CHUNK, json.dumps(settings))
    file = io.BytesIO()
    picture.save(file, "PNG", pnginfo=text, optimize=True)
    return file.getvalue()


class PhotoFilling(NamedTuple):
    """What a photo becomes under a rule: the names of materials."""

    rule: Rule
    bright: str  # where it is at least as bright as the threshold
    between: str  # … and as half of it; what is darker becomes air


@dataclass(frozen=True)
class Photo:
    """A picture that was not drawn of cells: how bright is sand is a matter of taste."""

    path: Path
    pixels: np.ndarray  # (H, W, 4) uint8, no larger than LARGEST_PHOTO

    @cached_property
    def threshold(self):
        """The threshold that parts the photo best into bright and dark, in the range of THRESHOLD.

        Source: Otsu 1979, the greatest variance between two classes; for a photo of one brightness the usual one.
        """
        counts = np.zeros(LEVELS)
        for rows in np.array_split(self.pixels, len(self.pixels) // 64 + 1):
            shown = rows[..., 3] >= OPAQUE
            counts += np.bincount(
                np.minimum(_brightness(rows)[shown] * LEVELS, LEVELS - 1).astype(int), minlength=LEVELS
            )
        below = np.cumsum(counts)
        sums = np.cumsum(counts * np.arange(LEVELS))
        above = below[-1] - below
        with np.errstate(invalid="ignore", divide="ignore"):
            between = below * above * (sums / below - (sums[-1] - sums) / above) ** 2
        between = np.nan_to_num(between)
        if not between.any():
            return THRESHOLD.default
        return float(np.clip((np.argmax(between) + 1) / LEVELS, THRESHOLD.low, THRESHOLD.high))

    def picture(self, threshold=None, in_colours=False, filling=None):
        """Return the SeededScene with sand where the photo is at least that bright, walls down to half of it.

        threshold: that of the photo if left out. in_colours: each grain has the dye that looks most like the photo
        there, instead of all one colour. filling: a PhotoFilling, for cells of another rule than sand's.
        """
        level, settings = THRESHOLD.check(self.threshold if threshold is None else threshold), _told(self.path, None)
        bright, between = SAND, WALL
        if filling:
            bright, between = (filling.rule.codes.code(name) for name in (filling.bright, filling.between))
            settings = settings._replace(fields=settings.fields | {"rule": filling.rule})
        materials = _by_rows(self.pixels, lambda rows: _by_brightness(rows, level, bright, between))
        if in_colours and not filling:
            materials = np.where(materials == SAND, self._dyed, materials)
        return _scene(self.path, materials, 0, settings)

    @cached_property
    def _dyed(self):
        """The photo as sand alone: the material of the nearest dye in each cell."""
        return np.array(SAND_PALETTE.sands, np.uint8)[nearest_dyes(self.pixels[..., :3])]


def open_picture(path):
    """Return what a file holds: the SeededScene of a scene, or a Photo; raise PictureError, with one line, if neither.

    Cells in the colours of a saved scene are taken as they are; any other picture is a photo, scaled down to fit
    LARGEST_PHOTO.
    """
    path = Path(path)
    with _opened(path, saved_too=True) as picture:
        text = picture.info.get(CHUNK)
    settings = _told(path, text)
    palette = palette_of(settings.fields["rule"].definition)
    with _opened(path, saved_too=True) as picture:
        saved = _by_palette(picture, palette) if is_saved(picture) else None
        pixels = None if saved else rgba(picture)
    if saved is None and text is None and not _is_drawn(pixels):
        return Photo(path, _fitted(pixels))
    return _scene(path, *(saved or cells_of(pixels, palette)), settings)


def size_of(path):
    """Return (width, height) of the picture in a file; raise PictureError if it has none."""
    with _opened(Path(path), saved_too=True) as picture:
        return picture.size


def thumbnail_of(path, largest):
    """Return (size, RGB bytes) of the picture in a file, as small as `largest`; raise PictureError if it has none."""
    with _opened(Path(path), saved_too=True) as picture:
        return thumbnail(picture, largest)


@contextmanager
def _opened(path, saved_too=False):
    """Yield the Pillow picture in a file; raise PictureError where there is none."""

    def error(found, wanted):
        return PictureError(f"{path}: found {found}, wanted {wanted}")

    try:
        with opened(path, error, saved_too) as picture:
            yield picture
    except PictureError:
        raise
    except FileError as error:
        raise PictureError(error) from None


class _Settings(NamedTuple):
    """What a picture's text says."""

    checksum: str  # of the cells, or ""
    fields: dict  # of a Scene, beside its cells
    seed: int


def _told(path, text):
    """Return the _Settings in a picture's text, or the usual ones if it has none."""
    try:
        return _settings(path, text)
    except TableError as error:
        raise PictureError(error) from None


def _scene(path, materials, guessed, settings):
    """Return the SeededScene of the (H, W) numbers of cells, so many of them guessed, and _Settings."""
    palette = palette_of(settings.fields["rule"].definition)
    cells, colours = parted(materials, palette)
    problem = told_guesses(path, guessed, materials.size)
    if problem is None and settings.checksum not in ("", _checksum(materials)):
        problem = f"{path}: found other cells than were saved: it was edited or damaged"
    scene = Scene(path.stem, cells=cells, colours=colours, problem=problem, **settings.fields)
    return SeededScene(scene, settings.seed)


def _checksum(materials):
    """Return 16 hex digits that name (H, W) materials."""
    digest = hashlib.blake2b(f"{materials.shape} ".encode(), digest_size=8)
    digest.update(np.ascontiguousarray(materials))
    return digest.hexdigest()


def _by_palette(picture, palette_of_cells):
    """Return the material of each pixel of a picture with a palette, and how many of them were guessed."""
    palette = np.array(picture.getpalette("RGBA"), np.uint8).reshape(1, -1, 4)
    materials, guessed = np.full(256, EMPTY, np.uint8), np.zeros(256, bool)
    materials[: palette.shape[1]], guessed[: palette.shape[1]] = (
        nearest_cells(palette, palette_of_cells)[0],
        guesses(palette, palette_of_cells)[0],
    )
    for number, (*colour, alpha) in enumerate(palette[0, : len(palette_of_cells.colours)].tolist()):
        if alpha == 255 and tuple(colour) == palette_of_cells.colours[number]:
            materials[number] = number  # not another material of the same colour
    pixels = np.asarray(upright(picture))
    return materials[pixels], int(np.bincount(pixels.ravel(), minlength=256)[guessed].sum())


def _is_drawn(pixels):
    """Return whether nearly all pixels have the colours of cells."""
    sample = pixels[:: max(1, len(pixels) // 256), :, :3].astype(np.int16)
    near = [(np.abs(sample - colour) <= NEAR).all(axis=-1) for colour in SAND_PALETTE.colours]
    return np.any(near, axis=0).mean() >= PURE


def _by_rows(pixels, materials_of):
    return np.concatenate([materials_of(rows) for rows in np.array_split(pixels, len(pixels) // 64 + 1)])


def _brightness(pixels):
    """Return how bright pixels look, 0 … 1."""
    return pixels[..., :3].astype(np.float32) @ LUMA / 255


def _by_brightness(pixels, threshold, bright, between):
    seen = _brightness(pixels)
    materials = np.where(seen >= threshold, bright, np.where(seen >= threshold / 2, between, EMPTY)).astype(np.uint8)
    materials[pixels[..., 3] < OPAQUE] = EMPTY
    return materials


def nearest_dyes(pixels):
    """Return the number of the dye that looks most like each pixel, (H, W) uint8, from (H, W, 3) uint8 of sRGB."""
    dyes = oklab(np.array(list(DYED.values()), np.uint8))
    found = np.empty(pixels.shape[:2], np.uint8)
    for row, line in enumerate(oklab(pixels)):
        found[row] = ((line[:, None] - dyes) ** 2).sum(axis=-1).argmin(axis=-1)
    return found


def _fitted(pixels):
    height, width = pixels.shape[:2]
    scale = min(1.0, LARGEST_PHOTO[0] / width, LARGEST_PHOTO[1] / height)
    return resampled(pixels, max(1, round(height * scale)), max(1, round(width * scale)))


def _settings(path, text):
    """Return the _Settings in a picture's text, the usual ones if it has none; raise TableError where it is wrong."""
    if text is None:
        fields = {"title": path.stem, "notice": "", "rule": Rule.with_p(0.75, "balanced")}
        fields |= {"speed": parameters.SPEED.default, "cell": parameters.CELL.default}
        return _Settings("", fields, parameters.SEED.default)
    try:
        table = CheckedTable(path, json.loads(text), f"{CHUNK}: ")
    except (ValueError, TypeError, RecursionError):
        raise TableError(path, CHUNK, "broken JSON", "the settings of a scene") from None
    if not isinstance(table.values, dict):
        raise TableError(path, CHUNK, "no object", "the settings of a scene")
    table.number("sandglass", Knob("version", VERSION, 1, VERSION, "(a newer Sandglass wrote it)", "", whole=True))
    table.allow(("sandglass", "title", "notice", "walls", "rule", "seed", "speed", "cell", "cells", "fixtures"))
    fields = {"title": table.line("title", path.stem), "notice": table.line("notice", "")}
    fields |= {"rule": decode_rule(table.table("rule")), "speed": table.number("speed", parameters.SPEED)}
    fields["made_of"] = table.choice("walls", WALL_LOOKS, WALL_LOOKS[0])
    fields |= {"cell": table.number("cell", parameters.CELL), "fixtures": read_fixtures(table)}
    return _Settings(table.line("cells", ""), fields, table.number("seed", parameters.SEED))
