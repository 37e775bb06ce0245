"""The trial of timers: it plays what it says, by the real clock, and tells late ones from those on time."""

import pygame
import pytest

from game.play.trials import timer_trial
from game.play.trials.timer_trial import TimedRun, table, trials


def test_a_timer_of_a_second_ends_on_time_by_the_real_clock():
    report = timer_trial.play(TimedRun(1.0, "paper", strokes=True, changes=True), 3)
    pygame.display.quit()
    assert report["fallen"] and report["late_s"] >= 0 and report["iterations"] > 0
    assert report["late_s"] < timer_trial.ALLOWED_S + max(report["frame_s"], report["worst_frame_s"])


def test_trials_are_the_same_each_time_and_of_all_kinds():
    some = trials(20, 10, 60)
    assert some == trials(20, 10, 60) and all(10 <= each.seconds <= 60 for each in some)
    words = " ".join(each.words for each in some)
    assert all(kind in words for kind in timer_trial.ALONE.values())


@pytest.mark.parametrize(("late_s", "status"), [(0.05, 0), (0.3, 1)])
def test_a_late_timer_fails_the_command(monkeypatch, capsys, late_s, status):
    report = {"late_s": late_s, "frame_s": 0.016, "worst_frame_s": 0.1, "fallen": True, "iterations": 5}
    whole = report | {"seconds": 10.0, "scene": "", "words": "nothing"}
    monkeypatch.setattr(timer_trial, "run", lambda wanted, together: [whole])
    monkeypatch.setattr("sys.argv", ["timer_trial"])
    assert timer_trial.main() == status
    assert table([whole]) in capsys.readouterr().out
