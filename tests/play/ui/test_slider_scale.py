"""A slider's arithmetic: every value can be reached, steps never stick, and the spelling is short."""

import pytest

from game.play.ui.slider_scale import SliderScale
from game.world.sand import parameters

SCALES = [
    SliderScale(parameters.P),
    SliderScale(parameters.BIAS),
    SliderScale(parameters.UI_SCALE),
    SliderScale(parameters.BRUSH),
    SliderScale(parameters.CELL),
    SliderScale(parameters.SIDE),
    SliderScale(parameters.SPEED, log=True),
    SliderScale(parameters.SIDE, log=True),
    SliderScale(parameters.BRUSH, log=True),
]
IDS = [f"{scale.knob.name}{' log' * scale.log}" for scale in SCALES]


@pytest.mark.parametrize("scale", SCALES, ids=IDS)
def test_the_ends_are_exact_and_of_the_knob_s_kind(scale):
    for fraction, end in (
        (0.0, scale.knob.low),
        (-3.0, scale.knob.low),
        (1.0, scale.knob.high),
        (1.5, scale.knob.high),
    ):
        assert scale.at(fraction) == end
        assert isinstance(scale.at(fraction), int if scale.knob.whole else float)


@pytest.mark.parametrize("scale", SCALES, ids=IDS)
def test_every_value_a_slider_gives_is_one_the_knob_takes(scale):
    for i in range(1001):
        scale.knob.check(scale.at(i / 1000))


@pytest.mark.parametrize("scale", SCALES, ids=IDS)
@pytest.mark.parametrize("shift", (False, True))
def test_steps_go_from_end_to_end_and_back_without_sticking(scale, shift):
    for way, end in ((1, scale.knob.high), (-1, scale.knob.low)):
        value = scale.at(0.0 if way > 0 else 1.0)
        for _ in range(20_000):
            if value == end:
                break
            moved = scale.stepped(value, way, shift)
            assert (moved - value) * way > 0
            value = scale.knob.check(moved)
        assert value == end


def test_a_hundredth_is_exactly_a_hundredth():
    scale, value = SliderScale(parameters.P), 0.0
    for i in range(1, 101):
        value = scale.stepped(value, 1)
        assert value == float(f"{i / 100:.2f}") == scale.at(i / 100)


def test_a_fraction_and_its_value_agree():
    for scale in SCALES:
        for i in range(11):
            assert scale.fraction(scale.at(i / 10)) == pytest.approx(i / 10, abs=0.06)


def test_values_are_spelled_short():
    assert SliderScale(parameters.P).spell(0.25) == "0.25"
    assert SliderScale(parameters.P).spell(0.251) == "0.251"
    assert SliderScale(parameters.BIAS).spell(-0.5) == "–0.50"
    assert SliderScale(parameters.BRUSH).spell(12) == "12 cells" and SliderScale(parameters.BRUSH).spell(1) == "1 cell"
    speed = SliderScale(parameters.SPEED, log=True)
    assert [speed.spell(v) for v in (1.5, 240, 12_000, 1_000_000)] == [
        "1.5 it./s",
        "240 it./s",
        "12 k it./s",
        "1 M it./s",
    ]
    assert [SliderScale(parameters.SPEED, log=True).spell(v) for v in (6.1873, 13.0456, 987.6, 4321.5, 123_456)] == [
        *("6.19 it./s", "13 it./s", "988 it./s", "4322 it./s", "123 k it./s")
    ]
