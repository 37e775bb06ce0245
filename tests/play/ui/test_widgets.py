"""The panel's laws: the mouse gets what it points at, the keyboard reaches all, nothing overlaps, idle is free."""

import itertools
import random
from unittest import mock

import pygame
import pytest

from game.play.ui.theme import Theme
from game.play.ui.widgets import Ui
from game.world.sand import parameters
from tests.play.ui.sample_panel import PARAGRAPH, SCENES, WIDTH, Panel, down, key, move, up, wheel
from tests.sweeps import sweep

SCALES = (0.75, 1.0, 1.5, 3.0)
OUTSIDE = (700, 200)
THEMES = Theme(1.0), Theme(1.03)


# --- the mouse ---


@pytest.mark.parametrize("scale", SCALES)
def test_a_drag_sets_the_slider_to_the_value_under_the_pointer(scale):
    panel = Panel(scale, height=2160)
    panel.frame(down(panel.spot("p", 0.25)))
    assert panel.p == pytest.approx(0.25, abs=0.01)
    panel.frame(move(panel.spot("p", 0.75)))
    assert panel.p == pytest.approx(0.75, abs=0.01)
    assert panel.p == round(panel.p, 2)


def test_a_drag_goes_on_outside_of_the_panel_and_ends_at_the_release():
    panel = Panel()
    panel.frame(down(panel.spot("p", 0.5)))
    assert panel.frame(move((OUTSIDE[0], 5))) == []
    assert panel.p == 1.0
    assert panel.ui.focus.owns(OUTSIDE)
    panel.frame(move((-40, 800)))
    assert panel.p == 0.0
    assert panel.frame(up((-40, 800))) == []
    rest = panel.frame(move(OUTSIDE))
    assert len(rest) == 1 and panel.p == 0.0


def test_the_ends_of_a_slider_are_exactly_low_and_high():
    panel = Panel()
    for name, field, each in (("Lean", "bias", parameters.BIAS), ("Speed", "speed", parameters.SPEED)):
        panel.click(panel.spot(name, 0.0))
        assert getattr(panel, field) == each.low
        panel.click(panel.spot(name, 1.0))
        assert getattr(panel, field) == each.high
        panel.now_s += 1


def test_a_double_click_brings_back_the_default():
    panel = Panel()
    panel.click(panel.spot("p", 0.3))
    panel.click(panel.spot("p", 0.3))
    assert panel.p == parameters.P.default
    panel.frame(wait_s=1)
    panel.click(panel.spot("Brush", 0.8))
    panel.click(panel.spot("Brush", 0.8))
    assert panel.brush == 10


def test_two_slow_clicks_are_no_double_click():
    panel = Panel()
    panel.click(panel.spot("p", 0.3))
    panel.frame(wait_s=1)
    panel.click(panel.spot("p", 0.3))
    assert panel.p == pytest.approx(0.3, abs=0.01)


def test_a_value_that_nobody_moved_comes_back_untouched():
    panel = Panel()
    panel.p = 1 / 3
    panel.frame()
    assert panel.p == 1 / 3


def test_a_press_on_the_words_moves_no_slider():
    panel = Panel()
    words = panel.ui.rects["p"].move(8, 0).midleft
    panel.frame(down(words), move(panel.spot("p", 0.9)), up(panel.spot("p", 0.9)))
    assert panel.p == 0.6


def test_a_button_acts_when_released_inside_and_not_otherwise():
    panel = Panel()
    flip = panel.ui.rects["Flip"].center
    panel.frame(down(flip))
    assert panel.pressed == []
    panel.frame(up(flip))
    panel.frame(down(flip), up(OUTSIDE))
    panel.frame(down(panel.ui.rects["Undo"].center), up(flip))
    assert panel.pressed == ["Flip"]


def test_a_button_hears_each_of_two_quick_clicks():
    panel = Panel()
    for _ in range(2):
        panel.click(panel.ui.rects["Flip"].center)
    assert panel.pressed == ["Flip", "Flip"]


def test_a_disabled_button_neither_acts_nor_takes_focus():
    panel = Panel()
    panel.click(panel.ui.rects["Undo"].center)
    assert panel.pressed == [] and panel.ui.focus.name is None
    panel.undo = True
    panel.frame()
    panel.click(panel.ui.rects["Undo"].center)
    assert panel.pressed == ["Undo"]


