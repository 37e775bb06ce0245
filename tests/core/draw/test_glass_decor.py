"""Decor: what is inside of a glass, where it gleams, what is wood, and what stands behind."""

import numpy as np
import pytest

from game.core.draw.glass_decor import FREE, GLEAM, INSIDE, POST, WOOD, decor_of, decorate, places_of
from game.core.planes import WALL, WALLS, layout, pack, unpack
from game.world.scenes.scene import load_scene, scene_names


def decorated(walls):
    places = np.zeros(walls.shape, np.uint8)
    decorate(walls.view(np.uint8), places)
    return places


def outside(walls):
    """Return which cells are free and joined to the border by free cells, from a plain flood."""
    reached = np.pad(~walls, 1, constant_values=True)
    free, found = reached.copy(), np.zeros_like(reached)
    found[0, 0] = True
    while True:
        spread = found.copy()
        spread[1:] |= found[:-1]
        spread[:-1] |= found[1:]
        spread[:, 1:] |= found[:, :-1]
        spread[:, :-1] |= found[:, 1:]
        spread &= free
        if (spread == found).all():
            return found[1:-1, 1:-1]
        found = spread


@pytest.mark.parametrize("shape", [(1, 1), (5, 4), (30, 41), (64, 64)])
@pytest.mark.parametrize("density", [0.0, 0.2, 0.45, 0.7, 1.0])
def test_what_walls_shut_in_is_inside_and_nothing_else(shape, density):
    for seed in range(4):
        walls = np.random.default_rng(seed).random(shape) < density
        places = decorated(walls)
        open_to_the_border = outside(walls)
        assert not np.isin(places, (INSIDE, GLEAM))[open_to_the_border].any()
        assert np.isin(places, (INSIDE, GLEAM))[~walls & ~open_to_the_border].all()
        assert np.isin(places[walls], (FREE, WOOD)).all()
        assert np.isin(places[open_to_the_border], (FREE, POST)).all()


@pytest.mark.parametrize("size", [None, (90, 120), (61, 61), (360, 480)])
def test_an_hourglass_has_two_caps_two_posts_a_room_and_its_gleam(size):
    scene = load_scene("hourglass", size)
    places = decorated(scene.walls)
    height, width = places.shape
    wood_rows = np.flatnonzero(((places == WOOD) & scene.walls).any(axis=1))
    assert wood_rows[0] < height / 10 and wood_rows[-1] > height * 9 / 10
    assert not ((wood_rows > height / 8) & (wood_rows < height * 7 / 8)).any(), "the glass is no wood"
    middle = places[height // 4]
    posts = np.flatnonzero((middle == POST) & ~scene.walls[height // 4])
    assert posts.min() < width / 2 < posts.max()
    assert (np.diff(posts) > 1).sum() == 1, "two posts"
    assert (middle[posts.min() + 1 : posts.max()] == GLEAM).any()
    assert places[height // 2, width // 2] == INSIDE and scene.sand[~np.isin(places, (INSIDE, GLEAM))].sum() == 0


def test_decor_planes_hold_what_decorates_each_cell():
    walls = np.random.default_rng(3).random((37, 150)) < 0.4
    where = layout(*walls.shape)
    planes = decor_of(pack(walls * np.uint8(WALL), where)[WALLS : WALLS + 4], where)
    found = unpack(planes, where)
    assert (found == places_of(walls)).all()


@pytest.mark.parametrize("quarters", [1, 3])
@pytest.mark.parametrize("name", ["hourglass", "clocks"])
def test_a_glass_on_its_side_has_the_wood_and_the_posts_that_it_had(name, quarters):
    walls = load_scene(name).walls
    upright, lying = places_of(walls), np.rot90(places_of(np.rot90(walls, quarters)), -quarters)
    assert (upright == POST).any() and (upright == WOOD).any()
    for kind in (POST, WOOD, INSIDE):
        seen = [(places == kind) & ((places != INSIDE) | ~walls) for places in (upright, lying)]
        assert (seen[0] != seen[1]).mean() < 0.02  # a gleam is on the other side of its room


def test_a_scene_that_stands_is_decorated_as_it_stands():
    glasses = [scene for scene in map(load_scene, scene_names()) if scene.made_of == "glass"]
    assert len(glasses) > 3
    for scene in glasses:
        assert (places_of(scene.walls) == decorated(scene.walls)).all(), scene.name


def test_a_glass_upside_down_is_decorated_alike_but_for_its_gleam():
    walls = load_scene("hourglass").walls
    upright, turned = decorated(walls), decorated(np.ascontiguousarray(walls[::-1, ::-1]))[::-1, ::-1]
    upright[(upright == GLEAM) & ~walls] = turned[(turned == GLEAM) & ~walls] = INSIDE
    assert (upright == turned).mean() > 0.999
