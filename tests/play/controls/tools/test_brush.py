"""The tools in the player's hands: what each draws, how it is taken back, and that a finger does as the mouse does."""

from dataclasses import replace

import numpy as np
import pygame
import pytest

from game import Rule
from game.play.controls.tools.brush import SIZES, TOOLS
from game.world.sand.fixtures import Fixture
from game.world.sessions.action import Paint, SetRule
from game.world.sessions.recording import parse
from game.world.sessions.session import Session
from tests.saved import recording_of, to_bytes
from tests.sweeps import sweep

KEYS = {
    "brush": (pygame.K_d, 0),
    "line": (pygame.K_n, 0),
    "rectangle": (pygame.K_u, 0),
    "ellipse": (pygame.K_o, 0),
    "fill": (pygame.K_v, 0),
    "spray": (pygame.K_a, 0),
    "replace": (pygame.K_y, 0),
    "pick": (pygame.K_i, 0),
    "tap": (pygame.K_j, 0),
    "drain": (pygame.K_z, 0),
    "select": (pygame.K_s, pygame.KMOD_SHIFT),
    "stamp": (pygame.K_v, pygame.KMOD_CTRL),
    "ruler": (pygame.K_m, pygame.KMOD_SHIFT),
}


@pytest.fixture
def still(player):
    """Return a player of the blank scene for whom time stands still."""
    player.hold_time()
    return player


@pytest.fixture
def shift():
    pygame.key.set_mods(pygame.KMOD_LSHIFT)
    yield
    pygame.key.set_mods(pygame.KMOD_NONE)


def acts(player):
    return player.session.timeline.history.story()


def take(player, tool, diameter=1):
    if tool == "stamp":
        select(player, (5, 55), (40, 75))
        player.key(pygame.K_c, mod=pygame.KMOD_CTRL)
    code, mod = KEYS[tool]
    player.key(code, mod=mod)
    player.parts.brush.diameter = diameter


def select(player, one, other):
    player.key(pygame.K_s, mod=pygame.KMOD_SHIFT)
    player.drag(player.pixel(*one), player.pixel(*other))


def box_of(cells):
    rows, columns = np.nonzero(cells)
    return int(columns.min()), int(rows.min()), int(columns.max()) + 1, int(rows.max()) + 1


def test_number_keys_give_sizes_and_letters_give_tools(still):
    for number, size in enumerate(SIZES):
        still.key(pygame.K_1 + number, str(number + 1))
        assert still.parts.brush.diameter == size
    for tool in KEYS:
        take(still, tool)
        assert still.parts.brush.tool == tool


@sweep("tool", TOOLS, keep=["replace", "stamp", "drain", "pick"])
def test_undo_after_a_tool_gives_back_the_world_before_it(still, tool):
    still.parts.brush.material = "wall"
    still.drag(still.pixel(5, 60), still.pixel(110, 70))
    still.parts.brush.material = "sand"
    still.drag(still.pixel(20, 20), still.pixel(60, 25))
    before = still.world.digest()
    take(still, tool, 9)
    still.parts.brush.material = "wall"
    still.drag(still.pixel(30, 22), still.pixel(40, 30), still.pixel(70, 66))
    assert (still.world.digest() != before) == (tool not in ("pick", "select", "ruler"))
    if still.world.digest() != before:
        still.key(pygame.K_z, mod=pygame.KMOD_CTRL)
    assert still.world.digest() == before
    assert still.session.account.balanced(still.world)


@sweep("tool", TOOLS, keep=["brush", "stamp", "tap", "ellipse"])
def test_what_a_tool_did_is_told_by_the_replay(player, tool):
    player.drag(player.pixel(20, 20), player.pixel(60, 25))
    take(player, tool, 5)
    player.drag(player.pixel(30, 22), player.pixel(50, 40), player.pixel(70, 66))
    player.wait(3)
    recording, _ = parse(to_bytes(recording_of(player.session)), "file")
    told = Session.retold(recording)
    told.seek(recording.end)
    assert told.world.digest() == player.world.digest()
    assert told.account == player.session.account and told.account.balanced(told.world)


def test_a_line_waits_for_the_release_and_is_one_act(still):
    take(still, "line", 3)
    still.button(pygame.MOUSEBUTTONDOWN, still.pixel(10, 10))
    still.move(still.pixel(90, 70))
    still.wait(3)
    assert still.world.grains == 0 and not acts(still)
    still.move(still.pixel(60, 10))
    still.button(pygame.MOUSEBUTTONUP, still.pixel(60, 10))
    assert len(acts(still)) == 1 and box_of(still.world.sand) == (9, 9, 62, 12)


