"""Comparing what you like: by keys alone and by mouse alone, with what lies over the worlds, and what is saved."""

import csv
import time

import pygame
import pytest
from PIL import Image

from game.play.ui.input import key_name
from game.world.rules.definition import load_definition
from game.world.rules.rule import Rule
from game.world.sand.differences import differing
from game.world.sand.ensemble import counts_at
from game.world.sessions.action import SetRule
from game.world.sessions.comparison import Comparison
from tests.play.player import Player
from tests.sweeps import sweep

SHIFT = pygame.KMOD_SHIFT
LONG_S = 30.0


@pytest.fixture
def paper():
    """Return a Player of the paper's glass, whose time stands still."""
    player = Player("paper", (1280, 720))
    player.hold_time()
    yield player
    player.parts.close()
    pygame.display.quit()


def choose(player, name, number):
    """Press one of the segments of a control."""
    player.click(player.parts_of(name)[number].center)


def pick(player, name, label):
    """Pick a label from a list in the panel."""
    player.click(player.control(name))
    rows = player.parts.panel.ui.parts(name)
    popup = player.parts.panel.ui.focus.popup
    player.click(rows[list(popup.options).index(label)].center)


def await_density(player):
    """Wait until the density maps are those of this iteration."""
    end = time.monotonic() + LONG_S
    player.wait(2)
    while player.parts.density.thread.working or player.parts.density.answer is None:
        assert time.monotonic() < end
        time.sleep(0.01)
        player.wait(1)
    player.wait(2)


def titles(player):
    return [title for title, _ in player.parts.display.sand_view.titles().values()]


def notes(player):
    return [note for _, note in player.parts.display.sand_view.titles().values()]


def test_by_keys_alone_the_papers_four_p_are_compared_up_to_iteration_200(paper, own_folder):
    paper.key(pygame.K_h, "H", SHIFT)
    assert titles(paper) == ["p = 0.25", "p = 0.5", "p = 0.75", "p = 1"]
    paper.session.clock.speed = 10_000
    paper.key(pygame.K_END, "", SHIFT)
    paper.wait(60)
    assert [each.world.iteration for each in paper.session.sessions.values()] == [200] * 4 and paper.session.paused
    paper.key(pygame.K_F7)
    paper.wait(1)
    assert all(note.endswith("cells differ") for note in notes(paper))
    paper.key(pygame.K_F8)
    await_density(paper)
    assert notes(paper) == ["t\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}200"] * 4
    paper.key(pygame.K_l, "L", SHIFT)
    paper.settle()
    assert len([*(own_folder / "measures").glob("*.png")]) == 4
    assert len([*(own_folder / "measures").glob("*.csv")]) == 1
    for _ in range(2):
        paper.key(pygame.K_ESCAPE)
    assert not isinstance(paper.session, Comparison) and not paper.parts.density.shown


def test_by_mouse_alone_two_orders_are_compared_and_their_differences_saved(paper, own_folder):
    choose(paper, "Differ in", 1)
    choose(paper, "Worlds", 0)
    paper.unfold("Which")
    pick(paper, "World 2", "Balanced")
    paper.click(paper.control("Compare"))
    assert titles(paper) == ["Margolus", "Balanced"]
    paper.session.clock.speed = 10_000
    paper.click(paper.control("Run to t"))
    paper.wait(60)
    choose(paper, "Show", 1)
    paper.wait(1)
    assert paper.parts.differences.shown and notes(paper)[0] != "0 cells differ"
    paper.click(paper.control("Save comparison"))
    paper.settle()
    (table,) = (own_folder / "measures").glob("*.csv")
    rows = list(csv.DictReader(table.open(newline="")))
    assert [(row["world"], row["iteration"]) for row in rows] == [("Margolus", "200"), ("Balanced", "200")]
    framed = paper.parts.display.sand_view.framed
    sizes = [Image.open(path).size for path in (own_folder / "measures").glob("*.png")]
    assert sizes == [rect.size for rect in framed.values()]
    choose(paper, "Show", 0)
    assert not paper.parts.differences.shown
    paper.click(paper.control("Compare"))
    assert not isinstance(paper.session, Comparison)


def test_rules_of_other_materials_are_compared_each_in_its_own_colours(paper):
    paper.parts.comparing.subject, paper.parts.comparing.number = "rule", 2
    paper.parts.comparing.choose_rule(1, next(each for each in paper.parts.rule_files.labels if "oil" in each.lower()))
    paper.key(pygame.K_h, "H", SHIFT)
    assert "Compiling" in paper.parts.notices.text
    paper.settle()
    one, other = paper.session.sessions.values()
    assert one.world.codes != other.world.codes and (one.world.sand == other.world.sand).all()
    paper.key(pygame.K_l, "l")
    paper.wait(40)
    column, row = 30, 10
    paper.drag(paper.pixel(column, row), paper.pixel(column + 4, row))
    assert one.world.sand[row, column] and other.world.sand[row, column]
    surface, view = paper.parts.window.surface, paper.parts.display.sand_view
    x, y = paper.pixel(column + 2, row)
    seen = {surface.get_at((x + pane.x - view.area.x, y + pane.y - view.area.y))[:3] for pane in view.panes}
    assert all(red > blue for red, _, blue in seen)  # sand in both


def test_worlds_that_would_all_be_alike_are_not_compared(paper):
    paper.parts.comparing.p = [0.5] * 4
    paper.key(pygame.K_h, "H", SHIFT)
    assert not isinstance(paper.session, Comparison) and "alike" in paper.parts.notices.text


