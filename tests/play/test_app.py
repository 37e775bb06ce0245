"""The window, driven by events as a person gives them, under the dummy video driver."""

import numpy as np
import pygame
import pytest

from game import Rule
from game.core.draw.looks import EDGE, RIM, WALL, WOOD, WOOD_EDGE, WOOD_RIM
from game.world.scenes.scene import load_scene
from game.world.sessions.action import SetRule
from game.world.sessions.session import Session
from tests.play.player import FRAME_NS


def test_sand_appears_where_the_pointer_went_and_the_stroke_has_no_gaps(player):
    player.hold_time()
    player.drag(player.pixel(10, 10), player.pixel(100, 70))
    sand = player.world.sand
    for share in np.linspace(0, 1, 400):
        assert sand[int(10.5 + 60 * share), int(10.5 + 90 * share)]
    assert not sand[70, 20] and not sand[20, 80]


def test_a_pointer_that_jumps_in_many_steps_paints_every_cell_between(player):
    player.hold_time()
    player.parts.brush.diameter = 1
    player.drag(*(player.pixel(x, y) for x, y in [(5, 5), (100, 8), (100, 80), (7, 33)]))
    rows, columns = np.nonzero(player.world.sand)
    reached = {(5, 5)}
    waiting = [(5, 5)]
    cells = set(zip(columns.tolist(), rows.tolist(), strict=True))
    while waiting:
        x, y = waiting.pop()
        near = {(x + dx, y + dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1)} & cells - reached
        reached |= near
        waiting += near
    assert reached == cells and (7, 33) in cells and (100, 80) in cells


def test_a_held_brush_keeps_pouring(player):
    player.button(pygame.MOUSEBUTTONDOWN, player.pixel(60, 20))
    player.wait(5)
    few = player.world.grains
    player.wait(30)
    assert player.world.grains > few > 0
    player.button(pygame.MOUSEBUTTONUP, player.pixel(60, 20))
    some = player.world.grains
    player.wait(10)
    assert player.world.grains == some


def test_the_right_button_erases_whatever_the_tool(player):
    player.hold_time()
    player.key(pygame.K_w, "w")
    player.drag(player.pixel(20, 40), player.pixel(90, 40))
    assert player.world.walls[40, 50]
    player.drag(player.pixel(50, 20), player.pixel(50, 60), button=3)
    assert not player.world.walls[40, 50] and player.world.walls[40, 30]


def test_sand_leaves_walls_standing_unless_asked(player):
    player.hold_time()
    player.key(pygame.K_w, "w")
    player.drag(player.pixel(50, 40), player.pixel(70, 40))
    walls = player.world.walls
    player.key(pygame.K_s, "s")
    player.drag(player.pixel(60, 30), player.pixel(60, 50))
    assert (player.world.walls == walls).all() and player.world.sand.any()
    player.parts.brush.over_walls = True
    player.drag(player.pixel(60, 30), player.pixel(60, 50))
    assert player.world.sand[40, 60] and not player.world.walls[40, 60]


def test_the_eraser_takes_sand_and_walls(player):
    player.hold_time()
    player.drag(player.pixel(20, 20), player.pixel(60, 20))
    player.key(pygame.K_x, "x")
    player.drag(player.pixel(20, 20), player.pixel(60, 20))
    assert player.world.grains == 0


def test_keys_choose_tool_and_size(player):
    for code, tool in ((pygame.K_w, "wall"), (pygame.K_x, "erase"), (pygame.K_s, "sand")):
        player.key(code)
        assert player.parts.brush.material == tool
    before = player.parts.brush.diameter
    player.key(pygame.K_RIGHTBRACKET, "]")
    assert player.parts.brush.diameter == before + 1
    player.key(pygame.K_LEFTBRACKET, "[")
    player.pointer = player.pixel(60, 40)
    player.frame(pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=-2, flipped=False))
    assert player.parts.brush.diameter == before - 2


@pytest.mark.parametrize("mod", [pygame.KMOD_RALT, pygame.KMOD_MODE, pygame.KMOD_RALT | pygame.KMOD_LCTRL])
def test_brackets_that_a_layout_types_with_alt_gr_are_heard(player, mod):
    before = player.parts.brush.diameter
    player.key(pygame.K_9, "]", mod)
    assert player.parts.brush.diameter == before + 1
    player.key(pygame.K_8, "[", mod)
    assert player.parts.brush.diameter == before


def test_alt_alone_gives_no_command(player):
    before = player.parts.brush.diameter
    player.key(pygame.K_RIGHTBRACKET, "]", pygame.KMOD_LALT)
    assert player.parts.brush.diameter == before


