"""Makes kernels ready before they are needed: each is compiled by using it once on a world of a few cells."""

from contextlib import suppress

import numpy as np

from game.core import jit, planes
from game.core.compiler.beside import run_beside
from game.core.draw.cells import draw_turned
from game.core.draw.heatmap import covers_of, lay_heat, mean_levels
from game.core.draw.looks import Substance
from game.core.step import advance_bands
from game.world.background.forecast_thread import ForecastRequest, forecast_of
from game.world.looks.firelight import Firelight
from game.world.looks.heatmap_colours import cover
from game.world.looks.motion_samples import MotionSamples
from game.world.looks.painter import Painter, rgb
from game.world.looks.themes import substances_of
from game.world.looks.view import View
from game.world.rules.rule import Rule
from game.world.sand import fixtures as fixture
from game.world.sand.advance import advance
from game.world.sand.crop import Crop, CropBox
from game.world.sand.ensemble import growing_counts
from game.world.sand.fixtures import DRAIN, TAP, Fixture
from game.world.sand.measure import pile_heights
from game.world.sand.reaction_counts import ReactionMeter
from game.world.sand.world import World
from game.world.sessions.action import Draw, Fill, Paint, Turn, apply

CELLS = (1, 0.25)  # pixels to a cell: each is drawn in another way
KINDS = {  # a rule for each kind of kernel
    "sand that always moves": Rule(),
    "sand that topples by chance": Rule.with_p(0.5),
    "sand with seven probabilities": Rule(*[0.5] * 7),
}


def cache_trouble():
    """Return in one line what was wrong with the kept kernels so far, or None: it costs time, and nothing else."""
    return jit.trouble()


def steps(rule, walls, cell=1, coloured=False, fixtures=()):
    """Return [(what, act)], every kernel that showing a scene with `rule` needs; call each act to make it ready.

    The last one moves sand. walls: what they are made of. cell: pixels to a cell. coloured: whether the sand has
    colours. fixtures: its taps and drains.
    """
    return drawing_steps(rule, walls, cell) + moving_steps(rule, coloured, fixtures)


def make_stepping_beside():
    """Have the stepping compiled by another process, if that can be and has not been, and wait for it.

    It takes longer than all else that a first frame needs.
    """
    if not jit.is_kept(advance_bands):
        with suppress(OSError):
            run_beside(_step, is_urgent=True)


def moving_steps(rule, coloured=False, fixtures=()):
    """Return the steps of `steps` that move sand."""
    return [
        *([("taps and drains", lambda: _flow(coloured))] if fixtures else []),
        ("the layout of the cells", lambda: (_dot(coloured).sand, _dot(coloured).flip())),
        (_kind_of(rule), lambda: advance(_dot(coloured, rule), rule, 1)),
    ]


def drawing_steps(rule, walls, cell=1):
    """Return the steps of `steps` that draw."""
    return [("drawing", lambda: _draw(rule, walls, cell))]


def later_steps(rule):
    """Return [(what, act)] for the kernels that a player may need next."""
    of_sand = rule if rule.codes.is_sand else Rule()
    others = [(what, other) for what, other in KINDS.items() if what != _kind_of(of_sand)]
    return [
        ("the brush", _brush),
        ("the turn of the glass", _turn),
        ("the light of fire", _firelight),
        ("the figures", _figures),
        ("the eraser of fixtures", _eraser),
        *(("drawing glass", lambda cell=cell: _draw(Rule(), "glass", cell)) for cell in CELLS),
        ("the forecast", _forecast),
        ("the measures", lambda: pile_heights(_dot())),
        ("the reactions", lambda: ReactionMeter().look(_dot(rule=rule), rule)),
        ("the names of worlds", lambda: World.from_cells(*np.zeros((2, 66, 2), bool)).digest()),  # of two bands
        ("the books of colours", lambda: _dot(coloured=True).amounts),
        *((f"{what} of colours", act) for what, act in moving_steps(of_sand, coloured=True)),
        ("the brush of colours", lambda: _brush(coloured=True)),
        ("figures of colours", lambda: _figures(coloured=True)),
    ] + [
        (what, lambda other=other, coloured=coloured: advance(_dot(coloured), other, 1))
        for coloured in (False, True)
        for what, other in others
    ]


