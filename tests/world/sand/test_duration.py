"""Durations are read as people write them, and shown as they read them."""

import pytest

from game.world.sand.duration import parse_duration, spell, spell_left, spell_short


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("90", 90),
        ("90s", 90),
        ("3m", 180),
        ("1:30", 90),
        ("1h", 3600),
        ("1h30m", 5400),
        ("1:02:03", 3723),
        (" 2.5 M ", 150),
        ("1.5", 1.5),
    ],
)
def test_a_time_is_read(text, seconds):
    assert parse_duration(text) == seconds


@pytest.mark.parametrize(
    "text", ["", "soon", "3x", "1:60", "-3", "0", "0.5s", "25h", "1e3", "m", "nan", "1:2:3:4", "3m3m"]
)
def test_what_is_no_time_is_refused_in_one_line(text):
    with pytest.raises(ValueError, match="timer must be a time such as 90, 90s, 3m, 1:30 or 1h") as error:
        parse_duration(text)
    assert "\n" not in str(error.value)


def test_times_are_spelled():
    assert [spell(180), spell(3723), spell(180.02, 2), spell(59.999, 2)] == ["3:00", "1:02:03", "3:00.02", "1:00.00"]
    assert [spell_left(150.01), spell_left(0.01), spell_left(0), spell_left(-3)] == ["2:31", "0:01", "0:00", "0:00"]
    assert [spell_short(each) for each in (1, 59.7, 90, 3600, 86_400)] == ["1 s", "1:00", "1:30", "1:00 h", "24:00 h"]
