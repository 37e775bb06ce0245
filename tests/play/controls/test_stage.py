"""The stage: large letters for a class, and nothing small; by keys alone and by mouse alone."""

import pygame
import pytest

from game.play.controls.stage import LINES
from game.play.ui import large_words
from game.play.ui import theme as look
from game.play.ui.theme import Theme
from game.play.window.large_pointer import picture
from tests.sweeps import sweep

SIZES = ((640, 480), 1), ((1280, 720), 1), ((1280, 720), 2), ((1920, 1080), 1), ((3840, 2160), 1.5)
SMALLEST = 0.02  # of the window's height, of any letter on the stage


def resized(player, size, scale):
    player.parts.settings.override("ui_scale", scale)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    player.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))


def staged(player):
    """Enter the stage and let its notice pass."""
    player.key(pygame.K_F5)
    player.now_s += 60
    player.wait(2)


def told(player):
    """Return [(rect, text, size in pixels)] of the large letters."""
    theme = player.parts.display.theme
    return [
        (rect, how[0], theme.px(how[1])) for stroke, rect, *how in player.drawn() if stroke is large_words.large_words
    ]


def texts(player):
    return " ".join(text for _, text, _ in told(player))


@sweep(("size", "scale"), SIZES, keep=[SIZES[0], SIZES[2]])
def test_what_was_chosen_is_read_across_a_room_and_nothing_small_is_left(glass, size, scale):
    resized(glass, size, scale)
    glass.hold_time()
    glass.key(pygame.K_l, "l")
    staged(glass)
    layout, theme = glass.parts.display.layout, glass.parts.display.theme
    assert not glass.parts.display.panel_shown and not layout.status_line.height
    number = glass.world.iteration
    said = texts(glass)
    for wanted in (f"iteration {number:,}", "p = 0.75", f"partition {number % 4 + 1} of 4"):
        assert wanted in said
    for rect, text, high in told(glass):
        assert high > 2 * SMALLEST * size[1] and layout.board.contains(rect)
        assert large_words.width(theme, text, high / theme.scale) <= rect[2] * 1.02
    assert all(
        theme.px(kind) >= SMALLEST * size[1] for _, _, kind in glass.written() if kind in (look.SMALL, look.BODY)
    )
    words = glass.words()
    assert "frame" not in words and (layout.plots is None or "grains per iteration" in words or size[1] < 1000)
    glass.parts.close()


def test_by_keys_alone_it_comes_and_goes_and_the_panel_is_as_it_was(glass):
    for shown in (True, False):
        assert glass.parts.display.panel_shown == shown
        glass.key(pygame.K_F5)
        assert glass.parts.stage.on and not glass.parts.display.panel_shown
        glass.key(pygame.K_ESCAPE)
        assert not glass.parts.stage.on and glass.parts.display.panel_shown == shown
        glass.key(pygame.K_p, "p")


def test_by_mouse_alone_it_comes_and_goes_and_its_lines_are_chosen(glass):
    glass.hold_time()
    glass.unfold("Lines on the stage")
    for name in ("iteration", "clock"):
        glass.click(glass.control(f"Stage {name}"))
    assert glass.parts.settings["stage_lines"] == ("p", "partition")
    glass.click(glass.control("Stage"))
    glass.now_s += 60
    glass.wait(2)
    assert "p = 0.75" in texts(glass) and "iteration" not in texts(glass) and ":" not in texts(glass)
    glass.click(glass.parts.display.layout.board.center)
    assert not glass.parts.stage.on and glass.parts.display.panel_shown


def test_with_no_line_chosen_the_sand_has_their_room_and_the_mouse_still_finds_the_end(glass):
    glass.parts.settings["stage_lines"] = ()
    staged(glass)
    board = glass.parts.display.layout.board
    assert board.height < 0.06 * glass.parts.window.size[1] and texts(glass) == "End the stage"
    glass.parts.settings["stage_lines"] = LINES
    glass.wait(1)
    assert glass.parts.display.layout.board.height > 2 * board.height
    glass.parts.settings["stage_lines"] = ()
    glass.wait(1)
    glass.click(glass.parts.display.layout.board.center)
    assert not glass.parts.stage.on


def test_how_to_leave_it_is_said_no_longer_than_it_lasts(glass):
    glass.key(pygame.K_F5)
    assert "ends the stage" in glass.parts.notices.text
    glass.key(pygame.K_F5)
    glass.wait(1)
    assert glass.parts.notices.text is None


def test_a_notice_is_told_there(glass):
    staged(glass)
    glass.parts.notices.say("A line to be read.")
    assert "A line to be read." in glass.words()


@pytest.mark.parametrize("on_stage", [True, False])
def test_a_timer_has_a_clock_of_large_numerals_there_and_in_full_screen(glass, on_stage):
    if on_stage:
        staged(glass)
    else:
        glass.key(pygame.K_F11)
    glass.parts.timer.set(95)
    glass.parts.timer.start()
    glass.wait(2)
    height = glass.parts.window.size[1]
    ((_, text, high),) = [each for each in told(glass) if ":" in each[1]]
    assert text in ("1:35", "1:34") and high >= 0.1 * height
    glass.parts.timer.stop()
    glass.wait(2)
    assert not on_stage or "1:3" not in texts(glass)
    assert on_stage or not glass.parts.display.layout.board.height


def test_it_leaves_no_step_to_undo(glass):
    line = glass.session.timeline.history.line
    staged(glass)
    glass.key(pygame.K_F5)
    assert glass.session.timeline.history.line is line


def test_numbers_are_equally_wide_whatever_their_digits():
    theme = Theme(2)
    assert len({large_words.width(theme, f"{digit * 3} of 4", 40) for digit in "0123456789"}) == 1


def test_the_pointer_is_found_from_the_back_of_a_room():
    assert min(picture(1).get_size()) >= 36 and min(picture(2).get_size()) >= 72