def test_space_holds_time_and_a_period_steps_one_iteration(glass):
    glass.key(pygame.K_SPACE, " ")
    at = glass.world.iteration
    glass.wait(20)
    assert glass.world.iteration == at
    glass.key(pygame.K_PERIOD, ".")
    assert glass.world.iteration == at + 1
    glass.key(pygame.K_SPACE, " ")
    glass.wait(20)
    assert glass.world.iteration > at + 20


def test_f_turns_the_glass_over_exactly_while_time_stands_still(glass):
    glass.wait(30)
    sand, walls, at = glass.world.sand, glass.world.walls, glass.world.iteration
    glass.frame(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_f, unicode="f", mod=0), elapsed_ns=0)
    assert (glass.world.sand == sand[::-1, ::-1]).all() and (glass.world.walls == walls[::-1, ::-1]).all()
    glass.frame()
    assert glass.world.iteration <= at + 4
    glass.now_s += 1e6  # the turn is over
    glass.wait(10)
    assert glass.world.iteration > at + 10 and glass.world.grains == sand.sum()


def test_r_starts_the_scene_again(glass):
    start = glass.session.scene.world(0).digest()
    glass.wait(30)
    glass.session.paused = True
    glass.key(pygame.K_r, "r")
    assert glass.world.digest() == start


def test_r_leaves_friction_and_speed_as_they_were_set_and_one_undo_takes_it_back(glass):
    glass.parts.sessions.do(SetRule(Rule.with_p(0.2)))
    glass.session.clock.speed = 333.0
    glass.wait(20)
    glass.hold_time()
    before = glass.world.digest()
    glass.key(pygame.K_r, "r")
    assert glass.world.iteration == 0 and glass.session.rule == Rule.with_p(0.2) and glass.session.clock.speed == 333
    glass.session.undo()
    assert glass.world.digest() == before


def test_c_takes_the_sand_and_leaves_the_walls(glass):
    walls = glass.world.walls
    glass.key(pygame.K_c, "c")
    assert glass.world.grains == 0 and (glass.world.walls == walls).all()


def test_plus_and_minus_change_the_speed(glass):
    before = glass.session.clock.speed
    glass.key(pygame.K_PLUS, "+")
    assert glass.session.clock.speed > before
    glass.key(pygame.K_MINUS, "-")
    assert glass.session.clock.speed == pytest.approx(before)


def test_escape_closes_what_is_open_and_never_quits(glass):
    parts, own = glass.parts, glass.session
    shown = "help", "cursor", "plots", "forecast", "fullscreen"
    for command in (*(f"view.toggle_{each}" for each in shown), "sand.compare"):
        parts.commands.give(command)
        glass.wait(2)
    parts.stats_card.toggle()
    for _ in range(12):
        glass.key(pygame.K_ESCAPE)
    is_open = parts.help.shown, parts.cursor.on, parts.plots.shown, parts.forecasting.shown, parts.stats_card.kept
    assert not any(is_open) and not parts.window.fullscreen
    assert parts.sessions.now is own and parts.running
    assert "Ctrl+Q quits" in parts.notices.text


def test_ctrl_q_quits(glass):
    glass.key(pygame.K_q, "q", pygame.KMOD_LCTRL)
    assert not glass.parts.running


def test_the_p_slider_sets_both_topples(glass):
    glass.click(glass.control("p", 0.999))
    assert glass.session.rule.topple_left == glass.session.rule.topple_right == 1.0
    glass.drag(glass.control("p", 0.9), glass.control("p", 0.3), glass.control("p", 0.0))
    assert glass.session.rule.topple_left == glass.session.rule.topple_right == 0.0


def test_the_bias_slider_leans_the_topples(glass):
    glass.click(glass.control("Bias, schedule and file"))
    p = glass.session.rule.p
    glass.click(glass.control("Bias", 0.0))
    assert (glass.session.rule.topple_left, glass.session.rule.topple_right) == (p, 0.0)
    glass.click(glass.control("Bias", 0.999))
    assert (glass.session.rule.topple_left, glass.session.rule.topple_right) == (0.0, p)


def test_p_at_zero_does_not_forget_the_bias(glass):
    glass.click(glass.control("Bias, schedule and file"))
    glass.click(glass.control("Bias", 0.0))
    glass.click(glass.control("p", 0.0))
    glass.click(glass.control("p", 0.999))
    assert (glass.session.rule.topple_left, glass.session.rule.topple_right) == (1.0, 0.0)


def test_every_probability_has_its_slider(glass):
    glass.click(glass.control("All seven probabilities"))
    for name in ("topple_left", "topple_right", "fall_pair", "fall_low_left", "fall_full_right"):
        label = name.replace("_", " ").capitalize()
        glass.click(glass.control(label, 0.0))
        assert getattr(glass.session.rule, name) == 0.0, name


