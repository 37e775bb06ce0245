"""Swatches: which colour stands for a material in the panel, on cards and in small pictures."""

from game.play.ui import theme as look
from game.world.sand.material_codes import SAND_NAME, WALL_NAME

WORLDS = 0, 4, 1, 5  # numbers of the colours of sand that stand for worlds side by side
MOST_STRIPES = 3  # in a cell that may hold one of several; with more it may hold nearly anything


def swatch_of(colours, material):
    """Return the colour, a role or RGB, that stands for a Material in a theme's Colours."""
    if material.kind == "empty":
        return look.SUNKEN
    if material.name == WALL_NAME:
        return look.STONE
    return colours.swatch(0) if material.name == SAND_NAME else colours.apart(material.colour)


def swatches_of(colours, materials):
    """Return the colours of all Materials, by code."""
    return tuple(swatch_of(colours, each) for each in materials)


def colours_of_worlds(colours, names):
    """Return {name: RGB} of worlds side by side in a theme's Colours."""
    return {name: colours.swatch(number) for name, number in zip(names, WORLDS, strict=False)}


def striped(picture, swatches):
    """Return (cells before, cells after) of codes with the colours of their stripes in their place."""
    return tuple(tuple(tuple(_stripes(codes, swatches) for codes in row) for row in cells) for cells in picture)


def _stripes(codes, swatches):
    """Return the colours of a cell: of what it may hold; as empty where it mostly is, as stone where all is one."""
    if len(codes) <= MOST_STRIPES:
        return tuple(dict.fromkeys(swatches[code] for code in codes))
    return (swatches[0],) if 0 in codes and len(codes) < len(swatches) else (look.STONE,)
