"""Which key does what: the one table that the window obeys and that the help shows."""

from typing import NamedTuple

import pygame

CTRL = pygame.KMOD_CTRL | pygame.KMOD_META  # on a Mac, Cmd
SHIFT = pygame.KMOD_SHIFT
NAMED = 1 << 30  # from here on codes are of keys that type nothing
FIRST_ACCENTED, LAST_LATIN = 0xC0, 0x24F  # codes of Latin letters beyond a to z
ALT_GR = pygame.KMOD_RALT | pygame.KMOD_MODE  # by which many a layout types brackets; Windows holds Ctrl down with it


class Key(NamedTuple):
    """A key and the command it gives. The help shows those with a label."""

    label: str
    codes: tuple
    command: str  # a group of `Commands` and a method, then what it is given
    meaning: str
    mods: int = 0  # which of CTRL and SHIFT are to be held with it


GROUPS = {  # what the help shows together; a key without a command is heard elsewhere
    "Time": (
        Key("Space", (pygame.K_SPACE,), "time.pause", "pause, resume"),
        Key(".", (pygame.K_PERIOD,), "time.step", "one iteration"),
        Key("+ -", (pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS), "time.faster", "faster, slower"),
        Key("", (pygame.K_MINUS, pygame.K_KP_MINUS), "time.slower", ""),
        Key("Right", (), "", "hold: fast forward"),
        Key("Shift+Right", (pygame.K_RIGHT,), "time.await_flow", "run to next grain; End: to rest", SHIFT),
        Key("", (pygame.K_END,), "time.settle", ""),
        Key("Shift+End", (pygame.K_END,), "time.run_to", "run to an iteration", SHIFT),
        Key("T", (pygame.K_t,), "time.toggle_timer", "start or stop the timer"),
        Key("Backspace", (), "", "hold: run back (Shift: faster)"),
        Key("Ctrl+Z", (pygame.K_z,), "time.undo", "undo", CTRL),
        Key("Ctrl+Y", (pygame.K_y,), "time.redo", "redo", CTRL),
        Key("", (pygame.K_z,), "time.redo", "", CTRL | SHIFT),
    ),
    "Sand": (
        Key("F", (pygame.K_f,), "sand.flip", "turn the glass over"),
        Key("Shift+F", (pygame.K_f,), "sand.turn 1", "a quarter turn", SHIFT),
        Key("Ctrl+F", (pygame.K_f,), "sand.turn 3", "a quarter back", CTRL),
        Key("Q E", (pygame.K_q,), "sand.tilt -1", "tilt left, right"),
        Key("", (pygame.K_e,), "sand.tilt 1", ""),
        Key("R", (pygame.K_r,), "sand.restart", "restart the scene"),
        Key("C", (pygame.K_c,), "sand.clear", "remove all but walls"),
        Key("H", (pygame.K_h,), "view.toggle_forecast", "forecast"),
        Key("Shift+H", (pygame.K_h,), "sand.compare", "compare worlds", SHIFT),
        Key("F7 F8", (pygame.K_F7,), "view.toggle_differences", "their differences; density"),
        Key("", (pygame.K_F8,), "view.toggle_density", ""),
        Key("L", (pygame.K_l,), "view.toggle_plots", "plots (Shift: save as CSV)"),
        Key("", (pygame.K_l,), "files.save_measures", "", SHIFT),
    ),
    "Tools": (
        Key("Left button", (), "", "use the tool"),
        Key("Right button", (), "", "erase with it"),
        Key("Shift+drag", (), "", "straight, square"),
        Key("D A Y", (pygame.K_d,), "sand.tool brush", "brush, spray, replace"),
        Key("", (pygame.K_a,), "sand.tool spray", ""),
        Key("", (pygame.K_y,), "sand.tool replace", ""),
        Key("N U O", (pygame.K_n,), "sand.tool line", "line, box, ellipse"),
        Key("", (pygame.K_u,), "sand.tool rectangle", ""),
        Key("", (pygame.K_o,), "sand.tool ellipse", ""),
        Key("Shift+U O", (pygame.K_u,), "sand.edge rectangle", "only their outlines", SHIFT),
        Key("", (pygame.K_o,), "sand.edge ellipse", "", SHIFT),
        Key("V I", (pygame.K_v,), "sand.tool fill", "fill, pick"),
        Key("", (pygame.K_i,), "sand.tool pick", ""),
        Key("J Z", (pygame.K_j,), "sand.tool tap", "tap, drain"),
        Key("", (pygame.K_z,), "sand.tool drain", ""),
        Key("Shift+M", (pygame.K_m,), "sand.tool ruler", "ruler: angle and distance", SHIFT),
        Key("K", (pygame.K_k,), "view.toggle_cursor", "keyboard cursor"),
    ),
    "Pieces": (
        Key("Shift+S", (pygame.K_s,), "piece.select", "select; drag it to move it", SHIFT),
        Key("Ctrl+A", (pygame.K_a,), "piece.select_all", "select all", CTRL),
        Key("Ctrl+C X", (pygame.K_c,), "piece.copy", "copy, cut", CTRL),
        Key("", (pygame.K_x,), "piece.cut", "", CTRL),
        Key("Ctrl+V", (pygame.K_v,), "piece.paste", "take what was copied in hand", CTRL),
        Key("Ctrl+Shift+C V", (pygame.K_c,), "files.copy_sand", "copy a picture of the sand; paste one", CTRL | SHIFT),
        Key("", (pygame.K_v,), "piece.paste_picture", "", CTRL | SHIFT),
        Key("Shift+X, Shift+E", (pygame.K_x,), "piece.mirror", "mirror, turn it", SHIFT),
        Key("", (pygame.K_e,), "piece.turn", "", SHIFT),
        Key("Ctrl+K, F3", (pygame.K_k,), "piece.keep", "keep it as a stamp; all stamps", CTRL),
        Key("", (pygame.K_F3,), "files.open_stamps", ""),
        Key("Del", (pygame.K_DELETE,), "piece.erase", "erase what is selected"),
    ),
    "Brush": (
        Key("S W X", (pygame.K_s,), "sand.material sand", "sand, wall, eraser"),
        Key("", (pygame.K_w,), "sand.material wall", ""),
        Key("", (pygame.K_x,), "sand.material erase", ""),
        Key(", Shift+,", (pygame.K_COMMA,), "sand.next_colour 1", "next, previous colour or material"),
        Key("", (pygame.K_COMMA,), "sand.next_colour -1", "", SHIFT),
        Key("1 … 9", (pygame.K_1, pygame.K_KP1), "sand.size 1", "brush of 1, 2, 3, 5, 8 … 55 cells"),
        *(Key("", (pygame.K_1 + more, pygame.K_KP1 + more), f"sand.size {more + 1}", "") for more in range(1, 9)),
        Key("Wheel, [ ]", (pygame.K_LEFTBRACKET,), "sand.smaller_brush", "smaller, larger brush"),
        Key("", (pygame.K_RIGHTBRACKET,), "sand.larger_brush", ""),
        Key("Shift+D", (pygame.K_d,), "sand.next_shape", "round, square, diamond", SHIFT),
    ),
    "View": (
        Key("0, B", (pygame.K_0, pygame.K_KP0), "view.show_all", "whole lattice; next blocks"),
        Key(
            "Ctrl + -",
            (pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS),
            "view.zoom 1",
            "zoom (also Ctrl+wheel)",
            CTRL,
        ),
        Key("", (pygame.K_PLUS, pygame.K_EQUALS), "view.zoom 1", "", CTRL | SHIFT),
        Key("", (pygame.K_MINUS, pygame.K_KP_MINUS), "view.zoom -1", "", CTRL),
        Key("", (pygame.K_b,), "view.toggle_blocks", ""),
        Key("Ctrl+arrows", (pygame.K_LEFT,), "view.look -1 0", "move the view (also Space+drag)", CTRL),
        Key("", (pygame.K_RIGHT,), "view.look 1 0", "", CTRL),
        Key("", (pygame.K_UP,), "view.look 0 -1", "", CTRL),
        Key("", (pygame.K_DOWN,), "view.look 0 1", "", CTRL),
    ),
    "Scenes and pictures": (
        Key("F2", (pygame.K_F2,), "files.show_scenes", "gallery of scenes"),
        Key("Ctrl+N R", (pygame.K_n,), "files.new_canvas", "new canvas; another size for it", CTRL),
        Key("", (pygame.K_r,), "files.resize_canvas", "", CTRL),
        Key("Ctrl+S", (pygame.K_s,), "files.save", "save the scene", CTRL),
        Key("Ctrl+Shift+S", (pygame.K_s,), "files.save_replay", "save the session as a replay", CTRL | SHIFT),
        Key("Ctrl+O", (pygame.K_o,), "files.open_scenes", "open a saved scene", CTRL),
        Key("F12", (pygame.K_F12,), "files.shoot_window", "picture of the window"),
        Key("Shift+F12", (pygame.K_F12,), "files.shoot_sand", "picture of the sand", SHIFT),
        Key("G", (pygame.K_g,), "files.record", "record, until G again"),
        Key("Shift+G", (pygame.K_g,), "files.record_past", "record the last ten seconds", SHIFT),
    ),
    "Window": (
        Key("Tab, arrows", (), "", "use the panel"),
        Key("P", (pygame.K_p,), "view.toggle_panel", "hide or show the panel"),
        Key("Ctrl+PgUp PgDn", (pygame.K_PAGEUP,), "view.turn_tab -1", "its sections", CTRL),
        Key("", (pygame.K_PAGEDOWN,), "view.turn_tab 1", "", CTRL),
        Key("F5", (pygame.K_F5,), "view.toggle_stage", "stage: large, for a class"),
        Key("M", (pygame.K_m,), "view.toggle_sound", "sound of the sand"),
        Key("F11", (pygame.K_F11,), "view.toggle_fullscreen", "full screen"),
        Key("F1 or ?", (pygame.K_F1, pygame.K_QUESTION), "view.toggle_help", "this page"),
        Key("Esc", (pygame.K_ESCAPE,), "view.escape", "close what is open"),
        Key("Ctrl+Q", (pygame.K_q,), "view.quit", "quit", CTRL),
    ),
}
KEYS = tuple(key for keys in GROUPS.values() for key in keys)
REPEATING = {  # again while a key is held
    *("time.step", "time.faster", "time.slower", "time.undo", "time.redo", "sand.smaller_brush", "sand.larger_brush"),
    *("view.zoom 1", "view.zoom -1", "view.look -1 0", "view.look 1 0", "view.look 0 -1", "view.look 0 1"),
}
_COMMANDS = {(code, key.mods): key.command for key in KEYS for code in key.codes}
_BY_TEXT = {
    "?": "view.toggle_help",
    ".": "time.step",
    "+": "time.faster",
    "-": "time.slower",
    "[": "sand.smaller_brush",
    "]": "sand.larger_brush",
}


