"""The drawing: every pixel shows its cell."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import Rule, advance, load_scene
from game.core.draw.cells import SHADES, TEXTURE
from game.core.draw.downscaled import shift_edges
from game.core.draw.glass_decor import places_of
from game.core.draw.looks import AIR, GRAIN, GRAIN_BY_WALL, SURFACE, WALL, dyed
from game.world.looks import colour_space, row_threads
from game.world.looks.painter import Painter, texture
from game.world.looks.themes import DAY, NIGHT, palette
from game.world.looks.view import View
from game.world.sessions.action import Flip, Paint, apply
from tests.cells import coloured, grains_over_a_pile_below_a_band, random_world
from tests.looks import looks_of
from tests.sweeps import sweep


def dyed_look(look, colour):
    """Return the look of a cell of a world with colours."""
    return dyed(look)[colour] if GRAIN <= look <= GRAIN_BY_WALL else look


def drawn(world, view, height, width):
    pixels = np.full((height, width), 7, np.uint32)
    Painter(view).draw(world, pixels)
    return pixels


@sweep("shape", [(1, 1), (2, 3), (61, 61), (30, 128), (31, 130), (9, 257)], keep=[(1, 1), (31, 130)])
@pytest.mark.parametrize("cell", [1, 2, 5])
@pytest.mark.parametrize("dyed", [False, True])
def test_every_pixel_has_the_colour_of_its_cell(shape, cell, dyed):
    world = random_world(np.random.default_rng(1), *shape)
    world = coloured(world, np.random.default_rng(2)) if dyed else world
    height, width = shape[0] * cell + 9, shape[1] * cell + 5
    view = View(shape, 3, 4, shape[1] * cell, shape[0] * cell)
    rows, columns = np.mgrid[0 : shape[0], 0 : shape[1]]
    looks = looks_of(world.sand, world.walls)
    dyes = np.array([dyed_look(look, number) for look, number in zip(looks.flat, world.colours.flat, strict=True)])
    colours = palette(NIGHT)[dyes.reshape(shape), texture()[rows % TEXTURE, columns % TEXTURE]]
    wanted = np.full((height, width), 7, np.uint32)
    wanted[4 : 4 + view.height, 3 : 3 + view.width] = colours.repeat(cell, axis=0).repeat(cell, axis=1)
    assert (drawn(world, view, height, width) == wanted).all()


@given(st.integers(1, 20), st.integers(1, 300), st.integers(0, 2**32), st.floats(0, 1), st.floats(0, 1))
def test_every_neighbourhood_looks_as_its_plain_twin_says(height, width, seed, sand, walls):
    world = random_world(np.random.default_rng(seed), height, width, sand=sand, walls=(1 - sand) * walls)
    places = places_of(world.walls)
    rows, columns = np.mgrid[0:height, 0:width] % TEXTURE
    view, pixels = View(world.shape, 0, 0, width, height), np.zeros(world.shape, np.uint32)
    for made_of, decor in (("stone", None), ("glass", places)):
        Painter(view, DAY, made_of).draw(world, pixels)
        looks = looks_of(world.sand, world.walls, decor)
        assert (pixels == palette(DAY, made_of)[looks, texture()[rows, columns]]).all()


def mean(one, other):
    """Return the mean of two arrays of colours, each channel rounded down."""
    channels = [(colours.view(np.uint8).astype(int)) for colours in (one, other)]
    return ((channels[0] + channels[1]) // 2).astype(np.uint8).view(np.uint32)


@given(st.integers(2, 40), st.integers(2, 300), st.floats(0.5, 0.99), st.integers(0, 2**32))
def test_two_cells_in_one_pixel_are_mixed(height, width, cell, seed):
    world = random_world(np.random.default_rng(seed), height, width)
    view = View(world.shape, 0, 0, max(width * cell, width / 2), max(height * cell, height / 2))
    near = np.zeros(world.shape, np.uint32)
    Painter(View(world.shape, 0, 0, width, height)).draw(world, near)
    rows, columns = view.row_edges, view.column_edges
    tall = mean(near[rows[:-1]], near[rows[1:] - 1])
    wanted = mean(np.ascontiguousarray(tall[:, columns[:-1]]), np.ascontiguousarray(tall[:, columns[1:] - 1]))
    wanted = np.where(np.diff(columns) == 1, tall[:, columns[:-1]], wanted)
    pixels = np.zeros(wanted.shape, np.uint32)
    Painter(view).draw(world, pixels)
    ends = slice(1, -1)  # the first and the last pixel may hold a cell more
    assert (pixels[ends, ends] == wanted[ends, ends]).all()


def test_a_glass_that_is_broken_and_mended_is_drawn_anew_as_a_whole():
    scene = load_scene("hourglass")
    world, (height, width) = scene.world(), scene.shape
    view, pixels, whole = View(world.shape, 0, 0, width, height), *np.zeros((2, height, width), np.uint32)
    painter, rule = Painter(view, walls="glass"), Rule()
    acts = [Paint(material, (20.0, 200.0), (60.0, 200.0), 3, over_walls=True) for material in ("erase", "wall", "sand")]
    shown = []
    for act in (None, *acts, Flip()):
        if act:
            apply(act, world, rule)
        painter.draw(world, pixels)
        Painter(view, walls="glass").draw(world, whole)
        assert (pixels == whole).all()
        shown.append(pixels[30, 90])
    assert shown[1] != shown[0] == shown[2], "the air in it is no longer that of a glass"


def test_sand_at_rest_does_not_flicker():
    scene = load_scene("hourglass", (90, 120))
    world, rule = scene.world(), Rule.with_p(1, "balanced")
    advance(world, rule, 20_000)
    assert world.activity.settled
    view, pictures = View(world.shape, 0, 0, 90, 120), []
    for _ in range(9):
        pictures.append(np.zeros(world.shape, np.uint32))
        Painter(view, walls="glass").draw(world, pictures[-1])
        advance(world, rule, 1)
    assert all((each == pictures[0]).all() for each in pictures)


def test_all_shades_are_used_about_equally():
    counts = np.bincount(texture().ravel(), minlength=SHADES)
    assert len(counts) == SHADES and counts.min() > 0.7 * TEXTURE**2 / SHADES


@sweep("size", [(400, 1500), (311, 401)], keep=[(311, 401)])
@sweep("cell", [None, 0.07, 0.37, 0.7, 1, 3], keep=[None, 0.37, 1])
def test_what_is_drawn_piece_by_piece_is_the_whole_picture(size, cell):
    generator = np.random.default_rng(2)
    world = random_world(generator, 1400, 300, sand=0.02, walls=0.02)
    rule = Rule.with_p(0.7, "balanced")
    view = View.fit(world.shape, 5, 6, *size)
    if cell:
        view = View.near(world.shape, (5, 6, *size), cell, (140, 800), 100, 100)
    painter, pixels = Painter(view), np.zeros((size[1] + 20, size[0] + 20), np.uint32)
    drawn = 0
    for number in range(60):
        advance(world, rule, int(generator.integers(0, 60)))
        if number % 7 == 0:
            row = float(generator.integers(1400))
            material = ("erase", "sand", "wall")[generator.integers(3)]
            apply(Paint(material, (150.5, row + 0.5), (160.5, row + 0.5), 3, over_walls=True), world, rule)
        drawn += sum(bottom - top for top, bottom in painter.draw(world, pixels))
        whole = np.zeros_like(pixels)
        Painter(view).draw(world, whole)
        assert (pixels == whole).all(), number
    assert drawn < 55 * (view.seen[3] - view.seen[1])


def light_of(values):
    """Return the light of pixel values 0xRRGGBB in 0 … 1: (…, 3)."""
    return colour_space.linear(np.stack([values >> 16 & 255, values >> 8 & 255, values & 255], axis=-1) / 255)


def colour_light(number):
    """Return by what light sand of a colour differs from amber sand, as (3,)."""
    return np.subtract(*(light_of(palette(NIGHT)[dyed(GRAIN)[each]]).mean(axis=0) for each in (number, 0)))


@sweep("cell", [0.05, 0.26, 1 / 3, 0.31, 0.49], keep=[0.05, 0.31])
@pytest.mark.parametrize("dyed", [False, True])
def test_a_pixel_of_many_cells_has_their_mean_light(cell, dyed):
    world = random_world(np.random.default_rng(6), 261, 398)
    world = coloured(world, np.random.default_rng(6)) if dyed else world
    view = View.near(world.shape, (2, 3, 120, 100), cell, (200, 130), 60, 50)
    shown = light_of(drawn(world, view, 110, 130)[view.seen[1] : view.seen[3], view.seen[0] : view.seen[2]])
    sand, walls = world.sand, world.walls
    lit = np.vstack([sand[:1], sand[1:] & ~(sand | walls)[:-1]])
    places = np.where(lit, SURFACE, np.where(sand, GRAIN, np.where(walls, WALL, AIR)))
    means = light_of(palette(NIGHT)).mean(axis=1)[places]
    dyes = np.stack([colour_light(number) for number in range(8)])[world.colours]
    means += np.where(sand[..., None], dyes, 0)
    rows, columns = view.row_edges, shift_edges(view.column_edges, world.layout.words)
    for y, x in np.random.default_rng(7).integers(0, shown.shape[:2], (200, 2)):
        part = means[rows[y] : rows[y + 1], columns[x] : columns[x + 1]]
        assert shown[y, x] == pytest.approx(part.mean(axis=(0, 1)).clip(0, 1), abs=0.005)


@pytest.mark.parametrize("cell", [0.3, 0.7, 1, 3])
@pytest.mark.parametrize("dyed", [False, True])
def test_a_picture_is_the_same_however_many_threads_draw_its_rows(cell, dyed, monkeypatch):
    world = random_world(np.random.default_rng(9), 931, 1170, walls=0.1)  # so that they draw at the same time
    world = coloured(world, np.random.default_rng(9)) if dyed else world
    height, width = (round(side * cell) for side in world.shape)
    pictures = []
    for threads in (1, 3):
        monkeypatch.setattr(row_threads, "THREADS", threads)
        monkeypatch.setattr(row_threads, "LEAST_PIXELS", 1)
        pixels = np.zeros((height, width), np.uint32)
        Painter(View(world.shape, 0, 0, width, height), DAY, "glass").draw(world, pixels)
        pictures.append(pixels)
    assert (pictures[0] == pictures[1]).all()


def test_what_falls_out_of_a_band_changes_the_looks_of_the_pile_below():
    world = grains_over_a_pile_below_a_band()
    view, pixels, whole = View(world.shape, 0, 0, *world.shape[::-1]), *np.zeros((2, *world.shape), np.uint32)
    painter = Painter(view)
    for _ in range(40):
        advance(world, Rule.with_p(0.5, "balanced"), 1)
        painter.draw(world, pixels)
        Painter(view).draw(world, whole)
        assert (pixels == whole).all()


def test_a_world_that_rests_is_not_drawn_again():
    world = random_world(np.random.default_rng(3), 40, 60, sand=0.3, walls=0)
    painter, pixels = Painter(View.fit(world.shape, 0, 0, 60, 40)), np.zeros((40, 60), np.uint32)
    advance(world, Rule(), 1000)
    assert painter.draw(world, pixels) == [(0, 40)]
    advance(world, Rule(), 1000)
    assert painter.draw(world, pixels) == []
    assert painter.draw(world, pixels, damage=[(3, 9), (8, 12), (30, 99)]) == [(3, 12), (30, 40)]
    assert painter.draw(world.copy(), pixels) == [(0, 40)], "another world"
