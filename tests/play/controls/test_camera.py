"""The camera: what is in sight changes as the hands ask, and the sand does not."""

import math

import numpy as np
import pygame
import pytest

from game.play.controls.camera import FEWEST_CELLS, MISTAKE_S
from game.play.trials import frame_timing
from game.world.scenes.scene import load_scene
from tests.play.player import Player


@pytest.fixture
def still(player):
    """Return a Player of a blank scene in which time stands still."""
    player.hold_time()
    return player


def wheel(player, notches, pos):
    player.pointer = pos
    player.frame()
    pygame.key.set_mods(pygame.KMOD_LCTRL)
    player.frame(pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=notches, flipped=False))
    pygame.key.set_mods(0)


def finger(player, kind, number, pos):
    width, height = player.parts.window.size
    player.frame(
        pygame.event.Event(kind, finger_id=number, touch_id=1, x=pos[0] / width, y=pos[1] / height, dx=0, dy=0)
    )


def shown(player):
    area = player.parts.display.layout.sand
    return pygame.surfarray.array2d(player.parts.window.surface)[: area.width, : area.height]


def is_fresh(player):
    """Return whether what is on the sand view is what would be drawn there from nothing."""
    player.pointer = None
    player.frame(elapsed_ns=0)  # the tool's outline goes with the pointer
    while any(each.shown for each in player.parts.overlays if each is not player.parts.minimap):
        player.now_s += 60  # what is said goes away
        player.wait(1)
    before = shown(player)
    player.parts.display.sand_view.refresh()
    player.frame()
    return (before == shown(player)).all()


def test_the_cell_under_the_pointer_stays_there_as_the_wheel_zooms(still):
    pos = still.pixel(60, 45)
    for notches in (1, 1, 3, -1, 2, -2):
        wheel(still, notches, pos)
        assert [int(part) for part in still.parts.display.sand_view.view.place(*pos)] == [60, 45]
    assert still.parts.display.sand_view.view.cell == 10 and still.parts.brush.diameter == 6
    still.key(pygame.K_0, "0")
    assert still.parts.display.sand_view.view == still.parts.display.sand_view.whole


def test_sand_is_painted_on_the_cell_under_the_pointer_at_every_zoom(still):
    still.parts.brush.diameter = 1
    pos = still.pixel(60, 45)
    for notches in (0, 2, 3, 4):
        wheel(still, notches, pos)
        for dx, dy in ((0, 0), (100, 30), (-200, -120)):
            column, row = (int(part) for part in still.parts.display.sand_view.view.place(pos[0] + dx, pos[1] + dy))
            still.click((pos[0] + dx, pos[1] + dy))
            assert still.world.sand[row, column]
    assert still.world.grains <= 12
    assert is_fresh(still)


def test_the_middle_button_drags_the_lattice_along(still):
    wheel(still, 4, still.pixel(60, 45))
    start = (300, 300)
    place = still.parts.display.sand_view.view.place(*start)
    still.drag(start, (310, 305), (350, 280), button=2)
    assert still.parts.display.sand_view.view.place(350, 280) == pytest.approx(place)
    assert still.world.grains == 0


def test_space_drags_or_else_pauses(player):
    wheel(player, 4, player.pixel(60, 45))
    player.press(pygame.K_SPACE, " ")
    assert not player.session.paused
    place = player.parts.display.sand_view.view.place(300, 300)
    player.drag((300, 300), (330, 290))
    player.release(pygame.K_SPACE)
    assert player.parts.display.sand_view.view.place(330, 290) == pytest.approx(place)
    assert not player.session.paused and player.world.grains == 0
    player.key(pygame.K_SPACE, " ")
    assert player.session.paused


def test_keys_zoom_and_look_around(still):
    for _ in range(4):
        still.key(pygame.K_PLUS, "+", pygame.KMOD_LCTRL)
    view = still.parts.display.sand_view.view
    still.key(pygame.K_RIGHT, "", pygame.KMOD_LCTRL)
    still.key(pygame.K_DOWN, "", pygame.KMOD_LCTRL)
    moved = still.parts.display.sand_view.view
    assert moved.left < view.left and moved.top < view.top and moved.cell == view.cell
    still.key(pygame.K_MINUS, "-", pygame.KMOD_LCTRL)
    assert still.parts.display.sand_view.view.cell < view.cell


def test_what_was_in_the_middle_is_there_after_the_window_has_changed(still):
    wheel(still, 5, still.pixel(30, 40))
    for size in ((1200, 800), (900, 700)):
        area = still.parts.display.sand_view.area
        middle = still.parts.display.sand_view.view.place(area.x + area.width / 2 - 0.5, area.y + area.height / 2 - 0.5)
        pygame.display.set_mode(size, pygame.RESIZABLE, 32)
        still.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
        area = still.parts.display.sand_view.area
        after = still.parts.display.sand_view.view.place(area.x + area.width / 2 - 0.5, area.y + area.height / 2 - 0.5)
        assert after == pytest.approx(middle, abs=1.5)


def test_the_turned_glass_shows_the_same_sand_upside_down(glass):
    glass.hold_time()
    wheel(glass, 4, glass.pixel(100, 60))
    glass.wait(100)
    view = glass.parts.display.sand_view.view
    glass.key(pygame.K_f, "f")
    glass.now_s += 1e6
    glass.wait(2)
    turned = glass.parts.display.sand_view.view
    x, y = 300, 300
    column, row = view.place(x, y)
    area = glass.parts.display.sand_view.area
    beyond = turned.place(area.x + area.right - 1 - x, area.y + area.bottom - 1 - y)
    assert beyond == pytest.approx((view.shape[1] - column, view.shape[0] - row), abs=1e-6)
    assert is_fresh(glass)


