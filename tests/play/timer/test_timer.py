"""The timer: the last grain falls on time, whatever becomes of frames, sand and sleep. Its clock is a false one."""

from types import SimpleNamespace

import numpy as np
import pygame
import pytest

from game.play.timer import run_out_planner
from game.play.timer.chime import LENGTH_S, chime_samples
from game.play.timer.run_out_planner import RunOutPlanner
from game.play.timer.timer import OFF, OVER, PATIENCE_S, RUNNING, SHARE, Pace, Timer
from game.play.ui.sliders import HANDLE
from game.play.view.notices import Notices
from game.play.window.audio import RATE
from game.world.rules.rule import Rule
from game.world.sand.duration import spell
from game.world.scenes.hourglass_maker import scene_of
from game.world.sessions.action import Load, Paint, SetRule
from game.world.sessions.run_out import RunOut
from game.world.sessions.session import Session
from tests.cells import small_glass
from tests.play.player import FRAME_NS, Player
from tests.sweeps import sweep

FRAME_S = FRAME_NS / 1e9


class Waiting(Player):
    """A player with a small glass, and a timer that follows the player's own clock."""

    def __init__(self, height=48):
        super().__init__("hourglass", size=(700, 560))
        self.parts.sessions.open_scene(scene_of(small_glass(height)), 1)
        self.timer.clock = lambda: self.now_s
        self.parts.commands.give("view.toggle_panel")  # a frame without it is a much shorter one
        self.wait(0)

    @property
    def timer(self):
        return self.parts.timer

    def unfold(self, name):
        self.parts.commands.give("view.toggle_panel")
        self.wait(1)
        super().unfold(name)

    def start(self, seconds):
        self.timer.set(seconds)
        self.key(pygame.K_t, "t")
        self.plan()

    def plan(self):
        """Wait for the plan while the wall clock stands still."""
        self.settle()

    def pass_time(self, seconds, frame_s=FRAME_S):
        """Let time pass in frames of a length, or of lengths drawn by a function."""
        end = self.now_s + seconds
        while self.now_s < end:
            length = frame_s() if callable(frame_s) else frame_s
            self.frame(elapsed_ns=round(1e9 * length))

    def run_out(self, frame_s=FRAME_S):
        for _ in range(3000):
            self.pass_time(1e-9, frame_s)
            if self.parts.background.busy:
                self.plan()
            if self.timer.state != RUNNING:
                return
        pytest.fail(f"{self.timer.gone_s} s have gone, wanted {self.timer.wanted_s}")


@pytest.fixture
def waiting(monkeypatch):
    """Return someone who waits for a small glass, at a computer that always has time for what is due."""
    monkeypatch.setattr("game.play.frame_step.LEAST_STEPPING_NS", 10**12)
    monkeypatch.setattr("game.play.timer.timer.SEEK_NS", 10**12)
    yield Waiting()
    pygame.display.quit()


@sweep("seconds", [2, 7.3, 20], keep=[2])
def test_the_last_grain_falls_within_a_frame_of_the_time(waiting, seconds):
    waiting.start(seconds)
    while waiting.timer.state == RUNNING:
        ending = waiting.parts.planner.ask()
        assert (waiting.session.now >= ending.at) == (waiting.timer.gone_s >= seconds)
        waiting.frame()
    assert waiting.session.now == ending.at and 0 <= waiting.timer.error_s <= FRAME_S + 1e-6
    assert "The last grain fell at" in waiting.timer.said


def test_dropped_frames_are_caught_up(waiting):
    lengths = np.random.default_rng(5).choice([FRAME_S, 0.05, 0.4, 1.1], size=1000).tolist()
    waiting.start(12)
    waiting.run_out(lengths.pop)
    assert waiting.timer.error_s <= 1.1


