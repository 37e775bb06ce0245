"""A scene: the cells, the rule and the pace that one readable file describes."""

import os
from dataclasses import dataclass, fields, replace
from functools import cache
from pathlib import Path
from weakref import WeakValueDictionary
from zlib import crc32

import numpy as np

from game.world.files.atomic import FileError
from game.world.files.checked_table import as_line, read_table
from game.world.files.paths import asset
from game.world.looks.themes import WALL_LOOKS
from game.world.rules.rule import FIELDS, PROBABILITIES, SCHEDULES, Rule
from game.world.rules.rule_json import read_rule
from game.world.sand import parameters
from game.world.sand.fixtures import DRAIN, TAP
from game.world.sand.material_codes import SAND
from game.world.sand.sand_colours import AMBER
from game.world.sand.world import World, check_codes
from game.world.scenes.cell_arrays import (
    painted_cells,
    palette_of,
    parted,
    resampled,
    told_guesses,
    written_cells,
)
from game.world.scenes.fixture_tables import KEYS as FIXTURE_KEYS
from game.world.scenes.fixture_tables import checked_number, read_fixture
from game.world.scenes.hourglass_spec import Glass
from game.world.scenes.shapes import MOST_WORK, Scale, glass_of, neck_of, paint, read_shapes, work_of

ORDER = (  # as shown; others follow
    *("hourglass", "paper", "funnel", "galton", "sandpile", "ledges", "maze", "tower", "city", "marbles", "delta"),
    *("silo", "clocks", "mixing", "fountain", "rainbow", "dunes", "aquarium", "kitchen", "volcano"),
    *("garden", "forest-fire", "winter-pond", "acid-cave", "steam-engine", "salt-works", "water-clock", "three-sands"),
    *("two-sands", "fullhd", "blank"),
)
SOURCES = ("cells", "picture", "shape")  # where the cells come from: one of these, or none for an empty scene
SIDES = ("width", "height")
CELLS = ("cells", "colours")  # the arrays of a Scene
KEYS = ("title", "notice", "height", "width", *SOURCES, TAP, DRAIN, "walls", "rule", "speed", "cell")

_known = WeakValueDictionary()  # (shape, dtype, checksum): the cells of scenes that are still told of


class SceneError(FileError):
    """What is wrong with a scene file, as one line: FILE: KEY: found X, wanted Y."""


@dataclass(frozen=True, eq=False)
class Scene:
    """What a scene file describes. cells: (H, W) uint8, not writable, codes of the materials of its rule."""

    name: str
    title: str
    notice: str  # what to look out for, in one sentence
    cells: np.ndarray
    rule: Rule
    speed: float  # iterations per second
    cell: int  # pixels across one cell
    neck: int | None = None  # the row in the middle of its glass, if it has one
    made_of: str = WALL_LOOKS[0]  # what the walls look like
    fixtures: tuple = ()  # of Fixture: taps and drains
    colours: np.ndarray | None = None  # of the sand, (H, W) uint8, not writable; None where all of it is amber
    glass: Glass | None = None  # the one hourglass that it is made of, if it is
    problem: str | None = None  # what is odd about the file that it was read from, in one line
    shipped: bool = False  # its file came with the toy, so that name and size are enough to make it again

    def __post_init__(self):
        for name in ("name", "title", "notice"):  # what files are called may hold any sign
            object.__setattr__(self, name, as_line(getattr(self, name)))
        object.__setattr__(self, "cells", _shared(check_codes(self.cells, self.rule.materials)))
        object.__setattr__(self, "colours", _shared(self.colours))

    @property
    def shape(self):
        """The lattice's (height, width) in cells."""
        return self.cells.shape

    @property
    def sand(self):
        """Where sand is in a scene of sand: a new (H, W) bool array."""
        return self.cells == SAND

    @property
    def walls(self):
        """Where walls are: a new (H, W) bool array."""
        return self.cells == self.rule.codes.wall

    @property
    def coloured(self):
        """Whether any of its sand has a colour, or will have one that a tap pours."""
        return self.colours is not None or any(each.colour != AMBER for each in self.fixtures)

    def is_like(self, other):
        """Return whether another scene tells the same, of the same arrays: equal ones are shared."""
        pairs = ((each.name, getattr(self, each.name), getattr(other, each.name)) for each in fields(self))
        return all(mine is its or (name not in CELLS and mine == its) for name, mine, its in pairs)

    def world(self, seed=0):
        """Return a new World with the scene's cells, at iteration 0."""
        world = World.of_codes(self.cells, self.rule.codes, seed, self.colours)
        world.fixtures = self.fixtures
        return world


def _shared(cells):
    """Return equal cells that nobody can write to: those of another scene, if there are any, to take no more memory."""
    if cells is None:
        return None
    if cells.flags.writeable:
        cells = cells.copy()
        cells.flags.writeable = False
    if not cells.flags.c_contiguous:
        return cells
    same = _known.setdefault((cells.shape, cells.dtype.str, crc32(cells)), cells)
    return same if same is cells or np.array_equal(same, cells) else cells


def load_scene(name_or_path, size=None):
    """Return the shipped Scene of that name, or the one in a file (a path, or a name that ends in .toml).

    size: (width, height) in cells, for the same scene on another lattice: shapes are drawn again at that resolution,
    drawn or pictured cells are resampled. Raises SceneError, with one line to show, for whatever is wrong in the file,
    and ValueError for a bad size.
    """
    path = _path(name_or_path)
    try:
        return _scene(path, size)
    except FileError as error:
        raise SceneError(error) from None


