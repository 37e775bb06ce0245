"""The screen: what is on the window, drawn anew only where it differs from what should be there."""

from game.play.controls import fixture_tool, tilt
from game.play.ui import draw_list


class Screen:
    """Draws the stage, the time bar, the HUD and the panel, and what is laid over the sand."""

    def __init__(self, toy):
        self._toy = toy
        self._hud_drawn = self._bar_drawn = None
        self._lay_over = self._draw_over  # one object, which the stage knows again

    def forget(self):
        """Draw the lines under the sand and the panel anew next time."""
        self._hud_drawn = self._bar_drawn = None
        self._toy.plots.forget()
        self._toy.panel.ui.invalidate()
        if self._toy.display.page:
            self._toy.display.page.forget()

    def draw(self, now_s):
        """Draw the parts of the window that differ from what is on it; return their rects."""
        toy, layout, surface = self._toy, self._toy.display.layout, self._toy.display.window.surface
        if toy.display.page:
            return toy.display.page.draw(surface)
        if toy.display.stale:
            toy.display.stage.refresh()
        toy.blocks.prepare()
        rects = []
        if toy.display.stale or not toy.stepping.passing(now_s):
            streams = None if toy.sessions.now.paused else toy.sessions.now.streams
            rects = toy.display.stage.draw(toy.sessions.now.world, self._marks(), self._overlay(), now_s, streams)
        toy.display.stale = False
        bar = toy.time_bar.drawing(toy.sessions.now)
        if bar != self._bar_drawn:
            draw_list.draw(surface, toy.display.theme, bar)
            self._bar_drawn = bar
            rects.append(layout.bar)
        line = toy.hud.drawing(toy.display.theme, layout.hud, toy.sessions.now, self._said(), toy.timer.words)
        if line != self._hud_drawn:
            draw_list.draw(surface, toy.display.theme, line)
            self._hud_drawn = line
            rects.append(layout.hud)
        rects += toy.plots.draw(surface)
        if toy.display.panel_shown and toy.panel.ui.end(surface):
            rects.append(layout.panel)
        return rects

    def _said(self):
        """Return what the HUD is to say first, or ""."""
        toy, timeline = self._toy, self._toy.sessions.now.timeline
        if toy.stepping.on_the_way:
            return f"Computing the sand: {100 * timeline.moment.now // timeline.goal} %"
        return toy.recorder.said or ("Time runs back" if toy.rewind.held else toy.ahead.words)

    def _overlay(self):
        """Return what draws over the sand now, or None."""
        toy = self._toy
        return self._lay_over if any(each.shown for each in toy.overlays) else None

    def _draw_over(self, surface):
        """Draw all overlays and return the rects that they cover."""
        toy, area = self._toy, self._toy.display.layout.sand
        return [rect for each in toy.overlays if each.shown for rect in each.draw(surface, toy.display.theme, area)]

    def _marks(self):
        """Return the marks of the fixtures, of a table that leans, and of the tool over the sand."""
        toy, view, pointer = self._toy, self._toy.display.stage.view, self._toy.hearing.pointer
        if toy.display.stage.turn:
            return ()
        marks = tilt.marks(toy.sessions.now.rule, view) + fixture_tool.marks(
            toy.sessions.now.world.fixtures, view, toy.display.theme.px
        )
        if toy.camera.busy or toy.photo_import.shown:
            return marks
        if toy.cursor.on and not toy.brush.by_mouse:
            return marks + toy.cursor.marks(view)
        return marks + (toy.brush.marks(view.place(*pointer), view) if pointer else ())
