"""What strokes, figures and floods reach, against plain twins that look at one cell at a time."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import World
from game.core.paint.ink import ANY, RAINBOW, Ink
from game.core.paint.primitives import ELLIPSE, RECTANGLE
from game.core.paint.strokes import DIAMOND, ROUND, SQUARE
from game.world.sand.material_codes import EMPTY, SAND, WALL
from tests.cells import joined_to, random_world

HEIGHT, WIDTH = 23, 147
places = st.tuples(st.floats(-6, WIDTH + 6), st.floats(-6, HEIGHT + 6))
columns, rows = st.integers(-5, WIDTH + 5), st.integers(-5, HEIGHT + 5)
inks = st.builds(
    Ink,
    code=st.sampled_from((EMPTY, SAND, WALL)),
    taken=st.integers(0, ANY),
    spray=st.integers(0, 2),
    colour=st.integers(0, RAINBOW),
)

REACH = {  # how far a point is from the middle of a brush, as its shape counts
    ROUND: np.hypot,
    SQUARE: lambda x, y: np.maximum(abs(x), abs(y)),
    DIAMOND: lambda x, y: abs(x) + abs(y),
}


def strewn(number=0):
    return random_world(np.random.default_rng(number), HEIGHT, WIDTH)


def kinds_of(world):
    return np.where(world.walls, WALL, np.where(world.sand, SAND, EMPTY))


def empty():
    return World.from_cells(np.zeros((HEIGHT, WIDTH), bool), np.zeros((HEIGHT, WIDTH), bool))


def reached_by(act):
    """Return the cells that an act on a world of its own reaches."""
    world = empty()
    act(world, Ink(WALL))
    return world.walls


@pytest.mark.parametrize("shape", REACH)
@given(start=places, end=places, diameter=st.integers(1, 12))
def test_a_stroke_is_the_brush_at_each_place_of_a_line(shape, start, end, diameter):
    cells = reached_by(lambda world, ink: world.stroke(start, end, diameter, shape, ink))
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH] + 0.5
    nearest = np.full((HEIGHT, WIDTH), np.inf)
    for part in np.linspace(0, 1, 150):
        middle_x, middle_y = (one + part * (other - one) for one, other in zip(start, end, strict=True))
        nearest = np.minimum(nearest, REACH[shape](x - middle_x, y - middle_y))
    step = math.dist(start, end) / 149  # a place between two of those looked at may be nearer by as much
    assert not (cells & (nearest > diameter / 2 + step)).any()
    assert not (~cells & (nearest < diameter / 2 - 1e-6)).any()


@pytest.mark.parametrize("kind", [RECTANGLE, ELLIPSE])
@given(left=columns, top=rows, width=st.integers(1, 60), height=st.integers(1, 30), edge=st.integers(0, 4))
def test_a_figure_is_what_lies_inside_its_outline_and_not_inside_a_smaller_one(kind, left, top, width, height, edge):
    def inside(x, y, inwards):
        wide, high = width / 2 - inwards, height / 2 - inwards
        if wide <= 0 or high <= 0:
            return False
        across, down = abs(x + 0.5 - left - width / 2) / wide, abs(y + 0.5 - top - height / 2) / high
        return math.hypot(across, down) <= 1 + 1e-9 if kind == ELLIPSE else max(across, down) <= 1

    box = left, top, left + width, top + height
    cells = reached_by(lambda world, ink: world.figure(kind, box, edge, ink))
    for y, x in np.ndindex(HEIGHT, WIDTH):
        assert cells[y, x] == (inside(x, y, 0) and not (edge and inside(x, y, edge)))


@given(st.integers(0, 50), st.integers(0, WIDTH - 1), st.integers(0, HEIGHT - 1), st.floats(0.1, 0.9))
def test_a_fill_reaches_what_is_connected_side_by_side(number, column, row, crowd):
    world = random_world(np.random.default_rng(number), HEIGHT, WIDTH, sand=crowd, walls=0.1)
    kinds = kinds_of(world)
    reached = joined_to(kinds, row, column)
    material = (kinds[row, column] + 1) % 3
    world.fill(column, row, Ink(material))
    for place in reached:
        kinds[place] = material
    assert (kinds_of(world) == kinds).all()


@pytest.mark.parametrize("length", [31, 33, 63, 64, 65, 127, 128, 129, 300])
def test_a_fill_reaches_the_end_of_a_corridor_however_long(length):
    for start in (0, length // 2, length - 1):
        world = World.from_cells(*np.zeros((2, 1, length), bool))
        world.fill(start, 0, Ink(SAND))
        assert world.grains == length
        world = World.from_cells(*np.zeros((2, length, 1), bool))
        world.fill(0, start, Ink(SAND))
        assert world.grains == length


@given(inks, places, places)
def test_only_the_kinds_named_take_the_ink(ink, start, end):
    world, before = strewn(), kinds_of(strewn())
    change = sum(world.stroke(start, end, 9, ROUND, ink))
    after = kinds_of(world)
    reached = reached_by(lambda world, full: world.stroke(start, end, 9, ROUND, full))
    takes = reached & (ink.taken >> before & 1).astype(bool)
    assert (after[~takes] == before[~takes]).all()
    assert (after[takes] == ink.code).all() or ink.spray
    assert change == (after == SAND).sum() - (before == SAND).sum() == world.grains - strewn().grains


def test_a_spray_picks_the_same_few_cells_for_a_number_and_others_for_another():
    def sprayed(number):
        world = empty()
        world.stroke((70.0, 11.0), (70.0, 11.0), 100, SQUARE, Ink(SAND, ANY, number))
        return world.sand

    area, together = 100 * HEIGHT, np.zeros((HEIGHT, WIDTH), bool)
    for number in range(1, 201):
        assert (sprayed(number) == sprayed(number)).all()
        assert 0 < sprayed(number).sum() < area / 15
        together |= sprayed(number)
    assert abs(sum(sprayed(number).sum() for number in range(1, 201)) / 200 - area / 40) < 2
    assert together.sum() > 0.98 * area


@pytest.mark.parametrize("material", [EMPTY, SAND, WALL])
def test_walls_painted_are_walls_to_the_sand_that_falls_on_them(material):
    """Walls for odd x are a copy: what is painted must be what from_cells would have made."""
    world = strewn(3)
    world.stroke((-3.0, 4.0), (150.0, 18.0), 7, DIAMOND, Ink(material))
    world.figure(ELLIPSE, (60, 2, 130, 20), 3, Ink(material))
    world.fill(0, 0, Ink(WALL))
    again = World.from_cells(world.sand, world.walls)
    assert (world.planes == again.planes).all()
