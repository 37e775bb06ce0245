"""Laws of the maker: a glass suits the time it is made for, and takes the sand of the one before, grain by grain."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import load_rule, load_scene
from game.world.files.checked_table import CheckedTable
from game.world.scenes.hourglass_maker import SLOWEST, glass_for, glass_within, good_pace, resized, scene_of
from game.world.scenes.hourglass_spec import Glass, read
from game.world.sessions.action import Paint, Reshape
from game.world.sessions.recording import load_replay
from game.world.sessions.run_out import find_run_out
from game.world.sessions.session import Session
from tests.saved import save_replay


@pytest.mark.parametrize("seconds", [1, 10, 30, 60, 180])
def test_a_glass_made_for_a_time_suits_it(seconds):
    scene = scene_of(glass_for(seconds))
    pace = find_run_out(Session(scene).timeline.lookahead()).iterations / seconds
    assert good_pace(seconds) / 1.35 < pace < 1.35 * good_pace(seconds)
    assert SLOWEST <= good_pace(seconds) <= 240


@pytest.mark.parametrize("seconds", [86_400, 36_000, 1500])
def test_even_a_long_time_gets_a_glass_that_a_screen_can_show(seconds):
    glass = glass_for(seconds)
    assert glass.height <= 1200 and scene_of(glass).sand.any()


def test_a_glass_fits_the_lattice_it_is_asked_for():
    assert scene_of(glass_within(37, 90)).shape == (90, 37)
    with pytest.raises(ValueError, match="at least 5 cells"):
        glass_within(4, 90)


@pytest.mark.parametrize("name", ["hourglass", "paper"])
def test_a_scene_of_one_glass_is_the_glass_that_the_maker_would_make(name):
    for size in (None, (150, 211)):
        scene = load_scene(name, size)
        sand, walls = scene.glass.cells()
        assert (sand == scene.sand).all() and (walls == scene.walls).all()


def test_a_glass_is_filled_with_its_material_or_with_what_the_world_has():
    rule, glass = load_rule("water-and-oil"), glass_for(10)
    for material, filled in (("oil", "oil"), ("", "sand"), ("lava", "sand"), ("wall", "sand"), ("air", "sand")):
        world = scene_of(replace(glass, material=material), rule).world()
        assert (world.where(filled) == glass.cells()[0]).all() and (world.walls == glass.cells()[1]).all()


def test_a_glass_is_read_as_it_was_written():
    for glass in (glass_for(10), replace(glass_for(20), material="oil")):
        assert read(CheckedTable("a file", glass.as_dict())) == glass
    assert "material" not in glass_for(10).as_dict()  # older versions can read that


def test_a_scene_of_one_glass_of_water_is_a_glass_of_water():
    scene = load_scene("water-clock")
    assert scene.glass.material == "water"
    assert (scene_of(scene.glass, scene.rule).world().materials == scene.world().materials).all()


@pytest.mark.parametrize("name", ["funnel", "fullhd", "clocks", "blank"])
def test_other_scenes_are_no_glass(name):
    assert load_scene(name).glass is None


glasses = st.builds(
    Glass,
    st.integers(12, 70),
    st.integers(12, 70),
    st.integers(0, 3),
    st.integers(0, 3),
    st.floats(1, 9),
    st.floats(0, 1),
    st.floats(1, 4),
    st.floats(0, 1),
)


@given(st.lists(glasses, min_size=1, max_size=4), st.integers(0, 300))
def test_sand_poured_from_glass_to_glass_is_all_there_and_inside(line, iterations):
    session = Session(load_scene("paper"), 1)
    for glass in line:
        session.timeline.run(iterations)
        before = session.world.grains
        session.do(Reshape(glass))
        inside = glass.inside()
        assert session.world.grains == min(before, inside.sum())
        assert not (session.world.sand & ~inside).any() and (session.world.walls == glass.cells()[1]).all()
        assert session.account.balanced(session.world) and session.scene.glass == glass


def test_sand_that_fits_stays_where_it_is():
    session = Session(load_scene("paper"), 1)
    session.timeline.run(600)
    before = session.world.sand
    session.do(Reshape(replace(session.scene.glass, neck=3)))
    assert (session.world.sand == before).all()
    session.do(Reshape(replace(session.scene.glass, height=81, width=81)))
    assert (session.world.sand[10:71, 10:71] == before).all()


def test_upper_sand_stays_above_while_there_is_room():
    session = Session(load_scene("hourglass"), 1)
    session.timeline.run(3000)
    upper = session.world.sand[:120].sum()
    session.do(Reshape(replace(session.scene.glass, wall=6, curve=0.3)))
    assert session.world.sand[:120].sum() == upper


def test_filling_anew_is_booked():
    session = Session(load_scene("paper"), 1)
    session.timeline.run(300)
    session.do(Reshape(replace(session.scene.glass, fill=0.3), refill=True))
    glass = session.scene.glass
    assert (session.world.sand == glass.cells()[0]).all() and session.account.balanced(session.world)
    assert session.now == 300


def test_a_slider_that_is_dragged_is_one_act():
    session = Session(load_scene("paper"), 1)
    session.timeline.run(100)
    before = session.world.digest()
    for neck in (2, 3, 4, 5):
        session.do(Reshape(replace(session.scene.glass, neck=neck)), join=neck > 2)
    assert session.world.digest() != before
    session.undo()
    assert session.world.digest() == before and session.scene.name == "paper"


def test_another_glass_keeps_the_pace():
    session = Session(load_scene("paper"), 1)
    session.clock.speed = 333
    session.do(Reshape(replace(session.scene.glass, neck=5)))
    session.frame(16_000_000)
    assert session.clock.speed == 333


def test_every_colour_is_poured_as_it_was():
    session = Session(load_scene("hourglass"), 1)
    session.do(Paint("sand", (60.0, 60.0), (110.0, 60.0), 30, colour="indigo"))
    before = session.world.amounts
    for height in (200, 260, 181):
        session.timeline.run(100)
        session.do(Reshape(resized(session.scene.glass, height)))
        assert session.world.amounts == before and session.account.balanced(session.world)


def test_a_glass_survives_a_session_file(tmp_path):
    session = Session(scene_of(glass_for(20)), 1)
    save_replay(tmp_path / "glass.sandglass", session)
    assert load_replay(tmp_path / "glass.sandglass").scene.glass == session.scene.glass