def test_two_fingers_zoom_and_take_back_what_one_has_painted(still):
    one, other = (300, 300), (400, 300)
    still.frame(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=one, button=1, touch=True))
    finger(still, pygame.FINGERDOWN, 1, one)
    assert still.world.grains > 0
    finger(still, pygame.FINGERDOWN, 2, other)
    assert still.world.grains == 0
    place, cell = still.parts.display.sand_view.view.place(350, 300), still.parts.display.sand_view.view.cell
    finger(still, pygame.FINGERMOTION, 1, (200, 300))
    still.frame(pygame.event.Event(pygame.MOUSEMOTION, pos=(200, 300), rel=(0, 0), buttons=(1, 0, 0), touch=True))
    finger(still, pygame.FINGERMOTION, 2, (500, 300))
    assert still.parts.display.sand_view.view.cell == pytest.approx(3 * cell)
    assert still.parts.display.sand_view.view.place(350, 300) == pytest.approx(place)
    finger(still, pygame.FINGERUP, 2, (500, 300))
    finger(still, pygame.FINGERUP, 1, (200, 300))
    still.frame(pygame.event.Event(pygame.MOUSEBUTTONUP, pos=(200, 300), button=1, touch=True))
    assert still.world.grains == 0 and still.parts.display.sand_view.view.cell == round(3 * cell)
    still.click(one)
    assert still.world.grains > 0


def test_two_fingers_take_back_no_stroke_that_was_there_before(still):
    one = (300, 300)
    still.click(one)
    grains = still.world.grains
    still.frame(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=one, button=1, touch=True))
    finger(still, pygame.FINGERDOWN, 1, one)
    finger(still, pygame.FINGERDOWN, 2, (400, 300))
    assert still.world.grains == grains > 0


def pinch(player, seconds_after_the_first_finger):
    """Paint with a finger, and lay a second one beside it so much later."""
    one, other = (300, 300), (400, 300)
    player.frame(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=one, button=1, touch=True))
    finger(player, pygame.FINGERDOWN, 1, one)
    player.now_s += seconds_after_the_first_finger
    finger(player, pygame.FINGERDOWN, 2, other)


@pytest.mark.parametrize(("seconds", "stays"), [(MISTAKE_S - 0.1, False), (MISTAKE_S + 0.1, True)])
def test_a_pinch_undoes_a_stroke_that_has_just_begun_and_leaves_an_older_one(still, seconds, stays):
    pinch(still, seconds)
    assert bool(still.world.grains) == stays


def test_a_third_finger_neither_zooms_nor_paints(still):
    pinch(still, 0.1)
    view = still.parts.display.sand_view.view
    finger(still, pygame.FINGERDOWN, 3, (500, 500))
    for number, pos in ((3, (200, 200)), (1, (150, 420))):
        finger(still, pygame.FINGERMOTION, number, pos)
    still.frame(pygame.event.Event(pygame.MOUSEMOTION, pos=(150, 420), rel=(0, 0), buttons=(1, 0, 0), touch=True))
    assert still.parts.display.sand_view.view == view and not still.world.grains
    finger(still, pygame.FINGERUP, 3, (200, 200))
    finger(still, pygame.FINGERMOTION, 2, (650, 300))
    wider = math.dist((150, 420), (650, 300)) / math.dist((150, 420), (400, 300))
    assert still.parts.display.sand_view.view.cell == pytest.approx(wider * view.cell)


def test_the_wheel_stops_at_whole_pixels_up_to_the_largest_cell(still):
    cells = []
    for _ in range(40):
        wheel(still, 1, still.pixel(60, 45))
        cells.append(still.parts.display.sand_view.view.cell)
    assert all(cell == int(cell) for cell in cells) and cells == sorted(cells)
    largest, area = cells[-1], still.parts.display.sand_view.area
    assert cells[-2] == largest and min(area.size) / largest >= FEWEST_CELLS


def test_a_pinch_ends_at_whole_pixels(still):
    pinch(still, 0.1)
    finger(still, pygame.FINGERMOTION, 2, (477, 300))
    assert still.parts.display.sand_view.view.cell % 1
    finger(still, pygame.FINGERUP, 2, (477, 300))
    assert still.parts.display.sand_view.view.cell % 1 == 0 < still.parts.display.sand_view.view.cell


def test_the_world_does_not_know_who_looks():
    near, far = Player("hourglass"), Player("hourglass")
    for _ in range(20):
        wheel(near, 1, (200, 300))
        far.wait(1)
    last = max(near.session.now, far.session.now)  # a frame runs as much as there is time for
    for each in (near, far):
        each.session.seek(last)
    assert near.world.digest() == far.world.digest()
    assert near.session.timeline.history.line.before is None
    pygame.display.quit()


def test_what_changes_out_of_sight_is_seen_when_it_comes_into_sight(glass):
    rng = np.random.default_rng(4)
    for _ in range(25):
        wheel(glass, int(rng.integers(-4, 5)), tuple(int(part) for part in rng.integers(20, 560, 2)))
        glass.wait(2)
        glass.drag((300, 300), tuple(int(part) for part in rng.integers(20, 560, 2)), button=2)
    glass.hold_time()
    assert is_fresh(glass)


@pytest.mark.parametrize(("asked", "shown"), [(24, 24), (None, 9)])
def test_frames_are_timed_at_the_zoom_that_was_asked_for(asked, shown):
    report = frame_timing.frames(load_scene("paper"), (900, 700), 1, 2, cell=asked)
    assert report["pixels_per_cell"] == shown
    pygame.display.quit()
