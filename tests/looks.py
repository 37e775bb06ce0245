"""What every cell looks like: the plain twin of the drawing."""

import numpy as np

from game import World
from game.core.draw import glass_decor
from game.core.draw import looks as cells
from game.world.sand.material_codes import MaterialCodes


def looks_of(sand, walls, places=None):
    """Return the (H, W) looks of cells; places: (H, W) what decorates them, or None."""
    height, width = sand.shape

    def is_wall(y, x):
        return y >= 0 and (y >= height or not 0 <= x < width or walls[y, x])

    def is_covered(y, x):
        return y >= 0 and (sand[y, x] or walls[y, x])

    def look(y, x):
        left, right, above, below = (is_wall(*at) for at in ((y, x - 1), (y, x + 1), (y - 1, x), (y + 1, x)))
        place = glass_decor.FREE if places is None else places[y, x]
        if walls[y, x]:
            body, rim, edge = (cells.WALL, cells.RIM, cells.EDGE)
            if place == glass_decor.WOOD:
                body, rim, edge = (cells.WOOD, cells.WOOD_RIM, cells.WOOD_EDGE)
            return body if left and above and right and below else rim if not (left and above) else edge
        if sand[y, x]:
            if not is_covered(y - 1, x):
                return cells.SURFACE
            if left or right or above:
                return cells.GRAIN_BY_WALL
            return cells.GRAIN if is_covered(y - 2, x) else cells.UNDER
        if place >= glass_decor.GLEAM:
            return cells.GLEAM if place == glass_decor.GLEAM else cells.POST
        by_wall = left or right or above or below
        if place == glass_decor.INSIDE:
            return cells.INSIDE_BY_WALL if by_wall else cells.INSIDE
        return cells.AIR_BY_WALL if by_wall else cells.AIR

    return np.array([[look(y, x) for x in range(width)] for y in range(height)])


def packed_world(codes, substances):
    """Return a World of (H, W) uint8 codes that Substances tell the looks of."""
    names = [f"material {code}" for code in range(2**substances.bits)]
    names[substances.outside] = "wall"
    return World.of_codes(codes, MaterialCodes(tuple(names)))


def general_looks(codes, substances, places=None):
    """Return the (H, W) numbers of the looks of cells of any Substances; places: as for `looks_of`."""
    height, width = codes.shape
    by_code = {code: each for each in substances.all for code in each.codes}
    numbers = {each: number for number, each in enumerate(cells.looks_of(substances))}

    def kind(y, x):
        if y < 0:
            return "air"
        code = codes[y, x] if y < height and 0 <= x < width else substances.outside
        return by_code[code].kind if code else "air"

    def look(y, x):
        left, right, above, below = (kind(*at) for at in ((y, x - 1), (y, x + 1), (y - 1, x), (y + 1, x)))
        place, own = glass_decor.FREE if places is None else places[y, x], by_code.get(codes[y, x])
        bare = above in ("air", "gas")
        beside = "solid" in (left, right, above)
        if own is None:
            if place >= glass_decor.GLEAM:
                return cells.Look(cells.GLEAM if place == glass_decor.GLEAM else cells.POST)
            shades = (cells.AIR, cells.AIR_BY_WALL), (cells.INSIDE, cells.INSIDE_BY_WALL)
            return cells.Look(shades[int(place == glass_decor.INSIDE)][beside or below == "solid"])
        if own.kind == "gas":
            return cells.Look(cells.GAS_INSIDE if place == glass_decor.INSIDE else cells.GAS, own)
        if own.kind == "liquid":
            return cells.Look(cells.LIQUID_SURFACE if bare else cells.LIQUID, own)
        if own.kind == "solid":
            part = 1 if not left == above == "solid" else 2 if not right == below == "solid" else 0
            if place == glass_decor.WOOD and codes[y, x] == substances.outside:
                return cells.Look((cells.WOOD, cells.WOOD_RIM, cells.WOOD_EDGE)[part])
            return cells.Look((cells.WALL, cells.RIM, cells.EDGE)[part], own)
        if bare:
            return cells.Look(cells.SURFACE, own)
        if beside:
            return cells.Look(cells.GRAIN_BY_WALL, own)
        under = above == "powder" and kind(y - 2, x) in ("air", "gas")
        return cells.Look(cells.UNDER if under else cells.GRAIN, own)

    return np.array([[numbers[look(y, x)] for x in range(width)] for y in range(height)])
