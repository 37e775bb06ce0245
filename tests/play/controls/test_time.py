"""Time in the player's hands: rewind, time bar, undo and redo, as hands on keys and mouse bring them about."""

import pygame
import pytest
from PIL import Image

from game.play.storage import open_sessions
from game.play.storage.recorder import image_of_sand
from game.world.files.paths import folder_of
from game.world.scenes.scene import load_scene
from game.world.sessions.action import Flip
from game.world.sessions.moment import Moment
from game.world.sessions.session import BUDGET_NS, SEEK_NS, Session
from game.world.sessions.timeline import Timeline
from tests.play.player import Player, words_of
from tests.sweeps import sweep

CTRL = pygame.KMOD_LCTRL
SHIFT = pygame.KMOD_LSHIFT


def undo(player):
    player.key(pygame.K_z, mod=CTRL)


def redo(player):
    player.key(pygame.K_y, mod=CTRL)


def digests_of_the_scene(upto):
    session, found = Session(load_scene("hourglass")), []
    for _ in range(upto + 1):
        found.append(session.world.digest())
        session.step()
    return found


def on_bar(player, share):
    """Return the place on the time bar at `share` of the way."""
    track = player.parts.time_bar.track
    return track.x + round(share * (track.width - 1)), track.centery


def test_rewinding_shows_the_past_and_forward_again_is_the_identity(glass):
    glass.wait(100)
    glass.hold_time()
    end, sand = glass.session.now, glass.world.digest()
    known = digests_of_the_scene(end)
    glass.press(pygame.K_BACKSPACE)
    seen = []
    for _ in range(30):
        glass.frame()
        seen.append(glass.session.now)
        assert glass.world.digest() == known[glass.session.now]
    glass.release(pygame.K_BACKSPACE)
    assert seen == sorted(seen, reverse=True) and seen[-1] < end - 60
    glass.session.paused = False
    while glass.session.now < end:
        glass.frame()
    glass.session.seek(end)
    assert glass.world.digest() == sand


def test_shift_runs_back_faster_and_time_stops_at_the_beginning(glass):
    glass.wait(120)
    ways = []
    for mod in (0, SHIFT):
        before = glass.session.now
        glass.press(pygame.K_BACKSPACE, mod=mod)
        glass.wait(4)
        ways.append(before - glass.session.now)
        glass.hold_time()
        glass.release(pygame.K_BACKSPACE)
    assert ways[1] > 3 * ways[0] > 0
    glass.press(pygame.K_BACKSPACE, mod=SHIFT)
    glass.wait(60)
    assert glass.session.now == 0 and glass.world.digest() == glass.session.scene.world(0).digest()


def test_time_stands_still_while_the_bar_is_held_and_goes_on_after(glass):
    glass.wait(60)
    glass.button(pygame.MOUSEBUTTONDOWN, on_bar(glass, 0.5))
    at = glass.session.now
    glass.wait(5)
    assert glass.session.now == at
    glass.button(pygame.MOUSEBUTTONUP, on_bar(glass, 0.5))
    glass.wait(5)
    assert glass.session.now > at


def test_the_sand_follows_the_pointer_on_the_time_bar(glass):
    glass.wait(100)
    glass.hold_time()
    end = glass.session.reached
    known = digests_of_the_scene(end)
    glass.button(pygame.MOUSEBUTTONDOWN, on_bar(glass, 0.9))
    for share in (0.7, 0.2, 0.0, 0.35, 1.0, 0.5):
        glass.move(on_bar(glass, share))
        assert glass.session.now == pytest.approx(share * end, abs=2)
        assert glass.world.digest() == known[glass.session.now]
    glass.button(pygame.MOUSEBUTTONUP, on_bar(glass, 0.5))
    assert glass.session.reached == end


def test_undo_leaves_the_sand_as_it_would_have_been(glass):
    glass.wait(20)
    glass.drag(glass.pixel(20, 20), glass.pixel(60, 30))
    glass.wait(20)
    glass.hold_time()
    undo(glass)
    assert glass.world.digest() == digests_of_the_scene(glass.session.now)[-1]


def test_redo_brings_the_stroke_back(player):
    player.drag(player.pixel(20, 20), player.pixel(60, 30))
    player.wait(10)
    player.hold_time()
    sand = player.world.digest()
    undo(player)
    assert player.world.grains == 0
    redo(player)
    assert player.world.digest() == sand
    undo(player)
    player.key(pygame.K_z, mod=CTRL | SHIFT)
    assert player.world.digest() == sand


def test_a_stroke_with_all_that_it_pours_is_one_step(player):
    player.button(pygame.MOUSEBUTTONDOWN, player.pixel(60, 20))
    player.wait(30)
    player.move(player.pixel(80, 20))
    player.button(pygame.MOUSEBUTTONUP, player.pixel(80, 20))
    assert player.world.grains > 100
    undo(player)
    assert player.world.grains == 0


def test_two_strokes_are_two_steps(player):
    player.hold_time()
    player.click(player.pixel(20, 20))
    some = player.world.grains
    player.click(player.pixel(60, 20))
    undo(player)
    assert player.world.grains == some


