"""Colours as amounts of light, in which cells that share a pixel mix as the eye mixes them, and in Oklab.

In Oklab distances between colours are about as large as they look. Sources: IEC 61966-2-1 (sRGB); Björn Ottosson, "A
perceptual color space for image processing", 2020 (Oklab).
"""

import numpy as np

from game.core.draw.downscaled import LIGHTS
from game.core.draw.looks import AIR, GLEAM, INSIDE, POST, counted_looks, looks_of
from game.core.draw.motion_blur import SAMPLES

# From light to the responses of the eye's cones, and from their cube roots to Oklab.
_CONES = np.array(
    [[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566],
     [0.0883024619, 0.2817188376, 0.6299787005]]
)  # fmt: skip
_OKLAB = np.array(
    [[0.2104542553, 0.7936177850, -0.0040720468], [1.9779984951, -2.4285922050, 0.4505937099],
     [0.0259040371, 0.7827717662, -0.8086757660]]
)  # fmt: skip


def linear(values):
    """Return the light, in 0 … 1, of an array of sRGB components in 0 … 1."""
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def encoded(light):
    """Return the sRGB components of light: the inverse of `linear`."""
    return np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def oklab(colours):
    """Return (…, 3) float32 in Oklab from (…, 3) uint8 of sRGB."""
    light = linear(np.arange(256, dtype=np.float32) / 255)
    return np.cbrt(light[colours] @ _CONES.T.astype(np.float32)) @ _OKLAB.T.astype(np.float32)


def from_oklab(colours):
    """Return (…, 3) uint8 of sRGB from (…, 3) in Oklab; what no screen shows is clipped."""
    cones = (colours @ np.linalg.inv(_OKLAB).T) ** 3
    return np.rint(255 * encoded(np.clip(cones @ np.linalg.inv(_CONES).T, 0.0, 1.0))).astype(np.uint8)


def lights(palette, substances):
    """Return the light of air, then what each cell that core.draw.downscaled counts adds to it, in three parts.

    The parts are (…, 3) float64 in levels of light: what is counted always, in decorated lattices and where sand has
    colours. palette: (MOST_LOOKS, shades) 0xRRGGBB.
    """
    look = linear(_components(palette) / 255).mean(axis=1) * (LIGHTS - 1)
    numbers = {each: number for number, each in enumerate(looks_of(substances))}
    always, decor, dyes = (
        np.array([look[numbers.get(one, one)] - look[numbers.get(other, other)] for one, other in sorts]).reshape(-1, 3)
        for sorts in counted_looks(substances)
    )
    return np.vstack([look[:1], always]), decor, dyes


def _components(palette):
    return np.stack([palette >> 16 & 255, palette >> 8 & 255, palette & 255], axis=-1)


def blends(palette, channels, streams, grounds=(AIR, INSIDE, GLEAM, POST)):
    """Return what cells look like through which something fell in some samples: (numbers, SAMPLES - 1, 4, shades).

    They are pixel values. palette: (MOST_LOOKS, shades) 0xRRGGBB. channels: those of the pixels. streams: the looks of
    what falls, by number. grounds: the looks of what it falls before. Before a darker ground light is mixed; before a
    brighter one sRGB values are, or thin streams could not be seen against it.
    """
    values = _components(palette) / 255
    grounds, sand = values[list(grounds)], values[list(streams)][:, None, None]
    share = np.arange(1, SAMPLES)[:, None, None, None] / SAMPLES
    mixed_light = (1 - share) * linear(grounds) + share * linear(sand)
    mixed_values = linear((1 - share) * grounds + share * sand)
    is_darker = (grounds.sum(axis=-1) < sand.sum(axis=-1))[..., None]
    levels = np.round(np.where(is_darker, mixed_light, mixed_values) * (LIGHTS - 1)).astype(int)
    return sum(channels[part][levels[..., part]] for part in range(3))


def channels(map_rgb):
    """Return each level of light as red, green and blue part of a pixel value: (3, LIGHTS) uint32."""
    light = np.arange(LIGHTS) / (LIGHTS - 1)
    places = np.searchsorted(linear(np.arange(1, 256) / 255 - 0.5 / 255), light, "right")
    red = [map_rgb(value, 0, 0) for value in range(256)]
    green = [map_rgb(0, value, 0) for value in range(256)]
    blue = [map_rgb(0, 0, value) for value in range(256)]
    return np.array([red, green, blue], np.uint32)[:, places]