def test_acts_on_the_way_do_not_move_the_end(waiting):
    waiting.start(10)
    for act in (
        lambda: waiting.drag(waiting.pixel(16, 10), waiting.pixel(20, 12)),
        lambda: waiting.key(pygame.K_f, "f"),
        lambda: waiting.parts.sessions.do(SetRule(Rule.with_p(0.3, "balanced"))),
        lambda: waiting.session.undo(),
        lambda: waiting.parts.sessions.do(Load(scene_of(small_glass(70)), 2)),
    ):
        waiting.pass_time(1.5)
        act()
        assert waiting.parts.planner.newest is not None, "the old pace goes on while the new one is worked out"
        waiting.pass_time(0.1)
        waiting.plan()
    waiting.run_out()
    assert waiting.timer.error_s <= FRAME_S + 1e-6 and "The last grain fell" in waiting.timer.said


def test_a_glass_that_is_turned_over_half_way_runs_out_on_time(waiting):
    waiting.start(6)
    waiting.pass_time(3)
    waiting.key(pygame.K_f, "f")
    waiting.plan()
    waiting.run_out()
    assert waiting.timer.error_s <= FRAME_S + 1e-6


def test_the_pace_is_even(waiting):
    waiting.start(20)
    waiting.pass_time(0.5)
    steps = []
    for _ in range(600):
        before = waiting.session.now
        waiting.frame()
        steps.append(waiting.session.now - before)
    assert max(steps) - min(steps) <= 1
    pace = waiting.timer.iterations_per_second
    assert sum(steps) == pytest.approx(600 * FRAME_S * pace, abs=2)


def test_a_new_plan_neither_jumps_nor_stalls(waiting):
    waiting.start(20)
    waiting.pass_time(8)
    before = waiting.session.now
    waiting.parts.sessions.do(SetRule(Rule.with_p(0.7, "balanced")))
    waiting.plan()
    waiting.wait(60)
    pace = (waiting.parts.planner.ask().at - before) / 12
    assert waiting.session.now - before == pytest.approx(pace * 62 * FRAME_S, abs=3)


def test_a_plan_made_after_the_end_does_not_hold_before_it(waiting):
    waiting.session.timeline.run(2000)
    waiting.start(5)
    assert waiting.parts.planner.ask().iterations == 0
    waiting.session.seek(100)
    assert waiting.parts.planner.ask() is None
    waiting.plan()
    assert waiting.parts.planner.ask().iterations > 0


def test_a_pause_holds_the_time(waiting):
    waiting.start(5)
    waiting.pass_time(2)
    waiting.key(pygame.K_SPACE, " ")
    left = waiting.timer.left_s
    waiting.pass_time(60, frame_s=0.5)
    assert waiting.timer.left_s == pytest.approx(left, abs=2 * FRAME_S)
    waiting.key(pygame.K_SPACE, " ")
    waiting.run_out()
    assert waiting.timer.error_s <= FRAME_S + 1e-6


def test_after_a_long_sleep_it_ends_at_once_and_says_so(waiting):
    waiting.start(5)
    waiting.pass_time(1)
    waiting.frame(elapsed_ns=600 * 10**9)
    waiting.wait(2)
    assert waiting.timer.state == OVER and waiting.session.now >= waiting.parts.planner.ask().at
    assert waiting.timer.said == "0:05 ended 9:56 ago, while the computer slept."


def test_after_a_short_sleep_it_catches_up(waiting):
    waiting.start(9)
    waiting.pass_time(1)
    waiting.frame(elapsed_ns=5 * 10**9)
    waiting.run_out()
    assert waiting.timer.error_s <= FRAME_S + 1e-6


def test_turning_the_glass_over_at_the_end_starts_again(waiting):
    waiting.start(3)
    waiting.run_out()
    waiting.pass_time(1)
    waiting.key(pygame.K_f, "f")
    waiting.plan()
    assert waiting.timer.state == RUNNING
    waiting.run_out()
    assert "The last grain fell" in waiting.timer.said