def test_clicks_switch_toggle_fold_and_segments():
    panel = Panel()
    panel.click(panel.ui.rects["Over walls"].center)
    panel.click(panel.ui.parts("Tool")[2].center)
    panel.click(panel.ui.rects["More"].center)
    assert (panel.over, panel.tool, panel.folded_out) == (True, 2, False)
    assert "Pair" not in panel.ui.rects


# --- who owns an event ---


def test_events_outside_of_the_panel_are_left_to_others():
    panel = Panel()
    mouse = [move(OUTSIDE), wheel(1), down(OUTSIDE), up(OUTSIDE), down(OUTSIDE, 3), up(OUTSIDE, 3)]
    events = [*mouse, key(pygame.K_SPACE), key(pygame.K_ESCAPE)]
    assert panel.frame(*events) == events
    assert not panel.ui.focus.owns(OUTSIDE)


def test_events_over_the_panel_are_its_own():
    panel = Panel()
    here = panel.ui.rects["p"].center
    assert panel.frame(move(here), wheel(1), down(here), up(here), down(here, 3), up(here, 3), down(here, 4)) == []
    assert panel.ui.focus.owns(here)


def test_a_stroke_begun_outside_goes_on_over_the_panel():
    panel = Panel()
    over = panel.ui.rects["p"].center
    stroke = [down(OUTSIDE), move(over), up(over)]
    assert panel.frame(*stroke[:2]) == stroke[:2]
    assert not panel.ui.focus.owns(over)
    assert panel.frame(stroke[2]) == stroke[2:]
    assert panel.p == 0.6


def test_keys_that_do_nothing_for_the_focused_control_are_left_to_others():
    panel = Panel()
    panel.tab_to("p")
    foreign = [key(pygame.K_SPACE, text=" "), key(pygame.K_f, text="f"), key(pygame.K_LEFT, mod=pygame.KMOD_LCTRL)]
    assert panel.frame(*foreign) == foreign
    panel.tab_to("Flip")
    arrow = key(pygame.K_LEFT)
    assert panel.frame(arrow) == [arrow]


def test_space_pushes_a_button_only_when_the_keyboard_brought_the_focus():
    panel = Panel()
    panel.click(panel.ui.rects["Flip"].center)
    space = key(pygame.K_SPACE, text=" ")
    assert panel.frame(space) == [space] and panel.pressed == ["Flip"]
    panel.tab_to("Load")
    assert panel.frame(space) == [] and panel.pressed == ["Flip", "Load"]


def test_escape_drops_the_focus_and_is_the_panel_s_only_once():
    panel = Panel()
    panel.tab_to("p")
    escape = key(pygame.K_ESCAPE)
    assert panel.frame(escape) == [] and panel.ui.focus.name is None
    assert panel.frame(escape) == [escape]


def test_a_press_outside_drops_the_focus():
    panel = Panel()
    panel.click(panel.spot("p"))
    assert panel.ui.focus.name is not None
    panel.click(OUTSIDE)
    assert panel.ui.focus.name is None


def test_one_wheel_notch_scrolls_once_though_it_is_told_twice():
    panel = Panel(height=200)
    panel.frame(move((100, 100)), wheel(-1), down((100, 100), 5), up((100, 100), 5))
    once = panel.ui.focus.scroll.offset
    panel.frame(wheel(-1))
    assert once > 0 and panel.ui.focus.scroll.offset == 2 * once


# --- the keyboard ---


def test_tab_reaches_every_control_in_order_and_shift_tab_goes_back():
    panel = Panel()
    names = [name for name in panel.ui.rects if name != "Undo"]
    seen = []
    for _ in names:
        panel.type(pygame.K_TAB)
        seen.append(panel.ui.focus.name)
    assert seen == names
    panel.frame(key(pygame.K_TAB, mod=pygame.KMOD_LSHIFT))
    assert panel.ui.focus.name == names[-2]


