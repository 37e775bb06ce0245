"""The ruler: angle and distance on the picture, by mouse alone and by keys alone; the sand stays as it is."""

import math

import pygame
import pytest

from tests.play.player import Player

SHIFT = pygame.KMOD_SHIFT


@pytest.fixture
def ruling(player):
    """Return a Player with the ruler in hand, whose time stands still."""
    player.hold_time()
    player.key(pygame.K_m, "M", SHIFT)
    assert player.parts.brush.tool == "ruler"
    return player


@pytest.mark.parametrize(
    ("start", "end"), [((10, 60), (50, 20)), ((70, 10), (20, 40)), ((5, 5), (5, 45)), ((9, 9), (60, 9))]
)
def test_it_says_how_long_a_line_is_and_how_steep(ruling, start, end):
    digest, line = ruling.world.digest(), ruling.session.timeline.history.line
    places = [ruling.pixel(*place) for place in (start, end)]
    ruling.drag(*places)
    cell = ruling.parts.display.sand_view.view.cell
    across, down = (abs(b - a) / cell for a, b in zip(*places, strict=True))
    angle, length, parts = ruling.parts.ruler.lines
    assert angle == f"{math.degrees(math.atan2(down, across)):.1f}°"
    assert length == f"{math.hypot(across, down):.1f} cells"
    assert parts == f"{across:.1f} across, {down:.1f} high"
    assert ruling.world.digest() == digest and ruling.session.timeline.history.line is line


def test_by_mouse_alone_it_is_taken_and_put_away(player):
    player.hold_time()
    player.click(player.control("Ruler"))
    player.drag(player.pixel(10, 60), player.pixel(40, 30))
    player.wait(1)
    assert player.parts.ruler.shown and player.parts.ruler.lines[0] == "45.0°"
    assert len(player.parts.ruler.marks(player.parts.display.sand_view.view)) == 2
    player.click(player.control("Ruler"))
    assert not player.parts.ruler.shown and player.parts.brush.tool == "brush"


def test_by_keys_alone_it_is_laid_from_cell_to_cell(ruling):
    ruling.key(pygame.K_k, "k")
    ruling.press(pygame.K_RETURN)
    for _ in range(3):
        ruling.key(pygame.K_RIGHT, mod=SHIFT)
    for _ in range(3):
        ruling.key(pygame.K_UP, mod=SHIFT)
    ruling.release(pygame.K_RETURN)
    assert ruling.parts.ruler.lines == ("45.0°", "42.4 cells", "30.0 across, 30.0 high")
    assert not ruling.world.grains


def test_held_straight_it_goes_in_steps_of_45_degrees(ruling):
    brush = ruling.parts.brush
    brush.press((10.0, 10.0))
    brush.release((43.0, 39.0), True)
    assert ruling.parts.ruler.lines[0] == "45.0°"


def test_its_card_stays_in_the_sands_part_of_the_window_and_goes_with_the_tool(ruling):
    area = ruling.parts.display.layout.sand
    for end in ((119, 89), (0, 0), (119, 0), (0, 89)):
        ruling.drag(ruling.pixel(60, 45), ruling.pixel(*end))
        ruling.wait(1)
        view, theme = ruling.parts.display.sand_view, ruling.parts.display.theme
        (covered,) = ruling.parts.ruler.draw(ruling.parts.window.surface, theme, view.area)
        assert area.contains(covered)
    ruling.key(pygame.K_d, "d")
    ruling.wait(1)
    assert not ruling.parts.ruler.shown


def test_in_a_comparison_it_lies_on_every_world():
    player = Player("paper", (1100, 700))
    player.hold_time()
    player.key(pygame.K_h, "H", SHIFT)
    player.key(pygame.K_m, "M", SHIFT)
    player.wait(1)
    player.drag(player.pixel(10, 10), player.pixel(30, 10))
    player.wait(1)
    surface, view = player.parts.window.surface, player.parts.display.sand_view
    colour = player.parts.display.theme.rgb("ring")
    x, y = (round(part) for part in view.view.pixel(12, player.parts.brush.ruled[0][1]))
    seen = [surface.get_at((x + pane.x - view.area.x, y + pane.y - view.area.y))[:3] for pane in view.panes]
    assert seen == [colour] * 4
    player.parts.close()
    pygame.display.quit()
