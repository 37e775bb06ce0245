"""The clock neither loses nor invents time."""

from hypothesis import given
from hypothesis import strategies as st

from game.world.sand.clock import NS_PER_S, STALL_NS, Clock

FRAMES = st.lists(st.integers(0, STALL_NS), min_size=1, max_size=200)


@given(FRAMES, st.integers(1, 10**6))
def test_iterations_are_exactly_the_time_that_passed(frames, speed):
    clock = Clock(speed)
    assert sum(clock.due(elapsed) for elapsed in frames) == sum(frames) * speed // NS_PER_S


def test_a_stall_is_cut_short():
    clock = Clock(1000)
    assert clock.due(86_400 * NS_PER_S) == clock.due(STALL_NS) == 250


def test_time_that_runs_backwards_or_stands_still_is_no_time():
    clock = Clock(1000)
    assert [clock.due(elapsed) for elapsed in (-5 * NS_PER_S, 0, -1)] == [0, 0, 0]


def test_an_hour_of_frames_at_59_94_hz_loses_nothing():
    clock, frame_ns, frames = Clock(240), 16_683_350, 60 * 60 * 60
    assert sum(clock.due(frame_ns) for _ in range(frames)) == frames * frame_ns * 240 // NS_PER_S


def test_a_change_of_speed_keeps_the_fraction_of_an_iteration():
    clock = Clock(1)
    assert clock.due(STALL_NS) == 0
    clock.speed = 3
    assert clock.due(STALL_NS) == 1  # a quarter from before and three quarters now
