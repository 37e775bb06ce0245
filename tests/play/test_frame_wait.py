"""At rest, paused or out of sight the window waits for events; what moves, is timed or is awaited goes on."""

import time
from types import SimpleNamespace

import pygame
import pytest

from game.play import frame_wait, loop
from game.play.frame_wait import CALM_FRAMES, CALM_MS, FrameWait
from game.play.view.hints import HINTS


class Waits:
    """Counts the waits for events and for frames, and waits for none."""

    def __init__(self, monkeypatch):
        self.for_events, self.for_frames = [], 0
        monkeypatch.setattr(frame_wait, "wait_for_event", lambda longest_ms, _: self.for_events.append(longest_ms))
        monkeypatch.setattr(frame_wait.pygame.time, "Clock", lambda: self)

    def tick(self, rate=0):
        self.for_frames += bool(rate)


@pytest.fixture
def waits(monkeypatch):
    return Waits(monkeypatch)


def know_all_hints(player):
    player.parts.settings["hints_seen"] = tuple(hint.name for hint in HINTS)
    player.wait(10)
    pygame.event.clear()


def play(player, waits, frames):
    """Play frames as the loop does, and return how many of them waited for an event."""
    wait, before = FrameWait(), len(waits.for_events)
    for _ in range(frames):
        player.frame(*wait.events(player.parts.at_rest, hidden=False))
    return len(waits.for_events) - before


def test_a_window_at_rest_or_paused_waits_for_events(player, waits):
    know_all_hints(player)
    assert play(player, waits, 100) == 100 - CALM_FRAMES and set(waits.for_events) == {CALM_MS}
    player.drag(player.pixel(20, 20), player.pixel(60, 20))
    assert play(player, waits, 20) == 0
    player.hold_time()
    assert play(player, waits, 100) > 0


def test_a_timer_and_a_held_key_are_never_kept_waiting(player, waits):
    know_all_hints(player)
    player.hold_time()
    player.press(pygame.K_s, "s")
    assert play(player, waits, 100) == 0
    player.release(pygame.K_s)
    player.parts.timer.start()
    assert play(player, waits, 100) == 0


def test_a_hidden_window_plays_few_frames(waits):
    pygame.display.init()
    wait = FrameWait()
    for at_rest in (True, False):
        wait.events(at_rest, hidden=True)
    assert waits.for_events == [CALM_MS, frame_wait.HIDDEN_MS] and waits.for_frames == 0


def test_an_event_that_ends_a_wait_is_heard(monkeypatch):
    pygame.display.init()
    pygame.event.clear()
    looks = []

    def sleep(seconds):
        looks.append(seconds)
        if len(looks) == 3:
            pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_s))

    monkeypatch.setattr(frame_wait.time, "sleep", sleep)
    assert [event.key for event in FrameWait().events(at_rest=True, hidden=True)] == [pygame.K_s]
    assert looks == [frame_wait.HIDDEN_MS / 1e3] * 3


def test_a_window_that_is_seen_looks_for_an_event_more_often(monkeypatch):
    pygame.display.init()
    pygame.event.clear()
    looks = []
    monkeypatch.setattr(frame_wait, "wait_for_event", lambda *waited: looks.append(waited))
    monkeypatch.setattr(frame_wait.pygame.event, "get", list)  # no device is added meanwhile
    wait = FrameWait()
    for _ in range(CALM_FRAMES + 1):
        wait.events(at_rest=True, hidden=False)
    assert looks == [(CALM_MS, frame_wait.LOOK_MS)]


def test_a_line_that_is_read_keeps_nothing_at_work_and_goes_all_the_same(player, waits):
    know_all_hints(player)
    player.parts.notices.say("Saved")
    assert play(player, waits, 100) == 100 - CALM_FRAMES and player.parts.notices.text
    player.wait(300)
    assert player.parts.notices.text is None


def test_what_nobody_sees_moves_on_undrawn_and_is_drawn_when_it_is_seen_again(glass, monkeypatch):
    with monkeypatch.context() as patch:
        patch.setattr(pygame.display, "get_active", lambda: False)
        patch.setattr(glass.parts.renderer, "draw", lambda _: pytest.fail("drawn"))
        patch.setattr(glass.parts.panel, "lay_out", lambda *_: pytest.fail("laid out"))
        before = glass.session.now
        assert not any(glass.frame() for _ in range(60))
        assert glass.session.now > before + 100
    glass.hold_time()
    glass.frame(elapsed_ns=0)
    seen = glass.parts.window.surface.copy()
    glass.frame(pygame.event.Event(pygame.WINDOWEXPOSED), elapsed_ns=0)
    assert pygame.image.tobytes(seen, "RGB") == pygame.image.tobytes(glass.parts.window.surface, "RGB")


def test_an_event_is_heard_while_nobody_sees_the_window(player, monkeypatch):
    monkeypatch.setattr(pygame.display, "get_active", lambda: False)
    player.key(pygame.K_SPACE, " ")
    assert player.session.paused


def test_what_was_done_beside_the_frames_ends_a_wait(player):
    pygame.event.clear()
    player.parts.background.do(lambda: time.sleep(0.05))
    assert pygame.event.wait(5000).type == pygame.USEREVENT  # and no event at all once the wait is over


def test_the_loop_waits_as_the_toy_allows(monkeypatch, player):
    asked = []
    wait = SimpleNamespace(events=lambda *told: asked.append(told) or [])
    monkeypatch.setattr(loop, "FrameWait", lambda: wait)
    monkeypatch.setattr(player.app, "frame", lambda *_: len(asked) == 3 and player.parts.quit())
    loop.run(player.app)
    assert len(asked) == 4 and all(len(told) == 2 for told in asked)
