"""Looks of worlds of any materials: as a plain reading of each cell's surroundings says."""

import numpy as np
import pytest

from game import load_rule, rule_names
from game.core.draw.cells import TEXTURE
from game.core.draw.downscaled import shift_edges
from game.core.draw.glass_decor import places_of
from game.core.draw.looks import MOST_LOOKS, SAND, SHAPES, Substance, Substances, counted_looks, has_glass, looks_of
from game.world.looks.motion_samples import MotionSamples
from game.world.looks.painter import Painter, texture
from game.world.looks.themes import THEMES, palette, substances_of
from game.world.looks.view import View
from tests.looks import general_looks, packed_world
from tests.sweeps import sweep

SHAPES_OF_LATTICES = [(1, 1), (1, 3), (2, 2), (3, 130), (7, 385), (40, 61)]


def random_substances(generator):
    """Return Substances of some materials of random classes, and wall."""
    number = int(generator.integers(3, 17))
    kinds = [*generator.choice(list(SHAPES), number - 1)]
    outside = int(generator.integers(1, number))
    kinds[outside - 1] = "solid"
    colours = generator.integers(0, 256, (number, 3)).tolist()
    every = tuple(Substance(str(kind), (1 + at,), tuple(colours[at])) for at, kind in enumerate(kinds))
    return Substances(every, max(2, (number - 1).bit_length()), outside)


def codes_at_random(generator, shape, substances):
    return generator.integers(0, 1 + len(substances.all), shape, np.uint8)


@pytest.mark.parametrize("shape", SHAPES_OF_LATTICES)
@sweep("seed", range(8), keep=[0])
@pytest.mark.parametrize("made_of", ["stone", "glass"])
def test_any_materials_look_as_what_lies_around_them_says(shape, seed, made_of):
    generator, colours = np.random.default_rng(seed), list(THEMES.values())[seed % 3]
    substances = random_substances(generator)
    codes = codes_at_random(generator, shape, substances)
    decor = places_of(codes == substances.outside) if made_of == "glass" and has_glass(substances) else None
    looks, pixels = general_looks(codes, substances, decor), np.zeros(shape, np.uint32)
    view = View(shape, 0, 0, *shape[::-1])
    Painter(view, colours, made_of, substances=substances).draw(packed_world(codes, substances), pixels)
    rows, columns = np.mgrid[0 : shape[0], 0 : shape[1]] % TEXTURE
    assert (pixels == palette(colours, made_of, substances=substances)[looks, texture()[rows, columns]]).all()


@sweep("seed", range(6), keep=[0, 1])
def test_a_pixel_of_many_cells_of_any_materials_has_their_mean_light(seed):
    generator = np.random.default_rng(seed)
    substances, shape = random_substances(generator), (64, 400)
    codes = codes_at_random(generator, shape, substances)
    painter = Painter(View(shape, 0, 0, 40, 6), substances=substances)
    pixels, looks = np.zeros((6, 40), np.uint32), general_looks(codes, substances)
    world, numbers = packed_world(codes, substances), looks_of(substances)
    painter.draw(world, pixels)
    values = palette(THEMES["night"], substances=substances)
    light = light_of(values).mean(axis=1)
    counted = {one for one, _ in counted_looks(substances)[0]}
    plain = [number for number in range(len(numbers))]
    for number, look in enumerate(numbers):
        if look.substance and look not in counted:
            plain[number] = numbers.index(next(each for each in numbers if each.substance == look.substance))
        elif not look.substance:
            plain[number] = 0
    means = light[np.array(plain)[looks]]
    rows, columns = View(shape, 0, 0, 40, 6).row_edges, View(shape, 0, 0, 40, 6).column_edges
    columns = shift_edges(columns, world.layout.words)
    for y in range(6):
        for x in range(40):
            wanted = means[rows[y] : rows[y + 1], columns[x] : columns[x + 1]].mean(axis=(0, 1))
            assert light_of(pixels[y, x]) == pytest.approx(wanted.clip(0, 1), abs=0.006)


def light_of(values):
    """Return the light of pixel values 0xRRGGBB in 0 … 1: (…, 3)."""
    parts = np.stack([values >> 16 & 255, values >> 8 & 255, values & 255], axis=-1) / 255
    return np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)


@pytest.mark.parametrize("name", rule_names())
def test_the_materials_of_every_shipped_rule_can_be_drawn_in_a_glass(name):
    substances = substances_of(load_rule(name).definition.materials)
    assert has_glass(substances) and len(looks_of(substances)) <= MOST_LOOKS


def test_sand_is_drawn_as_the_theme_says():
    assert substances_of(load_rule("sand").definition.materials) == SAND


def test_what_falls_leaves_the_colour_of_what_fell_last():
    substances = Substances(
        (Substance("powder", (1,), (200, 40, 40)), Substance("liquid", (2,), (40, 40, 200)), Substance("solid", (3,))),
        2,
        3,
    )
    codes, streams = np.zeros((4, 6), np.uint8), MotionSamples(substances)
    world, pictures = packed_world(codes, substances), []
    for kind in (1, 2):
        for number in range(5):
            codes[:] = 0
            codes[number % 4, 2] = kind
            world.planes[:], world.iteration = packed_world(codes, substances).planes, world.iteration + 1
            world.activity.wake(0, 4)
            streams.note(world)
        pixels = np.zeros(codes.shape, np.uint32)
        Painter(View(codes.shape, 0, 0, 6, 4), substances=substances).draw(world, pixels, streams=streams)
        pictures.append(int(pixels[2, 2]))
    red, blue = pictures
    assert red >> 16 > red & 255 and blue & 255 > blue >> 16
