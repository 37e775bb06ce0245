"""Themes: which colours the window and the sand have, as values. No window is needed."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.core.draw.cells import SHADES
from game.core.draw.looks import (
    AIR,
    AIR_BY_WALL,
    DYES,
    EDGE,
    GAS,
    GAS_INSIDE,
    GLEAM,
    GRAIN,
    GRAIN_BY_WALL,
    INSIDE,
    INSIDE_BY_WALL,
    LIQUID,
    LIQUID_SURFACE,
    MOST_LOOKS,
    POST,
    RIM,
    SAND,
    SHAPES,
    SURFACE,
    UNDER,
    WALL,
    WOOD,
    WOOD_EDGE,
    WOOD_RIM,
    Substance,
    Substances,
    dyed,
    looks_of,
    sand_of,
)

LIGHT = {  # by what the darkest and the lightest shade of a material differ from its mean
    GRAIN: (-0.06, 0.07),
    SURFACE: (0.32, 0.44),
    UNDER: (0.12, 0.2),
    GRAIN_BY_WALL: (-0.2, -0.11),
    WALL: (-0.06, 0.07),
    RIM: (0.28, 0.28),
    EDGE: (-0.28, -0.28),
    LIQUID: (-0.03, 0.03),
    LIQUID_SURFACE: (0.3, 0.34),
}
GLOWING = (-0.12, 0.3)  # as in LIGHT: of what glows
APART, MOVED = 40, 0.2  # channels of colours nearer than that are moved, by that part
GAS_COVERS = 0.6  # how much of what is behind it a gas hides
CLEAR_COVERS = 0.74, 0.88  # … and what else is translucent, where it is darkest and where it is lightest
WALL_LOOKS = ("stone", "glass", "wood")  # what a scene's walls can be made of; in glass its long level runs are wooden


class Range(NamedTuple):
    """The darkest and the lightest shade of a look, as RGB in 0 … 255."""

    dark: tuple
    light: tuple


class Walls(NamedTuple):
    """The look of one kind of walls."""

    body: Range
    rim: Range  # where light falls on it
    edge: Range  # where none does


class Colours(NamedTuple):
    """The colours of a theme, RGB in 0 … 255."""

    name: str
    ground: tuple  # around the lattice
    air: dict  # {look: Range} of what is neither sand nor wall
    sand: dict  # {look: Range}
    stream: int  # the look of falling sand: it must stand out against the air, even where it is thin
    walls: dict  # {one of WALL_LOOKS: Walls}
    panel: dict  # {role: RGB} of the controls and the words
    glow: float  # how strong the light of fire is, 0 … 1
    dyes: tuple  # the mean colours of dyed sand, in the order of `sand_colours.COLOURS` without the first

    def __hash__(self):
        return hash(self.name)

    def looks(self, walls="stone"):
        """Return {look: Range} of all looks in a scene whose walls are made of `walls`."""
        made_of, wood = self.walls[walls], self.walls["wood"]
        return {
            **self.air,
            **self.sand,
            **dict(zip((WALL, RIM, EDGE), made_of, strict=True)),
            **dict(zip((WOOD, WOOD_RIM, WOOD_EDGE), wood, strict=True)),
        }

    def mean(self, look, walls="stone"):
        """Return the mean colour of a look, RGB as floats: what many cells of it look like from afar."""
        dark, light = self.looks(walls)[look]
        return tuple((d + bright) / 2 for d, bright in zip(dark, light, strict=True))

    def dye(self, number):
        """Return {look: Range} of sand of a colour, by its number: what its mean makes of amber's light and shadow."""
        if number == 0:
            return self.sand
        return {look: _material(self.dyes[number - 1], look) for look in self.sand}

    def seen(self, look, walls):
        """Return the Range of a Look in a scene whose walls are made of `walls`."""
        if look.substance is None or look.substance.colour is None:
            return self.looks(walls)[look.shape]
        if look.substance.glows:
            return Range(*(_lit(look.substance.colour, by) for by in GLOWING))
        if look.substance.translucent and look.shape not in (GAS, GAS_INSIDE):
            return self._translucent(look)
        if look.shape not in (GAS, GAS_INSIDE):
            return _material(self.apart(look.substance.colour), look.shape)
        behind = self.air[AIR if look.shape == GAS else INSIDE]
        return Range(*(_mixed(look.substance.colour, each, GAS_COVERS) for each in behind))

    def apart(self, colour):
        """Return a colour that can be told from the air: one too near to it is moved from it, darker or lighter."""
        air = self.air[AIR].dark
        if max(abs(part - other) for part, other in zip(colour, air, strict=True)) >= APART:
            return colour
        return _lit(colour, -MOVED if sum(air) > 3 * 128 else MOVED)

    def _translucent(self, look):
        """Return the Range of a Look of what is translucent: less of what is behind shows where light falls on it."""
        air = self.air[AIR].dark
        colour = self.apart(look.substance.colour)
        if look.shape in (SURFACE, RIM, LIQUID_SURFACE):
            return _material(colour, look.shape)
        ends = zip(_material(colour, look.shape), CLEAR_COVERS, strict=True)
        return Range(*(_mixed(each, air, covers) for each, covers in ends))

    @lru_cache(maxsize=64)  # noqa: B019 - the themes live as long as the program
    def swatch(self, number):
        """Return the RGB that stands for sand of a colour, by its number."""
        return tuple(map(round, self.mean_of(number, GRAIN)))

    def mean_of(self, number, look):
        """Return the mean colour of a look of sand of a colour, RGB as floats."""
        return tuple((dark + light) / 2 for dark, light in zip(*self.dye(number)[look], strict=True))


