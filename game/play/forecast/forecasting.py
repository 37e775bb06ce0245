"""Forecasting: the forecast of the sand on the stage, asked for after each frame and shown when it is there."""

import math
from typing import NamedTuple

from game.play.forecast.heatmap_overlay import Veil
from game.play.forecast.legend import Legend
from game.world.background.forecast_thread import ForecastRequest, ForecastThread, standard_error
from game.world.sand import parameters
from game.world.sand.crop import Crop, CropBox, forecast_box

MOST_CELLS = 2**21  # in one forecast: what a full HD lattice has; 64 runs of them take about a quarter of a second
STALE_S = 0.3  # a forecast is shown as stale once what it was asked for has been another matter for so long


class Matter(NamedTuple):
    """What a forecast is about, apart from the iteration: equal as long as it stays the same matter."""

    line: object  # the last act
    scene: object
    rule: object
    ahead: int  # iterations
    part: CropBox
    exact: bool  # whether what lies around the part cannot matter


class Forecasting:
    """Where the sand will be: the question, the latest answer, and the two on the stage."""

    def __init__(self, toy, forecaster=None):
        self._toy = toy
        self._legend = Legend(toy, self)
        self.forecaster = forecaster or ForecastThread()
        self.shown = False
        self.ahead = parameters.AHEAD.default  # iterations
        self.answer = None  # the Forecast that is shown
        self.stale = False  # it has been to another question than the present one for a while
        self._asked = None  # (Matter, iteration) of the last question
        self._current_s = 0.0  # when the answer was last to the present question

    def toggle(self):
        """Show the forecast, or no longer."""
        if self.shown:
            self.close()
        self.shown = not self.shown

    def close(self):
        """Ask nothing more and take the forecast away; return when the thread has ended."""
        self.forecaster.close()
        self.answer = self._asked = self._toy.display.stage.veil = None
        self._toy.display.refresh()

    def update(self, now_s):
        """Take the latest answer, and ask again if anything has happened; never wait."""
        if not self.shown:
            return
        session = self._toy.sessions.now
        matter = self._matter()
        if session.timeline.goal is None and (matter, session.world.iteration) != self._asked:
            self._ask(matter, now_s)
        self._take(matter, now_s)
        if self._legend.changed(now_s):
            self._toy.display.refresh()

    def share_at(self, row, column):
        """Return (share of the runs with sand in a cell, its standard error), or None where nothing is known."""
        if self.answer is None:
            return None
        part, runs = self.answer.request.crop.box, self.answer.runs
        y, x = row - part.top, column - part.left
        if not (0 <= y < part.height and 0 <= x < part.width):
            return None
        share = int(self.answer.counts[y, x]) / runs
        return share, 0.0 if self.answer.certain else standard_error(share, runs)

    def handle_events(self, events, now_s, mouse_pos):
        """Leave all events to others."""
        return events

    def draw(self, surface, theme, area):
        """Draw the legend; return the rects that it covers."""
        return self._legend.draw(surface, theme, area)

    def _matter(self):
        session, stage = self._toy.sessions.now, self._toy.display.stage
        view, area, shape = stage.view, stage.area, session.world.shape
        (left, top), (right, bottom) = view.place(area.left, area.top), view.place(area.right, area.bottom)
        sight = CropBox.within(shape, math.floor(top), math.floor(left), math.ceil(bottom), math.ceil(right))
        part, exact = forecast_box(shape, sight, self.ahead, MOST_CELLS)
        return Matter(session.timeline.history.line, session.scene, session.rule, self.ahead, part, exact)

    def _ask(self, matter, now_s):
        world, before = self._toy.sessions.now.world, self._asked
        self._asked = matter, world.iteration
        crop, runs = Crop(world, matter.part), parameters.RUNS.default
        question = ForecastRequest(crop, matter.rule, matter.ahead, world.iteration, world.seed, runs, (matter, now_s))
        self.forecaster.ask(question, hurry=before is None or before[0] != matter)

    def _take(self, matter, now_s):
        """Show the latest answer; as stale, once it has been to another question than the present one for too long."""
        before, answer = (self.answer, self.stale), self.forecaster.answer
        if answer is None:
            return
        question, (about, asked_s) = answer.request, answer.request.about
        if about.scene is not matter.scene:
            answer, self.stale = None, False
        else:
            now = self._toy.sessions.now.world.iteration
            current = about == matter and question.start <= now <= question.start + question.ahead
            self._current_s = now_s if current else max(self._current_s, asked_s)
            self.stale = now_s - self._current_s > STALE_S
        self.answer = answer
        if (self.answer, self.stale) != before:
            self._toy.display.stage.veil = answer and Veil(question.crop.box, answer.levels, self.stale)
            self._toy.display.refresh()
