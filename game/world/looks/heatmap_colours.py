"""The colours of heat: a scale that anyone can read, from dark violet to pale green, and how it covers the sand.

Lightness rises by equal steps of what the eye tells apart, so the order of the colours is seen without their hue, by
colour-blind eyes and in print. Made in Oklab (Björn Ottosson, "A perceptual color space for image processing", 2020).
"""

from functools import cache

import numpy as np

from game.core.draw.heatmap import ALWAYS, LEVELS, NEVER, SOLID
from game.world.looks.themes import rgb

LIGHTNESS = 0.2, 0.86  # of the rarest and of the surest, in Oklab
HUE = 300.0, 165.0  # degrees in Oklab, violet to green: far from the sand's amber
CHROMA = 0.1  # at its most, halfway; more does not fit the screen's colours
KEPT = 0.45, 0.12  # the part of the sand's own colour that shows where it will never be, and where it will
STALE_KEPT = 0.45, 0.35
STALE_CHROMA = 0.0  # a stale forecast is grey

_TO_CONE = np.array(
    [[1, 0.3963377774, 0.2158037573], [1, -0.1055613458, -0.0638541728], [1, -0.0894841775, -1.2914855480]]
)
_TO_RGB = np.array(
    [
        [4.0767416621, -3.3077115913, 0.2309699292],
        [-1.2684380046, 2.6097574011, -0.3413193965],
        [-0.0041960863, -0.7034186147, 1.7076147010],
    ]
)


@cache
def scale(stale=False):
    """Return the (LEVELS, 3) uint8 colours of the levels from NEVER to ALWAYS, as red, green, blue."""
    share = np.minimum(np.arange(LEVELS) / ALWAYS, 1.0)
    light, hue = (low + (high - low) * share for low, high in (LIGHTNESS, np.radians(HUE)))
    chroma = (STALE_CHROMA if stale else CHROMA) * np.sin(np.pi * (0.12 + 0.7 * share))
    cones = np.stack([light, chroma * np.cos(hue), chroma * np.sin(hue)], axis=1) @ _TO_CONE.T
    linear = np.clip(cones**3 @ _TO_RGB.T, 0.0, 1.0)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.rint(255 * encoded).astype(np.uint8)


def cover(map_rgb, stale=False):
    """Return (kept, laid), both (LEVELS,) uint32, as `core.heat.lay_heat` takes them; map_rgb: see `palette`."""
    share = np.minimum(np.arange(LEVELS) / ALWAYS, 1.0)
    rarely, surely = STALE_KEPT if stale else KEPT
    kept = np.rint(256 * (surely + (rarely - surely) * (1.0 - share) ** 6)).astype(np.uint32)
    kept[NEVER], kept[SOLID] = round(256 * rarely), 256
    laid = scale(stale).astype(np.uint32) * (256 - kept)[:, None] >> np.uint32(8)
    laid[NEVER] = laid[SOLID] = 0
    return kept, np.array([map_rgb(*colour) for colour in laid.tolist()], np.uint32)


def over(colour, stale=False):
    """Return the (LEVELS, 3) uint8 colours that the levels make of a pixel of a colour (red, green, blue)."""
    kept, laid = cover(rgb, stale)
    parts = laid[:, None] >> np.array([16, 8, 0], np.uint32) & np.uint32(255)
    return ((np.array(colour, np.uint32) * kept[:, None] >> np.uint32(8)) + parts).astype(np.uint8)