_LETTERS = {pygame.KSCAN_A + number: pygame.K_a + number for number in range(26)}
_PLACES = _LETTERS | {  # what stands there on a US keyboard
    **{pygame.KSCAN_1 + number: pygame.K_1 + number for number in range(9)},
    pygame.KSCAN_0: pygame.K_0,
    pygame.KSCAN_MINUS: pygame.K_MINUS,
    pygame.KSCAN_EQUALS: pygame.K_EQUALS,
    pygame.KSCAN_LEFTBRACKET: pygame.K_LEFTBRACKET,
    pygame.KSCAN_RIGHTBRACKET: pygame.K_RIGHTBRACKET,
    pygame.KSCAN_COMMA: pygame.K_COMMA,
    pygame.KSCAN_PERIOD: pygame.K_PERIOD,
}


def command(event):
    """Return the command that a KEYDOWN event gives, or None.

    On a layout without Latin letters a key gives the command of its place on a US keyboard.
    """
    if event.mod & ALT_GR:
        return _BY_TEXT.get(event.unicode)
    if event.mod & pygame.KMOD_ALT:
        return None
    place = getattr(event, "scancode", None)
    if LAST_LATIN < event.key < NAMED:
        return _command_of(_PLACES.get(place), event)
    found = _command_of(event.key, event)
    if found or pygame.K_a <= event.key <= pygame.K_z or event.key >= FIRST_ACCENTED:
        return found
    return _command_of(_LETTERS.get(place), event)  # Greek and Hebrew keyboards have signs in place of Q and W


def _command_of(code, event):
    ctrl, shift = CTRL if event.mod & CTRL else 0, SHIFT if event.mod & SHIFT else 0
    if ctrl:
        return _COMMANDS.get((code, ctrl | shift))
    found = _BY_TEXT.get(event.unicode) or _COMMANDS.get((code, shift))
    return found or _COMMANDS.get((code, 0))
