"""Bands that rest: of a settled world only what still stirs is computed and drawn."""

import numpy as np
import pytest

from game import World, advance, load_rule
from game.world.looks.painter import Painter
from game.world.looks.themes import substances_of
from game.world.looks.view import View


@pytest.fixture(params=["alchemy", "water-and-oil"])
def tank(request):
    """Return (a rule, a wide world half full of water whose surface has still to even out, long after)."""
    rule = load_rule(request.param)
    cells = np.zeros((1080, 1920), np.uint8)
    cells[540:] = cells[539, ::2] = rule.codes.code("water")
    world = World.from_materials(cells, rule, 3)
    advance(world, rule, 2000)
    return rule, world


def test_a_half_full_tank_keeps_the_band_of_its_surface_awake_and_no_other(tank):
    rule, world = tank
    before, bands = world.activity.stamp, world.activity
    advance(world, rule, 40)
    stirred = np.flatnonzero(bands.changed > before)
    assert len(stirred) == 1 and len(bands.changed) > 10
    surface = 540 // 2 // bands.band_rows
    assert abs(stirred[0] - surface) <= 1 and bands.awake(rule.schedule, world.iteration).sum() <= 3


def test_of_a_half_full_tank_only_the_rows_about_the_surface_are_drawn(tank):
    rule, world = tank
    painter = Painter(View(world.shape, 0, 0, 1920, 1080), substances=substances_of(rule.definition.materials))
    pixels = np.zeros((1080, 1920), np.uint32)
    assert painter.draw(world, pixels) == [(0, 1080)]
    advance(world, rule, 40)
    ((top, bottom),) = painter.draw(world, pixels)
    assert top <= 540 < bottom and bottom - top < 1080 // 10
