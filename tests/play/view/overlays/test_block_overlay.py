"""The blocks over the sand: shown where grains are large and time stands still, and gone without a trace."""

import numpy as np
import pygame
import pytest

from game.play.view.overlays.block_overlay import part_in_sight
from game.world.looks.view import View
from game.world.sand.block_events import coming_events
from tests.sweeps import sweep


@pytest.fixture
def close(glass):
    """Return a Player who looks at the hourglass from near by, in mid-flow."""
    glass.wait(30)
    glass.hold_time()
    glass.pointer = glass.pixel(100, 60)
    glass.frame()
    for _ in range(9):
        glass.key(pygame.K_PLUS, "+", pygame.KMOD_LCTRL)
    glass.pointer = None
    glass.frame(elapsed_ns=2 * 10**9)  # the badge goes
    glass.wait(1)
    return glass


def shown(player):
    area = player.parts.display.layout.sand
    return pygame.surfarray.array2d(player.parts.window.surface)[: area.width, : area.height]


def test_they_come_with_a_key_and_go_without_a_trace(close):
    before = shown(close)
    close.key(pygame.K_b, "b")
    assert (shown(close) != before).any() and close.parts.block_overlay.shown
    close.key(pygame.K_b, "b")
    assert (shown(close) == before).all()


def test_they_are_hidden_from_afar_and_while_time_runs(close):
    close.key(pygame.K_b, "b")
    close.session.paused = False
    close.frame()
    assert not close.parts.block_overlay.shown and close.parts.block_overlay.on
    close.hold_time()
    close.key(pygame.K_0, "0")
    assert not close.parts.block_overlay.shown


@sweep(("pixels", "large_enough"), [(7.9, False), (8, True), (10, True)], keep=[(7.9, False), (8, True)])
def test_they_are_shown_in_cells_of_eight_pixels_and_who_is_further_away_is_told(close, pixels, large_enough):
    sand_view = close.parts.display.sand_view
    sand_view.show(View.near(sand_view.view.shape, sand_view.area, pixels, (100, 60), *sand_view.area.center))
    assert sand_view.view.cell == pytest.approx(pixels)
    close.key(pygame.K_b, "b")
    assert close.parts.block_overlay.shown is large_enough
    assert ("Zoom in" in (close.parts.notices.text or "")) is not large_enough


def test_what_is_drawn_piece_by_piece_is_what_is_drawn_at_once(close):
    close.key(pygame.K_b, "b")
    rng = np.random.default_rng(3)
    for number in range(12):
        close.key(pygame.K_PERIOD, ".") if number % 3 else close.click(
            tuple(int(part) for part in rng.integers(50, 500, 2))
        )
        close.pointer = tuple(int(part) for part in rng.integers(0, 550, 2))
        close.frame()
    close.pointer = None
    close.wait(100)
    before = shown(close)
    close.parts.display.sand_view.refresh()
    close.frame()
    assert (shown(close) == before).all()


def test_a_step_leaves_trails_until_something_else_happens(close):
    close.key(pygame.K_b, "b")
    view = close.parts.display.sand_view.view
    coming = coming_events(close.world, close.session.rule, part_in_sight(view))
    close.key(pygame.K_PERIOD, ".")
    blocks = close.parts.block_overlay
    assert len(blocks.trails.rows) + len(blocks.stays.rows) == len(coming.rows) > 0
    close.frame()
    assert blocks.trails is not None
    close.parts.brush.material = "wall"
    close.click((300, 300))
    assert blocks.trails is None
    close.key(pygame.K_PERIOD, ".")
    assert blocks.trails is not None
    close.key(pygame.K_z, "z", pygame.KMOD_LCTRL)
    assert blocks.trails is None
