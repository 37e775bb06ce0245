"""The line under the sand: calm, in plain words, and true; all figures are a point of the finger away."""

import pygame
import pytest

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.view.frame_stats import FrameTime, read
from game.play.view.overlays.stats_card import BUSY, FULL
from game.world.sessions.action import Paint
from tests.play.player import Player
from tests.sweeps import sweep

MS = 10**6
BUDGET_MS = 16


def on_time(wanted_ms, other_ms=1.0, share=1.0):
    """Return 15 frames in which moving the sand takes `wanted_ms` each, on a machine that gives them so much of it."""
    moved = min(wanted_ms, max(BUDGET_MS * share - other_ms, 0.5))
    done = int(1000 * moved / wanted_ms)
    frame = FrameTime(
        round((moved + other_ms) / share * MS), round((moved + other_ms) * MS), round(moved * MS), 1000, done
    )
    return [frame] * 15


def late(ms, wanted_ms):
    """Return a frame with `ms` of time to make up for, in which it could move sand for as long as frames last."""
    due = round(1000 * ms / 16.7)
    moved = min(BUDGET_MS - 1, wanted_ms * due / 1000)
    return FrameTime(16 * MS, 16 * MS, round(moved * MS), due, round(1000 * moved / wanted_ms))


def line(player):
    """Return the words of the line and their colour."""
    _, _, words, _, colour, _ = player.parts.status_line.drawing(
        player.parts.display.theme, pygame.Rect(0, 0, 2000, 30), player.session
    )[1]
    return words, colour


@pytest.mark.parametrize("share", [1.0, 0.7])
def test_sand_that_is_too_much_for_the_machine_fills_its_frames(share):
    reading = read(on_time(40, share=share), 0.25)
    assert reading.full and not reading.late and reading.done < reading.due


def test_sand_that_leaves_time_fills_none():
    reading = read(on_time(8), 0.25)
    assert not reading.full and not reading.late and reading.done == reading.due


def test_a_frame_that_came_late_is_not_a_full_one():
    reading = read([*on_time(4)[:2], late(200, 4)], 0.25)
    assert reading.late and not reading.full


def test_a_machine_that_is_busy_elsewhere_does_not_fill_frames():
    reading = read(on_time(10, share=0.4), 0.25)
    assert reading.late and not reading.full


def test_a_window_that_takes_all_the_time_fills_its_frames():
    reading = read([FrameTime(42 * MS, 42 * MS, 2 * MS, 100, 20)] * 6, 0.252)
    assert reading.full


def test_the_line_tells_the_speed_and_the_grains_and_no_more(glass):
    glass.wait(30)
    assert line(glass) == (f"160 iterations a second    {glass.world.grains:,} grains", look.DIM)
    glass.key(pygame.K_SPACE, " ")
    assert line(glass)[0] == f"Paused    {glass.world.grains:,} grains"


def test_the_line_says_when_the_sand_rests(player):
    player.wait(40)
    assert line(player)[0] == "The sand is at rest    0 grains"


def test_of_several_materials_the_line_counts_the_one_in_hand_or_all_where_there_is_none_even_while_time_stands():
    player = Player("kitchen")
    player.hold_time()
    for name in ("sand", "lava", "fire", "wall"):
        player.parts.brush.material = name
        player.wait(30)
        count, what = player.world.where(name).sum(), name
        if name in ("fire", "wall"):
            count, what = player.world.grains, "all materials"
        assert line(player)[0] == f"Paused    {count:,} cells of {what}"
    pygame.display.quit()


def test_too_high_a_speed_is_said_plainly_with_what_is_reached(glass):
    glass.parts.sessions.load("fountain")  # which never comes to rest
    glass.session.clock.speed = 1_000_000
    glass.wait(30)
    words, colour = line(glass)
    assert "of 1,000,000 iterations a second: all this computer can do" in words and colour == look.ACCENT
    glass.parts.stats_card.toggle()
    glass.wait(20)
    assert FULL in " ".join(glass.parts.stats_card.lines)


