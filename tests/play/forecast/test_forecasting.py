"""The forecast in its window: over the sand, beside the frames, and honest about its age."""

import threading

import numpy as np
import pygame
import pytest

from game import Rule
from game.core.draw.heatmap import ALWAYS, NEVER
from game.play.forecast import legend
from game.play.forecast.forecasting import STALE_S
from game.play.ui import theme as look
from game.world.background.forecast_thread import ForecastThread, forecast_of
from game.world.looks.heatmap_colours import cover
from game.world.looks.heatmap_overlay import stale_covers
from game.world.looks.painter import rgb
from game.world.looks.themes import THEMES
from game.world.looks.view import View
from game.world.sand.ensemble import Cancelled, counts_at
from game.world.sessions.action import Flip, SetRule
from tests.play.player import FRAME_NS, Player
from tests.sweeps import sweep


@pytest.fixture
def paper():
    """Return a Player of the paper's glass, p = 0.5, paused after a while."""
    player = Player("paper")
    player.session.do(SetRule(Rule.with_p(0.5)))
    player.wait(60)
    player.hold_time()
    yield player
    pygame.display.quit()


SHADE = 12  # of 255, by which air in a wall's shadow or a glass differs from other air under a forecast


def pixels_of(player):
    """Return the sand's pixels as the player sees them, (h, w, 3)."""
    return pygame.surfarray.array3d(player.parts.window.surface).swapaxes(0, 1).astype(int)


def see_forecast(player, runs=10_000):
    """Wait for the forecast of the present moment and return the Forecast."""
    forecasting = player.parts.forecasting
    if not forecasting.shown:
        player.key(pygame.K_h, "h")
    for _ in range(4000):
        answer = forecasting.answer
        if answer and answer.runs == runs and is_current(player, answer):
            player.frame(elapsed_ns=0)
            return answer
        threading.Event().wait(0.005)
        player.frame(elapsed_ns=0)
    raise AssertionError("no forecast")


def forecast_threads():
    """Return the threads that work on forecasts."""
    return [each for each in threading.enumerate() if each.name == "forecaster"]


def is_current(player, answer):
    """Return whether a Forecast is of the present moment, as far ahead as is wanted."""
    about, session = answer.request.about[0], player.session
    present = session.timeline.history.line, session.scene, session.rule, player.parts.forecasting.ahead
    return (
        about.line,
        about.scene,
        about.rule,
        about.ahead,
    ) == present and answer.request.crop.iteration == session.world.iteration


class Stuck(ForecastThread):
    """A thread whose runs take forever, unless they are let go."""

    def __init__(self):
        self.free = threading.Event()
        super().__init__(self._runs)

    def _runs(self, world, rule, ahead, runs, of, cancelled):
        while not self.free.wait(0.002):
            if cancelled():
                raise Cancelled
        yield runs, np.where(world.walls, 0, runs).astype(np.int64)


@pytest.fixture
def stuck(player):
    """Return the thread of a blank scene with the forecast on, which says nothing yet."""
    yield forecast_by(player, Stuck())