def test_escape_lets_go_of_a_line_that_was_not_meant(still):
    take(still, "line", 3)
    still.button(pygame.MOUSEBUTTONDOWN, still.pixel(10, 10))
    still.move(still.pixel(90, 70))
    still.key(pygame.K_ESCAPE)
    still.button(pygame.MOUSEBUTTONUP, still.pixel(60, 10))
    assert not acts(still) and still.parts.running


def test_shift_makes_the_brush_draw_straight(still, shift):
    still.parts.brush.diameter = 1
    still.drag(still.pixel(10, 10), still.pixel(20, 50), still.pixel(70, 10))
    assert box_of(still.world.sand) == (10, 10, 71, 11) and len(acts(still)) == 1


def test_shift_holds_lines_to_45_degrees_and_sides_alike(still, shift):
    take(still, "line")
    still.drag(still.pixel(10, 10), still.pixel(50, 47))
    assert (np.diff(np.nonzero(still.world.sand), axis=0) == 0).all()
    still.key(pygame.K_c, "c")
    for tool in ("rectangle", "ellipse"):
        take(still, tool)
        still.drag(still.pixel(60, 50), still.pixel(30, 41))
        assert box_of(still.world.sand) == (30, 20, 61, 51)
        still.key(pygame.K_c, "c")


def test_a_rectangle_reaches_from_corner_to_corner(still):
    take(still, "rectangle", 4)
    still.drag(still.pixel(50, 40), still.pixel(20, 10))
    assert still.world.grains == 31 * 31 and box_of(still.world.sand) == (20, 10, 51, 41)
    still.key(pygame.K_c, "c")
    still.key(pygame.K_u, mod=pygame.KMOD_LSHIFT)
    still.drag(still.pixel(50, 40), still.pixel(20, 10))
    assert still.world.grains == 31 * 31 - 23 * 23 and not still.world.sand[25, 35]


def test_a_fill_stops_at_walls(still):
    still.parts.brush.material, still.parts.brush.edge_only = "wall", True
    take(still, "rectangle")
    still.parts.brush.edge_only = True
    still.drag(still.pixel(20, 10), still.pixel(50, 40))
    still.parts.brush.material = "sand"
    take(still, "fill")
    still.click(still.pixel(30, 30))
    assert still.world.grains == 29 * 29
    still.parts.brush.material = "wall"
    still.click(still.pixel(30, 30))
    assert still.world.grains == 0 and still.world.walls.sum() == 31 * 31


def test_replace_changes_only_what_it_began_on(still):
    take(still, "brush", 5)
    still.drag(still.pixel(20, 20), still.pixel(60, 20))
    take(still, "replace", 9)
    still.parts.brush.material = "wall"
    sand = still.world.sand
    still.drag(still.pixel(30, 20), still.pixel(90, 30))
    walls = still.world.walls
    assert walls.any() and not (walls & ~sand).any()
    still.parts.brush.material = "sand"
    still.drag(still.pixel(30, 20), still.pixel(90, 30))
    assert (still.world.sand == sand).all()


def test_pick_takes_what_is_there_and_gives_the_tool_back(still):
    still.parts.brush.material = "wall"
    still.drag(still.pixel(20, 20), still.pixel(30, 20))
    take(still, "line")
    for place, material in ((50, "erase"), (25, "wall")):
        still.parts.brush.material = "sand"
        still.key(pygame.K_i)
        still.click(still.pixel(place, 20))
        assert (still.parts.brush.material, still.parts.brush.tool) == (material, "line")


def test_a_spray_that_rests_grows_denser(still):
    take(still, "spray", 30)
    still.button(pygame.MOUSEBUTTONDOWN, still.pixel(50, 40))
    few = still.world.grains
    still.wait(10)
    assert 0 < few < 100 < still.world.grains < 700


def test_a_stroke_whose_beginning_was_lost_is_taken_back_without_the_one_before(still, monkeypatch):
    still.drag(still.pixel(20, 20), still.pixel(60, 25))
    grains = still.world.grains
    with monkeypatch.context() as way:
        way.setattr(still.parts.sessions, "ready", lambda: False)
        still.button(pygame.MOUSEBUTTONDOWN, still.pixel(20, 60))
    still.move(still.pixel(60, 65))
    still.button(pygame.MOUSEBUTTONUP, still.pixel(60, 65))
    assert still.world.grains > grains
    still.key(pygame.K_z, "", pygame.KMOD_CTRL)
    assert still.world.grains == grains


