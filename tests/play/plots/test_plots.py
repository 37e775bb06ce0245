"""The plots: beside the sand, never over anything, and nothing at all when closed."""

import csv
from dataclasses import fields, replace
from itertools import pairwise, product

import numpy as np
import pygame
import pytest

from game import load_rule
from game.play.plots import charts, comparison_cards, material_cards
from game.play.plots.reactions_card import figure
from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.theme import Theme
from game.play.window.layout import WindowLayout
from game.world.sessions import measurements
from game.world.sessions.action import Clear, Draw, Paint, SetRule
from tests.play.player import Player
from tests.sweeps import sweep


@pytest.mark.parametrize("panel_shown", [True, False])
@pytest.mark.parametrize("shape", [(240, 180), (90, 400), (1, 1)])
@pytest.mark.parametrize(("size", "scale"), [((640, 480), 1), ((1280, 720), 1), ((1280, 720), 2), ((3840, 2160), 3)])
def test_the_plots_take_room_from_the_sand_alone(size, scale, shape, panel_shown):
    with_plots = WindowLayout(Theme(scale), size, panel_shown, shape, plotted=True)
    without = WindowLayout(Theme(scale), size, panel_shown)
    parts = [with_plots.sand, with_plots.bar, with_plots.status_line, *[with_plots.panel] * panel_shown]
    assert (with_plots.bar, with_plots.status_line, with_plots.panel) == (
        without.bar,
        without.status_line,
        without.panel,
    )
    if with_plots.plots is None:
        assert with_plots.sand == without.sand
        return
    assert not any(with_plots.plots.colliderect(each) for each in parts)
    assert with_plots.plots.union(with_plots.sand) == without.sand


def test_l_shows_them_and_takes_them_away(glass):
    before = glass.parts.display.layout.sand
    glass.key(pygame.K_l, "l")
    glass.wait(20)
    assert glass.parts.display.layout.plots and glass.parts.display.layout.sand.width < before.width
    glass.key(pygame.K_l, "l")
    glass.wait(1)
    assert glass.parts.display.layout.plots is None and glass.parts.display.layout.sand == before


def test_closed_they_measure_nothing(glass, monkeypatch):
    monkeypatch.setattr("game.play.plots.plots.Measurements.follow", None)  # would not be called in vain
    glass.wait(40)


def test_still_plots_of_a_still_world_are_not_drawn_again(glass):
    glass.key(pygame.K_l, "l")
    glass.hold_time()
    glass.wait(40)
    area = glass.parts.display.layout.plots
    assert glass.parts.plots.draw(glass.parts.window.surface) == []
    glass.parts.plots.forget()
    assert glass.parts.plots.draw(glass.parts.window.surface) == [area]


@pytest.mark.parametrize(("size", "makes_room"), [((400, 300), False), ((640, 480), True)])
def test_a_window_without_room_says_so_and_which_key_makes_some(size, makes_room):
    player = Player("hourglass")
    player.parts.settings.override("ui_scale", 2)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    player.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
    player.key(pygame.K_l, "l")
    player.wait(1)
    assert player.parts.display.layout.plots is None and "too small" in player.parts.notices.text
    assert ("P hides the panel" in player.parts.notices.text) == makes_room
    player.key(pygame.K_p, "p")
    player.wait(1)
    assert (player.parts.display.layout.plots is not None) == makes_room
    player.parts.close()
    pygame.display.quit()


@pytest.mark.parametrize("panel_shown", [True, False])
@pytest.mark.parametrize(("size", "scale"), [((640, 480), 1), ((1280, 720), 1), ((1280, 720), 2), ((1920, 1080), 2)])
def test_on_usual_screens_there_is_room_for_the_plots_at_any_scale(size, scale, panel_shown):
    layout = WindowLayout(Theme(scale), size, panel_shown, (240, 180), plotted=True)
    assert layout.plots and layout.sand.width >= 240 and layout.sand.height >= 240


def test_the_tables_are_saved_with_a_header(glass, own_folder, monkeypatch):
    monkeypatch.setattr("game.play.plots.plots.SHARE", 0)  # on whatever machine: as often as it may be
    glass.key(pygame.K_l, "l")
    glass.wait(60)
    glass.hold_time()
    glass.key(pygame.K_l, "L", pygame.KMOD_SHIFT)
    glass.settle()
    story, profile = sorted((own_folder / "measures").glob("*.csv"), key=lambda path: len(path.name))
    rows = list(csv.reader(story.open(newline="")))
    assert tuple(rows[0]) == glass.parts.plots.measurements.columns and len(rows) > 3
    assert all(int(row[2]) + int(row[3]) == glass.world.grains for row in rows[1:])
    assert len(list(csv.reader(profile.open(newline="")))) == glass.world.shape[1] + 1


