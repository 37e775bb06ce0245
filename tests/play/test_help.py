"""Laws of the page of keys: all of them, on one screen, none cut, none over another."""

import itertools

import pygame
import pytest

from game.play import help as page
from game.play import keys
from game.play.commands import Commands
from game.play.help import groups, lay_out
from game.play.question import Answer
from game.play.ui import paint
from game.play.ui.theme import Theme

SIZES = (640, 480), (1280, 720), (3840, 2160)
SCALES = 0.75, 1, 1.5, 3


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("size", SIZES)
def test_every_key_is_on_the_page_and_none_is_cut_or_covered(size, scale):
    window = pygame.Rect((0, 0), size)
    theme, strokes = lay_out(Theme(scale), window)
    written = [(rect, text, kind) for stroke, rect, text, kind, *_ in strokes if stroke is paint.words]
    assert {text for _, text, _ in written} >= {word for _, rows in groups() for row in rows for word in row}
    for rect, text, kind in written:
        assert theme.width(text, kind) <= rect.width and theme.line_height(kind) <= rect.height + 2
        assert window.contains(rect)
    for (one, *_), (other, *_) in itertools.combinations(written[2:], 2):
        assert not one.colliderect(other)


def test_the_text_is_as_large_as_there_is_room_for():
    sizes = [lay_out(Theme(1), pygame.Rect(0, 0, *size))[0].scale for size in SIZES]
    assert sizes == sorted(sizes) and sizes[-1] == 1


def test_a_quarter_more_keys_still_fit(monkeypatch):
    more = {title: (*rows, *rows[::4]) for title, rows in keys.GROUPS.items()}
    monkeypatch.setattr(page, "GROUPS", more)
    for size in SIZES:
        window = pygame.Rect(0, 0, *size)
        _, strokes = lay_out(Theme(1), window)
        assert all(window.contains(rect) for _, rect, *_ in strokes)


def test_every_key_gives_a_command_that_there_is():
    assert all(hasattr(Commands, key.command.split()[0]) for key in keys.KEYS if key.codes)


def test_no_two_commands_share_a_key():
    taken = [(code, key.mods) for key in keys.KEYS for code in key.codes]
    assert len(taken) == len(set(taken))


def test_what_the_page_hides_hears_no_key(glass):
    answers = Answer("Yes", None, pygame.K_RETURN, "Enter"), Answer("Later", None, pygame.K_ESCAPE, "Esc")
    glass.toy.question.ask("Go on?", "Words.", answers)
    glass.key(pygame.K_F1)
    for key in (pygame.K_RETURN, pygame.K_ESCAPE):
        glass.key(key)
        assert glass.toy.question.shown
    assert not glass.toy.help.shown
    glass.key(pygame.K_RETURN)
    assert not glass.toy.question.shown


def test_the_upper_of_two_pages_is_closed_first(glass):
    for key in (pygame.K_F2, pygame.K_F1, pygame.K_ESCAPE):
        glass.key(key)
    assert glass.toy.page is glass.toy.gallery


def test_a_click_closes_the_page_and_keys_go_on_working(glass):
    glass.key(pygame.K_F1)
    glass.key(pygame.K_SPACE, " ")
    assert glass.session.paused
    glass.click((400, 300))
    assert not glass.toy.help.shown and glass.session.world.grains == glass.session.account.start