def test_a_flip_that_the_turning_table_leaves_out_starts_no_time(waiting):
    waiting.start(1)
    waiting.run_out()
    waiting.key(pygame.K_f, "F", pygame.KMOD_SHIFT)
    assert waiting.parts.display.sand_view.turn
    waiting.key(pygame.K_f, "f")
    assert waiting.timer.state == OVER


def test_sand_goes_on_settling_at_the_pace(waiting):
    waiting.start(4)
    waiting.pass_time(1)
    pace = waiting.timer.iterations_per_second
    waiting.run_out()
    before = waiting.session.now
    waiting.wait(60)
    assert waiting.session.now - before == pytest.approx(60 * FRAME_S * pace, rel=0.1)


def test_a_timer_without_sand_to_fall_still_ends_on_time(waiting):
    waiting.parts.commands.sand.clear()
    waiting.start(2)
    assert "Nothing is above the neck" in waiting.parts.notices.text
    waiting.run_out()
    assert waiting.timer.error_s <= FRAME_S + 1e-6 and "No sand was left" in waiting.timer.said


def test_sand_that_cannot_pass_is_told_of(waiting):
    height, width = waiting.world.shape
    waiting.parts.sessions.do(Paint("wall", (0.0, height / 2), (float(width), height / 2), 3))
    waiting.session.timeline.run(200)
    waiting.start(2)
    assert "is stuck" in waiting.parts.notices.text
    waiting.run_out()
    assert "was stuck" in waiting.timer.said


def test_a_scene_without_end_is_told_of(waiting, monkeypatch):
    monkeypatch.setattr("game.world.sessions.run_out.find_run_out.__defaults__", (None, 4000, 10**10))
    waiting.parts.sessions.do(SetRule(Rule.with_p(1e-7, "balanced")))
    waiting.start(2)
    assert "No end of this can be foreseen: the timer only counts" in waiting.parts.notices.text
    waiting.run_out()
    assert waiting.timer.error_s <= FRAME_S + 1e-6 and "No end of this" in waiting.timer.said


def test_an_end_that_was_not_found_in_time_is_told_as_such(waiting, monkeypatch):
    monkeypatch.setattr(waiting.parts.planner, "ask", lambda: None)
    waiting.start(1)
    waiting.pass_time(PATIENCE_S + 1.5, 0.1)
    assert waiting.timer.state == OVER and "was not found in time" in waiting.timer.said


def test_a_time_that_is_over_is_forgotten_in_another_scene_and_not_when_the_glass_rests(waiting):
    waiting.start(2)
    waiting.pass_time(3)
    assert waiting.timer.state == OVER and waiting.timer.said
    waiting.parts.sessions.load("blank")
    waiting.wait(1)
    assert waiting.timer.state == OFF and not waiting.timer.said and pygame.display.get_caption()[0] == "Sandglass"


def test_the_title_counts_down(waiting):
    waiting.start(3)
    titles = []
    while waiting.timer.state == RUNNING:
        waiting.frame()
        title = pygame.display.get_caption()[0]
        if title not in titles:
            titles.append(title)
    assert titles == [f"{left} – Sandglass" for left in ("0:03", "0:02", "0:01", "0:03 is over")]
    waiting.key(pygame.K_t, "t")
    waiting.key(pygame.K_t, "t")
    assert waiting.timer.state == OFF and pygame.display.get_caption()[0] == "Sandglass"


def test_stopping_gives_the_speed_back(waiting):
    speed = waiting.session.clock.speed
    waiting.start(30)
    waiting.pass_time(0.3)
    assert waiting.session.clock.speed != speed
    waiting.key(pygame.K_t, "t")
    assert waiting.session.clock.speed == speed


def test_another_scene_gets_its_own_speed_back_and_not_that_of_the_one_before(waiting):
    waiting.start(30)
    waiting.pass_time(0.3)
    waiting.parts.sessions.load("clocks")
    waiting.plan()
    waiting.pass_time(0.3)
    assert waiting.session.clock.speed != waiting.session.scene.speed
    waiting.key(pygame.K_t, "t")
    assert waiting.session.clock.speed == waiting.session.scene.speed


