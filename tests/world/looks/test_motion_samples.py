"""Smooth streams: falling sand as the mean of the last iterations, and nothing else changed."""

import numpy as np
import pytest

from game import Rule, World, advance, load_scene
from game.core.draw.cells import TEXTURE
from game.core.draw.glass_decor import decor_of
from game.core.draw.looks import AIR, GLEAM, INSIDE, POST, SURFACE, dyed
from game.core.draw.motion_blur import SAMPLES
from game.core.planes import unpack
from game.world.looks.colour_space import blends, channels, linear
from game.world.looks.motion_samples import FROM_SPEED, MotionSamples
from game.world.looks.painter import Painter, texture
from game.world.looks.themes import NIGHT, THEMES, palette, rgb
from game.world.looks.view import View
from game.world.sessions.action import Flip, Paint, apply
from game.world.sessions.session import FRAMES_PER_SECOND, Session
from tests.cells import coloured, grains_over_a_pile_below_a_band, random_world
from tests.eyes import SIGHTS, difference, lab
from tests.sweeps import sweep

RULE = Rule.with_p(0.7, "balanced")


def painter_of(world, walls="stone"):
    height, width = world.shape
    return Painter(View(world.shape, 0, 0, width, height), walls=walls), np.zeros(world.shape, np.uint32)


def drawn(world, streams=None, walls="stone"):
    painter, pixels = painter_of(world, walls)
    painter.draw(world, pixels, streams=streams)
    return pixels


def run(world, streams, iterations):
    """Run iterations, each sampled, and return the sand after each."""
    sand = []
    for _ in range(iterations):
        advance(world, RULE, 1)
        streams.note(world)
        sand.append(world.sand)
    return np.array(sand)


def run_with_colours(world, streams, iterations, last):
    """Do as `run` does, and note the colour of each cell's last grain in `last`, in place."""
    sand = []
    for _ in range(iterations):
        sand += list(run(world, streams, 1))
        last[world.sand] = world.colours[world.sand]
    return np.array(sand)


def components(pixels):
    return np.stack([pixels >> 16 & 255, pixels >> 8 & 255, pixels & 255], axis=-1).astype(int)


@pytest.mark.parametrize("walls", ["stone", "glass"])
@sweep("shape", [(1, 3), (2, 2), (37, 61), (40, 300), (90, 128)], keep=[(1, 3), (37, 61)])
@pytest.mark.parametrize("dyes", [False, True])
def test_moving_cells_show_the_mean_of_a_cycle_and_others_what_they_are(shape, walls, dyes):
    world, streams = random_world(np.random.default_rng(4), *shape, sand=0.2, walls=0.05), MotionSamples()
    world = coloured(world, np.random.default_rng(5)) if dyes else world
    last = world.colours
    for _ in range(8):
        share = run_with_colours(world, streams, 5, last)[-SAMPLES:].mean(axis=0)
        moving = (share > 0) & (share < 1)
        places = unpack(decor_of(world.wall_planes, world.layout), world.layout)
        grounds = np.array([AIR, INSIDE, GLEAM, POST] if walls == "glass" else [AIR] * 4)[places]
        y, x = np.mgrid[0 : shape[0], 0 : shape[1]] % TEXTURE
        light = linear(components(palette(NIGHT, walls)) / 255)
        sand, ground = light[dyed(SURFACE)[last], texture()[y, x]], light[grounds, texture()[y, x]]
        wanted = share[..., None] * sand + (1 - share[..., None]) * ground
        pixels = drawn(world, streams, walls)
        assert np.abs(linear(components(pixels) / 255) - wanted)[moving].max(initial=0) < 0.006
        assert (pixels == drawn(world, walls=walls))[~moving].all()


def test_the_world_evolves_the_same_and_at_the_same_pace_with_smooth_streams():
    plain, smooth = (Session(load_scene("hourglass", (90, 120))) for _ in range(2))
    smooth.streams = MotionSamples()
    for elapsed_ms in np.random.default_rng(5).integers(0, 60, 80):
        for session in (plain, smooth):
            session.clock.speed = 300
            session.frame(int(elapsed_ms) * 10**6)
        assert (plain.now, plain.done) == (smooth.now, smooth.done)
    assert plain.now > 500 and plain.world.digest() == smooth.world.digest()
    assert smooth.streams.follows(smooth.world)


