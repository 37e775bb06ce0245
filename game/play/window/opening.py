"""The opening: how large the window is when it opens for the first time."""

from itertools import takewhile

from game.play.controls import time_bar
from game.play.panel import panel
from game.play.view import status_line
from game.play.window.layout import MARGIN
from game.play.window.window import room_on
from game.world.sand import parameters

SHARE = 0.7  # of the desktop that a window grows to
LARGEST = 2880, 1620  # pixels: drawing many more of them would take a good part of each frame
FINE, FINE_SCALE = 2000, 1.5  # a desktop of so many pixels from top to bottom has small ones: the panel begins larger
LOWEST = 560  # pixels at scale 1: of a window whose panel is still of use


def window_size(scene, cell, theme):
    """Return the (width, height) in pixels of a window that shows `scene` with `cell` pixels to a cell."""
    px = theme.px
    height, width = (side * cell + 2 * px(MARGIN) for side in scene.shape)
    return width + px(panel.WIDTH), max(height + px(time_bar.HEIGHT) + px(status_line.HEIGHT), px(LOWEST))


def first_scale(desktop):
    """Return the size that the panel and its text begin with on a desktop of (width, height) in pixels."""
    return FINE_SCALE if desktop[1] >= FINE else parameters.UI_SCALE.default


def first_size(scene, theme, desktop):
    """Return the size of a window whose cells are as large as suits a desktop of (width, height) in pixels.

    The cells grow from what the scene asks for, in whole pixels. A scene that needs more than there is gets what it
    asks for; Window cuts that.
    """
    room = room_on(desktop)

    def suits(size):
        fits = all(side <= min(*most) for side, *most in zip(size, room, LARGEST, strict=True))
        return fits and size[0] * size[1] <= SHARE * desktop[0] * desktop[1]

    sizes = (window_size(scene, cell, theme) for cell in range(scene.cell, parameters.CELL.high + 1))
    return [window_size(scene, scene.cell, theme), *takewhile(suits, sizes)][-1]