def test_a_clear_and_a_load_can_be_taken_back(glass):
    glass.wait(10)
    glass.hold_time()
    sand = glass.world.digest()
    glass.key(pygame.K_c)
    glass.parts.sessions.load("paper")
    undo(glass)
    assert glass.session.scene.name == "hourglass" and glass.world.grains == 0
    undo(glass)
    assert glass.world.digest() == sand


def test_a_drag_of_a_slider_is_one_step(glass):
    rule = glass.session.rule
    glass.drag(*(glass.control("p", share) for share in (0.9, 0.6, 0.3, 0.1)))
    glass.wait(1)
    first = glass.session.rule
    glass.drag(*(glass.control("p", share) for share in (0.2, 0.5, 0.8)))
    undo(glass)
    assert glass.session.rule == first
    undo(glass)
    assert glass.session.rule == rule


def test_undo_goes_back_to_the_moment_before_the_act_if_asked_to(glass):
    glass.wait(20)
    glass.parts.commands.time.undo_goes_back = True
    at = glass.session.now
    glass.session.do(Flip())
    glass.wait(60)
    glass.hold_time()
    undo(glass)
    assert glass.session.now == at and glass.world.digest() == digests_of_the_scene(at)[-1]


def test_the_panel_takes_back_what_the_keys_take_back(player):
    player.hold_time()
    player.click(player.pixel(20, 20))
    some = player.world.grains
    player.click(player.control("Undo"))
    assert player.world.grains == 0
    player.click(player.control("Redo"))
    assert player.world.grains == some


def test_with_nothing_to_undo_the_screen_says_so(player):
    undo(player)
    assert player.parts.notices.text == "Nothing to undo."
    redo(player)
    assert player.parts.notices.text == "Nothing to redo."


def test_painting_in_the_past_begins_a_new_future_and_redo_finds_the_old_one(player):
    player.drag(player.pixel(20, 20), player.pixel(40, 20))
    player.wait(30)
    player.drag(player.pixel(80, 20), player.pixel(100, 20))
    player.wait(30)
    player.hold_time()
    end, old = player.session.now, player.world.digest()
    player.drag(on_bar(player, 0.9), on_bar(player, 0.4))
    player.drag(player.pixel(50, 60), player.pixel(60, 60))
    new = player.session.now
    assert player.session.reached == new < end
    redo(player)
    player.session.seek(end)
    assert player.world.digest() == old


def test_the_marks_of_acts_and_flips_lie_where_they_happened(player):
    player.wait(20)
    first = player.session.now
    player.click(player.pixel(20, 20))
    player.wait(20)
    second = player.session.now
    player.parts.sessions.do(Flip())
    player.frame()
    marks = player.parts.time_bar.marks
    assert marks.acts.tolist() == [pytest.approx(first, abs=8)]
    assert marks.strong.tolist() == [second]
    undo(player)
    assert marks.strong.tolist() == []


def test_every_grain_of_the_session_is_on_the_books(player):
    player.drag(player.pixel(20, 20), player.pixel(40, 20))
    player.wait(20)
    player.drag(player.pixel(20, 60), player.pixel(60, 85), button=3)
    player.wait(20)
    line = player.parts.status_line.drawing(player.parts.display.theme, pygame.Rect(0, 0, 2000, 30), player.session)[1][
        2
    ]
    assert f"{player.world.grains} grains" in line
    player.parts.stats_card.toggle()
    player.wait(20)
    account, words = player.session.account, " ".join(player.parts.stats_card.lines)
    books = f"0 at the start + {account.painted} painted - {account.erased} erased = {player.world.grains} now"
    assert books in words and "MB" in words


def test_a_frame_waits_once_for_a_moment_that_is_far_whatever_is_done_in_it(glass, monkeypatch):
    budgets = []

    def catch_up(timeline, budget_ns=None):
        budgets.append(budget_ns)
        return caught_up(timeline, budget_ns)

    caught_up = Timeline.catch_up
    glass.session.seek(2**40, budget_ns=1)
    glass.pointer = pos = glass.pixel(90, 60)
    monkeypatch.setattr(Timeline, "catch_up", catch_up)
    moves = [pygame.event.Event(pygame.MOUSEMOTION, pos=pos, rel=(0, 0), buttons=(1, 0, 0))] * 3
    glass.frame(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=pos, button=1), *moves)
    assert len(budgets) >= 2 and sum(budgets) <= SEEK_NS + BUDGET_NS
    assert not glass.session.timeline.history.story()


def test_what_the_pointer_does_beside_the_lattice_leaves_the_future_alone(player):
    player.wait(30)
    player.drag(player.pixel(20, 20), player.pixel(40, 20))
    player.hold_time()
    player.wait(1)
    end, line = player.session.reached, player.session.timeline.history.line
    player.session.seek(5)
    player.parts.brush.diameter = 1
    for tool in (pygame.K_d, pygame.K_v, pygame.K_u, pygame.K_j):
        player.key(tool)
        player.drag(player.pixel(-3, -2), player.pixel(-2, -2))
    assert player.session.reached == end and player.session.timeline.history.line is line