def test_a_finger_paints_as_the_mouse_does_and_not_twice(still):
    def both(kind, finger, place):
        x, y = still.pixel(*place)
        wide, high = still.parts.window.size
        still.pointer = x, y
        still.frame(
            pygame.event.Event(finger, touch_id=1, finger_id=0, x=x / wide, y=y / high, dx=0.0, dy=0.0),
            pygame.event.Event(kind, pos=(x, y), rel=(0, 0), buttons=(1, 0, 0), button=1, touch=True),
        )

    take(still, "line", 3)
    both(pygame.MOUSEBUTTONDOWN, pygame.FINGERDOWN, (10, 10))
    both(pygame.MOUSEMOTION, pygame.FINGERMOTION, (60, 40))
    both(pygame.MOUSEBUTTONUP, pygame.FINGERUP, (60, 40))
    ends = [still.parts.display.sand_view.view.place(*still.pixel(*cell)) for cell in ((10, 10), (60, 40))]
    assert [entry.what for entry in acts(still)] == [Paint("sand", *ends, 3)]
    assert still.session.account.painted == still.world.grains


def test_marks_of_a_gesture_leave_no_trace(still):
    for tool in TOOLS:
        take(still, tool, 12)
        still.button(pygame.MOUSEBUTTONDOWN, still.pixel(20, 20))
        for place in ((90, 80), (119, 5), (40, 40)):
            still.move(still.pixel(*place))
        still.button(pygame.MOUSEBUTTONUP, still.pixel(40, 40))
    still.pointer = None
    still.frame()
    shown = pygame.surfarray.array2d(still.parts.window.surface)
    still.parts.display.sand_view.refresh()
    still.frame()
    area = still.parts.display.layout.sand
    fresh = pygame.surfarray.array2d(still.parts.window.surface)
    assert (shown[: area.width, : area.height] == fresh[: area.width, : area.height]).all()


def test_the_panel_chooses_tools_by_mouse_and_by_keyboard(still):
    for number, tool in enumerate(each for each in TOOLS if each != "ruler"):  # which stands with what measures
        still.click(still.parts_of("Tool")[number].center)
        assert still.parts.brush.tool == tool
    still.pointer = None
    for code, tool in (
        (pygame.K_HOME, "brush"),
        (pygame.K_RIGHT, "line"),
        (pygame.K_DOWN, "spray"),
        (pygame.K_UP, "line"),
    ):
        still.key(code)
        assert still.parts.brush.tool == tool


def test_taps_and_drains_are_put_moved_and_erased(still):
    take(still, "tap", 5)
    still.parts.brush.every = 3
    still.click(still.pixel(60, 10))
    take(still, "drain", 8)
    still.click(still.pixel(60, 85))
    tap, drain = Fixture("tap", 58, 10, 5, 1, 3), Fixture("drain", 57, 85, 8, 1, 1)
    assert still.world.fixtures == (tap, drain)
    still.drag(still.pixel(59, 10), still.pixel(40, 30), still.pixel(39, 20))
    assert still.world.fixtures == (drain, replace(tap, x=38, y=20))
    still.key(pygame.K_z, mod=pygame.KMOD_CTRL)
    assert still.world.fixtures == (tap, drain)
    still.click(still.pixel(60, 10))
    assert len(acts(still)) == 2
    still.drag(still.pixel(60, 8), still.pixel(60, 12), button=3)
    assert still.world.fixtures == (drain,)


def test_a_tap_pours_and_a_drain_swallows_in_the_window(player):
    for tool, row in (("tap", 10), ("drain", 80)):
        take(player, tool, 5)
        player.click(player.pixel(60, row))
    player.wait(60)
    account = player.session.account
    assert account.poured > account.swallowed > 0 and account.balanced(player.world)
    drawn = pygame.surfarray.array2d(player.parts.window.surface)
    player.key(pygame.K_SPACE, " ")
    player.drag(player.pixel(50, 80), player.pixel(70, 80), button=3)
    assert (pygame.surfarray.array2d(player.parts.window.surface) != drawn).any() and len(player.world.fixtures) == 1


def test_quarter_turns_turn_the_table_and_back(glass):
    glass.parts.settings["reduced_motion"] = True
    glass.session.paused = True
    before, (height, width) = glass.world.digest(), glass.world.shape
    glass.key(pygame.K_f, "F", pygame.KMOD_LSHIFT)
    assert glass.world.shape == (width, height) and glass.parts.display.sand_view.view.shape == (width, height)
    glass.key(pygame.K_f, mod=pygame.KMOD_CTRL)
    assert glass.world.digest() == before
    for _ in range(4):
        glass.key(pygame.K_f, "F", pygame.KMOD_LSHIFT)
    assert glass.world.digest() == before and glass.session.account.balanced(glass.world)


