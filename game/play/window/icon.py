"""The icon: a half-empty hourglass, drawn from the scene. `python -m game.play.window.icon FILE` writes it."""

import sys

import numpy as np
import pygame

from game.world.files.paths import asset
from game.world.looks.painter import Painter
from game.world.looks.themes import NIGHT
from game.world.looks.view import View
from game.world.sand.advance import advance
from game.world.scenes.scene import load_scene

FILE = asset("icon.png")
SIDE = 256  # pixels
CELLS = 42, 56  # of the lattice: few, so that the glass is still seen at the size of a title bar
RUN = 260  # iterations: about half of the sand has fallen
CELL = 4  # pixels
RADIUS = 48  # of the corners
SMOOTHING = 4  # the corners are drawn this many times larger and shrunk


def load():
    """Return the icon as a surface."""
    return pygame.image.load(FILE)


def draw():
    """Return the icon, drawn anew."""
    scene = load_scene("hourglass", CELLS)
    world = scene.world()
    advance(world, scene.rule, RUN)
    width, height = (CELL * side for side in CELLS)
    pixels = np.zeros((height, width), np.uint32)
    painter = Painter(
        View.fit(scene.shape, 0, 0, width, height),
        NIGHT,
        scene.made_of,
        lambda red, green, blue: red | green << 8 | blue << 16,
    )
    painter.draw(world, pixels)
    glass = pygame.image.frombuffer(pixels, (width, height), "RGBX")
    glass = glass.subsurface(glass.get_rect().inflate(-2 * CELL, -2 * CELL))  # the lattice's edge is shaded
    icon = _plate(tuple(int(part) for part in NIGHT.mean(0, scene.made_of)))
    icon.blit(glass, glass.get_rect(center=(SIDE // 2, SIDE // 2)))
    return icon


def _plate(colour):
    """Return a square with round corners."""
    big = pygame.Surface((SIDE * SMOOTHING,) * 2, pygame.SRCALPHA, 32)
    big.fill((*colour, 0))
    pygame.draw.rect(big, colour, big.get_rect(), border_radius=RADIUS * SMOOTHING)
    return pygame.transform.smoothscale(big, (SIDE, SIDE))


if __name__ == "__main__":
    pygame.image.save(draw(), sys.argv[1] if len(sys.argv) > 1 else FILE)
