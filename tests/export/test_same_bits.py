"""An exported rule moves every cell as Python does, however it is compiled."""

import numpy as np
import pytest

from game import World, advance, load_rule, rule_names
from game.core.paint.ink import Ink
from game.core.paint.strokes import ROUND
from game.export.files import files
from game.export.rule_parts import rule_parts
from game.export.start_scene import small_start
from game.world.sand.schedules import SCHEDULES
from tests.export.library import BUILDS, builds, compiled, library
from tests.sweeps import sweep

SHAPES = ((1, 1), (1, 130), (129, 1), (2, 2), (3, 128), (9, 127), (8, 129), (5, 256), (12, 257))


MOSS = """
title = "Moss"
layers = ["growth"]

[materials]
air = { letter = ".", class = "empty", colour = "#000000" }
moss = { letter = "m", class = "solid", colour = "#00ff00" }
wall = { letter = "#", class = "solid", colour = "#888888" }

[[event]]
name = "moss grows on walls"
chance = 0.25
picture = "#. -> #m"

[[event]]
name = "moss dies or spreads"
chance = [0.125, 0.0625]
picture = "m. -> .. | mm"
"""


# Nothing is left to chance, and two of the layers have no event that can happen.
STONES = """
title = "Stones"
layers = ["empty", "motion", "idle"]

[materials]
air = { letter = ".", class = "empty", colour = "#000000" }
stone = { letter = "s", class = "powder", density = 9, colour = "#999999" }
wall = { letter = "#", class = "solid", colour = "#888888" }

[any]
G = "gas"

[[event]]
name = "no gas"
layer = "empty"
picture = "G -> ."

[[event]]
name = "no gas at all"
layer = "idle"
picture = "G. -> .G"

[[event]]
name = "fall"
layer = "motion"
ways = "as drawn"
picture = '''
s    .
. -> s
'''
"""


def random_shape(generator, number):
    """Return the (height, width) of a world: those at the edges of words first, then any."""
    return SHAPES[number] if number < len(SHAPES) else tuple(generator.integers(1, (90, 150)))


def random_cells(generator, shape, materials):
    cells = generator.integers(0, materials, shape).astype(np.uint8)
    cells[generator.random(shape) < generator.choice([0.0, 0.3, 0.8])] = 0
    return cells


def story(generator, rule, shape):
    """Return what is done to a world: functions of (a World, its rule, the same in C) that return the rule after."""
    height, width = shape
    acts = []
    for name in generator.permutation(list(rule.chances))[:2]:
        acts.append(chance_set(str(name), float(generator.uniform(0.01, 0.49))))
    for _ in range(2):
        x, y = (int(generator.integers(-3, side + 3)) for side in (width, height))
        acts.append(stroke_of(x, y, int(generator.integers(1, 14)), int(generator.integers(len(rule.materials)))))
    return [*acts, turned]


def chance_set(name, p):
    def act(world, rule, copies):
        for each in copies:
            assert each.set_chance(name.encode(), p) and each.chance(name.encode()) == p
        return rule.with_chances(**{name: p})

    return act


def stroke_of(x, y, diameter, code):
    def act(world, rule, copies):
        before = world.materials
        place = x + 0.5, y + 0.5
        world.stroke(place, place, diameter, ROUND, Ink(code))
        for each in copies:
            assert each.disc(x, y, diameter, code) == np.count_nonzero(before != world.materials)
        return rule

    return act


def turned(world, rule, copies):
    world.flip()
    for each in copies:
        each.flip()
    return rule


def check(rule, libraries, worlds):
    generator = np.random.default_rng(90)
    for number in range(worlds):
        shape = random_shape(generator, number)
        cells, seed = random_cells(generator, shape, len(rule.materials)), int(generator.integers(2**63)) * 2 + 1
        acts = story(generator, rule, shape)
        for schedule in SCHEDULES:
            world, now = World.from_materials(cells, rule, seed), rule.with_schedule(schedule)
            copies = [each.world(cells, seed, schedule) for each in libraries]
            for act in (*acts, None):
                iterations = 64 // (len(acts) + 1) if act else 64 - world.iteration
                advance(world, now, iterations)
                for each in copies:
                    each.step(iterations)
                now = act(world, now, copies) if act else now
            assert [each.name() for each in copies] == [world.digest()] * len(copies), (shape, schedule)


@sweep("name", ["sand", "water-and-oil"], keep=["water-and-oil"])
def test_a_shipped_rule_has_the_same_bits_in_c(name):
    check(load_rule(name), [library(name, build) for build in builds()], worlds=20)


@sweep("name", rule_names())
def test_every_shipped_rule_has_the_same_bits_in_c_however_it_is_compiled(name):
    check(load_rule(name), [library(name, build) for build in builds(BUILDS)], worlds=60)


@pytest.mark.parametrize("p", [0.0, 1.0, 2**-32, 1 - 2**-32, 2**-33, 0.5 + 2**-40])
def test_the_ends_of_a_chance_have_the_same_bits_in_c(p):
    generator, rule, calls = np.random.default_rng(91), load_rule("sand"), library("sand", builds()[0])
    cells = random_cells(generator, (40, 150), 3)
    world, copy = World.from_materials(cells, rule, 3), calls.world(cells, 3)
    for name in rule.chances:
        rule = chance_set(name, p)(world, rule, [copy])
    advance(world, rule, 64)
    copy.step(64)
    assert copy.name() == world.digest()


def test_bands_at_rest_wake_when_something_comes_to_them():
    """Grains fall past a heap at rest; then it has its floor taken away. The lattice has three bands."""
    rule, cells = load_rule("sand").with_schedule("balanced"), np.zeros((170, 3000), np.uint8)
    cells[90, ::3], cells[80:90, 1500], cells[0, 1::60] = 2, 1, 1
    world, copy = World.from_materials(cells, rule, 8), library("sand", builds()[0]).world(cells, 8, rule.schedule)
    for x, y, code in ((1501, 30, 1), (1500, 90, 0), (0, 0, 1)):
        advance(world, rule, 250)
        assert copy.step(250) == 0 and world.activity.settled
        assert copy.name() == world.digest()
        world.stroke((x + 0.5, y + 0.5), (x + 0.5, y + 0.5), 5, ROUND, Ink(code))
        copy.disc(x, y, 5, code)


def rule_of(text, folder):
    """Return a rule and its Library."""
    path = folder / "own.toml"
    path.write_text(text, encoding="utf-8")
    rule = load_rule(path)
    return rule, compiled(files(small_start(rule))["sandglass.h"], builds()[0], folder)


def test_a_rule_of_events_at_the_border_has_the_same_bits_in_c(tmp_path):
    rule, calls = rule_of(MOSS, tmp_path)
    assert all(rule_parts(rule)[edge] for edge in ("above", "below"))
    check(rule, [calls], worlds=12)


def test_a_rule_without_chance_has_the_same_bits_in_c(tmp_path):
    rule, calls = rule_of(STONES, tmp_path)
    check(rule, [calls], worlds=12)