def _dot(coloured=False, rule=None):
    """Return a world of a few cells, made when asked for, since making one compiles the layout."""
    if rule is not None and not rule.codes.is_sand:
        return World.from_materials(np.eye(2, dtype=np.uint8), rule)
    sand = np.eye(2, dtype=bool)
    sand.flags.writeable = False  # as those of scenes
    walls = sand & False
    walls.flags.writeable = False
    return World.from_cells(sand, walls, colours=sand.astype(np.uint8) if coloured else None)


def _bare(codes):
    """Return a world of 8×8 empty cells, made without compiling the layout."""
    where = planes.layout(8, 8, len(codes.names), codes.wall)
    bits = planes.empty(where, 4 * where.bits)
    bits[:] = 0
    return World(bits, where, codes, 0, 0)


def _step():
    advance(_bare(Rule().codes), Rule(), 1)


def _draw(rule, walls, cell):
    substances = substances_of(rule.definition.materials)
    world, streams = _bare(rule.codes), MotionSamples(substances)
    for _ in range(2):
        world.iteration += 1
        streams.note(world)
    side = max(1, 8 * min(cell, 1))  # more pixels than cells are drawn as one pixel for each is
    painter = Painter(View(world.shape, 0, 0, side, side), walls=walls, substances=substances)
    painter.draw(world, np.zeros((8, 8), np.uint32), streams=streams)


def _firelight():
    light = Firelight([Substance("gas", (1,), (255, 0, 0), True)], 0.5, rgb, View((2, 2), 0, 0, 2, 2))
    light.follow(_dot())
    light.draw(np.zeros((2, 2), np.uint32), 0, 2)


def _turn():
    picture = np.zeros((2, 2), np.uint32)
    draw_turned(picture, 0, 1.0, 0.0, 1.0, picture.copy(), 0, 0, 2, 2)


def _brush(coloured=False):
    apply(Paint("sand", (0.0, 0.0), (1.0, 1.0), 1), _dot(coloured), Rule())


def _figures(coloured=False):
    for act in (Draw("ellipse", "sand", (0.5, 0.5), (1.5, 1.5)), Fill("sand", (0.5, 0.5)), Turn(1)):
        apply(act, _dot(coloured), Rule())


def _flow(coloured):
    world = _dot(coloured)
    world.fixtures = (Fixture(TAP, 0, 0), Fixture(DRAIN, 1, 1))
    fixture.act(world)


def _eraser():
    for act in (Paint("erase", (0.0, 0.0), (1.0, 1.0), 1), Draw("rectangle", "erase", (0.5, 0.5), (1.5, 1.5))):
        world = _dot()
        world.fixtures = (Fixture(TAP, 0, 0),)
        apply(act, world, Rule())


def _forecast():
    world, rule = _dot(), Rule.with_p(0.5)
    crop, places = Crop(world, CropBox(0, 0, 2, 2)), np.arange(2, dtype=np.int32)
    for runs, counts in growing_counts(crop.world(), rule, 1, runs=1):
        answer = forecast_of(ForecastRequest(crop, rule, 1, 1), world.walls, counts, runs)
    mean_levels(answer.levels, places, places, np.zeros((1, 1), np.uint8))
    lay_heat(answer.levels, covers_of(*cover(rgb)), places, places, np.zeros((2, 2), np.uint32), 0, 0)


def _kind_of(rule):
    if not rule.codes.is_sand:
        return f"the rule of {rule.definition.title}"
    if all(p == 1.0 for p in rule.probabilities):
        return "sand that always moves"
    if all(p == 1.0 for p in rule.probabilities[2:]):
        return "sand that topples by chance"
    return "sand with seven probabilities"