@pytest.mark.parametrize("stopped_there", [True, False])
def test_a_session_that_was_left_gets_its_speed_back(waiting, stopped_there):
    speed = waiting.session.clock.speed
    waiting.start(30)
    waiting.pass_time(0.3)
    waiting.key(pygame.K_h, mod=pygame.KMOD_LSHIFT)
    waiting.plan()
    waiting.pass_time(0.3)
    if stopped_there:
        waiting.key(pygame.K_t, "t")
        assert waiting.session.clock.speed == speed
    waiting.key(pygame.K_h, mod=pygame.KMOD_LSHIFT)
    if not stopped_there:
        waiting.key(pygame.K_t, "t")
    assert waiting.session.clock.speed == speed


def test_the_panel_sets_and_starts_it(waiting):
    waiting.unfold("Timer")
    waiting.wait(1)
    waiting.click(waiting.parts_of("Minutes")[3].center)
    assert waiting.timer.wanted_s == 600
    waiting.click(waiting.control("Timer start"))
    waiting.plan()
    assert waiting.timer.state == RUNNING
    waiting.click(waiting.control("A glass for it"))
    waiting.plan()
    assert waiting.session.scene.name == "glass" and waiting.timer.state == RUNNING
    assert 30 <= waiting.parts.planner.ask().iterations / 600 <= 240


def test_its_slider_goes_from_a_second_by_even_steps_to_two_hours(waiting):
    waiting.unfold("Timer")
    waiting.wait(1)
    waiting.click(waiting.control("Any time", 0.0))
    assert waiting.timer.wanted_s == 1
    waiting.parts.panel.ui.focus.by_keyboard = True
    seen = [1]
    while seen[-1] < 7200:
        waiting.press(pygame.K_RIGHT)
        seen.append(waiting.timer.wanted_s)
        assert seen[-1] > seen[-2]
    assert {10, 30, 60, 7200} < set(seen) and all(each % 60 == 0 for each in seen if each > 1800)
    while seen[-1] > 1:
        waiting.press(pygame.K_LEFT)
        seen.append(waiting.timer.wanted_s)
        assert seen[-1] < seen[-2]


@sweep(
    ("seconds", "words"),
    [(1, "1 s"), (10, "10 s"), (1.5, "1.5 s"), (90, "1:30"), (5400, "1:30 h")],
    keep=[(1.5, "1.5 s"), (5400, "1:30 h")],
)
def test_its_slider_shows_what_was_asked_for_where_it_is(waiting, seconds, words):
    waiting.unfold("Timer")
    waiting.timer.set(seconds)
    waiting.wait(1)
    assert words in [text for _, text, _ in waiting.written()] and waiting.timer.wanted_s == seconds
    edge, wide = HANDLE, waiting.parts_of("Any time")[0].width
    waiting.click(waiting.control("Any time", (edge + (wide - 2 * edge) * np.log(seconds) / np.log(7200)) / wide))
    assert waiting.timer.wanted_s == pytest.approx(seconds, rel=0.1, abs=0.5)


@sweep("reduced", [True, False], keep=[False])
def test_the_frame_glows_for_a_while(waiting, reduced):
    waiting.parts.settings["reduced_motion"] = reduced
    corner = waiting.parts.display.layout.sand.x + 1, waiting.parts.display.layout.sand.centery
    dark = waiting.parts.window.surface.get_at(corner)
    waiting.start(1)
    waiting.run_out()
    waiting.wait(40)
    bright = waiting.parts.window.surface.get_at(corner)
    assert sum(bright[:3]) > sum(dark[:3])
    waiting.pass_time(6, 0.1)
    assert waiting.parts.window.surface.get_at(corner) == dark and not waiting.parts.glow.shown


# --- without a window ---