def test_the_row_is_the_neck_unless_the_player_sets_another(glass):
    plots = glass.parts.plots
    assert plots.measured_row == 120
    plots.measured_row = 77
    glass.key(pygame.K_l, "l")
    glass.wait(2)
    assert plots.measurements.row == 77
    glass.parts.sessions.load("paper")
    glass.wait(2)
    assert plots.measurements.row == 30


def test_the_row_lies_in_the_lattice_however_it_is_turned(player):
    plots, (high, wide) = player.parts.plots, player.world.shape
    player.parts.commands.sand.turn(1)
    plots.measured_row = wide
    player.now_s += 1e6
    player.wait(1)
    player.parts.commands.sand.turn(3)
    assert player.world.shape == (high, wide) and plots.measured_row == high < wide


def written(player):
    """Return the words in the cards: (rect, text, size)."""
    return [each for each in player.written() if each[0].colliderect(player.parts.display.layout.plots)]


@sweep(
    ("size", "scale"),
    [((1280, 720), 0.75), ((1280, 720), 1), ((2560, 1600), 2)],
    keep=[((1280, 720), 0.75)],
)
def test_each_plot_has_a_scale_from_zero_to_a_round_figure_and_the_budget_is_named(size, scale):
    player = coloured(size, scale, 1)
    area, drawn = player.parts.display.layout.plots, player.drawn()
    cards = [rect for stroke, rect, *_ in drawn if stroke is draw_list.box and area.contains(rect)]
    for card in cards[:4]:  # then come the audit, and its swatches
        strokes = [(stroke, rect, how) for stroke, rect, *how in drawn if card.colliderect(rect) and rect != area]
        figures = [(rect, how[0]) for _, rect, how in strokes if how[2:] == [look.FAINT, 1]]
        figures = sorted(
            ((rect, text) for rect, text in figures if "iteration" not in text), key=lambda each: -each[0].y
        )
        (lowest, zero), *_, (_, top) = figures
        assert zero == "0" and top.replace(",", "").replace(".", "").strip("0") in {*"1234568", "15"}
        assert all(low.top >= high.bottom for (low, _), (high, _) in pairwise(figures))
        assert all(card.contains(rect) for rect, _ in figures)
        charted = [rect for stroke, rect, _ in strokes if stroke in (charts.curve, charts.hill)]
        assert all(rect.left > lowest.right for rect in charted)
    assert "16 ms" in [text for _, text in figures]
    pygame.display.quit()


@pytest.mark.parametrize("number", [0, 0.1, 0.11, 1, 1.6, 7, 99, 100, 5224, 12345678])
def test_a_round_figure_is_at_most_half_as_large_again(number):
    assert number <= charts.round_up(number) <= 1.5 * number + 1e-9


def coloured(size, scale, factor):
    """Return a player who looks at the plots of a world with all colours, many times as many grains on its books."""
    player = Player("rainbow", size)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    player.parts.settings.override("ui_scale", scale)
    player.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
    player.key(pygame.K_l, "l")
    player.hold_time()
    player.session.do(Paint("erase", (40.0, 30.0), (120.0, 70.0), 9))
    account = player.session.account
    tallies = {
        field.name: tuple(factor * each for each in getattr(account, field.name))
        for field in fields(account)
        if field.name != "kept"
    }
    player.session.timeline.moment.account = replace(account, **tallies)
    player.wait(40)
    samples = player.parts.plots.measurements.samples
    samples[:] = [each._replace(frame_ms=9.0) for each in samples]  # on whatever machine
    return player


@pytest.mark.parametrize("slowest_ms", [3.2, 123.4, 12_345.6])
def test_a_slow_frame_leaves_room_for_its_title(slowest_ms):
    player = coloured((900, 520), 1, 1)
    player.parts.plots.measurements.samples[-1] = player.parts.plots.measurements.samples[-1]._replace(
        frame_ms=slowest_ms
    )
    theme = player.parts.display.theme
    rect = next(rect for rect, text, _ in written(player) if text == "Slowest frame")
    assert theme.width("Slowest frame", look.SMALL) <= rect.width
    pygame.display.quit()