def test_every_control_works_by_keyboard_alone():
    panel = Panel()
    panel.tab_to("Scene")
    panel.type(pygame.K_RETURN, pygame.K_DOWN, pygame.K_DOWN, pygame.K_RETURN)
    panel.tab_to("Flip")
    panel.type(pygame.K_RETURN, pygame.K_SPACE)
    panel.tab_to("p")
    panel.type(pygame.K_RIGHT, pygame.K_UP, pygame.K_LEFT)
    panel.tab_to("Lean")
    panel.type(pygame.K_HOME)
    panel.tab_to("Brush")
    panel.type(pygame.K_END)
    panel.tab_to("Tool")
    panel.type(pygame.K_RIGHT)
    panel.tab_to("Over walls")
    panel.type(pygame.K_SPACE)
    panel.tab_to("More")
    panel.type(pygame.K_LEFT)
    assert (panel.scene, panel.pressed, panel.p, panel.bias) == (2, ["Flip", "Flip"], 0.61, -1.0)
    assert (panel.brush, panel.tool, panel.over, panel.folded_out) == (200, 1, True, False)


def test_shift_makes_arrows_finer_for_fractions_and_coarser_for_whole_numbers():
    panel = Panel()
    panel.tab_to("p")
    panel.frame(key(pygame.K_RIGHT, mod=pygame.KMOD_LSHIFT))
    assert panel.p == 0.601
    panel.type(pygame.K_RIGHT)
    assert panel.p == 0.61
    panel.tab_to("Brush")
    panel.frame(key(pygame.K_RIGHT, mod=pygame.KMOD_LSHIFT))
    assert panel.brush == 10


def test_delete_brings_back_the_default():
    panel = Panel()
    for name in ("p", "Brush"):
        panel.tab_to(name)
        panel.type(pygame.K_DELETE)
    assert (panel.p, panel.brush) == (1.0, 10)


def test_several_keys_in_one_frame_count_one_by_one():
    panel = Panel()
    tab, right, home = key(pygame.K_TAB), key(pygame.K_RIGHT), key(pygame.K_HOME)
    panel.frame(*[tab] * 3, *[right] * 5, tab, home)
    assert (panel.p, panel.bias) == (0.65, -1.0)


def test_the_ring_shows_for_keyboard_focus_only():
    panel = Panel()
    panel.click(panel.spot("p", 0.6))
    panel.frame(move(OUTSIDE))
    by_mouse = pygame.image.tobytes(panel.surface, "RGB")
    panel.frame(key(pygame.K_ESCAPE))
    assert pygame.image.tobytes(panel.surface, "RGB") == by_mouse
    panel.tab_to("p")
    assert pygame.image.tobytes(panel.surface, "RGB") != by_mouse


# --- layout and scrolling ---


@sweep("scale", SCALES, keep=[SCALES[0], SCALES[-1]])
@sweep("height", (480, 720, 1080, 2160), keep=[480, 2160])
@sweep("width", (200, 300, 420), keep=[200, 420])
def test_no_two_controls_overlap_and_none_sticks_out(scale, height, width):
    panel = Panel(scale, height, width)
    rects = panel.ui.rects
    for (one, a), (other, b) in itertools.combinations(rects.items(), 2):
        assert not a.colliderect(b), (one, other)
    for name, rect in rects.items():
        assert panel.rect.left <= rect.left and rect.right <= panel.rect.right, name
        for part in panel.ui.parts(name):
            assert rect.contains(part), name


@sweep("scale", SCALES, keep=[SCALES[0], SCALES[-1]])
@pytest.mark.parametrize("height", (480, 1080))
def test_the_focused_control_is_scrolled_into_view(scale, height):
    panel = Panel(scale, height)
    for _ in range(2 * len(panel.ui.rects)):
        panel.type(pygame.K_TAB)
        assert panel.rect.contains(panel.ui.rects[panel.ui.focus.name]), panel.ui.focus.name


def test_a_scrolled_control_is_hit_where_it_is_seen():
    panel = Panel(height=300)
    panel.frame(move((100, 100)), wheel(-3))
    panel.click(panel.ui.rects["Over walls"].center)
    assert panel.over


def test_the_scroll_bar_can_be_dragged_to_the_end_and_back():
    panel = Panel(height=300)
    bar = panel.rect.right - 3
    panel.frame(down((bar, 10)), move((bar - 200, 900)))
    scroll = panel.ui.focus.scroll
    assert scroll.offset == scroll.limit > 0
    panel.frame(move((bar, -900)), up((bar, -900)))
    assert scroll.offset == 0


