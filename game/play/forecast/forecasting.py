"""Forecasting: requests a forecast of the sand in sight after each frame, and shows it once it is there."""

import math
from typing import NamedTuple

from game.play.forecast.legend import Legend
from game.world.background.forecast_thread import ForecastRequest, ForecastThread
from game.world.looks.heatmap_overlay import HeatmapOverlay, forecast_covers, stale_covers
from game.world.sand import parameters
from game.world.sand.crop import Crop, CropBox, forecast_box

MOST_CELLS = 2**21  # in one forecast: what a full HD lattice has; 64 runs of them take about a quarter of a second
STALE_S = 0.3  # a forecast is shown as stale once its subject has not been the present one for so long


class Subject(NamedTuple):
    """What a forecast is about, apart from the iteration."""

    line: object  # the last act
    scene: object
    rule: object
    ahead: int  # iterations
    of: str  # the material
    box: CropBox
    exact: bool  # whether what lies around the box cannot matter


class Forecasting:
    """Where the sand will be: the request, the latest forecast, and its heatmap and legend over the sand."""

    def __init__(self, sessions, display, pointer):
        self._sessions, self._display = sessions, display
        self.legend = Legend(sessions, display, pointer)
        self.thread = ForecastThread()
        self.ahead = parameters.AHEAD.default  # iterations
        self._of = None  # the name of the material that was chosen
        self.answer = None  # the Forecast that is shown
        self.stale = False  # the answer has not been about the present subject for a while
        self._requested = None  # (Subject, iteration) of the last request
        self._current_s = 0.0  # when the answer was last about the present subject

    @property
    def shown(self):
        """Whether it is wanted."""
        return self._display.legend_shown

    @property
    def materials(self):
        """The names of the materials that can be forecast."""
        codes = self._sessions.now.rule.codes
        return codes.told_of(codes.filled)

    @property
    def of(self):
        """The material that is forecast: the one that was chosen, or the usual one of a world that has not that."""
        return self._of if self._of in self.materials else self._sessions.now.rule.codes.usual

    @of.setter
    def of(self, name):
        self._of = name

    def toggle(self):
        """Show the forecast, or no longer."""
        if self.shown:
            self.close()
        self._display.legend_shown = not self.shown

    def close(self):
        """Request nothing more and take the forecast away; return when the thread has ended."""
        self.thread.close()
        self.answer = self._requested = self._display.sand_view.heatmap = None
        self._display.refresh()

    def update(self, now_s):
        """Take the latest answer, and make another request if anything has happened; never wait."""
        if not self.shown:
            return
        session, subject = self._sessions.now, self._subject()
        if session.timeline.goal is None and (subject, session.world.iteration) != self._requested:
            self._request(subject, now_s)
        self._take(subject, now_s)
        self.legend.update(self.answer, self.stale, now_s)

    def _subject(self):
        session, sand_view = self._sessions.now, self._display.sand_view
        view, area, shape = sand_view.view, sand_view.area, session.world.shape
        (left, top), (right, bottom) = view.place(area.left, area.top), view.place(area.right, area.bottom)
        sight = CropBox.within(shape, math.floor(top), math.floor(left), math.ceil(bottom), math.ceil(right))
        box, exact = forecast_box(shape, sight, self.ahead, MOST_CELLS)
        return Subject(session.timeline.history.line, session.scene, session.rule, self.ahead, self.of, box, exact)

    def _request(self, subject, now_s):
        world, before = self._sessions.now.world, self._requested
        self._requested = subject, world.iteration
        crop, runs = Crop(world, subject.box), parameters.RUNS.default
        request = ForecastRequest(crop, subject.rule, subject.ahead, runs, subject.of, about=(subject, now_s))
        self.thread.ask(request, hurry=before is None or before[0] != subject)

    def _take(self, subject, now_s):
        """Show the latest answer; as stale, once it has not been about the present subject for too long."""
        before, answer = (self.answer, self.stale), self.thread.answer
        if answer is None:
            return
        request, (about, requested_s) = answer.request, answer.request.about
        if about.scene is not subject.scene:
            answer, self.stale = None, False
        else:
            now = self._sessions.now.world.iteration
            current = about == subject and 0 <= now - request.crop.iteration <= request.ahead
            self._current_s = now_s if current else max(self._current_s, requested_s)
            self.stale = now_s - self._current_s > STALE_S
        self.answer = answer
        if (self.answer, self.stale) != before:
            covers = stale_covers if self.stale else forecast_covers
            self._display.sand_view.heatmap = answer and HeatmapOverlay(request.crop.box, answer.levels, covers)
            self._display.refresh()