def test_a_line_that_has_no_room_for_the_reason_says_the_pace_whole(glass):
    glass.parts.sessions.load("fountain")
    glass.session.clock.speed = 1_000_000
    glass.parts.settings.override("ui_scale", 2.0)
    glass.resize((640, 480))
    glass.wait(30)
    width, rect = glass.parts.display.theme.width, glass.parts.display.layout.status_line
    (said,) = ((room, text, size) for room, text, size in glass.written() if rect.contains(room))
    assert said[1].endswith(" of 1,000,000 iterations a second") and width(*said[1:]) <= said[0].width


def test_iterations_left_out_by_a_busy_machine_are_no_alarm(glass, monkeypatch):
    run = glass.session.timeline.run
    glass.parts.settings["smooth_streams"] = False
    monkeypatch.setattr(glass.session.timeline, "run", lambda iterations, *how: run(iterations // 2, *how))
    glass.parts.stats_card.toggle()
    glass.wait(40)
    words, colour = line(glass)
    assert "computer" not in words and colour == look.DIM and int(words.split()[0]) < 120
    assert BUSY in " ".join(glass.parts.stats_card.lines)


def test_a_grain_that_is_not_on_the_books_is_noticed(player):
    player.hold_time()
    account = player.session.account
    player.session.do(Paint("sand", (50.0, 50.0), (60.0, 50.0), 3))
    player.session.timeline.moment.account = account
    player.wait(30)
    words, colour = line(player)
    assert "but 0 in the account" in words and colour == look.ACCENT


def test_the_figures_come_where_the_pointer_rests_and_go_with_it(glass):
    glass.pointer = glass.parts.display.layout.status_line.center
    glass.wait(10)
    assert not glass.parts.stats_card.shown
    glass.wait(40)
    words = " ".join(glass.parts.stats_card.lines)
    assert all(word in words for word in ("frames a second", "16 ms", "iterations a second", "at the start", "MB"))
    glass.pointer = glass.pixel(10, 10)
    glass.wait(3)
    assert not glass.parts.stats_card.shown


def test_a_click_on_the_line_keeps_the_figures(glass):
    place = glass.parts.display.layout.status_line.center
    glass.click(place)
    glass.pointer = None
    glass.wait(3)
    assert glass.parts.stats_card.shown
    glass.click(place)
    glass.wait(3)
    assert not glass.parts.stats_card.shown


@sweep("size", [(640, 480), (1280, 720)], keep=[(640, 480)])
@sweep("scale", [0.75, 1, 3], keep=[0.75, 3])
def test_a_line_is_read_to_its_end_and_leaves_the_state_its_row(glass, size, scale):
    glass.parts.settings.override("ui_scale", scale)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    glass.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
    glass.wait(20)
    theme, rect = glass.parts.display.theme, glass.parts.display.layout.status_line
    for said in ("Short.", f"/home/{'long/' * 40}a.png: no space left on device"):
        strokes = glass.parts.status_line.drawing(theme, rect, glass.session, notice=(said, True))
        places = [(pygame.Rect(place), text[0]) for stroke, place, *text in strokes if stroke is draw_list.words]
        assert all(rect.contains(place) for place, _ in places)
        words = " ".join(text for _, text in places)
        assert ("grains" in words) if said == "Short." else ("no space left on device" in words)


def test_figures_tell_nothing_beside_their_card(glass):
    glass.parts.stats_card.toggle()
    glass.wait(20)
    rect = glass.parts.display.layout.cards["figures"]
    strokes = glass.parts.stats_card.drawing(glass.parts.display.theme, rect)
    assert len(strokes) > 5 and all(rect.contains(pygame.Rect(place)) for _, place, *_ in strokes)


@sweep("height", range(30, 240, 15), keep=[30, 75, 120, 225])
def test_no_figure_is_cut_off_in_a_card_that_is_too_low_for_all(glass, height):
    glass.parts.stats_card.toggle()
    glass.wait(20)
    card = glass.parts.stats_card
    strokes = card.drawing(glass.parts.display.theme, pygame.Rect(0, 0, 352, height))
    said = " ".join(text for stroke, _, text, *_ in (each for each in strokes if each[0] is draw_list.words))
    for line in card.lines:
        said = said.replace(line, "", 1)
    assert not said.strip()
