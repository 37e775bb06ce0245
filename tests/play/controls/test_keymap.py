"""The keymap on keyboards of other countries: letters are found where they are, or where they stand on a US one."""

import pygame
import pytest

from game.play.controls.keymap import KEYS, command

CTRL, SHIFT = pygame.KMOD_LCTRL, pygame.KMOD_LSHIFT
ROWS = "qwertyuiop[]", "asdfghjkl;'", "zxcvbnm,."
LETTERS = [char for row in ROWS for char in row if char.isalpha()]
LAYOUTS = {  # what the three rows type
    "ru": ("йцукенгшщзхъ", "фывапролджэ", "ячсмитьбю"),
    "gr": (";ςερτυθιοπ[]", "ασδφγηξκλ΄'", "ζχψωβνμ,."),
    "il": ("/'קראטוןםפ[]", "שדגכעיחלךף,", "זסבהנמצתץ"),
}
PLACES = {
    **{char: pygame.KSCAN_A + ord(char) - ord("a") for char in LETTERS},
    **{"[": pygame.KSCAN_LEFTBRACKET, "]": pygame.KSCAN_RIGHTBRACKET},
    **{",": pygame.KSCAN_COMMA, ".": pygame.KSCAN_PERIOD},
}


def press(code, place, mod=0, text=""):
    return command(pygame.event.Event(pygame.KEYDOWN, key=code, scancode=place, mod=mod, unicode=text))


def on(layout, char, mod=0):
    """Return the command of the key that types `char` on a US keyboard, pressed on another."""
    row = next(number for number, row in enumerate(ROWS) if char in row)
    typed = LAYOUTS[layout][row][ROWS[row].index(char)]
    return press(ord(typed), PLACES[char], mod, "" if mod & CTRL else typed)


@pytest.mark.parametrize("mod", [0, SHIFT, CTRL, CTRL | SHIFT])
@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_letter_gives_its_command_where_the_layout_has_none_of_them(layout, mod):
    for char in LETTERS:
        assert on(layout, char, mod) == press(ord(char), PLACES[char], mod), char


def test_brackets_and_stops_are_found_where_letters_took_their_places():
    for char, given in (("[", "sand.smaller_brush"), ("]", "sand.larger_brush"), (".", "time.step")):
        assert on("ru", char) == given
    assert on("ru", ",") == "sand.next_colour 1"


def test_french_and_german_letters_stay_where_they_are_written():
    assert press(pygame.K_a, pygame.KSCAN_Q, text="a") == "sand.tool spray"
    assert press(pygame.K_q, pygame.KSCAN_A, text="q") == "sand.tilt -1"
    assert press(pygame.K_COMMA, pygame.KSCAN_M, text=",") == "sand.next_colour 1"
    assert press(pygame.K_SEMICOLON, pygame.KSCAN_COMMA, text=";") is None
    assert press(pygame.K_z, pygame.KSCAN_Y, CTRL) == "time.undo"
    assert press(pygame.K_y, pygame.KSCAN_Z, CTRL) == "time.redo"
    for accented, place in (("é", pygame.KSCAN_2), ("ö", pygame.KSCAN_SEMICOLON), ("ü", pygame.KSCAN_LEFTBRACKET)):
        assert press(ord(accented), place, text=accented) is None


def test_keys_that_type_nothing_are_known_by_their_code():
    for code in (code for key in KEYS for code in key.codes if code >= 1 << 30):
        assert any(press(code, code & 0x1FF, mod) for mod in (0, CTRL, SHIFT))
