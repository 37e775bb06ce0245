"""The drawing: every pixel shows its cell."""

import numpy as np
import pytest

from game import Rule, advance
from game.core.pixels import SHADES, TEXTURE
from game.world.action import Paint, apply
from game.world.colours import NIGHT, palette
from game.world.picture import Painter, View, texture
from tests.cells import random_world
from tests.looks import looks_of


def drawn(world, view, height, width):
    pixels = np.full((height, width), 7, np.uint32)
    Painter(view).draw(world, pixels)
    return pixels


@pytest.mark.parametrize("shape", [(1, 1), (2, 3), (61, 61), (30, 128), (31, 130), (9, 257)])
@pytest.mark.parametrize("cell", [1, 2, 5])
def test_every_pixel_has_the_colour_of_its_cell(shape, cell):
    world = random_world(np.random.default_rng(1), *shape)
    height, width = shape[0] * cell + 9, shape[1] * cell + 5
    view = View(shape, 3, 4, shape[1] * cell, shape[0] * cell)
    rows, columns = np.mgrid[0 : shape[0], 0 : shape[1]]
    colours = palette(NIGHT)[looks_of(world.sand, world.walls), texture()[rows % TEXTURE, columns % TEXTURE]]
    wanted = np.full((height, width), 7, np.uint32)
    wanted[4 : 4 + view.height, 3 : 3 + view.width] = colours.repeat(cell, axis=0).repeat(cell, axis=1)
    assert (drawn(world, view, height, width) == wanted).all()


@pytest.mark.parametrize(("shape", "size"), [((100, 300), (150, 50)), ((90, 90), (140, 131)), ((7, 5), (640, 480))])
def test_a_view_fits_keeps_cells_square_and_shows_every_part(shape, size):
    view = View.fit(shape, 10, 20, *size)
    assert view.left >= 10 and view.top >= 20
    assert view.left + view.width <= 10 + size[0] and view.top + view.height <= 20 + size[1]
    assert view.width / shape[1] == pytest.approx(view.height / shape[0], abs=1 / min(shape))
    assert max(view.width / size[0], view.height / size[1]) >= 0.7
    assert view.columns[0] == 0 and view.rows[0] == 0
    assert view.columns[-1] >= shape[1] - max(1, 1 / view.cell) - 1 and (np.diff(view.columns) >= 0).all()


@pytest.mark.parametrize("size", [(900, 700), (333, 211)])
def test_the_cell_under_a_pixel_is_the_cell_drawn_there(size):
    view = View.fit((50, 80), 5, 6, *size)
    for x in range(view.left, view.left + view.width, 7):
        for y in range(view.top, view.top + view.height, 5):
            column, row = view.place(x, y)
            assert (int(column), int(row)) == (view.columns[x - view.left], view.rows[y - view.top])


def test_all_shades_are_used_about_equally():
    counts = np.bincount(texture().ravel(), minlength=SHADES)
    assert len(counts) == SHADES and counts.min() > 0.7 * TEXTURE**2 / SHADES


@pytest.mark.parametrize("size", [(400, 1500), (311, 401)])
def test_what_is_drawn_piece_by_piece_is_the_whole_picture(size):
    generator = np.random.default_rng(2)
    world = random_world(generator, 1400, 300, sand=0.02, walls=0.02)
    rule = Rule.with_p(0.7, "balanced")
    painter, view = Painter(View.fit(world.shape, 5, 6, *size)), View.fit(world.shape, 5, 6, *size)
    pixels = np.zeros((size[1] + 20, size[0] + 20), np.uint32)
    drawn = 0
    for number in range(120):
        advance(world, rule, int(generator.integers(0, 60)))
        if number % 7 == 0:
            row = float(generator.integers(1400))
            material = ("sand", "wall", "erase")[generator.integers(3)]
            apply(Paint(material, (150.5, row + 0.5), (160.5, row + 0.5), 3, over_walls=True), world, rule)
        drawn += sum(bottom - top for top, bottom in painter.draw(world, pixels))
        whole = np.zeros_like(pixels)
        Painter(view).draw(world, whole)
        assert (pixels == whole).all(), number
    assert drawn < 110 * view.height


def test_a_world_that_rests_is_not_drawn_again():
    world = random_world(np.random.default_rng(3), 40, 60, sand=0.3, walls=0)
    painter, pixels = Painter(View.fit(world.shape, 0, 0, 60, 40)), np.zeros((40, 60), np.uint32)
    advance(world, Rule(), 1000)
    assert painter.draw(world, pixels) == [(0, 40)]
    advance(world, Rule(), 1000)
    assert painter.draw(world, pixels) == []
    assert painter.draw(world, pixels, damage=[(3, 9), (8, 12), (30, 99)]) == [(3, 12), (30, 40)]
    assert painter.draw(world.copy(), pixels) == [(0, 40)], "another world"
