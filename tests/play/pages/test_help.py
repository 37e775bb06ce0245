"""Laws of the page of keys: all of them, none cut, none over another, on one screen or to be scrolled to."""

import itertools

import pygame
import pytest

from game.play.controls import keymap
from game.play.controls.commands import Commands
from game.play.pages import help as page
from game.play.pages.help import groups, lay_out
from game.play.ui import draw_list
from game.play.ui.theme import Theme
from game.play.view.dialog import Answer
from tests.play.player import Player
from tests.sweeps import sweep

SIZES = (640, 480), (1280, 720), (3840, 2160)
SCALES = 0.75, 1, 1.5, 3


@sweep("scale", SCALES, keep=[SCALES[0], SCALES[-1]])
@pytest.mark.parametrize("size", SIZES)
def test_every_key_is_on_the_page_and_none_is_cut_or_covered(size, scale):
    window = pygame.Rect((0, 0), size)
    laid = lay_out(Theme(scale), window)
    theme, strokes = laid.theme, laid.frame + laid.rows
    written = [(rect, text, kind) for stroke, rect, text, kind, *_ in strokes if stroke is draw_list.words]
    assert {text for _, text, _ in written} >= {word for _, rows in groups() for row in rows for word in row}
    assert window.contains(laid.frame[0][1]) and laid.frame[0][1].contains(laid.room)
    for rect, text, kind in written:
        assert theme.width(text, kind) <= rect.width and theme.line_height(kind) <= rect.height + 2
        assert window.contains(rect) or (laid.more and laid.room.contains(rect.move(0, laid.room.y - rect.y)))
    for (one, *_), (other, *_) in itertools.combinations(written[2:], 2):
        assert not one.colliderect(other)
    assert max(rect.bottom for rect, *_ in written) - laid.more * laid.line == laid.room.bottom


@sweep("scale", SCALES, keep=[1, 3])
def test_all_keys_are_on_one_screen_unless_the_text_would_be_much_smaller_than_asked_for(scale):
    for size in SIZES:
        laid = lay_out(Theme(scale), pygame.Rect(0, 0, *size))
        assert laid.theme.scale >= 0.8 * scale or laid.lines == laid.more + laid.seen


def test_in_usual_windows_all_keys_are_on_one_screen_and_in_a_small_one_they_are_as_large_as_asked_for():
    assert not any(lay_out(Theme(1), pygame.Rect(0, 0, *size)).more for size in SIZES[1:])
    assert lay_out(Theme(2), pygame.Rect(0, 0, 1360, 860)).theme.scale >= 1.6
    assert lay_out(Theme(1), pygame.Rect(0, 0, 640, 480)).theme.scale == 1


def test_wheel_and_keys_scroll_to_the_last_line_and_back():
    player = Player("hourglass", (640, 480))
    player.key(pygame.K_F1)
    at, laid = player.session.now, lay_out(player.parts.display.theme, pygame.Rect(0, 0, 640, 480))
    assert laid.more

    def lines_up():
        """Return by how many lines the rows have gone up."""
        _, first, text, *_ = laid.rows[0]
        return (first.y - [rect.y for rect, word, _ in player.written() if word == text][-1]) / laid.line

    for code, lines in ((pygame.K_DOWN, 1), (pygame.K_END, laid.more), (pygame.K_HOME, 0)):
        player.key(code)
        assert lines_up() == lines
    for _ in range(50):
        player.frame(pygame.event.Event(pygame.MOUSEWHEEL, y=-1, x=0))
    assert lines_up() == laid.more and player.parts.help.shown and player.session.now > at
    player.hold_time()
    player.wait(30)
    assert not player.frame()
    pygame.display.quit()


def test_a_quarter_more_keys_still_fit(monkeypatch):
    more = {title: (*rows, *rows[::4]) for title, rows in keymap.GROUPS.items()}
    monkeypatch.setattr(page, "GROUPS", more)
    for size in SIZES:
        window = pygame.Rect(0, 0, *size)
        assert all(window.contains(rect) for _, rect, *_ in lay_out(Theme(1), window).frame)


def test_every_key_gives_a_command_that_there_is():
    for name in {key.command.split()[0] for key in keymap.KEYS if key.codes}:
        group, method = name.split(".")
        assert hasattr(Commands.__annotations__[group], method), name


def test_no_two_commands_share_a_key():
    taken = [(code, key.mods) for key in keymap.KEYS for code in key.codes]
    assert len(taken) == len(set(taken))


def test_what_the_page_hides_hears_no_key(glass):
    answers = Answer("Yes", None, pygame.K_RETURN, "Enter"), Answer("Later", None, pygame.K_ESCAPE, "Esc")
    glass.parts.dialog.ask("Go on?", "Words.", answers)
    glass.key(pygame.K_F1)
    for key in (pygame.K_RETURN, pygame.K_ESCAPE):
        glass.key(key)
        assert glass.parts.dialog.shown
    assert not glass.parts.help.shown
    glass.key(pygame.K_RETURN)
    assert not glass.parts.dialog.shown


def test_the_upper_of_two_pages_is_closed_first(glass):
    for key in (pygame.K_F2, pygame.K_F1, pygame.K_ESCAPE):
        glass.key(key)
    assert glass.parts.display.page is glass.parts.gallery


def test_a_click_closes_the_page_and_keys_go_on_working(glass):
    glass.key(pygame.K_F1)
    glass.key(pygame.K_SPACE, " ")
    assert glass.session.paused
    glass.click((400, 300))
    assert not glass.parts.help.shown and glass.session.world.grains == glass.session.account.start
