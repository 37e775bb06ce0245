"""Worlds side by side: what is done in one pane is done in all, and the same key leads back."""

import itertools

import numpy as np
import pygame
import pytest

from game.play.ui import draw_list
from game.play.view import comparison_view
from game.play.view.comparison_view import GAP, TITLE
from game.world.looks.painter import Painter
from game.world.looks.view import View
from game.world.scenes.scene import load_scene
from game.world.sessions.action import Clear
from game.world.sessions.comparison import Comparison
from game.world.sessions.session import Session
from tests.play.player import Player
from tests.sweeps import sweep


@pytest.fixture
def three():
    """Return a Player of the hourglass under three schedules."""
    player = Player("hourglass", (1100, 700))
    player.parts.comparing.subject = "schedule"
    player.wait(20)
    player.key(pygame.K_h, "H", pygame.KMOD_SHIFT)
    player.wait(1)
    yield player
    player.parts.close()
    pygame.display.quit()


def shifts(view):
    """Return the way from the leading pane to each pane, in pixels."""
    return [(pane.x - view.area.x, pane.y - view.area.y) for pane in view.panes]


def places_in(player, column, row):
    """Return the pixel of a cell in each pane."""
    x, y = player.pixel(column, row)
    return [(x + dx, y + dy) for dx, dy in shifts(player.parts.display.sand_view)]


def test_the_key_shows_the_present_sand_three_times_and_goes_back_to_where_it_was():
    player = Player("hourglass", (1100, 700))
    player.parts.comparing.subject = "schedule"
    player.wait(20)
    player.hold_time()
    before, digest = player.session, player.world.digest()
    player.key(pygame.K_h, "H", pygame.KMOD_SHIFT)
    assert isinstance(player.session, Comparison)
    assert all((each.world.sand == before.world.sand).all() for each in player.session.sessions.values())
    player.session.paused = False
    player.wait(30)
    assert len({each.world.digest() for each in player.session.sessions.values()}) == 3
    player.key(pygame.K_h, "H", pygame.KMOD_SHIFT)
    assert player.session is before and player.world.digest() == digest
    pygame.display.quit()


def test_a_stroke_in_any_pane_is_painted_in_all(three):
    three.hold_time()
    three.parts.brush.diameter = 5
    for number in range(3):
        three.key(pygame.K_c, "c")
        three.drag(places_in(three, 60, 190)[number], places_in(three, 90, 200)[number])
        sands = [each.world.sand for each in three.session.sessions.values()]
        assert sands[0][190, 60] and sands[0][200, 90]
        assert all((each == sands[0]).all() for each in sands)


def test_a_stroke_that_leaves_its_pane_does_not_jump_to_the_other_side(three):
    three.hold_time()
    three.key(pygame.K_c, "c")
    from_x, to_x = places_in(three, 170, 180)[0], places_in(three, 5, 180)[1]
    three.drag(from_x, to_x)
    assert not three.world.sand[:, :160].any()


def test_each_pane_shows_its_own_world_and_what_is_left(three):
    three.wait(100)
    three.hold_time()
    three.wait(20)
    surface = pygame.surfarray.array3d(three.parts.window.surface)
    seen = []
    for dx, dy in shifts(three.parts.display.sand_view):
        left, top, right, bottom = three.parts.display.sand_view.view.seen
        seen.append(surface[left + dx : right + dx, top + dy : bottom + dy])
    assert (seen[0] != seen[1]).any() and (seen[1] != seen[2]).any()
    titles = three.parts.display.sand_view.titles()
    for title, session in three.session.sessions.items():
        left = int(np.count_nonzero(session.world.sand[: session.scene.neck]))
        assert titles[title] == (title, f"{left:,} left above")


@sweep(
    ("size", "scale"),
    [((640, 480), 1), ((1100, 700), 1), ((1360, 860), 2), ((1360, 860), 3)],
    keep=[((640, 480), 1), ((1360, 860), 3)],
)
def test_name_and_count_of_a_title_lie_side_by_side_and_every_name_is_whole(three, monkeypatch, size, scale):
    written = []
    three.parts.settings.override("ui_scale", scale)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    words = draw_list.words
    monkeypatch.setattr(draw_list, "words", lambda *how: written.append(how) or words(*how))
    three.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
    sand_view, theme = three.parts.display.sand_view, three.parts.display.theme
    for pane, framed, (wanted, told) in zip(
        sand_view.panes, sand_view.framed.values(), sand_view.titles().values(), strict=True
    ):
        title = pygame.Rect(framed.topleft, (framed.width, framed.height - pane.height))
        (name, text, kind), (left, count, other) = [each[2:5] for each in written if title.contains(each[2])]
        assert text == wanted and name.x + theme.width(text, kind) <= name.right
        assert count and told.startswith(count) and theme.width(count, other) <= left.width
        if name.y == left.y:
            assert name.x + theme.width(text, kind) < left.right - theme.width(count, other)
        else:
            assert name.bottom <= left.centery


def test_a_line_parts_zoomed_panes(three):
    for _ in range(8):
        three.key(pygame.K_PLUS, "", pygame.KMOD_CTRL)
    three.hold_time()
    three.wait(3)
    surface, edge = three.parts.window.surface, three.parts.display.theme.rgb("edge")
    panes, gap = three.parts.display.sand_view.panes, three.parts.display.theme.px(GAP)
    for gap in [pygame.Rect(pane.right, pane.y, gap, pane.height) for pane in panes[:-1]]:
        assert {
            tuple(surface.get_at((x, y))[:3]) for x in range(gap.left, gap.right) for y in range(gap.top, gap.bottom)
        } == {edge}


