"""Opens the scene that a player asks for: by name, by its file, or by a picture."""

import os
from dataclasses import replace
from pathlib import Path

from game.world.sand import parameters
from game.world.scenes.cell_arrays import joined, palette_of, parted, resampled
from game.world.scenes.picture_file import Photo, SeededScene, open_picture
from game.world.scenes.scene import load_scene

PICTURES = (".png", ".gif", ".bmp", ".jpg", ".jpeg", ".webp")


def load_start(name_or_path, size=None):
    """Return the SeededScene (scene, seed) that is meant: a shipped scene, a scene file, a saved scene or a photo.

    size: (width, height) in cells, for another lattice. The seed is the default where none was saved. Raises
    SceneError or PictureError, with one line to show, and ValueError for a bad size.
    """
    if Path(os.fspath(name_or_path)).suffix.lower() not in PICTURES:
        return SeededScene(load_scene(name_or_path, size), parameters.SEED.default)
    found = open_picture(name_or_path)
    scene, seed = found.picture(in_colours=True) if isinstance(found, Photo) else found
    return SeededScene(scene if size is None else _on_lattice(scene, *size), seed)


def _on_lattice(scene, width, height):
    """Return the scene with each cell of another lattice as the one at its centre."""
    own_height, own_width = scene.shape
    palette = palette_of(scene.rule.definition)
    numbers = joined(scene.cells, scene.colours, palette)
    numbers = resampled(numbers, parameters.SIDE.check(height), parameters.SIDE.check(width))
    cells, colours = parted(numbers, palette)
    fixtures = tuple(each.scaled(width / own_width, height / own_height) for each in scene.fixtures)
    return replace(scene, cells=cells, colours=colours, fixtures=fixtures)