@sweep("factor", [1, 15, 1500], keep=[1500])
@sweep(
    ("size", "scale"),
    [((900, 520), 1), ((1280, 720), 1), ((1300, 480), 1), ((1065, 480), 1), ((2560, 1600), 3)],
    keep=[((900, 520), 1), ((2560, 1600), 3)],
)
def test_the_books_of_eight_colours_can_be_read_at_any_size(size, scale, factor):
    player = coloured(size, scale, factor)
    area, theme = player.parts.display.layout.plots, player.parts.display.theme
    words = [each for each in written(player) if each[1]]
    assert sum(text.startswith("=") for _, text, _ in words) >= 8
    seen = []
    for rect, text, kind in words:
        assert area.contains(rect) and rect.height >= 0.9 * theme.line_height(kind), text
        wide = theme.width(text, kind)
        assert wide <= rect.width, text
        align = "right" if text.lstrip("=+-")[:1].isdigit() else "left"
        seen += [pygame.Rect(rect.right - wide if align == "right" else rect.x, rect.y, min(wide, rect.width), 1)]
    numbers = [box for box, (_, text, _) in zip(seen, words, strict=True) if text[0] in "=+-0123456789"]
    assert all(len(each.collidelistall(numbers)) == 1 for each in numbers)
    pygame.display.quit()


def test_each_colour_has_a_row_that_adds_up(player):
    for colour in ("indigo", "amber", "rose"):
        player.session.do(Paint("sand", (20.0, 50.0), (90.0, 50.0), 9, colour=colour))
    player.session.do(Paint("erase", (30.0, 50.0), (60.0, 50.0), 5))
    rows, now = player.session.account.rows, player.world.amounts
    assert [row[0] for row in rows] == [0, 2, 4]
    for number, start, painted, erased, poured, swallowed, formed, used, left in rows:
        assert start + painted - erased + poured - swallowed == left == now[number] and formed == used == 0
    player.key(pygame.K_l, "l")
    player.wait(20)
    texts = [text for _, text, _ in written(player)]
    assert all(f"={now[number]:,}" in texts for number in (0, 2, 4))


def test_sand_of_one_colour_has_its_sums_alone(glass):
    glass.key(pygame.K_l, "l")
    glass.wait(20)
    texts = [text for _, text, _ in written(glass)]
    assert "at the start" in texts and "start" not in texts


def test_grains_that_changed_their_colour_alone_are_noticed(player):
    player.key(pygame.K_l, "l")
    player.session.do(Paint("sand", (20.0, 50.0), (90.0, 50.0), 9, colour="indigo"))
    account = player.session.account
    swapped = replace(account, painted_by_kind=account.painted_by_kind[::-1])
    player.session.timeline.moment.account = swapped
    player.wait(20)
    assert "but in other colours" in [text for _, text, _ in written(player)]


def test_the_audit_balances_after_whatever_is_done(player):
    generator = np.random.default_rng(90)
    for number in range(60):
        material = ["sand", "erase", "wall"][generator.integers(3)]
        places = [tuple(map(float, generator.integers(0, 90, 2))) for _ in range(2)]
        player.session.do(Clear() if number == 40 else Paint(material, *places, int(generator.integers(1, 20))))
        player.frame()
        lines = player.session.account.lines
        total = sum({"": 1, "+": 1, "-": -1, "=": 0}[sign] * grains for sign, _, grains in lines)
        assert lines[-1] == ("=", "now", total) and total == player.world.grains


def test_a_window_that_has_become_too_small_for_the_plots_says_so(glass):
    glass.key(pygame.K_l, "l")
    glass.wait(2)
    assert glass.parts.display.layout.plots is not None
    pygame.display.set_mode((400, 300), pygame.RESIZABLE, 32)
    glass.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=400, y=300))
    glass.wait(2)
    assert glass.parts.display.layout.plots is None and "too small" in glass.parts.notices.text
    glass.key(pygame.K_l, "l")
    glass.wait(2)
    assert "too small" not in (glass.parts.notices.text or "")


def test_a_world_of_several_materials_shows_each_with_its_name_number_and_colour_and_the_sums_it_keeps():
    player = Player("aquarium")
    player.parts.brush.material = "water"
    player.parts.commands.give("view.toggle_plots")
    player.wait(40)
    player.hold_time()
    player.wait(40)
    world, written = player.world, player.words()
    amounts = dict(zip(world.codes.names, world.amounts, strict=True))
    for name in ("sand", "water", "oil"):
        assert f"{amounts[name]:,}" in written and name in written
    start = player.session.account.start_by_kind[world.codes.code("oil")]
    assert f"{start:,} + 0 – 0 = {start:,}" in written and "to the cell" in written
    assert f"{amounts['water']:,} cells of water" in written
    pygame.display.quit()