def test_a_flip_turns_all_three_and_undo_brings_them_back(three):
    three.hold_time()
    before = [each.world.sand for each in three.session.sessions.values()]
    three.key(pygame.K_f, "f")
    three.now_s += 1e6
    three.wait(3)
    after = [each.world.sand for each in three.session.sessions.values()]
    assert all((new == old[::-1, ::-1]).all() for new, old in zip(after, before, strict=True))
    three.key(pygame.K_z, "", pygame.KMOD_CTRL)
    assert all((new.world.sand == old).all() for new, old in zip(three.session.sessions.values(), before, strict=True))


def test_undo_that_is_held_neither_leaves_the_comparison_nor_goes_on_beyond_it(three):
    own = next(iter(three.parts.sessions.waiting))
    own.timeline.do(Clear())
    three.hold_time()
    three.key(pygame.K_c, "c")
    for _ in range(5):
        three.press(pygame.K_z, "", pygame.KMOD_CTRL)
    assert isinstance(three.session, Comparison) and three.world.grains
    three.release(pygame.K_z)
    for _ in range(5):
        three.press(pygame.K_z, "", pygame.KMOD_CTRL)
    assert three.session is own and not three.world.grains


def test_still_panes_are_not_drawn_again(three):
    three.hold_time()
    three.now_s += 10  # the line that tells of them is gone
    three.wait(60)
    assert not any(three.frame() for _ in range(5))


def test_worlds_that_a_frame_has_no_time_to_draw_are_drawn_in_the_next_ones_and_none_is_forgotten(three, monkeypatch):
    monkeypatch.setattr(comparison_view, "DRAWING_NS", -1)
    three.wait(100)
    view, drawn = three.parts.display.sand_view, []
    for _ in range(6):
        before = pixels_in(three, view)
        three.frame()
        after = pixels_in(three, view)
        changed = [(old != new).any() for old, new in zip(before, after, strict=True)]
        drawn.append(np.flatnonzero(changed).tolist())
    assert [len(each) for each in drawn] == [1] * 6
    assert sorted(drawn[0] + drawn[1] + drawn[2]) == sorted(drawn[3] + drawn[4] + drawn[5]) == [0, 1, 2]
    three.hold_time()
    three.wait(3)
    shown = pixels_in(three, view)
    three.drawn()
    assert all((old == new).all() for old, new in zip(shown, pixels_in(three, view), strict=True))


def pixels_in(player, view):
    """Return the pixels of each pane, [(w, h, 3)]."""
    pixels = pygame.surfarray.array3d(player.parts.window.surface)
    return [pixels[pane.left : pane.right, pane.top : pane.bottom] for pane in view.panes]


@pytest.mark.parametrize("size", [(1100, 700), (1280, 720), (700, 1100), (640, 480)])
def test_four_values_of_p_stand_where_they_are_largest_with_all_of_their_titles(size):
    player = Player("paper", size)
    player.wait(1)
    player.click(player.control("Compare"))
    player.settle()
    view, area = player.parts.display.sand_view, player.parts.display.layout.sand
    panes = view.panes
    assert [title for title, _ in view.titles().values()] == ["p = 0.25", "p = 0.5", "p = 0.75", "p = 1"]
    assert all(area.contains(pane) for pane in panes)
    assert not any(one.colliderect(other) for one, other in itertools.combinations(panes, 2))
    across = area.width // 4 if area.width / 4 > area.height / 4 - TITLE else area.height // 4 - TITLE
    assert min(panes[0].size) >= min(across, *area.size) - 2 * GAP
    player.key(pygame.K_ESCAPE)
    assert not isinstance(player.session, Comparison)
    player.parts.close()
    pygame.display.quit()


def test_many_materials_are_compared_but_not_by_p():
    player = Player("kitchen", (1100, 700))
    player.wait(1)
    assert player.parts.comparing.subjects == ("schedule", "seed", "rule")
    player.click(player.control("Compare"))
    player.settle()
    player.wait(20)
    assert len({each.world.digest() for each in player.session.sessions.values()}) == 4
    player.parts.close()
    pygame.display.quit()


@sweep("scene", ["fullhd", "paper", "kitchen"], keep=["paper"])
def test_a_world_that_is_still_on_its_way_to_another_scene_is_shown_once_it_is_there(three, scene):
    three.hold_time()
    three.wait(30)
    behind = next(iter(three.session.others.values()))
    there = behind.timeline.moment
    behind.timeline.moment = Session(load_scene(scene)).timeline.moment
    view, surface = three.parts.display.sand_view, three.parts.window.surface
    titles, seen = view.titles(), [pygame.surfarray.array3d(surface.subsurface(pane)) for pane in view.panes]
    three.wait(60)
    assert view.titles() == titles
    behind.timeline.moment = there
    three.wait(60)
    for pane, before in zip(view.panes, seen, strict=True):
        assert (pygame.surfarray.array3d(surface.subsurface(pane)) == before).all()


def test_a_view_shows_no_world_of_another_shape():
    world = load_scene("paper").world()
    with pytest.raises(ValueError, match="shows no world"):
        Painter(View((60, 61), 0, 0, 61, 60)).draw(world, np.zeros((61, 61), np.uint32))
