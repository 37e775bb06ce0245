"""Behind a page that leaves the window in sight all goes on, in the shade."""

import pygame
import pytest

from game.play.view.renderer import SHADE
from tests.play.player import Player

SIZE = 1800, 1100


def picture(player):
    """Return a copy of what the window shows."""
    return player.parts.window.front.copy()


def seen_beside(surface):
    """Return the pixels of what no page covers: columns at the left, of the sand, and the right, of the panel."""
    return [pygame.surfarray.array2d(surface.subsurface((x, 0, 60, SIZE[1]))).tolist() for x in (0, SIZE[0] - 60)]


@pytest.fixture(params=["help", "material_page"])
def behind(request):
    """Return a player of the kitchen who has opened a page, and the page."""
    player = Player("kitchen")
    player.resize(SIZE)
    page = getattr(player.parts, request.param)
    page.toggle()
    player.wait(1)
    yield player, page
    pygame.display.quit()


@pytest.mark.parametrize("compared", [False, True])
def test_behind_a_page_the_window_looks_as_without_it_but_darker(behind, compared):
    player, page = behind
    if compared:
        player.parts.comparing.toggle()
    player.pointer = 30, 300
    player.wait(20)
    opened = picture(player)
    player.wait(20)
    player.hold_time()
    player.wait(30)
    shaded = picture(player)
    page.toggle()
    player.pointer = None
    player.wait(2)
    plain = picture(player)
    plain.fill((SHADE,) * 3, special_flags=pygame.BLEND_MULT)
    assert seen_beside(shaded) == seen_beside(plain) != seen_beside(opened)


def test_nothing_is_drawn_behind_a_page_where_nothing_changes(behind):
    player, _ = behind
    player.hold_time()
    player.wait(30)
    assert not player.frame()


def test_a_page_is_whole_after_the_window_has_changed_its_size(behind):
    player, _ = behind
    player.hold_time()
    player.wait(30)
    before = picture(player)
    for size in ((1500, 900), SIZE):
        player.resize(size)
        player.wait(30)
    assert (pygame.surfarray.array2d(picture(player)) == pygame.surfarray.array2d(before)).all()