@lru_cache(maxsize=32)
def substances_of(materials):
    """Return the Substances of a rule's materials, by code: each has a name, a kind (its class) and a colour.

    Sand and wall look as the theme says, others by the rule's colours.
    """
    codes = {}
    for code, each in enumerate(materials):
        if each.kind != "empty":
            alike = (
                each.kind,
                None if each.name in ("sand", "wall") else tuple(each.colour),
                each.glows,
                each.translucent,
            )
            codes.setdefault(alike, []).append(code)
    outside = next(code for code, each in enumerate(materials) if each.name == "wall")
    every = tuple(Substance(kind, tuple(numbers), *seen) for (kind, *seen), numbers in codes.items())
    return Substances(every, max(2, (len(materials) - 1).bit_length()), outside)


def _material(colour, shape):
    return Range(*(_lit(colour, by) for by in LIGHT[shape]))


def _lit(colour, by):
    """Return a colour made darker by a part of it (below 0), or by so much nearer to white."""
    return tuple(round(part + (by * (255 - part) if by > 0 else by * part)) for part in colour)


def _mixed(colour, behind, share):
    return tuple(round(share * part + (1 - share) * other) for part, other in zip(colour, behind, strict=True))


def rgb(red, green, blue):
    """Return the pixel value 0xRRGGBB."""
    return red << 16 | green << 8 | blue


def palette(colours, walls="stone", map_rgb=rgb, substances=SAND):
    """Return the (MOST_LOOKS, SHADES) uint32 pixel values of the looks of a world, black where there is none.

    map_rgb: turns red, green, blue in 0 … 255 into a pixel value; it is asked for one after the other.
    """
    ranges = {number: colours.seen(look, walls) for number, look in enumerate(looks_of(substances))}
    if sand_of(substances):
        ranges |= {dyed(look)[dye]: colours.dye(dye)[look] for dye in range(DYES) for look in SHAPES["powder"]}
    black = _flat(0, 0, 0)
    return np.array([_shades(*ranges.get(number, black), map_rgb) for number in range(MOST_LOOKS)], np.uint32)


