"""The renderer: draws a frame on the window, only where it differs from what is there."""

from typing import NamedTuple

import pygame

from game.play.ui import draw_list
from game.play.view.overlays.outlines import fixture_marks, tilt_marks
from game.world.sessions.session import Session

SHADE = 150  # of what lies behind a page: 0 is black, 255 as it is


class Frame(NamedTuple):
    """What a window shows."""

    now_s: float
    page: object  # what lies over everything else, or None
    session: Session
    passing: bool  # its moment is passed too quickly to be worth a look
    marks: tuple  # of the tools
    overlays: tuple  # what is shown over the sand, the last on top
    strips: dict  # {rect as a tuple: strokes} of what is drawn anew whenever it looks different
    plots: object
    controls: object  # the Ui of the panel, or None


class Renderer:
    """Draws the sand, what lies over it, and everything beside it."""

    def __init__(self, display):
        self._display = display
        self._strips = {}  # as last drawn
        self._overlays = ()
        self._plain = True  # falling sand was last drawn cell by cell
        self._lay_over = self._draw_overlays  # one object, which the view knows again

    def forget(self):
        """Draw anew next time what lies beside the sand."""
        self._strips = {}

    def draw(self, frame):
        """Draw what differs from the Frame on the window; return the rects that changed."""
        window, rects = self._display.window, []
        if self._display.in_sight:
            rects = self._draw_sand(frame) + self._draw_beside(frame)
        if not frame.page:
            return rects
        if rects:
            window.front.blit(window.surface, (0, 0))
            window.front.fill((SHADE,) * 3, special_flags=pygame.BLEND_MULT)
            frame.page.forget()
        drawn = frame.page.draw(window.front)
        return [window.front.get_rect()] if rects else drawn

    def _draw_beside(self, frame):
        """Draw what differs beside the sand."""
        surface, theme, rects = self._display.window.surface, self._display.theme, []
        for rect, strokes in frame.strips.items():
            if strokes != self._strips.get(rect):
                draw_list.draw(surface, theme, strokes)
                rects.append(pygame.Rect(rect))
        self._strips = frame.strips
        rects += frame.plots.draw(surface)
        if frame.controls and frame.controls.end(surface):
            rects.append(self._display.layout.panel)
        return rects

    def _draw_sand(self, frame):
        stale, self._display.stale = self._display.stale, False
        if stale:
            self._display.sand_view.refresh()
        elif frame.passing:
            return []
        session, self._overlays = frame.session, frame.overlays
        streams = None if self._display.sand_view.blocks else session.streams  # arrows point at the cells themselves
        if streams:
            streams.take_acts(session.world)
        if (streams is None) != self._plain:
            self._plain = streams is None
            self._display.sand_view.refresh()
        overlay = self._lay_over if frame.overlays else None
        return self._display.sand_view.draw(session.world, self._marks(frame), overlay, frame.now_s, streams)

    def _marks(self, frame):
        """Return the marks of the tilted table, of its fixtures and of the tools."""
        view, session = self._display.sand_view.view, frame.session
        if self._display.sand_view.turn:
            return ()
        fixtures = fixture_marks(session.world.fixtures, view, self._display.theme.px)
        return tilt_marks(session.rule.bias, view) + fixtures + frame.marks

    def _draw_overlays(self, surface):
        """Draw what lies over the sand and return the rects that it covers."""
        theme, area = self._display.theme, self._display.layout.sand
        return [rect for each in self._overlays for rect in each.draw(surface, theme, area)]