class Scripted:
    """Stands in for a ForecastThread: notes what is requested, and answers when it is told to."""

    def __init__(self):
        self.requests, self.hurries, self.answer = [], [], None

    def ask(self, request, hurry):
        self.requests.append(request)
        self.hurries.append(hurry)

    def tell(self, request, runs):
        """Answer that sand is where it was in half of the runs."""
        world = request.crop.world()
        sand, walls = world.sand, world.walls
        self.answer = forecast_of(request, walls, sand * np.int64(runs // 2), runs)

    def close(self):
        self.answer = None


@pytest.fixture
def scripted(player):
    """Return the Scripted forecasts of a blank scene in which a handful of sand falls."""
    player.hold_time()
    player.drag(player.pixel(50, 10), player.pixel(70, 10))
    player.session.paused = False
    return forecast_by(player, Scripted())


def forecast_by(player, thread):
    """Turn the forecast on, worked out by `thread`, and return that."""
    player.parts.forecasting.thread = thread
    player.key(pygame.K_h, "h")
    return thread


def test_h_lays_over_the_sand_what_so_many_runs_say(paper):
    answer, sand_view = see_forecast(paper), paper.parts.display.sand_view
    heatmap, sand_view.heatmap = sand_view.heatmap, None
    paper.parts.display.refresh()
    paper.frame(elapsed_ns=0)
    bare, sand_view.heatmap = pixels_of(paper), heatmap
    world, ahead = paper.world, paper.parts.forecasting.ahead
    expected = counts_at(world, Rule.with_p(0.5), [ahead], 10_000)[0]
    assert (answer.counts == expected).all()
    paper.parts.display.refresh()
    paper.frame(elapsed_ns=0)
    seen, (kept, laid) = pixels_of(paper), cover(lambda *colour: colour[0] << 16 | colour[1] << 8 | colour[2])
    for row, column in np.ndindex(world.shape):
        x, y = paper.pixel(column, row)
        level = answer.levels[row, column]
        tint = [int(laid[level]) >> shift & 255 for shift in (16, 8, 0)]
        assert (seen[y, x] == (bare[y, x] * int(kept[level]) >> 8) + tint).all()
    assert (answer.levels == ALWAYS).any() and (~world.sand & (answer.levels[:, :] > 0) & ~world.walls).any()


def test_h_again_takes_the_forecast_away_and_ends_its_thread(paper):
    bare = pixels_of(paper)
    see_forecast(paper)
    assert forecast_threads()
    assert (pixels_of(paper) != bare).any()
    paper.key(pygame.K_h, "h")
    paper.frame(elapsed_ns=0)
    area = paper.parts.display.layout.sand
    assert (pixels_of(paper)[: area.bottom, : area.right] == bare[: area.bottom, : area.right]).all()
    assert not forecast_threads()


def test_closing_the_window_ends_the_thread(paper):
    see_forecast(paper)
    assert forecast_threads()
    paper.parts.close()
    assert not forecast_threads()


def test_a_frame_never_waits_for_the_runs(player, stuck):
    before = player.world.iteration
    player.drag(player.pixel(20, 20), player.pixel(60, 20))
    player.wait(30)  # would not come back if it waited
    assert stuck.working and stuck.answer is None
    assert player.world.iteration > before + 30 and player.world.grains > 0
    assert player.parts.forecasting.legend.lines[1] == "Computing the first runs …"


def test_a_forecast_becomes_finer_in_the_window(player, scripted):
    player.hold_time()
    player.wait(1)
    for runs in (64, 512, 10_000):
        scripted.tell(scripted.requests[-1], runs)
        player.wait(1)
        assert player.parts.forecasting.legend.lines[1].startswith(f"{runs:,} runs")


def test_only_a_new_subject_hurries_so_that_the_forecast_of_flowing_sand_can_become_finer(player, scripted):
    player.wait(10)
    assert len(scripted.requests) > 10 and scripted.hurries == [True] + [False] * (len(scripted.requests) - 1)
    player.session.do(SetRule(Rule.with_p(0.3)))
    player.wait(3)
    assert scripted.hurries[-4:] == [True, False, False, False]


def test_the_forecast_of_flowing_sand_does_not_flicker(player, scripted):
    def seen():
        player.frame()
        forecasting = player.parts.forecasting
        return (
            bool(player.parts.display.sand_view.heatmap),
            forecasting.stale,
            forecasting.legend.lines[0] != "Forecast",
        )

    player.parts.forecasting.ahead = 1000
    player.frame()
    for _ in range(25):
        assert seen() == (False, False, False)
    for frame in range(60):
        if frame % 20 == 0:  # each answer is to what was asked a third of a second ago, and shown for as long
            scripted.tell(scripted.requests[-20], 512)
        assert seen() == (True, False, True)


def test_nothing_is_drawn_while_nothing_changes(paper):
    see_forecast(paper)
    paper.wait(3)
    assert not any(paper.frame() for _ in range(12))


def test_a_forecast_that_answers_another_question_is_shown_as_stale(player, stuck):
    forecasting = player.parts.forecasting
    player.hold_time()
    stuck.free.set()
    see_forecast(player)
    assert not forecasting.stale and player.parts.display.sand_view.heatmap.covers is not stale_covers
    stuck.free.clear()
    forecasting.ahead += 1
    player.frame()
    assert not forecasting.stale  # it is about to be answered
    player.wait(int(STALE_S * 1e9 / FRAME_NS) + 2)
    assert forecasting.stale and player.parts.display.sand_view.heatmap.covers is stale_covers
    stuck.free.set()
    see_forecast(player)
    assert not forecasting.stale and player.parts.display.sand_view.heatmap.covers is not stale_covers


@pytest.mark.parametrize("act", [SetRule(Rule.with_p(0.1)), Flip()])
def test_whatever_is_done_to_the_world_is_another_question(paper, act):
    first = see_forecast(paper)
    paper.session.do(act)
    second = see_forecast(paper)
    assert (second.counts != first.counts).any()
    expected = counts_at(paper.world, paper.session.rule, [200], 10_000)[0]
    assert (second.counts == expected).all()


def test_the_legend_tells_runs_error_moment_and_the_cell_under_the_pointer(paper):
    answer = see_forecast(paper)
    row, column = np.argwhere((answer.counts > 2000) & (answer.counts < 8000))[0]
    paper.pointer = paper.pixel(column, row)
    paper.wait(20)
    title, runs, ahead, when, here = paper.parts.forecasting.legend.lines
    share = answer.counts[row, column] / 10_000
    assert title == f"Sand at iteration {paper.session.now + 200:,}"
    assert ahead == "200 iterations ahead" and when == "Computed now"
    assert runs == "10,000 runs: ± 0.5 % at most"
    assert here == f"Here {100 * share:.1f} ± {100 * (share * (1 - share) / 10_000) ** 0.5:.1f} %"


def test_the_legend_is_as_high_as_its_lines_and_leaves_nothing_of_more(paper):
    pygame.display.set_mode((1280, 720), pygame.RESIZABLE, 32)
    paper.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=1280, y=720))
    see_forecast(paper)
    place = paper.parts.display.layout.cards["legend"]
    seen = []
    for pointer in (paper.pixel(30, 30), None):
        paper.move(pointer or (paper.parts.window.size[0] - 1, 1))
        paper.wait(20)
        for exposed in (False, True):
            if exposed:
                paper.drawn()
            seen.append(pixels_of(paper)[place.top : place.bottom, place.left : place.right])
    more, more_anew, less, less_anew = seen
    assert (more == more_anew).all() and (less == less_anew).all()
    heights = [np.flatnonzero((each != each[-1, -1]).any(axis=(1, 2)))[-1] for each in (more, less)]
    assert heights[0] - heights[1] == paper.parts.display.theme.line_height(look.SMALL)