def test_a_panel_that_shrinks_is_scrolled_back():
    panel = Panel(height=300)
    panel.frame(move((100, 100)), wheel(-50))
    panel.rect.height = 2000
    panel.frame()
    assert panel.ui.focus.scroll.offset == 0


# --- tips ---


def test_a_tip_appears_after_half_a_second_of_rest_and_goes_with_the_pointer():
    panel = Panel()
    panel.frame(move(panel.ui.rects["p"].center))
    panel.frame(wait_s=0.4)
    assert panel.ui.focus.tipped is None
    panel.frame(wait_s=0.2)
    assert panel.ui.focus.tipped == "p" and panel.ui.dirty
    panel.frame(move(OUTSIDE))
    assert panel.ui.focus.tipped is None and panel.ui.dirty


def test_a_tip_appears_for_the_keyboard_after_the_same_rest():
    panel = Panel()
    panel.tab_to("Flip")
    assert panel.ui.focus.tipped is None
    panel.frame(wait_s=0.6)
    assert panel.ui.focus.tipped == "Flip"
    panel.type(pygame.K_RETURN)
    assert panel.ui.focus.tipped is None


@pytest.mark.parametrize("name", ("Scene", "Flip", "p", "Pair"))
def test_a_tip_stays_inside_the_panel(name):
    panel = Panel(height=480)
    before = panel.surface.copy()
    panel.tab_to(name)
    panel.frame(wait_s=1)
    beside = pygame.Rect(panel.rect.right, 0, 500, 480)
    assert pygame.image.tobytes(panel.surface.subsurface(beside), "RGB") == pygame.image.tobytes(
        before.subsurface(beside), "RGB"
    )


# --- the drop-down list ---


def open_list(panel):
    panel.click(panel.ui.rects["Scene"].center)
    return panel.ui.parts("Scene")


@pytest.mark.parametrize("height", (200, 480, 2160))
def test_the_list_opens_inside_the_panel_and_a_click_chooses(height):
    panel = Panel(height=height)
    rows = open_list(panel)
    assert all(panel.rect.contains(row) for row in rows)
    panel.click(rows[2].center)
    assert panel.scene == 2 and panel.ui.focus.popup is None


def test_press_drag_and_release_chooses_too():
    panel = Panel()
    panel.frame(down(panel.ui.rects["Scene"].center))
    row = panel.ui.parts("Scene")[3].center
    panel.frame(move(row))
    panel.frame(up(row))
    assert panel.scene == 3 and panel.ui.focus.popup is None


def test_the_list_hides_what_it_covers_from_the_mouse():
    panel = Panel()
    rows = open_list(panel)
    flip = panel.ui.rects["Flip"]
    covered = next(row for row in rows if row.colliderect(flip))
    panel.click(covered.clip(flip).center)
    assert panel.pressed == [] and panel.scene == rows.index(covered)


def test_a_press_beside_the_list_only_closes_it():
    panel = Panel(height=300)
    panel.frame(move((5, 5)))
    open_list(panel)
    panel.click((5, 5))
    assert panel.ui.focus.popup is None and panel.scene == 0
    open_list(panel)
    assert len(panel.click(OUTSIDE)) == 2
    assert panel.ui.focus.popup is None


def test_keys_move_in_the_list_and_enter_takes():
    panel = Panel()
    panel.tab_to("Scene")
    panel.type(pygame.K_DOWN, pygame.K_END, pygame.K_RETURN)
    assert panel.scene == len(SCENES) - 1
    panel.type(pygame.K_RETURN, pygame.K_HOME)
    panel.frame(key(pygame.K_r, text="r"))
    panel.type(pygame.K_RETURN)
    assert SCENES[panel.scene] == "Rain"


def test_escape_and_tab_leave_the_list_without_choosing():
    panel = Panel()
    panel.tab_to("Scene")
    assert panel.type(pygame.K_RETURN, pygame.K_END, pygame.K_ESCAPE) == []
    assert panel.scene == 0 and panel.ui.focus.name == "Scene"
    panel.type(pygame.K_RETURN, pygame.K_END, pygame.K_TAB)
    assert panel.scene == 0 and panel.ui.focus.popup is None