def test_a_sum_that_some_events_may_change_says_which_and_by_how_much(monkeypatch):
    monkeypatch.setattr("game.play.plots.plots.SHARE", 0)  # on whatever machine: as often as it may be
    player = Player("acid-cave", (1280, 1500))
    player.parts.commands.give("view.toggle_plots")
    player.wait(240)
    player.hold_time()
    player.wait(40)
    world, written, account = player.world, player.words(), player.session.account
    sand = world.codes.code("sand")
    eaten = account.start_by_kind[sand] - world.amounts[sand]
    assert eaten > 10 and "sand, but acid eats" in written
    assert f"{account.start_by_kind[sand]:,} + 0 – 0 – {eaten:,} by events = {world.amounts[sand]:,}" in written
    pygame.display.quit()


@sweep(
    ("first", "then"),
    [("sand", "alchemy"), ("alchemy", "water-and-oil"), ("alchemy", "sand")],
    keep=[("alchemy", "water-and-oil")],
)
def test_plots_begin_anew_when_the_rule_brings_other_materials(first, then):
    player = Player("blank", (1280, 720))
    player.session.do(SetRule(load_rule(first)))
    player.session.do(Paint("sand", (20.0, 20.0), (60.0, 20.0), 9))
    player.key(pygame.K_l, "l")
    player.wait(20)
    player.hold_time()
    player.session.do(SetRule(load_rule(then)))
    player.wait(3)
    measured = player.parts.plots.measurements
    assert len({len(row) for row in measured.rows()} | {len(measured.columns)}) == 1
    player.session.undo()
    player.wait(3)
    assert player.parts.plots.measurements.codes == load_rule(first).codes
    player.parts.close()
    pygame.display.quit()


def test_the_forecast_of_any_material_is_chosen_and_named():
    player = Player("aquarium")
    player.hold_time()
    player.parts.commands.give("view.toggle_forecast")
    player.frame()
    assert player.parts.forecasting.of == "sand"
    player.parts.forecasting.of = "oil"
    player.parts.forecasting.ahead = 1
    while not (player.parts.forecasting.answer and player.parts.forecasting.answer.request.of == "oil"):
        player.frame(elapsed_ns=0)
        pygame.time.wait(5)
    player.wait(20)
    assert "Oil at iteration" in player.words()
    player.parts.close()
    pygame.display.quit()


def test_reactions_are_told_by_name_with_how_often_they_come_about():
    player = Player("volcano", (1280, 1500))
    player.session.do(Draw("rectangle", "water", (30.0, 20.0), (90.0, 60.0)))
    player.session.do(Draw("rectangle", "lava", (50.0, 20.0), (70.0, 40.0)))
    player.parts.commands.give("view.toggle_plots")
    player.frame()
    assert "Nothing has reacted yet." in player.words()
    player.wait(60)
    player.hold_time()
    player.wait(20)
    rates, written = player.parts.plots.measurements.reactions(), player.words()
    assert rates["water quenches lava"][-1] >= 0 and "water quenches lava" in written
    player.parts.close()
    pygame.display.quit()


def test_closed_plots_and_those_of_sand_count_no_reactions(glass, monkeypatch):
    monkeypatch.setattr(measurements.ReactionMeter, "look", None)
    glass.parts.commands.give("view.toggle_plots")
    glass.wait(20)
    glass.parts.commands.give("view.toggle_plots")
    glass.session.do(SetRule(load_rule("alchemy")))
    glass.wait(20)


@pytest.mark.parametrize(("number", "words"), [(0, "0"), (0.04, "0.0"), (9.94, "9.9"), (12.6, "13"), (99_400, "99k")])
def test_a_rate_is_short(number, words):
    assert figure(number) == words


@pytest.mark.parametrize(("size", "scale"), [((1280, 720), 1), ((1280, 720), 2), ((1920, 1080), 1)])
def test_the_pile_is_drawn_to_scale_as_it_lies_in_its_glass(glass, size, scale):
    glass.parts.settings.override("ui_scale", scale)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    glass.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
    glass.session.timeline.run(6000)
    glass.hold_time()
    glass.key(pygame.K_l, "l")
    glass.wait(1)
    pile = glass.parts.plots.measurements.pile
    ((room, spans),) = [(rect, how[0]) for stroke, rect, *how in glass.drawn() if stroke is charts.hill]
    there = np.flatnonzero(pile.heights)
    low = (pile.surface - pile.heights)[there].min()
    wide = spans[-1][0] - spans[0][0] + 1
    cell = wide / (there[-1] - there[0] + 1)  # pixels
    assert spans[0][0] >= 0 and spans[-1][0] < room.width
    for x, top, bottom in spans:
        column = there[0] + min(int((x - spans[0][0]) / cell), len(there) - 1)
        ground, edge = pile.surface[column] - pile.heights[column] - low, pile.surface[column] - low
        near = max(abs(int(pile.surface[column]) - int(other)) for other in pile.surface[column - 1 : column + 2])
        assert abs(room.height - top - edge * cell) <= cell * (near + 1) + 2
        assert abs(room.height - bottom - ground * cell) <= 3 * cell + 2
        assert 0 <= top < bottom <= room.height