def _shades(dark, light, map_rgb):
    """Return SHADES pixel values from dark to light."""
    parts = [[d + (b - d) * shade // (SHADES - 1) for d, b in zip(dark, light, strict=True)] for shade in range(SHADES)]
    return [map_rgb(*each) for each in parts]


def _flat(*colour):
    return Range(colour, colour)


NIGHT = Colours(
    name="night",
    ground=(24, 21, 18),
    air={
        AIR: _flat(34, 30, 26),
        AIR_BY_WALL: _flat(26, 23, 20),
        INSIDE: _flat(40, 39, 37),
        INSIDE_BY_WALL: _flat(31, 31, 30),
        GLEAM: _flat(53, 55, 56),
        POST: Range((70, 45, 31), (78, 51, 35)),
    },
    sand={
        GRAIN: Range((194, 140, 62), (222, 171, 88)),
        SURFACE: Range((246, 206, 126), (255, 226, 154)),
        UNDER: Range((220, 168, 86), (238, 194, 110)),
        GRAIN_BY_WALL: Range((168, 118, 49), (190, 138, 64)),
    },
    stream=SURFACE,
    walls={
        "stone": Walls(Range((92, 97, 98), (104, 109, 110)), _flat(130, 136, 137), _flat(70, 74, 75)),
        "glass": Walls(_flat(74, 86, 90), _flat(128, 150, 155), _flat(100, 119, 124)),
        "wood": Walls(Range((96, 59, 39), (110, 69, 46)), _flat(136, 90, 62), _flat(74, 46, 31)),
    },
    # kept darker than the sand, which is to be the brightest thing on the screen
    panel={
        "ground": (38, 34, 30),
        "raised": (60, 54, 47),
        "hover": (70, 63, 55),
        "pressed": (50, 45, 39),
        "groove": (68, 61, 54),
        "sunken": (29, 26, 23),
        "edge": (92, 83, 72),
        "text": (228, 219, 203),
        "dim": (188, 177, 161),
        "faint": (182, 171, 156),
        "accent": (210, 156, 68),
        "bright accent": (228, 178, 92),
        "handle": (240, 216, 164),
        "bright handle": (252, 236, 200),
        "stone": (112, 103, 92),
        "ring": (116, 172, 220),
    },
    glow=0.45,
    dyes=(
        (199, 106, 82),
        (244, 180, 198),
        (129, 87, 140),
        (99, 119, 198),
        (99, 180, 155),
        (168, 192, 138),
        (240, 229, 203),
    ),
)

DAY = Colours(
    name="day",
    ground=(222, 214, 200),
    air={
        AIR: _flat(239, 233, 221),
        AIR_BY_WALL: _flat(222, 214, 200),
        INSIDE: _flat(246, 243, 236),
        INSIDE_BY_WALL: _flat(226, 223, 216),
        GLEAM: _flat(255, 255, 253),
        POST: Range((158, 126, 102), (166, 133, 108)),
    },
    sand={
        GRAIN: Range((190, 118, 30), (214, 144, 52)),
        SURFACE: Range((232, 166, 66), (243, 184, 88)),
        UNDER: Range((212, 142, 48), (228, 160, 66)),
        GRAIN_BY_WALL: Range((166, 102, 24), (186, 120, 40)),
    },
    stream=GRAIN_BY_WALL,
    walls={
        "stone": Walls(Range((112, 116, 118), (122, 126, 128)), _flat(150, 154, 156), _flat(84, 88, 90)),
        "glass": Walls(_flat(178, 200, 206), _flat(104, 136, 146), _flat(134, 162, 170)),
        "wood": Walls(Range((98, 61, 38), (110, 70, 45)), _flat(130, 86, 58), _flat(70, 42, 25)),
    },
    panel={
        "ground": (243, 238, 229),
        "raised": (226, 218, 204),
        "hover": (214, 204, 188),
        "pressed": (234, 228, 216),
        "groove": (208, 198, 182),
        "sunken": (252, 249, 243),
        "edge": (168, 156, 138),
        "text": (48, 42, 35),
        "dim": (86, 77, 66),
        "faint": (92, 82, 70),
        "accent": (140, 80, 8),
        "bright accent": (124, 68, 2),
        "handle": (108, 60, 4),
        "bright handle": (92, 52, 4),
        "stone": (132, 122, 108),
        "ring": (24, 102, 176),
    },
    glow=0.35,
    dyes=(
        (141, 57, 12),
        (230, 153, 149),
        (102, 23, 93),
        (55, 73, 148),
        (12, 153, 181),
        (117, 120, 41),
        (229, 200, 142),
    ),
)

HIGH_CONTRAST = Colours(
    name="high-contrast",
    ground=(0, 0, 0),
    air={
        AIR: _flat(0, 0, 0),
        AIR_BY_WALL: _flat(0, 0, 0),
        INSIDE: _flat(10, 12, 20),
        INSIDE_BY_WALL: _flat(0, 0, 0),
        GLEAM: _flat(38, 44, 58),
        POST: _flat(88, 52, 28),
    },
    sand={
        GRAIN: Range((240, 178, 40), (255, 200, 70)),
        SURFACE: _flat(255, 240, 170),
        UNDER: Range((250, 205, 80), (255, 220, 110)),
        GRAIN_BY_WALL: Range((214, 146, 20), (230, 164, 34)),
    },
    stream=SURFACE,
    walls={
        "stone": Walls(_flat(112, 124, 148), _flat(186, 198, 222), _flat(84, 94, 116)),
        "glass": Walls(_flat(48, 82, 120), _flat(170, 214, 255), _flat(108, 160, 216)),
        "wood": Walls(_flat(136, 84, 48), _flat(176, 112, 74), _flat(96, 58, 32)),
    },
    panel={
        "ground": (0, 0, 0),
        "raised": (34, 34, 34),
        "hover": (62, 62, 62),
        "pressed": (20, 20, 20),
        "groove": (70, 70, 70),
        "sunken": (12, 12, 12),
        "edge": (190, 190, 190),
        "text": (255, 255, 255),
        "dim": (224, 224, 224),
        "faint": (200, 200, 200),
        "accent": (255, 190, 50),
        "bright accent": (255, 214, 110),
        "handle": (255, 236, 180),
        "bright handle": (255, 255, 255),
        "stone": (140, 150, 170),
        "ring": (90, 200, 255),
    },
    glow=0.0,
    dyes=(
        (185, 71, 92),
        (252, 138, 149),
        (151, 80, 172),
        (117, 124, 237),
        (98, 207, 185),
        (147, 171, 83),
        (255, 250, 235),
    ),
)

THEMES = {colours.name: colours for colours in (NIGHT, DAY, HIGH_CONTRAST)}
