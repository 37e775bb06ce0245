"""The colours of a heatmap, from dark violet to pale green, and how they cover the sand.

Lightness rises in equal perceived steps, so the order of the colours can be read without their hue: by colour-blind
people, and in print.
"""

from functools import cache

import numpy as np

from game.core.draw.heatmap import ALWAYS, LEVELS, NEVER, SOLID
from game.core.draw.looks import AIR
from game.world.looks.colour_space import from_oklab
from game.world.looks.themes import rgb

LIGHTNESS = 0.2, 0.86  # of the rarest and of the surest, in Oklab
HUE = 300.0, 165.0  # degrees in Oklab, violet to green: far from the sand's amber
CHROMA = 0.1  # at its most, halfway; more does not fit the screen's colours
KEPT = 0.45, 0.12  # the part of the sand's own colour that shows where it will never be, and where it will
MARK_KEPT = 0.2  # of a cell that is marked
STALE_KEPT = 0.45, 0.35
STALE_CHROMA = 0.0  # a stale forecast is grey


@cache
def scale(stale=False):
    """Return the (LEVELS, 3) uint8 colours of the levels from NEVER to ALWAYS, as red, green, blue."""
    share = np.minimum(np.arange(LEVELS) / ALWAYS, 1.0)
    light, hue = (low + (high - low) * share for low, high in (LIGHTNESS, np.radians(HUE)))
    chroma = (STALE_CHROMA if stale else CHROMA) * np.sin(np.pi * (0.12 + 0.7 * share))
    return from_oklab(np.stack([light, chroma * np.cos(hue), chroma * np.sin(hue)], axis=1))


def cover(map_rgb, stale=False):
    """Return (kept, laid), both (LEVELS,) uint32, as `heatmap.covers_of` takes them; map_rgb: see `palette`."""
    share = np.minimum(np.arange(LEVELS) / ALWAYS, 1.0)
    rarely, surely = STALE_KEPT if stale else KEPT
    kept = np.rint(256 * (surely + (rarely - surely) * (1.0 - share) ** 6)).astype(np.uint32)
    kept[NEVER], kept[SOLID] = round(256 * rarely), 256
    laid = scale(stale).astype(np.uint32) * (256 - kept)[:, None] >> np.uint32(8)
    laid[NEVER] = laid[SOLID] = 0
    return kept, np.array([map_rgb(*colour) for colour in laid.tolist()], np.uint32)


def density_cover(map_rgb):
    """Return (kept, laid) as `cover` does, for a density map: all of a cell but a wall is covered."""
    kept = np.zeros(LEVELS, np.uint32)
    kept[SOLID] = 256
    laid = np.array([map_rgb(*colour) for colour in scale().tolist()], np.uint32)
    laid[SOLID] = 0
    return kept, laid


def mark_cover(map_rgb, colour):
    """Return (kept, laid) as `cover` does, for cells that are marked with a colour, RGB, and others that are not."""
    kept = np.full(LEVELS, round(256 * MARK_KEPT), np.uint32)
    laid = np.full(LEVELS, map_rgb(*(round(part * (1.0 - MARK_KEPT)) for part in colour)), np.uint32)
    kept[NEVER] = kept[SOLID] = 256
    laid[NEVER] = laid[SOLID] = 0
    return kept, laid


def scale_over_air(colours, stale=False):
    """Return the (ALWAYS + 1, 3) uint8 colours of the levels from NEVER to ALWAYS, as they look over a theme's air."""
    kept, laid = (each[: ALWAYS + 1, None] for each in cover(rgb, stale))
    parts = laid >> np.array([16, 8, 0], np.uint32) & np.uint32(255)
    return ((np.array(colours.air[AIR].dark, np.uint32) * kept >> np.uint32(8)) + parts).astype(np.uint8)
