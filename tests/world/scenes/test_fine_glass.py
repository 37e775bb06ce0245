"""Laws of the fine glass: smaller cells, the same shape, the same minute."""

import numpy as np
import pytest

from game.world.sand.advance import advance
from game.world.scenes.fine_glass import COARSE, FASTEST, FINE, fine_glass
from game.world.scenes.hourglass_maker import scene_for
from game.world.scenes.scene import load_scene
from tests.sweeps import sweep

MINUTE_S = 60


def drained_s(scene):
    """Return after how many seconds at the scene's speed nothing moves any more."""
    world, iterations = scene.world(), 0
    while not world.activity.settled:
        advance(world, scene.rule, 100)
        iterations += 100
    return iterations / scene.speed


@sweep("high", [720, 1100, 1900, 4000], keep=[720, 1100])
def test_a_glass_of_any_fineness_drains_in_the_same_minute(high):
    scene = fine_glass(load_scene("hourglass"), (2 * high, high))
    assert drained_s(scene) == pytest.approx(MINUTE_S, rel=0.03)
    assert scene.speed <= FASTEST and scene.cell == FINE


@pytest.mark.parametrize("room", [(640, 480), (700, 640), (540, 719), (539, 900)])
def test_a_glass_whose_cells_are_small_already_stays_what_it_is(room):
    scene = load_scene("hourglass")
    assert fine_glass(scene, room) is scene


@pytest.mark.parametrize("room", [(540, 720), (1000, 752), (600, 2000), (3000, 1620)])
def test_a_fine_glass_fits_its_room_and_has_the_shape_of_the_coarse_one(room):
    coarse = load_scene("hourglass")
    fine = fine_glass(coarse, room)
    height, width = fine.shape
    assert height * FINE <= room[1] and width * FINE <= room[0] and fine.neck == height // 2
    assert (fine.sand == fine.sand[:, ::-1]).all() and (fine.walls == fine.walls[::-1]).all()
    shares = [(scene.sand.mean(), np.ptp(np.nonzero(scene.walls)[1]) / scene.shape[1]) for scene in (coarse, fine)]
    assert shares[0] == pytest.approx(shares[1], rel=0.08)


def test_no_other_scene_changes_its_cells():
    room = (9000, 9000)
    for name in ("galton", "rainbow", "sandpile"):
        scene = load_scene(name)
        assert fine_glass(scene, room) is scene


def test_a_glass_made_for_a_time_becomes_finer_too():
    scene = scene_for(10)
    assert fine_glass(scene, (2000, COARSE * scene.shape[0])).shape[0] > scene.shape[0]


@sweep("seconds", [1, 15, 180, 3600], keep=[1, 15])
def test_a_glass_for_a_time_is_only_as_fine_as_its_pace_bears(seconds):
    scene = fine_glass(scene_for(seconds), (6000, 4000))
    assert scene.speed <= FASTEST and drained_s(scene) == pytest.approx(seconds, rel=0.25)