@pytest.fixture
def sessions():
    """Return the Sessions of one that plays a small glass."""
    return SimpleNamespace(now=Session(scene_of(small_glass(48)), 1))


def said_of(sessions, seconds, work_s):
    """Return what a timer says of sand that runs out in 3000 iterations, which take `work_s` to compute, or None."""
    plan, notices, silent = RunOut(0, 3000, True, False, work_s * 1e9 / 3000), Notices(lambda: None), lambda *_: None
    planner = SimpleNamespace(newest=plan, ask=lambda: plan)
    glow, chime = SimpleNamespace(start=silent, stop=silent), SimpleNamespace(prepare=silent, ring=silent)
    timer = Timer(sessions, planner, notices, silent, glow, chime, clock=lambda: 0.0)
    timer.set(seconds)
    timer.start()
    timer.update(0.0)
    return notices.text


def test_what_will_be_late_is_said_at_the_start_with_a_time_that_would_do(sessions):
    assert said_of(sessions, 100, work_s=100 * SHARE - 1) is None
    said = said_of(sessions, 100, work_s=100 * SHARE + 3)
    assert said == f"This computer needs about {spell(100 + 3 / SHARE)} for this glass: it will be late."
    assert said_of(sessions, 100 + 3 / SHARE + 1, work_s=100 * SHARE + 3) is None


def test_a_computer_that_needs_almost_all_of_the_time_will_be_late(sessions):
    assert "will be late" in said_of(sessions, 100, work_s=80)
    assert said_of(sessions, 100, work_s=40) is None


class HeldWork:
    """Stands in for a Background: keeps the work that it is to do."""

    def __init__(self):
        self.works = []

    def do(self, work, then, otherwise):
        self.works.append(work)


@pytest.fixture
def search(sessions, monkeypatch):
    """Return a planner that searches, what tells its search to give up, and a function that lets seconds pass."""
    monkeypatch.setattr(run_out_planner, "find_run_out", lambda lookahead, cancelled: cancelled)
    now_s, held = [50.0], HeldWork()
    planner = RunOutPlanner(sessions, held, clock=lambda: now_s[0])
    planner.ask()
    _, cancelled = held.works[0]()

    def pass_time(seconds):
        now_s[0] += seconds
        planner.ask()

    return planner, cancelled, pass_time


def test_a_search_for_what_is_still_asked_goes_on_for_as_long_as_it_takes(search):
    _, cancelled, pass_time = search
    for _ in range(60):
        pass_time(1.0)
        assert not cancelled()


def test_a_search_that_an_act_has_put_out_of_date_is_cancelled_but_not_at_once(sessions, search):
    _, cancelled, pass_time = search
    sessions.now.do(SetRule(Rule.with_p(0.3)))
    pass_time(run_out_planner.PATIENCE_S / 2)
    assert not cancelled()
    pass_time(run_out_planner.PATIENCE_S)
    assert cancelled()


def test_closing_the_planner_cancels_its_search(search):
    planner, cancelled, _ = search
    planner.close()
    assert cancelled()


def test_a_pace_keeps_every_fraction():
    pace = Pace(0.0, 100, 1500.0, 800)
    at = [pace.at(frame / 60) for frame in range(1500 * 60 + 2)]
    assert at[0] == 100 and at[-3] == 799 and at[-2:] == [800, 800] and set(np.diff(at)) == {0, 1}
    assert all(abs(each - (100 + frame / 60 * 700 / 1500)) <= 1 for frame, each in enumerate(at))


def test_the_chime_is_a_soft_bell():
    wave = chime_samples()
    assert wave.shape == (round(LENGTH_S * RATE), 2) and 0.3 < np.abs(wave).max() <= 0.5
    assert abs(wave[0]).max() < 0.01 and abs(wave[-1]).max() < 0.001, "it neither begins nor ends with a click"
    spectrum = np.abs(np.fft.rfft(wave[: RATE // 2, 0]))
    assert np.argmax(spectrum) * 2 == pytest.approx(523, abs=3)