@sweep("theme", THEMES, keep=["night"])
def test_never_and_always_have_the_same_colours_in_the_legend_and_in_the_picture(paper, theme):
    paper.parts.settings.override("theme", theme)
    answer, bar = see_forecast(paper), pygame.Surface((256, 1))
    legend.draw_scale(bar, paper.parts.display.theme, bar.get_rect(), False)
    paper.parts.display.refresh()
    paper.frame(elapsed_ns=0)
    seen, world = pixels_of(paper), paper.world
    for level, x in ((NEVER, 0), (ALWAYS, 255)):
        cells = np.argwhere((answer.levels == level) & ~world.sand)
        drawn = [seen[paper.pixel(column, row)[::-1]] for row, column in cells]
        assert np.median(np.abs(np.array(drawn) - bar.get_at((x, 0))[:3]).max(axis=1)) <= SHADE


def test_another_scene_has_no_forecast_of_the_one_before(player, stuck):
    stuck.free.set()
    player.hold_time()
    see_forecast(player)
    stuck.free.clear()
    player.parts.sessions.load("paper")
    player.wait(2)
    assert player.parts.display.sand_view.heatmap is None and player.parts.forecasting.answer is None


def test_the_forecast_follows_the_view_in_and_out(paper):
    answer = see_forecast(paper)
    for cell in (30.0, 3.0, 0.4):
        view = View.near(
            (61, 61),
            tuple(paper.parts.display.sand_view.area),
            cell,
            (30.5, 50.5),
            *paper.parts.display.sand_view.area.center,
        )
        paper.parts.display.sand_view.show(view)
        paper.frame(elapsed_ns=0)
        veil = paper.parts.display.sand_view.heatmap
        pixels = np.zeros(paper.parts.window.size[::-1], np.uint32)
        veil.draw(pixels, view, [(0, pixels.shape[0])], rgb)
        _, laid = cover(rgb)
        left, top, right, bottom = view.seen
        assert not pixels[:top].any() and not pixels[bottom:].any() and not pixels[:, :left].any()
        if not view.dense:
            seen = laid[answer.levels[view.rows][:, view.columns]]
            assert (pixels[top:bottom, left:right] == seen).all() and seen.any()


def test_a_veil_drawn_span_by_span_is_the_veil_drawn_at_once(paper):
    see_forecast(paper)
    veil, view = paper.parts.display.sand_view.heatmap, paper.parts.display.sand_view.view
    once = np.random.default_rng(92).integers(0, 2**24, paper.parts.window.size[::-1]).astype(np.uint32)
    by_spans = once.copy()
    veil.draw(once, view, [(0, once.shape[0])], rgb)
    for top in range(0, once.shape[0], 37):
        veil.draw(by_spans, view, [(top, min(top + 37, once.shape[0]))], rgb)
    assert (by_spans == once).all()
