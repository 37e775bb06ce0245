"""Pictures of worlds and scenes as the window shows them, in any size."""

import numpy as np
import pygame

from game.world.looks import painter
from game.world.looks.themes import substances_of
from game.world.looks.view import View


def pixels_of(world, rule, walls, colours, size=None):
    """Return (h, w, 3) uint8 of a world of a rule with walls made of `walls`, in the colours of a theme.

    It is as large as fits `size` (width, height), or with a pixel to a cell.
    """
    view = View.fit(world.shape, 0, 0, *(size or world.shape[::-1]))
    pixels = np.zeros((view.top * 2 + view.height, view.left * 2 + view.width), np.uint32)
    substances = substances_of(rule.definition.materials)
    painter.Painter(view, colours, walls, substances=substances).draw(world, pixels)
    part = np.ascontiguousarray(pixels[view.top : view.top + view.height, view.left : view.left + view.width])
    return part.view(np.uint8).reshape(*part.shape, 4)[..., 2::-1]


def picture_of(scene, size, colours):
    """Return (size, RGB bytes) of a Scene as large as fits `size`, in the colours of a theme."""
    pixels = pixels_of(scene.world(), scene.rule, scene.made_of, colours, size)
    return pixels.shape[1::-1], pixels.tobytes()


def sprite_of(scene, size, colours):
    """Return a Scene as a surface that fits `size`."""
    fitting, data = picture_of(scene, size, colours)
    return pygame.image.frombytes(data, fitting, "RGB")
