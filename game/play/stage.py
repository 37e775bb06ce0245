"""The stage: the sand's part of the window, with the turning glass, the brush's outline and what is laid over it."""

import pygame

from game.play.turn import Turn
from game.play.ui import theme as look
from game.world import picture

LEAST_RADIUS = 2  # pixels: a smaller outline would hide under the pointer


class Stage:
    """Keeps what it has drawn, and draws only what differs from that."""

    def __init__(self, window):
        self.window = window
        self.area = pygame.Rect(0, 0, 1, 1)
        self.view = self.turn = None
        self._outline = self._overlay = None  # as last drawn
        self._bare = True  # nothing of the stage has been drawn yet

    def fit(self, shape, area, margin):
        """Show a lattice of `shape` in `area` of the window, with a margin in pixels."""
        surface = self.window.surface
        self.area = pygame.Rect(area)
        inner = self.area.inflate(-2 * margin, -2 * margin)
        self.view = picture.View.fit(shape, *inner)
        self._ground = surface.map_rgb(picture.GROUND)
        self._painter = picture.Painter(self.view, picture.palette(lambda *colour: surface.map_rgb(colour)))
        self.refresh()

    def refresh(self):
        """Draw everything next time."""
        self.window.surface.fill(picture.GROUND, self.area)
        self._painter.forget()
        self._outline, self._bare = None, True

    def start_turn(self, now_s):
        """Let the picture on the stage go round, from now on."""
        view, old = self.view, []
        self.window.paint(lambda pixels: old.append(_cut(pixels, view).copy()))
        self.turn = Turn(old[0], now_s)

    def end_turn(self):
        """Show the world again as it is."""
        self.turn = None
        self.refresh()

    def draw(self, world, outline, overlay, now_s):
        """Bring the stage up to date and return the rects of the window that changed.

        outline: (x, y, radius) of the brush in pixels, or None. overlay: a function that draws over the sand on a
        surface, or None.
        """
        if self.turn:
            frame = tuple(self.area)
            self.window.paint(lambda pixels: self.turn.draw(pixels, self._ground, frame, now_s))
            self._lay_over(overlay)
            return [self.area]
        if self._overlay and not overlay:
            self.refresh()
        old = _rect_of(self._outline) if outline != self._outline else None
        spans = self._draw_sand(world, old)
        if not spans and not old and outline == self._outline and overlay is self._overlay:
            return []
        self._outline = outline
        if outline:
            self._draw_outline(outline)
        self._lay_over(overlay)
        bare, self._bare = self._bare, False
        if overlay or bare:
            return [self.area]
        rects = [pygame.Rect(self.area.left, top, self.area.width, bottom - top) for top, bottom in spans]
        rects += [rect.clip(self.area) for rect in (old, _rect_of(outline)) if rect]
        return rects

    def _draw_sand(self, world, damaged):
        if damaged:
            self.window.surface.fill(picture.GROUND, damaged.clip(self.area))
        damage = [(damaged.top, damaged.bottom)] if damaged else []
        drawn = []
        self.window.paint(lambda pixels: drawn.extend(self._painter.draw(world, pixels, damage)))
        return drawn

    def _lay_over(self, overlay):
        if overlay:
            overlay(self.window.surface)
        self._overlay = overlay

    def _draw_outline(self, outline):
        x, y, radius = outline
        surface = self.window.surface
        surface.set_clip(self.area)
        pygame.draw.circle(surface, look.SUNKEN, (x, y), max(radius, LEAST_RADIUS) + 1, 1)
        pygame.draw.circle(surface, look.TEXT, (x, y), max(radius, LEAST_RADIUS), 1)
        surface.set_clip(None)


def _rect_of(outline):
    """Return the rect that holds an outline, or None for none."""
    if outline is None:
        return None
    x, y, radius = outline
    reach = max(radius, LEAST_RADIUS) + 3
    return pygame.Rect(int(x - reach), int(y - reach), int(2 * reach) + 2, int(2 * reach) + 2)


def _cut(pixels, view):
    return pixels[view.top : view.top + view.height, view.left : view.left + view.width]