def test_what_is_drawn_piece_by_piece_is_the_whole_picture():
    generator = np.random.default_rng(6)
    world, streams = random_world(generator, 1500, 300, sand=0.02, walls=0.02), MotionSamples()
    painter, pixels = painter_of(world, "glass")
    for number in range(60):
        run(world, streams, int(generator.integers(0, 9)))
        if number % 5 == 0:
            row = float(generator.integers(1400))
            apply(Paint("sand", (150.5, row), (160.5, row + 5), 3), world, RULE)
        followed = streams if number % 7 else None  # as while time is held
        painter.draw(world, pixels, streams=followed)
        assert (pixels == drawn(world, followed, "glass")).all(), number


def test_what_falls_out_of_a_band_is_sampled_too():
    world, streams = grains_over_a_pile_below_a_band(), MotionSamples()
    run(world, streams, 1)
    for _ in range(40):
        run(world, streams, 1)
        assert (unpack(streams.samples[world.iteration % SAMPLES], world.layout) == world.sand).all()


def test_sand_at_rest_is_drawn_as_without_and_never_again():
    world, streams = random_world(np.random.default_rng(7), 60, 80, sand=0.3, walls=0.02), MotionSamples()
    painter, pixels = painter_of(world)
    run(world, streams, 600)
    painter.draw(world, pixels, streams=streams)
    assert (pixels == drawn(world)).all()
    run(world, streams, 5)
    assert painter.draw(world, pixels, streams=streams) == []


def test_a_world_that_was_turned_over_or_changed_for_another_leaves_no_ghost():
    world, streams = World.from_cells(np.eye(40, dtype=bool), np.zeros((40, 40), bool)), MotionSamples()
    run(world, streams, 6)
    apply(Flip(), world, RULE)
    assert not streams.follows(world) and not streams.follows(world.copy())
    run(world, streams, 1)
    assert (drawn(world, streams) == drawn(world)).all()


@pytest.mark.parametrize(("shape", "speed"), [((3000, 3000), 1000), ((100, 100), FROM_SPEED - 1)])
def test_large_lattices_and_slow_motion_are_drawn_cell_by_cell(shape, speed):
    assert MotionSamples.are_worth((100, 100), FROM_SPEED) and not MotionSamples.are_worth(shape, speed)


@pytest.mark.parametrize("colours", THEMES.values(), ids=THEMES)
@pytest.mark.parametrize("sight", SIGHTS)
def test_even_the_thinnest_stream_can_be_seen_in_every_theme(colours, sight):
    values = palette(colours, "glass")
    for count in components(blends(values, channels(rgb), dyed(colours.stream)))[0]:
        for ground, streams in zip((AIR, INSIDE, GLEAM), count, strict=False):
            air = lab(colours.air[ground].dark, sight)
            assert min(difference(lab(each, sight), air) for each in streams) > 9


def test_what_is_erased_while_time_is_held_leaves_no_ghost_and_other_streams_stay():
    world, streams = random_world(np.random.default_rng(8), 2200, 40, sand=0.1, walls=0.0), MotionSamples()
    run(world, streams, 6)
    apply(Paint("erase", (20.5, 20.5), (20.5, 40.5), 30), world, RULE)
    streams.take_acts(world)
    band = 2 * world.activity.band_rows
    pixels, plain = drawn(world, streams), drawn(world)
    assert (pixels[:80] == plain[:80]).all() and (pixels[band + 2 :] != plain[band + 2 :]).any()


def test_a_copy_of_the_samples_draws_a_copy_of_the_world_and_goes_its_own_way():
    world, streams = random_world(np.random.default_rng(9), 60, 80, sand=0.2, walls=0.0), MotionSamples()
    run(world, streams, 6)
    still = world.copy()
    kept, wanted = streams.copy(still), drawn(world, streams)
    run(world, streams, 3)
    assert (drawn(still, kept) == wanted).all() and (wanted != drawn(still)).any()


def test_sand_that_moves_in_every_frame_is_drawn_as_streams():
    assert MotionSamples.are_worth((100, 100), FRAMES_PER_SECOND)
    for name in ("paper", "city"):
        scene = load_scene(name)
        assert MotionSamples.are_worth(scene.shape, scene.speed), name
