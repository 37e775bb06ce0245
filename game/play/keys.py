"""Which key does what: the one table that the window obeys and that the help shows."""

from typing import NamedTuple

import pygame


class Key(NamedTuple):
    """A key and the command it gives: the name of a method of `Toy`."""

    label: str
    codes: tuple
    command: str
    meaning: str


KEYS = (
    Key("Space", (pygame.K_SPACE,), "pause", "pause, and go on"),
    Key(".", (pygame.K_PERIOD,), "step", "one iteration"),
    Key("F", (pygame.K_f,), "flip", "turn the glass over"),
    Key("R", (pygame.K_r,), "restart", "start the scene again"),
    Key("C", (pygame.K_c,), "clear", "take all sand away"),
    Key("+", (pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS), "faster", "faster"),
    Key("-", (pygame.K_MINUS, pygame.K_KP_MINUS), "slower", "slower"),
    Key("1", (pygame.K_1, pygame.K_KP1), "take_sand", "paint sand"),
    Key("2", (pygame.K_2, pygame.K_KP2), "take_wall", "paint walls"),
    Key("3", (pygame.K_3, pygame.K_KP3), "take_eraser", "erase"),
    Key("[", (pygame.K_LEFTBRACKET,), "smaller_brush", "smaller brush"),
    Key("]", (pygame.K_RIGHTBRACKET,), "larger_brush", "larger brush"),
    Key("P", (pygame.K_p,), "toggle_panel", "hide or show the panel"),
    Key("F11", (pygame.K_F11,), "toggle_fullscreen", "full screen"),
    Key("F1 or ?", (pygame.K_F1, pygame.K_QUESTION), "toggle_help", "this page"),
    Key("Esc", (pygame.K_ESCAPE,), "escape", "close, leave, quit"),
)
OTHER_WAYS = (  # what is no command of a key
    ("Left button", "paint with the tool"),
    ("Right button", "erase"),
    ("Wheel", "size of the brush"),
    ("Tab, arrows", "work the panel"),
)
_COMMANDS = {code: key.command for key in KEYS for code in key.codes}
REPEATING = {"step", "faster", "slower", "smaller_brush", "larger_brush"}  # commands that a held key gives again


def command(event):
    """Return the command that a KEYDOWN event gives, or None."""
    if event.mod & (pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META):
        return None
    by_text = {"?": "toggle_help", "+": "faster", "-": "slower", "[": "smaller_brush", "]": "larger_brush", ".": "step"}
    return by_text.get(event.unicode) or _COMMANDS.get(event.key)