@pytest.mark.parametrize(
    ("numbers", "but", "spelt"),
    [
        ((364, 0, 0, 0, 364), ("a",), ("364 + 0 – 0 + 0 by events = 364", "364 = 364", "364 = 364")),
        (
            (364, 5, 0, 0, 350),
            ("a",),
            ("364 + 5 – 0 – 19 by events = 350", "364 + 5 – 19 by events = 350", "364 + 5 – 19 = 350"),
        ),
        ((96, 0, 0, 0, 96), (), ("96 + 0 – 0 = 96", "96 = 96", "96 = 96")),
        (
            (96, 0, 10, -6, 80),
            (),
            ("96 + 0 – 10 – 6 by events = 80", "96 – 10 – 6 by events = 80", "96 – 10 – 6 = 80"),
        ),
        (
            (96, 0, 0, 0, 95),
            (),
            ("96 + 0 – 0 = 96, but 95 are there", "96 = 96, but 95 are there", "96 = 96, but 95 are there"),
        ),
    ],
)
def test_a_sum_is_spelled_whole_or_without_what_is_zero_or_without_words(numbers, but, spelt):
    assert material_cards._spelt(*numbers, but) == spelt


@sweep(
    ("size", "panel_shown"),
    product([(900, 700), (1280, 720), (1920, 1080)], [True, False]),
    keep=[((900, 700), True), ((1280, 720), False)],
)
def test_the_cards_of_a_world_with_all_materials_of_alchemy_can_be_read(size, panel_shown):
    player = Player("kitchen", size)
    player.parts.display.panel_shown = panel_shown
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    player.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
    for number, name in enumerate(player.parts.brush.materials[:-1]):
        player.session.do(Paint(name, (20.0 + 10 * number, 10.0), (22.0 + 10 * number, 10.0), 5))
    player.session.do(Paint("erase", (20.0, 10.0), (190.0, 10.0), 2))
    player.parts.commands.give("view.toggle_plots")
    player.wait(60)
    theme, area = player.parts.display.theme, player.parts.display.layout.plots
    events = {each.name for each in player.session.rule.definition.events}  # which may be too long for a narrow card
    words = [each for each in written(player) if each[1] and each[1] not in events]
    assert sum(text.startswith("=") for _, text, _ in words) > 12
    for rect, text, kind in words:
        assert area.contains(rect) and rect.height >= 0.9 * theme.line_height(kind), text
        assert theme.width(text, kind) <= rect.width, text
    pygame.display.quit()


def test_a_curve_lies_at_its_own_iterations_be_they_fewer_than_those_of_others():
    series = [([0, 4, 10], [0.0, 0.5, 1.0], look.ACCENT), ([5], [1.0], look.RING), ([], [], look.DIM)]
    drawn = charts.curves(pygame.Rect(0, 0, 101, 101), series, 0, 1)
    assert [(points, colour) for _, _, points, colour in drawn] == [
        (((0, 100), (40, 50), (100, 0)), look.ACCENT),
        (((50, 0),), look.RING),
    ]
    assert charts.curves(pygame.Rect(0, 0, 9, 9), [([], [], look.DIM)], 0, 1) == []


def test_worlds_that_were_measured_at_other_iterations_are_compared(player):
    measured = {name: measurements.Measurements(player.session, 10) for name in ("one", "other")}
    for name in ("one", "one", "other", "one"):
        player.session.timeline.run(5)
        measured[name].follow(0.0, 0.0)
    colours = {"one": look.ACCENT, "other": look.RING}
    for quantity in comparison_cards.quantities(measured["one"]):
        room = pygame.Rect(0, 0, 600, 400)
        strokes = comparison_cards.comparison_card(Theme(1.0), room, quantity, measured, colours)
        assert f"iteration {player.session.now:,}" in [stroke[2] for stroke in strokes if stroke[0] is draw_list.words]
