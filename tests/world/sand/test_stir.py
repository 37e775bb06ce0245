"""Laws of the stir: what rests is not heard, what moves is, and from its side."""

import numpy as np
import pytest

from game import Rule, World, advance, load_scene
from game.world.sand.measure import Stir


def fallen(columns, shape=(80, 400)):
    """Return what is seen of grains that fall in some columns."""
    sand = np.zeros(shape, bool)
    sand[::4, columns] = True
    world, stir = World.from_cells(sand, np.zeros(shape, bool)), Stir()
    stir.look(world)
    advance(world, Rule(), 6)
    return stir.look(world)


def test_the_first_look_and_sand_at_rest_are_silent():
    sand = np.zeros((20, 300), bool)
    sand[-3:] = True
    world, stir = World.from_cells(sand, np.zeros_like(sand)), Stir()
    assert stir.look(world) == (0, 0)
    advance(world, Rule.with_p(0.5), 20)
    assert stir.look(world) == (0, 0)


@pytest.mark.parametrize("width", [60, 128, 400, 1000])
def test_the_side_is_where_the_sand_moves(width):
    shape = 80, width
    left, middle, right = (fallen([at], shape)[1] for at in (1, width // 2, width - 2))
    assert left < -0.7 and right > 0.7 and abs(middle) < 0.3


def test_more_sand_in_motion_is_more_to_hear():
    one, five, fifty = (fallen(list(range(10, 10 + count)))[0] for count in (1, 5, 50))
    assert 0 < one < five < fifty
    assert five == pytest.approx(5 * one, rel=0.3)


def test_a_sample_of_the_rows_tells_about_as_much_as_all_of_them():
    scene = load_scene("hourglass", (720, 960))
    world, stir = scene.world(), Stir()
    advance(world, scene.rule, 400)
    stir.look(world)
    before = world.sand
    advance(world, scene.rule, 16)
    assert stir.look(world)[0] == pytest.approx((world.sand != before).sum() / 2, rel=0.25)


def test_another_lattice_is_a_first_look():
    stir = Stir()
    for name in ("hourglass", "paper"):
        assert stir.look(load_scene(name).world()) == (0, 0)
