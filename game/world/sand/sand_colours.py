"""Dyes: the names of the colours that sand can have, and how they look in a picture file."""

import numpy as np

DYED = {  # RGB in a picture file; the window has colours of its own for each theme
    "amber": (222, 170, 84),
    "terracotta": (199, 106, 82),
    "rose": (244, 180, 198),
    "plum": (129, 87, 140),
    "indigo": (99, 119, 198),
    "teal": (99, 180, 155),
    "moss": (168, 192, 138),
    "ivory": (240, 229, 203),
}
COLOURS = tuple(DYED)  # a colour's number is its place here; the first is that of sand that was given none
AMBER = COLOURS[0]
RAINBOW = "rainbow"  # stripes of all of them
DYES = (*COLOURS, RAINBOW)  # what sand can be painted with

# From linear light to the responses of the eye's cones, and from their cube roots to Oklab (Ottosson 2020).
_CONES = np.array(
    [[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566],
     [0.0883024619, 0.2817188376, 0.6299787005]], np.float32
)  # fmt: skip
_OKLAB = np.array(
    [[0.2104542553, 0.7936177850, -0.0040720468], [1.9779984951, -2.4285922050, 0.4505937099],
     [0.0259040371, 0.7827717662, -0.8086757660]], np.float32
)  # fmt: skip


def nearest_dyes(pixels):
    """Return the number of the dye that looks most like each pixel, (H, W) uint8, from (H, W, 3) uint8 of sRGB.

    Alike is what lies near in Oklab, where distances are about as large as they look.
    """
    dyes = _oklab(np.array(list(DYED.values()), np.uint8))
    found = np.empty(pixels.shape[:2], np.uint8)
    for row, line in enumerate(_oklab(pixels)):
        found[row] = ((line[:, None] - dyes) ** 2).sum(axis=-1).argmin(axis=-1)
    return found


def _oklab(colours):
    parts = np.arange(256, dtype=np.float32) / 255
    light = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4).astype(np.float32)
    return np.cbrt(light[colours] @ _CONES.T) @ _OKLAB.T
