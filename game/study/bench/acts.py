"""What is done to a world besides moving it, and what one use of each costs."""

import numpy as np

from game.core.draw.looks import AIR, AIR_BY_WALL, EDGE, GRAIN, GRAIN_BY_WALL, RIM, SURFACE, UNDER, WALL
from game.study.bench import worlds
from game.study.bench.checks import WrongCellsError, same_as_twin
from game.study.bench.rounds import MILLISECONDS, Workload, ours, take_turns
from game.study.report import table
from game.study.report.report import Section
from game.study.report.table import Column, Table
from game.world.looks.painter import Painter, texture
from game.world.looks.themes import NIGHT, palette
from game.world.looks.view import View
from game.world.sessions.action import Paint, apply

COLUMNS = (
    Column("name", "act"),
    Column("time", "ms", MILLISECONDS),
    Column("iterations", "iterations' worth", table.three_digits),
    Column("when", "when"),
)
ITERATION = "one iteration"
BRUSH = 6  # cells: the default brush
STROKE = 20.0  # cells: a brisk move of the mouse in one frame


def act_table(plan):
    """Return the time of each act on an hourglass in mid-flow."""
    size = plan.scene_size
    world = worlds.flowing(size)
    same_as_twin(world, worlds.GLASS_RULE, plan.checked)
    acts = _acts(world)
    _check(world)
    workloads = [Workload(name, act, world.copy) for name, (_, act) in acts.items()]
    found = take_turns([ours(ITERATION, world, worlds.GLASS_RULE, plan.batch), *workloads], plan.rounds, plan.sample_ns)
    rows = [
        {
            "name": name,
            "time": found[name],
            "iterations": found[name].times(found[ITERATION]),
            "when": acts[name][0] if name in acts else "of the scene's rule, in a batch",
        }
        for name in found
    ]
    notes = [
        f"On the hourglass in mid-flow, {table.size(size)} cells. Checked beforehand: pixels, grains, flip and copy "
        "are those of plain numpy on the cells."
    ]
    return Section("acts", "3c · What a scene needs: the cost of each act", [Table("", COLUMNS, rows), *notes])


def _acts(world):
    """Return {name: (when it is done, act on a world)}."""
    height, width = world.shape
    painter, pixels = _painter(world), np.zeros((height, width), np.uint32)
    start = (width / 2, height / 4)
    stroke = Paint("sand", start, (start[0] + STROKE, start[1]), BRUSH)
    return {
        "draw every cell as a pixel": (
            "a frame after sand moved everywhere",
            lambda state: painter.draw(state, pixels),
        ),
        f"stroke of the brush, {BRUSH} cells wide": (
            "each frame while painting",
            lambda state: apply(stroke, state, worlds.GLASS_RULE),
        ),
        "count the grains": ("four times a second", lambda state: state.grains),
        "flip": ("when asked for", lambda state: state.flip()),
        "copy": ("a snapshot", lambda state: state.copy()),
        "digest": ("to compare worlds", lambda state: state.digest()),
    }


def _painter(world):
    height, width = world.shape
    return Painter(View(world.shape, 0, 0, width, height))


def _check(world):
    """Raise WrongCellsError unless the acts agree with plain numpy on the cells."""
    sand, walls = world.sand, world.walls
    pixels = np.zeros(world.shape, np.uint32)
    _painter(world).draw(world, pixels)
    turned = world.copy()
    turned.flip()
    same = {
        "draw": np.array_equal(pixels, _plain_pixels(sand, walls)),
        "grains": world.grains == sand.sum(),
        "flip": np.array_equal(turned.sand, sand[::-1, ::-1]) and np.array_equal(turned.walls, walls[::-1, ::-1]),
        "copy": world.copy().digest() == world.digest(),
    }
    wrong = [name for name, is_same in same.items() if not is_same]
    if wrong:
        raise WrongCellsError(f"{', '.join(wrong)} differs from plain numpy: nothing was timed")


def _plain_pixels(sand, walls):
    """Return what a window at one pixel a cell shows: (H, W) uint32."""
    beyond = np.pad(walls, 1, constant_values=True)
    beyond[0] = False  # light comes in from above
    above, below, left, right = beyond[:-2, 1:-1], beyond[2:, 1:-1], beyond[1:-1, :-2], beyond[1:-1, 2:]
    fallen = np.pad(sand, ((2, 0), (0, 0)))
    covered = fallen[:-2] | np.pad(walls, ((2, 0), (0, 0)))[:-2]
    surface = sand & ~fallen[1:-1] & ~above
    beside = sand & ~surface & (left | right | above)
    rim = walls & ~(left & above)
    kinds = {
        AIR_BY_WALL: ~sand & ~walls & (left | right | above | below),
        SURFACE: surface,
        GRAIN_BY_WALL: beside,
        UNDER: sand & ~beside & fallen[1:-1] & ~covered,
        GRAIN: sand,
        RIM: rim,
        EDGE: walls & ~rim & ~(right & below),
        WALL: walls,
    }
    looks = np.select(list(kinds.values()), list(kinds), AIR)
    shades = texture()
    height, width = sand.shape
    tiles = [-(-side // len(shades)) for side in (height, width)]
    return palette(NIGHT)[looks, np.tile(shades, tiles)[:height, :width]]
