"""A slider's arithmetic: every value can be reached, steps never stick, and the spelling is short."""

import pytest

from game.play.ui.slider_scale import Dial
from game.world.sand import parameters

DIALS = [
    Dial(parameters.P),
    Dial(parameters.BIAS),
    Dial(parameters.UI_SCALE),
    Dial(parameters.BRUSH),
    Dial(parameters.CELL),
    Dial(parameters.SIDE),
    Dial(parameters.SPEED, log=True),
    Dial(parameters.SIDE, log=True),
    Dial(parameters.BRUSH, log=True),
]
IDS = [f"{dial.knob.name}{' log' * dial.log}" for dial in DIALS]


@pytest.mark.parametrize("dial", DIALS, ids=IDS)
def test_the_ends_are_exact_and_of_the_knob_s_kind(dial):
    for fraction, end in ((0.0, dial.knob.low), (-3.0, dial.knob.low), (1.0, dial.knob.high), (1.5, dial.knob.high)):
        assert dial.at(fraction) == end
        assert isinstance(dial.at(fraction), int if dial.knob.whole else float)


@pytest.mark.parametrize("dial", DIALS, ids=IDS)
def test_every_value_a_slider_gives_is_one_the_knob_takes(dial):
    for i in range(1001):
        dial.knob.check(dial.at(i / 1000))


@pytest.mark.parametrize("dial", DIALS, ids=IDS)
@pytest.mark.parametrize("shift", (False, True))
def test_steps_go_from_end_to_end_and_back_without_sticking(dial, shift):
    for way, end in ((1, dial.knob.high), (-1, dial.knob.low)):
        value = dial.at(0.0 if way > 0 else 1.0)
        for _ in range(20_000):
            if value == end:
                break
            moved = dial.stepped(value, way, shift)
            assert (moved - value) * way > 0
            value = dial.knob.check(moved)
        assert value == end


def test_a_hundredth_is_exactly_a_hundredth():
    dial, value = Dial(parameters.P), 0.0
    for i in range(1, 101):
        value = dial.stepped(value, 1)
        assert value == float(f"{i / 100:.2f}") == dial.at(i / 100)


def test_a_fraction_and_its_value_agree():
    for dial in DIALS:
        for i in range(11):
            assert dial.fraction(dial.at(i / 10)) == pytest.approx(i / 10, abs=0.06)


def test_values_are_spelled_short():
    assert Dial(parameters.P).spell(0.25) == "0.25"
    assert Dial(parameters.P).spell(0.251) == "0.251"
    assert Dial(parameters.BIAS).spell(-0.5) == "–0.50"
    assert Dial(parameters.BRUSH).spell(12) == "12"
    speed = Dial(parameters.SPEED, log=True)
    assert [speed.spell(v) for v in (1.5, 240, 12_000, 1_000_000)] == [
        "1.5",
        "240",
        "12 k",
        "1 M",
    ]
    assert [Dial(parameters.SPEED, log=True).spell(v) for v in (6.1873, 13.0456, 987.6, 4321.5, 123_456)] == [
        *("6.19", "13", "988", "4322", "123 k")
    ]