def test_differences_need_worlds_side_by_side_and_follow_each_iteration(paper):
    paper.key(pygame.K_F7)
    assert not paper.parts.differences.shown and key_name("Shift+H") in paper.parts.notices.text
    paper.key(pygame.K_h, "H", SHIFT)
    paper.key(pygame.K_F7)
    for _ in range(60):
        paper.key(pygame.K_PERIOD, ".")
    paper.now_s += 10
    paper.wait(2)
    sessions = paper.session.sessions
    names = sorted(sessions, key=lambda name: name != paper.session.lead)
    wanted = differing([sessions[name].world for name in names])
    counts = {name: int(each.sum()) for name, each in zip(names, wanted, strict=True)}
    assert paper.parts.differences.counts == counts and max(counts.values()) > 0
    for name in sessions:
        assert paper.parts.display.sand_view.titles()[name][1] == f"{counts[name]:,} cells differ"


@sweep("started_at", [0, 30], keep=[30])
def test_density_is_that_of_many_runs_from_the_scenes_start_whenever_it_is_opened(paper, started_at):
    for _ in range(started_at):
        paper.key(pygame.K_PERIOD, ".")
    paper.key(pygame.K_F8)
    while paper.world.iteration < 50:
        paper.key(pygame.K_PERIOD, ".")
    await_density(paper)
    scene, answer = paper.session.scene, paper.parts.density.answer
    counts = counts_at(scene.world(paper.session.seed), scene.rule, [50], answer.runs)[0]
    (levels,) = answer.levels.values()
    walls = scene.walls
    assert answer.now == 50
    assert ((levels > 0) == (counts > 0))[~walls].all() and ((levels == 254) == (counts == answer.runs))[~walls].all()


def test_density_starts_from_what_was_done_last_and_goes_with_the_time_bar(paper):
    paper.key(pygame.K_F8)
    for _ in range(20):
        paper.key(pygame.K_PERIOD, ".")
    paper.key(pygame.K_c, "c")
    await_density(paper)
    (levels,) = paper.parts.density.answer.levels.values()
    assert not ((levels > 0) & (levels < 255)).any()
    paper.key(pygame.K_z, "", pygame.KMOD_CTRL)
    paper.session.seek(5)
    await_density(paper)
    assert paper.parts.density.answer.now == 5
    (levels,) = paper.parts.density.answer.levels.values()
    assert ((levels > 0) & (levels < 255)).any()


def test_only_one_thing_lies_over_the_sand(paper):
    paper.key(pygame.K_h, "H", SHIFT)
    shown = []
    for code in (pygame.K_h, pygame.K_F7, pygame.K_F8):
        paper.key(code)
        paper.wait(1)
        shown.append((paper.parts.forecasting.shown, paper.parts.differences.shown, paper.parts.density.shown))
    assert shown == [(True, False, False), (False, True, False), (False, False, True)]


def test_views_leave_no_step_to_undo_and_nothing_in_the_journal(paper):
    line = paper.session.timeline.history.line
    for code in (pygame.K_F8, pygame.K_F8):
        paper.key(code)
        paper.wait(1)
    assert paper.session.timeline.history.line is line


def test_the_iteration_of_the_world_is_reached_from_either_side(paper):
    paper.session.clock.speed = 3_000
    paper.session.seek(0)
    for at, begin in ((77, 0), (12, 77), (77, 12)):
        assert paper.world.iteration == begin
        paper.parts.commands.time.halt_at = at
        paper.key(pygame.K_END, "", SHIFT)
        paper.wait(40)
        assert paper.world.iteration == at and paper.session.paused
    paper.key(pygame.K_SPACE)
    paper.wait(3)
    assert paper.world.iteration > 77


def test_who_goes_elsewhere_on_the_way_to_an_iteration_is_not_held_there(paper):
    paper.key(pygame.K_END, "", SHIFT)
    assert not paper.session.paused
    paper.session.seek(300)
    paper.wait(3)
    assert paper.world.iteration > 300 and not paper.session.paused


def test_what_the_worlds_differ_in_is_kept_and_that_is_said(paper):
    paper.key(pygame.K_h, "H", SHIFT)
    paper.click(paper.control("p", 0.4))
    assert "keeps what its title says" in paper.parts.notices.text
    assert [each.rule.p for each in paper.session.sessions.values()] == [0.25, 0.5, 0.75, 1.0]
    paper.unfold("Bias, schedule and file")
    paper.click(paper.control("Bias", 0.8))
    paper.wait(1)
    assert all(each.rule.bias > 0 for each in paper.session.sessions.values())


def test_a_rule_that_has_nothing_of_what_is_here_is_left_out_and_named(paper):
    paper.parts.comparing.subject, paper.parts.comparing.number = "rule", 3
    for number, label in ((1, "Three sands"), (2, "Rolling sand")):
        paper.parts.comparing.choose_rule(number, label)
    paper.key(pygame.K_h, "H", SHIFT)
    paper.settle()
    assert titles(paper) == ["Sand", "Rolling sand"] and "Three sands" in paper.parts.notices.text
    paper.parts.notices.say("…")
    paper.key(pygame.K_ESCAPE)
    paper.parts.comparing.number = 2
    paper.key(pygame.K_h, "H", SHIFT)
    paper.settle()
    assert not isinstance(paper.session, Comparison) and "Three sands" in paper.parts.notices.text


def test_curves_are_drawn_for_all_worlds_whatever_rule_is_chosen_meanwhile(paper):
    paper.parts.comparing.subject = "seed"
    paper.key(pygame.K_h, "H", SHIFT)
    paper.key(pygame.K_l, "l")
    paper.session.paused = False
    for rule in ("water-and-oil", "sand"):
        paper.wait(40)
        paper.session.do(SetRule(Rule(definition=load_definition(rule))))
        paper.wait(40)
        written = paper.words()
        assert all(title in written for title in paper.session.sessions)
    assert len(paper.parts.plots.compared_table()[1]) % 4 == 0