def test_a_turn_of_the_table_is_seen_to_go_round(glass):
    glass.session.paused = True
    glass.key(pygame.K_f, "F", pygame.KMOD_LSHIFT)
    assert glass.parts.display.sand_view.turn and not glass.parts.display.sand_view.turn.over(glass.now_s)
    glass.now_s += 1e6
    glass.wait(2)
    assert glass.parts.display.sand_view.turn is None


def test_q_and_e_tilt_the_table_in_steps_that_meet_at_0(still):
    for code, wanted in (
        (pygame.K_e, 0.1),
        (pygame.K_e, 0.2),
        (pygame.K_q, 0.1),
        (pygame.K_q, 0.0),
        (pygame.K_q, -0.1),
    ):
        still.key(code)
        assert still.session.rule.bias == pytest.approx(wanted)
    still.session.do(SetRule(Rule.with_p(0.75, bias=0.04)))
    still.key(pygame.K_q)
    assert still.session.rule.bias == 0.0 and still.session.rule.p == 0.75
    for _ in range(14):
        still.key(pygame.K_e)
    assert still.session.rule.bias == 1.0


def test_a_tilted_table_is_told_of_with_its_side_and_bias(still):
    for code, told in (
        (pygame.K_q, "left: bias -0.1"),
        (pygame.K_e, "level: bias 0"),
        (pygame.K_e, "right: bias +0.1"),
    ):
        still.key(code)
        assert still.parts.notices.text.endswith(told)


def test_a_tilted_table_shows_a_frame_that_goes_with_the_tilt(still, monkeypatch):
    monkeypatch.setattr(still.parts.notices, "say", lambda text: None)
    upright = pygame.surfarray.array2d(still.parts.window.surface)
    still.key(pygame.K_e)
    area = still.parts.display.layout.sand
    sand = slice(0, area.width), slice(0, area.height)
    assert (pygame.surfarray.array2d(still.parts.window.surface)[sand] != upright[sand]).any()
    still.key(pygame.K_q)
    assert (pygame.surfarray.array2d(still.parts.window.surface)[sand] == upright[sand]).all()


def test_keys_alone_draw_a_whole_picture(still):
    def go(*ways, mod=0):
        for way in ways:
            still.key(getattr(pygame, f"K_{way}"), mod=mod)

    far = pygame.KMOD_LSHIFT
    still.key(pygame.K_k, "k")
    go("LEFT", "LEFT", "UP", mod=far)  # from the middle (60, 45) to (40, 35)
    still.key(pygame.K_w, "w")
    still.key(pygame.K_1, "1")
    still.key(pygame.K_n, "n")
    still.press(pygame.K_RETURN)
    go("RIGHT", "RIGHT", "RIGHT", mod=far)
    go("RIGHT", "DOWN")
    still.release(pygame.K_RETURN)
    walls = still.world.walls
    assert walls[35, 40] and walls[36, 71] and len(acts(still)) == 1
    still.key(pygame.K_s, "s")
    still.key(pygame.K_d, "d")
    go("UP", mod=far)
    still.press(pygame.K_RETURN)
    go("LEFT", "LEFT", "LEFT")
    still.release(pygame.K_RETURN)
    assert still.world.sand[26, 68:72].all() and still.world.grains == 4
    still.key(pygame.K_DELETE)
    assert still.world.grains == 3
    still.key(pygame.K_j, "j")
    still.key(pygame.K_RETURN)
    assert still.world.fixtures == (Fixture("tap", 68, 26, 1, 1, 4),)
    go("DOWN", "DOWN", mod=far)
    still.key(pygame.K_v, "v")
    still.key(pygame.K_RETURN)
    assert still.world.grains == 120 * 90 - walls.sum()
    assert still.session.account.balanced(still.world)
    still.key(pygame.K_k, "k")
    still.key(pygame.K_RETURN)
    assert sum(not entry.join for entry in acts(still)) == 5


def test_the_cursor_leaves_the_panel_its_keys_once_tab_has_led_there(still):
    still.key(pygame.K_k, "k")
    still.key(pygame.K_TAB)
    cursor = still.parts.cursor.place
    still.key(pygame.K_DOWN)
    assert still.parts.cursor.place == cursor
    still.key(pygame.K_ESCAPE)  # closes the list that the arrow opened
    still.key(pygame.K_ESCAPE)  # leaves the panel
    still.key(pygame.K_DOWN)
    assert still.parts.cursor.place == (cursor[0], cursor[1] + 1)
