"""Light: colours as amounts of light, which mix as the eye does where many cells share a pixel."""

import numpy as np

from game.core.draw.cells import AIR, GLEAM, GRAIN, INSIDE, POST, SURFACE, WALL, WOOD, dyed
from game.core.draw.downscaled import LIGHTS
from game.core.draw.motion_blur import SAMPLES


def linear(values):
    """Return the light of sRGB components in 0 … 1: (…) float64 in 0 … 1. Source: IEC 61966-2-1."""
    values = np.asarray(values, float)
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def lights(palette):
    """Return the light of air, then what each kind of cell that core.density_pixels counts adds to it, in three parts.

    The parts are (1 + KINDS, 3), (DECOR_KINDS, 3) and (DYES, 3) float64 in levels of light, as they are counted always,
    in decorated lattices and where sand has colours. palette: (DYED_LOOKS, shades) 0xRRGGBB.
    """
    look = linear(_components(palette) / 255).mean(axis=1) * (LIGHTS - 1)
    air, grains = look[AIR], look[dyed(GRAIN)]
    plain = [air, grains[0] - air, look[dyed(SURFACE)[0]] - grains[0], look[WALL] - air]
    decor = [look[WOOD] - look[WALL], look[INSIDE] - air, look[GLEAM] - air, look[POST] - air]
    return np.stack(plain), np.stack(decor), grains[1:] - grains[0]


def _components(palette):
    return np.stack([palette >> 16 & 255, palette >> 8 & 255, palette & 255], axis=-1)


def blends(palette, channels, stream):
    """Return what cells look like that held sand in some of the samples, pixel values: (dyes, SAMPLES - 1, 4, shades).

    palette: (DYED_LOOKS, shades) 0xRRGGBB. channels: those of the pixels. stream: the look of sand that falls. Before a
    darker ground light is mixed; before a brighter one sRGB values are, or thin streams would be lost in its glare. See
    `core.streams`.
    """
    values = _components(palette) / 255
    grounds, sand = values[[AIR, INSIDE, GLEAM, POST]], values[dyed(stream)][:, None, None]
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