def test_a_long_list_scrolls_to_its_last_option():
    panel = Panel(height=480)
    rows = open_list(panel)
    assert len(rows) < len(SCENES)
    panel.frame(move(rows[0].center), wheel(-100))
    panel.click(panel.ui.parts("Scene")[-1].center)
    assert panel.scene == len(SCENES) - 1


# --- drawing ---


def test_nothing_is_drawn_when_nothing_changes():
    panel = Panel()
    panel.frame()
    panel.surface.fill((1, 2, 3))
    for _ in range(3):
        panel.frame(wait_s=0.1)
        assert not panel.ui.dirty
    assert panel.surface.get_at((5, 5))[:3] == (1, 2, 3)


@pytest.mark.parametrize(
    "change",
    (
        lambda panel: setattr(panel, "p", 0.5),
        lambda panel: panel.rect.move_ip(20, 0),
        lambda panel: setattr(panel, "undo", True),
        lambda panel: panel.ui.invalidate(),
        lambda panel: setattr(panel.ui, "theme", type(panel.ui.theme)(2.0)),
        lambda panel: panel.frame(move(panel.ui.rects["p"].center)),
        lambda panel: panel.type(pygame.K_TAB),
    ),
)
def test_a_change_is_drawn_once(change):
    panel = Panel()
    panel.frame()
    assert not panel.ui.dirty
    change(panel)
    if not panel.ui.dirty:
        panel.frame()
    assert panel.ui.dirty
    panel.frame()
    assert not panel.ui.dirty


def test_the_same_events_give_the_same_values_and_pixels():
    def play():
        panel = Panel(height=480)
        panel.frame(move((150, 200)), wheel(-1), wait_s=0.1)
        panel.click(panel.spot("p", 0.4))
        panel.type(pygame.K_TAB, pygame.K_RIGHT, pygame.K_TAB, pygame.K_END)
        panel.frame(wait_s=1)
        return panel.p, panel.bias, panel.speed, pygame.image.tobytes(panel.surface, "RGB")

    assert play() == play()


def any_event(hand, panel):
    """Return something that a hand may do to a panel, or beside it."""
    pos = hand.randrange(-20, panel.rect.right + 60), hand.randrange(0, panel.rect.height)
    keys = pygame.K_TAB, pygame.K_RIGHT, pygame.K_DOWN, pygame.K_RETURN, pygame.K_ESCAPE, pygame.K_SPACE
    return hand.choice((down(pos), up(pos), move(pos), move(pos), wheel(hand.choice((-1, 1))), key(hand.choice(keys))))


def change(panel, hand):
    """Change now and then what a panel shows, and where."""
    change = hand.choice(("undo", "speed", "names", "paragraph", "width", "theme", *[""] * 18))
    if change == "undo":
        panel.undo = not panel.undo
    elif change == "speed":
        panel.speed = hand.choice((30, 30.0))
    elif change == "names":
        panel.names = hand.choice(("Save", "Help")), "Load", "Help"
    elif change == "paragraph":
        panel.paragraph = PARAGRAPH * hand.randrange(1, 4)
    elif change == "width":
        panel.rect.width = hand.choice((WIDTH, WIDTH + 40))
    elif change == "theme":
        panel.ui.theme = hand.choice(THEMES)


@sweep("seed", (2, 3), keep=[3])
def test_a_control_left_as_it_was_is_as_one_laid_out_anew(seed):
    """One panel leaves what it left before wherever it can, another never."""
    hands, seen = (random.Random(seed), random.Random(seed)), ([], [])
    ways = Ui.kept, lambda ui, control, arguments, how: control(ui, *arguments, **how)
    for hand, way, frames in zip(hands, ways, seen, strict=True):
        panel = Panel(height=420)
        with mock.patch.object(Ui, "kept", way):
            for _ in range(60):
                change(panel, hand)
                events = [any_event(hand, panel) for _ in range(hand.choice((0, 0, 1, 2)))]
                rest = panel.frame(*events, wait_s=hand.choice((0, 0.4)))
                values = panel.p, panel.bias, panel.speed, panel.brush, panel.fall_pair, panel.scene, panel.tool
                frames.append((len(rest), [(each, type(each)) for each in values], panel.over, panel.pressed[:]))
                frames[-1] += panel.ui.rects, panel.ui.focus.tipped, pygame.image.tobytes(panel.surface, "RGB")
    for kept, anew in zip(*seen, strict=True):
        assert kept == anew
