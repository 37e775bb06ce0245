"""The view of the sand: the outermost cells lie inside the lattice's box, with nothing of them beside it."""

from itertools import product

import numpy as np
import pygame

from game.world.looks.themes import THEMES
from game.world.looks.view import View
from game.world.sessions.action import Draw
from tests.play.player import Player
from tests.sweeps import sweep

ALL = (0.5, 0.5), (119.5, 89.5)  # from the first cell to the last


def shown(player):
    player.parts.display.refresh()
    player.frame(elapsed_ns=0)
    return pygame.surfarray.array2d(player.parts.window.surface).T


@sweep(("pixels", "theme"), product([1, 3.5, 10], THEMES), keep=[(1, "night"), (3.5, "day"), (10, "high-contrast")])
def test_the_outermost_cells_fill_their_box_and_nothing_of_them_lies_beside_it(theme, pixels):
    player = Player()
    player.parts.settings.override("theme", theme)
    player.hold_time()
    pygame.display.set_mode((1600, 1000), pygame.RESIZABLE, 32)
    player.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=1600, y=1000), elapsed_ns=0)
    view, area = player.parts.display.sand_view, player.parts.display.layout.sand
    view.show(View.near(view.view.shape, area, pixels, (60, 45), *area.center))
    empty, box = shown(player), pygame.Rect(*view.view.pixel(0, 0), 120 * pixels, 90 * pixels)
    assert area.contains(box)
    for material in ("sand", "wall"):
        player.parts.sessions.do(Draw("rectangle", material, *ALL, 0, True))
        differs = (
            shown(player)[area.top : area.bottom, area.left : area.right]
            != empty[area.top : area.bottom, area.left : area.right]
        )
        rows, columns = np.nonzero(differs)
        found = pygame.Rect(columns.min(), rows.min(), np.ptp(columns) + 1, np.ptp(rows) + 1).move(area.topleft)
        assert found == box and differs.sum() == box.width * box.height