def test_time_at_rest_takes_no_room_on_the_bar(player):
    player.drag(player.pixel(20, 20), player.pixel(40, 20))
    player.wait(200)
    strokes = player.parts.time_bar.drawing(player.session)
    player.session.timeline.run(50_000)
    assert player.parts.time_bar.drawing(player.session) == strokes


@pytest.mark.parametrize(
    ("code", "mod", "done"), [(pygame.K_f, 0, "Turning"), (pygame.K_h, SHIFT, "Getting the worlds")]
)
def test_what_takes_long_is_announced_by_a_frame_before(player, monkeypatch, code, mod, done):
    player.drag(player.pixel(20, 20), player.pixel(40, 20))
    player.hold_time()
    player.wait(1)
    monkeypatch.setattr(open_sessions, "LARGE", 100)
    session, before = player.session, player.world.digest()
    with player.reading() as drawn:
        player.press(code, mod=mod)
    assert any(done in text for _, text, _ in words_of(drawn))
    assert player.session is session and player.world.digest() == before
    player.frame()
    assert player.session is not session or player.world.digest() != before
    assert done not in player.words()


HEAVY = [
    lambda one: one.drag(one.pixel(5, 5), one.pixel(60, 60)),
    lambda one: one.key(pygame.K_c, "c"),
    lambda one: one.key(pygame.K_f, "f"),
    lambda one: one.key(pygame.K_r, "r"),
    lambda one: one.drag(one.control("Neck", 0.3), one.control("Neck", 0.6)),
    lambda one: one.drag(one.control("Glass size", 0.3), one.control("Glass size", 0.6)),
    lambda one: one.click(one.control("Refill")),
    lambda one: one.drag(on_bar(one, 0.1), on_bar(one, 0.7)),
    lambda one: (one.session.seek(0), one.session.clock.__setattr__("speed", 6000.0), one.wait(9)),
]


@sweep("do", HEAVY, keep=[HEAVY[0], HEAVY[4], HEAVY[7]])
def test_no_act_on_many_cells_comes_before_a_picture_that_says_so(monkeypatch, do):
    one = Player("hourglass", size=(900, 1400))
    one.unfold("Glass")
    one.session.timeline.run(300)
    one.session.do(Flip())
    one.session.timeline.run(300)
    one.session.seek(100)
    monkeypatch.setattr(open_sessions, "LARGE", 100)
    said, took, frame, take = [""], [], one.app.frame, Moment.take

    def framed(*told):
        changed = frame(*told)
        said.append(one.parts.sessions.words or one.parts.frame_step.words)
        return changed

    def taken(moment, action):
        if moment is one.session.timeline.moment:
            took.append((action, said[-1]))
        return take(moment, action)

    monkeypatch.setattr(one.app, "frame", framed)
    monkeypatch.setattr(Moment, "take", taken)
    do(one)
    one.wait(3)
    assert took and all(words for _, words in took)
    assert not one.parts.sessions.words
    pygame.display.quit()


def test_a_single_iteration_of_many_cells_comes_after_a_picture_that_says_so(glass, monkeypatch):
    glass.hold_time()
    monkeypatch.setattr(open_sessions, "LARGE", 100)
    before = glass.session.now
    with glass.reading() as drawn:
        glass.press(pygame.K_PERIOD, ".")
    assert glass.session.now == before and any("Running one iteration" in text for _, text, _ in words_of(drawn))
    glass.frame()
    assert glass.session.now == before + 1 and not glass.parts.sessions.words


def test_strokes_that_are_announced_are_one_step_and_leave_nothing_out(player, monkeypatch):
    places = [player.pixel(*place) for place in ((5, 5), (60, 60), (90, 20), (20, 70))]
    player.hold_time()
    player.drag(*places)
    painted = player.world.digest()
    player.session.undo()
    empty = player.world.digest()
    monkeypatch.setattr(open_sessions, "LARGE", 200)
    player.drag(*places)
    player.wait(2)
    assert player.world.digest() == painted != empty
    player.session.undo()
    assert player.world.digest() == empty


def test_streams_stay_smooth_while_time_is_held_and_in_the_picture_of_the_sand(glass):
    glass.session.clock.speed = 60.0
    glass.wait(150)
    glass.hold_time()
    glass.parts.display.refresh()
    glass.wait(1)
    glass.key(pygame.K_F12, mod=SHIFT)
    glass.settle()
    (path,) = folder_of("pictures").iterdir()
    picture = Image.open(path)
    scale = picture.width // glass.world.shape[1]
    cells = image_of_sand(glass.world, scale, glass.parts.display.colours, glass.session.scene.made_of)
    assert cells.size == picture.size and cells.tobytes() != picture.convert(cells.mode).tobytes()
    smooth = pygame.surfarray.array2d(glass.parts.window.surface)
    glass.parts.settings["smooth_streams"] = False
    glass.wait(1)
    left, top, right, bottom = glass.parts.display.sand_view.view.seen
    plain = pygame.surfarray.array2d(glass.parts.window.surface)
    assert (smooth[left:right, top:bottom] != plain[left:right, top:bottom]).any()
