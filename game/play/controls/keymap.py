"""Which key does what: the one table that the window obeys and that the help shows."""

from typing import NamedTuple

import pygame

CTRL = pygame.KMOD_CTRL | pygame.KMOD_META  # on a Mac, Cmd
SHIFT = pygame.KMOD_SHIFT
ALT_GR = pygame.KMOD_RALT | pygame.KMOD_MODE  # by which many a layout types brackets; Windows holds Ctrl down with it


class Key(NamedTuple):
    """A key and the command it gives: a method of `Commands`. The help shows those with a label."""

    label: str
    codes: tuple
    command: str  # words: the method's name, then what it is given
    meaning: str
    mods: int = 0  # which of CTRL and SHIFT are to be held with it


GROUPS = {  # what the help shows together; a key without a command is heard elsewhere
    "Time": (
        Key("Space", (pygame.K_SPACE,), "pause", "pause, and go on"),
        Key(".", (pygame.K_PERIOD,), "step", "one iteration"),
        Key("+ -", (pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS), "faster", "faster, slower"),
        Key("", (pygame.K_MINUS, pygame.K_KP_MINUS), "slower", ""),
        Key("Right", (), "", "hold: fast forward"),
        Key("Shift+Right", (pygame.K_RIGHT,), "await_flow", "to the next flow; End: to rest", SHIFT),
        Key("", (pygame.K_END,), "settle", ""),
        Key("T", (pygame.K_t,), "toggle_timer", "start the timer, or stop it"),
        Key("Backspace", (), "", "time runs back (Shift: fast)"),
        Key("Ctrl+Z", (pygame.K_z,), "undo", "take back the last act", CTRL),
        Key("Ctrl+Y", (pygame.K_y,), "redo", "bring it back", CTRL),
        Key("", (pygame.K_z,), "redo", "", CTRL | SHIFT),
    ),
    "Sand": (
        Key("F", (pygame.K_f,), "flip", "turn the glass over"),
        Key("Shift+F", (pygame.K_f,), "turn 1", "a quarter turn", SHIFT),
        Key("Ctrl+F", (pygame.K_f,), "turn 3", "a quarter back", CTRL),
        Key("Q E", (pygame.K_q,), "tilt -1", "tilt left, right"),
        Key("", (pygame.K_e,), "tilt 1", ""),
        Key("R", (pygame.K_r,), "restart", "start the scene again"),
        Key("C", (pygame.K_c,), "clear", "take all sand away"),
        Key("H", (pygame.K_h,), "toggle_forecast", "where it will be"),
        Key("Shift+H", (pygame.K_h,), "compare", "three schedules at once", SHIFT),
        Key("L", (pygame.K_l,), "toggle_plots", "plots (Shift: save as CSV)"),
        Key("", (pygame.K_l,), "save_measures", "", SHIFT),
    ),
    "Tools": (
        Key("Left button", (), "", "use the tool"),
        Key("Right button", (), "", "erase with it"),
        Key("Shift+drag", (), "", "straight, square"),
        Key("D A Y", (pygame.K_d,), "tool brush", "brush, spray, replace"),
        Key("", (pygame.K_a,), "tool spray", ""),
        Key("", (pygame.K_y,), "tool replace", ""),
        Key("N U O", (pygame.K_n,), "tool line", "line, box, ellipse"),
        Key("", (pygame.K_u,), "tool rectangle", ""),
        Key("", (pygame.K_o,), "tool ellipse", ""),
        Key("Shift+U O", (pygame.K_u,), "edge rectangle", "their outlines only", SHIFT),
        Key("", (pygame.K_o,), "edge ellipse", "", SHIFT),
        Key("V I", (pygame.K_v,), "tool fill", "fill, pick"),
        Key("", (pygame.K_i,), "tool pick", ""),
        Key("J Z", (pygame.K_j,), "tool tap", "tap, drain"),
        Key("", (pygame.K_z,), "tool drain", ""),
        Key("K", (pygame.K_k,), "toggle_cursor", "keyboard cursor"),
    ),
    "Brush": (
        Key("S W X", (pygame.K_s,), "material sand", "sand, wall, eraser"),
        Key("", (pygame.K_w,), "material wall", ""),
        Key("", (pygame.K_x,), "material erase", ""),
        Key(", Shift+,", (pygame.K_COMMA,), "next_colour 1", "next, previous colour"),
        Key("", (pygame.K_COMMA,), "next_colour -1", "", SHIFT),
        Key("1 … 9", (pygame.K_1, pygame.K_KP1), "size 1", "brush of 1, 2, 3, 5, 8 … 55 cells"),
        *(Key("", (pygame.K_1 + more, pygame.K_KP1 + more), f"size {more + 1}", "") for more in range(1, 9)),
        Key("Wheel, [ ]", (pygame.K_LEFTBRACKET,), "smaller_brush", "smaller, larger brush"),
        Key("", (pygame.K_RIGHTBRACKET,), "larger_brush", ""),
        Key("Shift+D", (pygame.K_d,), "next_shape", "round, square, diamond", SHIFT),
    ),
    "View": (
        Key("0, B", (pygame.K_0, pygame.K_KP0), "show_all", "all of the lattice; blocks to come"),
        Key("Ctrl + -", (pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS), "zoom 1", "zoom (also Ctrl+wheel)", CTRL),
        Key("", (pygame.K_PLUS, pygame.K_EQUALS), "zoom 1", "", CTRL | SHIFT),
        Key("", (pygame.K_MINUS, pygame.K_KP_MINUS), "zoom -1", "", CTRL),
        Key("", (pygame.K_b,), "toggle_blocks", ""),
        Key("Ctrl+arrows", (pygame.K_LEFT,), "look -1 0", "look around (also Space + drag)", CTRL),
        Key("", (pygame.K_RIGHT,), "look 1 0", "", CTRL),
        Key("", (pygame.K_UP,), "look 0 -1", "", CTRL),
        Key("", (pygame.K_DOWN,), "look 0 1", "", CTRL),
    ),
    "Scenes and pictures": (
        Key("F2", (pygame.K_F2,), "show_scenes", "gallery of scenes"),
        Key("Ctrl+S", (pygame.K_s,), "save", "save the scene", CTRL),
        Key("Ctrl+O", (pygame.K_o,), "open_scenes", "open a saved scene", CTRL),
        Key("F12", (pygame.K_F12,), "shoot_window", "picture of the window"),
        Key("Shift+F12", (pygame.K_F12,), "shoot_sand", "picture of the sand", SHIFT),
        Key("G", (pygame.K_g,), "record", "record a GIF, until G again"),
        Key("Shift+G", (pygame.K_g,), "record_past", "GIF of the last ten seconds", SHIFT),
    ),
    "Window": (
        Key("Tab, arrows", (), "", "work the panel"),
        Key("P", (pygame.K_p,), "toggle_panel", "hide or show the panel"),
        Key("M", (pygame.K_m,), "toggle_sound", "sound of the sand"),
        Key("F11", (pygame.K_F11,), "toggle_fullscreen", "full screen"),
        Key("F1 or ?", (pygame.K_F1, pygame.K_QUESTION), "toggle_help", "this page"),
        Key("Esc", (pygame.K_ESCAPE,), "escape", "close, leave; twice: quit"),
    ),
}
KEYS = tuple(key for keys in GROUPS.values() for key in keys)
REPEATING = {  # again while a key is held
    *("step", "faster", "slower", "smaller_brush", "larger_brush", "undo", "redo"),
    *("zoom 1", "zoom -1", "look -1 0", "look 1 0", "look 0 -1", "look 0 1"),
}
_COMMANDS = {(code, key.mods): key.command for key in KEYS for code in key.codes}
_BY_TEXT = {"?": "toggle_help", "+": "faster", "-": "slower", "[": "smaller_brush", "]": "larger_brush", ".": "step"}


def command(event):
    """Return the command that a KEYDOWN event gives, or None."""
    if event.mod & ALT_GR:
        return _BY_TEXT.get(event.unicode)
    if event.mod & pygame.KMOD_ALT:
        return None
    ctrl, shift = CTRL if event.mod & CTRL else 0, SHIFT if event.mod & SHIFT else 0
    if ctrl:
        return _COMMANDS.get((event.key, ctrl | shift))
    found = _BY_TEXT.get(event.unicode) or _COMMANDS.get((event.key, shift))
    return found or _COMMANDS.get((event.key, 0))
