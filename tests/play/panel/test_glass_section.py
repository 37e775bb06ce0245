"""The hourglass maker in the panel: the glass changes under a slider, the sand stays, and one undo takes it back."""

import pygame
import pytest

from game.play.panel.glass_section import running_time
from game.world.scenes.hourglass_maker import HEIGHT
from game.world.scenes.scene import load_scene
from game.world.sessions.action import Clear, Flip, Paint, Turn
from game.world.sessions.run_out import find_run_out
from game.world.sessions.session import Session
from tests.play.player import Player
from tests.sweeps import sweep


@pytest.fixture
def maker():
    """Return a player of the hourglass with the maker open and time held."""
    player = Player("hourglass", size=(900, 1400))
    player.unfold("Glass")
    player.hold_time()
    player.session.timeline.run(200)
    player.wait(1)
    yield player
    pygame.display.quit()


def drag(player, name, *shares):
    """Drag a slider along its track."""
    player.drag(*(player.control(name, share) for share in shares))
    player.settle()


@sweep(
    ("name", "share"),
    [("Neck", 0.5), ("Curve", 0.6), ("Wall", 0.35), ("Glass size", 0.8)],
    keep=[("Neck", 0.5), ("Glass size", 0.8)],
)
def test_the_sand_stays_in_the_glass_that_changes(maker, name, share):
    grains, walls = maker.world.grains, maker.world.walls
    drag(maker, name, share, share + 0.02, share + 0.04)
    glass = maker.session.scene.glass
    assert maker.world.grains == grains and maker.session.account.balanced(maker.world)
    assert maker.world.walls.shape != walls.shape or (maker.world.walls != walls).any()
    assert not (maker.world.sand & ~glass.inside()).any()


def test_one_undo_takes_a_drag_back(maker):
    before = maker.world.digest()
    drag(maker, "Wall", 0.4, 0.5, 0.6, 0.7)
    drag(maker, "Curve", 0.4, 0.5, 0.6)
    maker.session.undo()
    assert maker.session.scene.glass.curve == pytest.approx(0.95) and maker.world.digest() != before
    maker.session.undo()
    assert maker.world.digest() == before


def test_the_fill_slider_fills_the_upper_bulb(maker):
    drag(maker, "Fill", 0.3)
    glass = maker.session.scene.glass
    assert glass.fill == pytest.approx(0.3, abs=0.05) and (maker.world.sand == glass.cells()[0]).all()
    assert maker.session.account.balanced(maker.world)


def test_a_glass_too_small_for_its_sand_is_filled_anew(maker):
    drag(maker, "Glass size", 0.3)
    glass = maker.session.scene.glass
    assert glass.height < 120 and maker.world.grains == glass.cells()[0].sum()
    assert "filled anew" in maker.parts.notices.text and maker.session.account.balanced(maker.world)


def test_how_long_it_runs_is_told(maker):
    drag(maker, "Glass size", 0.5)
    maker.wait(2)
    left = find_run_out(maker.session.timeline.lookahead()).at - maker.session.now
    seconds = round(left / maker.session.clock.speed)
    assert f"Runs for {seconds // 60}:{seconds % 60:02} more" in maker.words()


def test_restart_fills_the_glass_that_was_made(maker):
    drag(maker, "Wall", 0.5)
    glass = maker.session.scene.glass
    maker.key(pygame.K_r, "r")
    assert maker.session.scene.glass == glass and (maker.world.sand == glass.cells()[0]).all()


def test_any_scene_can_become_a_glass(maker):
    maker.parts.sessions.load("funnel")
    maker.wait(1)
    grains = maker.world.grains
    maker.click(maker.control("Make a glass"))
    assert maker.session.scene.glass is not None and maker.world.grains == grains


@sweep("size", [(64, 600), (100, 1000), (16384, 16), (3, 30)], keep=[(3, 30)])
def test_a_lattice_of_any_proportions_becomes_a_glass_of_any_size(maker, size):
    maker.parts.sessions.open_scene(load_scene("blank", size), 1)
    maker.wait(1)
    maker.click(maker.control("Make a glass"))
    maker.wait(1)
    for start, end, height in ((0.4, -0.1, HEIGHT.low), (0.6, 1.1, HEIGHT.high)):
        drag(maker, "Glass size", start, end)
        assert maker.session.scene.glass.height == maker.world.shape[0] == height


