"""A scene's picture: its cells as the window shows them, in any size."""

import numpy as np
import pygame

from game.world.looks import painter
from game.world.looks.themes import substances_of
from game.world.looks.view import View


def picture_of(scene, size, colours):
    """Return (size, RGB bytes) of a Scene as large as fits `size`, in the colours of a theme."""
    view = View.fit(scene.shape, 0, 0, *size)
    pixels = np.zeros((view.top * 2 + view.height, view.left * 2 + view.width), np.uint32)
    substances = substances_of(scene.rule.definition.materials)
    painter.Painter(view, colours, scene.made_of, substances=substances).draw(scene.world(), pixels)
    part = np.ascontiguousarray(pixels[view.top : view.top + view.height, view.left : view.left + view.width])
    return part.shape[::-1], part.view(np.uint8).reshape(*part.shape, 4)[..., 2::-1].tobytes()


def sprite_of(scene, size, colours):
    """Return a Scene as a surface that fits `size`."""
    fitting, data = picture_of(scene, size, colours)
    return pygame.image.frombytes(data, fitting, "RGB")