def _scene(path, size):
    table = read_table(path)
    table.allow(KEYS)
    rule = read_rule(table, path.parent) or _rule(table.table("rule"))
    palette = palette_of(rule.definition)
    size = size and tuple(parameters.SIDE.check(side) for side in size)
    drawn, problem = _drawn(table, path.parent, palette)
    own = tuple(table.number(each, parameters.SIDE) for each in SIDES) if drawn is None else drawn.shape[::-1]
    scale = Scale(*own, *(size or own), palette)
    if drawn is None:
        numbers, shapes = _painted(table, scale)
    else:
        numbers, shapes = resampled(drawn, scale.height, scale.width), []
    cells, colours = parted(numbers, palette)
    return Scene(
        name=path.stem,
        title=table.line("title", path.stem),
        notice=table.line("notice", ""),
        cells=cells,
        colours=colours,
        rule=rule,
        speed=table.number("speed", parameters.SPEED, parameters.SPEED.default),
        cell=table.number("cell", parameters.CELL, parameters.CELL.default),
        neck=neck_of(shapes, scale),
        glass=glass_of(shapes, scale),
        made_of=table.choice("walls", WALL_LOOKS, WALL_LOOKS[0]),
        fixtures=_fixtures(table, scale),
        problem=problem,
        shipped=path.parent == asset("scenes"),
    )


def scene_names():
    """Return the names of the shipped scenes, the default first."""
    found = sorted(path.stem for path in asset("scenes").glob("*.toml"))
    return tuple(sorted(found, key=lambda name: ORDER.index(name) if name in ORDER else len(ORDER)))


@cache
def scene_title(name):
    """Return the title of a shipped scene without making its cells; its file is read once."""
    path = _path(name)
    return read_table(path).line("title", path.stem)


def _path(name_or_path):
    text = os.fspath(name_or_path)
    if isinstance(name_or_path, os.PathLike) or text.endswith(".toml") or any(sign in text for sign in "/\\"):
        path, known = Path(text), "a scene file"
    else:
        path, known = asset("scenes") / f"{text}.toml", "a scene"
    if "\0" in text or not os.path.lexists(path):
        wanted = f"{known}, or one of {', '.join(scene_names())}"
        raise SceneError(f"{text or repr(text)}: scene: found no such file, wanted {wanted}")
    return path


def _drawn(table, folder, palette):
    """Return the (H, W) uint8 materials that `table` spells cell by cell, in a text or a picture; None for neither.

    With them return what is odd about the picture, in one line, or None.
    """
    sources = [key for key in SOURCES if key in table]
    if len(sources) > 1:
        raise table.error(sources[1], f"it beside {sources[0]}", f"only one of {', '.join(SOURCES)}")
    if sources == ["cells"]:
        drawn = written_cells(table, palette)
        for key, side in zip(SIDES, drawn.shape[::-1], strict=True):
            if table.number(key, parameters.SIDE, side) != side:
                raise table.error(key, table.values[key], f"{side} as in cells, or to leave it out")
        return drawn, None
    if sources == ["picture"]:
        drawn, guessed = painted_cells(table, folder, palette)
        problem = told_guesses(folder / table.values["picture"], guessed, drawn.size)
        height, width = drawn.shape
        width, height = table.number("width", parameters.SIDE, width), table.number("height", parameters.SIDE, height)
        return resampled(drawn, height, width), problem
    return None, None


def _painted(table, scale):
    """Return the (H, W) uint8 materials that the shapes of `table` paint on the lattice of a Scale, and the shapes."""
    shapes, work = [], 0
    for each in table.tables("shape"):
        for shape in read_shapes(each, scale):
            work += work_of(shape, scale)
            if work > MOST_WORK:
                raise each.error("kind", "more to paint", f"shapes that come over {MOST_WORK:,} cells at most in all")
            shapes.append(shape)
    cells = np.zeros((scale.height, scale.width), np.uint8)  # all EMPTY, and memory that is taken as it is painted
    for shape in shapes:
        paint(cells, shape, scale)
    return cells, shapes


def _fixtures(table, scale):
    """Return the taps and drains that `table` describes, on the lattice of a Scale."""
    found = []
    for kind in (TAP, DRAIN):
        for each in table.tables(kind):
            each.allow(FIXTURE_KEYS[kind])
            found.append(read_fixture(each, kind, scale.palette.codes).scaled(scale.x, scale.y))
    return checked_number(found, table, f"{TAP} and {DRAIN}")


def _rule(table):
    """Return the Rule in the table [rule]: p and bias, or the toppling probabilities themselves; the rest as given."""
    table.allow(("p", "bias", *FIELDS))
    schedule = table.choice("schedule", tuple(SCHEDULES), Rule().schedule)
    if "p" in table or "bias" in table:
        for topple in ("topple_left", "topple_right"):
            if topple in table:
                raise table.error(topple, "it beside p or bias", "only one of the two ways")
    p, bias = (table.number(each.name, each, each.default) for each in (parameters.P, parameters.BIAS))
    given = {each.name: table.number(each.name, each) for each in PROBABILITIES if each.name in table}
    return replace(Rule.with_p(p, schedule, bias), **given)
