"""Firelight: what glows lights up what is near, and nothing else."""

import numpy as np
import pytest

from game import World, load_rule
from game.core.draw.firelight import FULL, TILE, count_glowing, padded, tiles_of
from game.core.planes import planes_where
from game.world.looks.firelight import REACH
from game.world.looks.painter import Painter
from game.world.looks.themes import NIGHT, THEMES, substances_of
from game.world.looks.view import View
from game.world.sessions.action import Paint, apply

RULE = load_rule("alchemy")
SUBSTANCES = substances_of(RULE.definition.materials)
AIR, SAND, FIRE = (RULE.materials.index(name) for name in ("air", "sand", "fire"))


def picture(cells, colours=NIGHT, cell=1):
    height, width = cells.shape
    view = View(cells.shape, 0, 0, max(1, round(cell * width)), max(1, round(cell * height)))
    pixels = np.zeros((view.height, view.width), np.uint32)
    Painter(view, colours, substances=SUBSTANCES).draw(World.from_materials(cells, RULE), pixels)
    return pixels


def brightness(pixels):
    return sum((pixels >> shift & 255).astype(int) for shift in (0, 8, 16))


def with_fire(shape, rows, columns):
    cells = np.zeros(shape, np.uint8)
    cells[rows, columns] = FIRE
    return cells


def test_light_fades_with_distance_and_ends():
    bright = brightness(picture(with_fire((120, 160), slice(56, 64), slice(76, 84))))
    line = bright[60, 84:-1]  # away from the walls around the lattice, which cast shadow
    assert (np.diff(line) <= 1).all()  # what is rounded in each colour
    assert (np.diff(line[: len(line) // TILE * TILE].reshape(-1, TILE).sum(axis=1)) <= 0).all()
    dark = brightness(picture(np.zeros((120, 160), np.uint8)))
    assert line[0] > 1.1 * dark[60, 84]
    assert (line[(REACH + 1) * TILE :] == dark[60, 84 + (REACH + 1) * TILE : -1]).all()


def test_light_goes_to_all_sides_alike():
    cells = with_fire((112, 112), slice(48, 64), slice(48, 64))
    cells[:48] = cells[64:] = cells[:, :48] = cells[:, 64:] = AIR
    bright = brightness(picture(cells))[1:-1, 1:-1]
    free = cells[1:-1, 1:-1] == AIR
    for turned in (bright[::-1], bright[:, ::-1], bright.T):
        assert (bright[free] == turned[free]).all()


def test_sand_near_a_fire_is_lit_too():
    cells = np.full((96, 96), SAND, np.uint8)
    dark = brightness(picture(cells))
    cells[40:56, 40:56] = FIRE
    bright = brightness(picture(cells))
    assert (bright[44:52, 58:64] > dark[44:52, 58:64]).all()


def test_without_anything_that_glows_nothing_is_lit():
    cells = np.full((40, 40), SAND, np.uint8)
    plain = SUBSTANCES._replace(all=tuple(each._replace(glows=False) for each in SUBSTANCES.all))
    pixels = np.zeros((40, 40), np.uint32)
    Painter(View((40, 40), 0, 0, 40, 40), substances=plain).draw(World.from_materials(cells, RULE), pixels)
    assert (picture(cells) == pixels).all()


def test_high_contrast_has_no_glow():
    colours = THEMES["high-contrast"]
    near = picture(with_fire((64, 64), slice(24, 40), slice(24, 40)), colours)
    none = picture(np.zeros((64, 64), np.uint8), colours)
    assert (near[:20] == none[:20]).all()


@pytest.mark.parametrize("shape", [(1, 1), (7, 9), (8, 8), (23, 130), (65, 257)])
def test_tiles_hold_what_glows_in_them(shape):
    cells = np.where(np.random.default_rng(3).random(shape) < 0.3, FIRE, SAND).astype(np.uint8)
    world = World.from_materials(cells, RULE)
    height, width = tiles_of(*shape)
    counts = np.full((height, padded(shape[1])), 7, np.int32)
    four = planes_where(world.planes, world.layout, {FIRE})
    count_glowing(four, world.layout.rows, world.layout.words, counts)
    wide = np.zeros((height * TILE, width * TILE), int)
    wide[: shape[0], : shape[1]] = cells == FIRE
    wanted = wide.reshape(height, TILE, width, TILE).sum(axis=(1, 3))
    assert (counts[:, :width] == wanted).all() and wanted.max() <= FULL


@pytest.mark.parametrize("cell", [0.3, 0.7, 1, 3])
def test_a_moving_fire_drawn_piece_by_piece_is_the_whole_picture(cell):
    generator = np.random.default_rng(4)
    cells = np.where(generator.random((500, 200)) < 0.02, SAND, AIR).astype(np.uint8)
    world = World.from_materials(cells, RULE)
    view = View.near(world.shape, (5, 6, 180, 260), cell, (100, 250), 95, 136)
    painter, pixels = Painter(view, substances=SUBSTANCES), np.zeros((280, 200), np.uint32)
    for _ in range(25):
        x, y = float(generator.integers(200)), float(generator.integers(500))
        apply(Paint(("fire", "erase")[generator.integers(2)], (x, y), (x + 5, y), 9), world, RULE)
        painter.draw(world, pixels)
        whole = np.zeros_like(pixels)
        Painter(view, substances=SUBSTANCES).draw(world, whole)
        assert (pixels == whole).all()