def test_less_p_makes_the_pile_thinner():
    widths = {}
    for p in (0.1, 1.0):
        session = Session(load_scene("hourglass"))
        session.do(SetRule(Rule.with_p(p, "balanced")))
        for _ in range(200):
            session.frame(FRAME_NS)
        lower = session.world.sand[session.world.shape[0] * 3 // 4 :]
        widths[p] = lower.any(axis=0).sum()
    assert 0 < widths[0.1] < widths[1.0]


def test_the_scene_list_loads_another_scene(glass):
    glass.click(glass.control("Scene"))
    glass.click(glass.parts.panel.ui.parts("Scene")[1].center)
    assert glass.session.scene.name == "paper" and glass.world.shape == (61, 61)


def test_resizing_the_window_does_not_touch_the_sand(glass):
    glass.session.paused = True
    before = glass.world.digest()
    for size in ((640, 480), (1600, 900), (701, 533)):
        pygame.display.set_mode(size, pygame.RESIZABLE, 32)
        glass.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
        view = glass.parts.display.sand_view.view
        assert view.left >= 0 and view.top >= 0
        area = glass.parts.display.layout.sand
        assert view.left + view.width <= area.right and view.top + view.height <= area.bottom
    assert glass.world.digest() == before


def test_an_idle_frame_draws_nothing(glass):
    glass.session.paused = True
    glass.wait(40)
    assert not any(glass.frame() for _ in range(10))


def test_what_is_drawn_is_the_world(glass):
    glass.parts.settings["smooth_streams"] = False
    glass.session.paused = True
    glass.wait(2)
    surface, world = glass.parts.window.surface, glass.world
    colours = glass.parts.display.colours
    for row, column in np.random.default_rng(0).integers((0, 0), world.shape, (300, 2)):
        found = surface.get_at(glass.pixel(column, row))[:3]
        near = {look for look, (dark, light) in colours.looks("glass").items() if dark <= found <= light}
        looks = (
            colours.sand
            if world.sand[row, column]
            else colours.air
            if not world.walls[row, column]
            else (WOOD, WOOD_RIM, WOOD_EDGE, WALL, RIM, EDGE)
        )
        assert near & set(looks), (row, column)


def test_the_window_and_the_bare_session_move_the_same_sand(glass):
    bare = Session(load_scene("hourglass"))
    glass.wait(100)
    while bare.world.iteration < glass.world.iteration:
        bare.step()
    assert bare.world.digest() == glass.world.digest()


def test_the_panel_can_be_hidden(glass):
    wide = glass.parts.display.layout.sand.width
    glass.key(pygame.K_p, "p")
    assert glass.parts.display.layout.sand.width == 900 > wide
    glass.click((850, 300))
    assert glass.parts.running
    glass.key(pygame.K_p, "p")
    assert glass.parts.display.layout.sand.width == wide


def test_closing_the_window_ends_the_loop(glass):
    glass.frame(pygame.event.Event(pygame.QUIT))
    assert not glass.parts.running


def test_nothing_of_the_outline_stays_behind(glass):
    rng = np.random.default_rng(5)
    for number in range(60):
        glass.session.paused = number % 3 == 0
        glass.parts.brush.diameter = int(rng.integers(1, 60))
        glass.pointer = tuple(int(part) for part in rng.integers((-20, -20), (700, 720)))
        glass.frame()
    glass.session.paused, glass.pointer = True, None
    glass.frame()
    shown = pygame.surfarray.array2d(glass.parts.window.surface)
    glass.parts.display.sand_view.refresh()
    glass.frame()
    fresh = pygame.surfarray.array2d(glass.parts.window.surface)
    area = glass.parts.display.layout.sand
    assert (shown[: area.width, : area.height] == fresh[: area.width, : area.height]).all()


def test_the_help_page_leaves_no_trace(glass):
    glass.session.paused = True
    glass.wait(2)
    before = pygame.surfarray.array2d(glass.parts.window.front)
    glass.key(pygame.K_F1)
    assert (pygame.surfarray.array2d(glass.parts.window.front) != before).any()
    glass.key(pygame.K_F1)
    area = glass.parts.display.layout.sand
    after = pygame.surfarray.array2d(glass.parts.window.front)
    assert (after[: area.width, : area.height] == before[: area.width, : area.height]).all()


def test_a_kernel_cache_that_cannot_be_kept_is_told_once_in_a_quiet_line(player, monkeypatch):
    monkeypatch.setattr("game.play.app.cache_trouble", lambda: "kernels cannot be kept: the disk is full")
    player.wait(2)
    assert player.parts.notices.text == "kernels cannot be kept: the disk is full"
    player.parts.notices.say("something else")
    player.wait(3)
    assert player.parts.notices.text == "something else"