def test_a_glass_that_was_made_is_saved_like_any_scene(maker):
    drag(maker, "Wall", 0.5)
    sand, walls = maker.world.sand, maker.world.walls
    maker.key(pygame.K_s, mod=pygame.KMOD_CTRL)
    maker.key(pygame.K_RETURN)
    maker.settle()
    path = maker.parts.notices.text.removeprefix("Saved as ")
    maker.parts.sessions.load("blank")
    maker.drop(path)
    assert (maker.world.sand == sand).all() and (maker.world.walls == walls).all()


def test_a_glass_is_filled_with_any_powder_or_liquid_of_its_rule():
    player = Player("water-clock", size=(900, 1400))
    player.unfold("Glass")
    player.hold_time()
    player.wait(1)
    assert "Filled with" in player.parts.panel.ui.rects and player.session.scene.glass.material == "water"
    player.click(player.control("Filled with"))
    player.click(player.parts_of("Filled with")[-1].center)
    player.settle()
    assert player.session.scene.glass.material == "oil"
    room = player.session.scene.glass.cells()[0].sum()
    assert player.world.amounts == (0, 0, 0, 0, room) and player.session.account.balanced(player.world)
    player.key(pygame.K_z, mod=pygame.KMOD_CTRL)
    assert player.world.amounts[4] == 0 and player.world.amounts[3] == room
    pygame.display.quit()


def test_sand_alone_leaves_no_choice_of_what_fills_a_glass(maker):
    assert "Filled with" not in maker.parts.panel.ui.rects


def test_a_slider_stays_under_the_pointer_when_lines_above_it_go():
    player = Player("hourglass", size=(900, 560))  # low: the fold is scrolled to
    player.unfold("Glass")
    player.hold_time()
    player.wait(1)
    places = [player.control("Neck", share) for share in (0.2, 0.3, 0.4)]
    player.drag(*places)
    player.settle()
    assert player.session.scene.name == "glass" and not player.session.scene.notice
    rect = player.parts.panel.ui.rects["Neck"]
    assert rect.collidepoint(places[-1])
    pygame.display.quit()


def test_a_drag_to_a_small_glass_and_back_leaves_a_full_one(maker):
    start = maker.session.scene.glass
    track = maker.parts_of("Glass size")[0]
    pos = maker.control("Glass size", 0.6)
    maker.drag(*((track.left + int(share * track.width), pos[1]) for share in (0.6, 0.3, 0.1, 0.3, 0.6)))
    maker.settle()
    glass = maker.session.scene.glass
    assert (maker.world.sand == glass.cells()[0]).all() and maker.session.account.balanced(maker.world)
    assert glass.fill == start.fill and maker.world.grains > 1000
    assert "filled anew" not in (maker.parts.notices.text or "")


@pytest.mark.parametrize(
    ("walls", "words"),
    [
        ((87.0, 118.0, 93.0, 118.0), "What is above the neck is stuck."),
        (None, "Nothing is above the neck."),
    ],
)
def test_a_plugged_glass_is_not_said_to_be_empty(walls, words):
    session = Session(load_scene("hourglass"))
    if walls:
        session.do(Paint("wall", walls[:2], walls[2:], 4))
    else:
        session.do(Clear())
    assert told(session) == words


def told(session):
    return running_time(session, find_run_out(session.timeline.lookahead()))


@sweep("quarters", [1, 3], keep=[1])
@pytest.mark.parametrize("begun", [0, 1500])
@sweep("name", ["hourglass", "paper", "sandpile", "tower", "clocks", "mixing"], keep=["tower"])
def test_sand_beside_the_neck_is_not_said_to_be_below_it(name, quarters, begun):
    session = Session(load_scene(name))
    session.timeline.run(begun)
    session.do(Turn(quarters))
    assert told(session).startswith("Runs for")
    session.timeline.run(20_000)
    assert told(session) == "All is at rest, and nothing is above a neck."


def test_no_sand_is_above_the_neck_only_where_all_has_run_through_or_there_is_none():
    session = Session(load_scene("clocks"))  # three glasses, which run out one after the other
    while told(session) != "Nothing is above the neck.":
        assert session.world.sand[:95].any()
        session.timeline.run(500)
    assert not session.world.sand[:94].any()
    session.do(Flip())
    assert told(session).startswith("Runs for")
    session.do(Clear())
    assert told(session) == "Nothing is above the neck."
