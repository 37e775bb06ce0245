"""The sand view: one lattice in its part of the window, with its marks, its overlays and its turns."""

import pygame

from game.play.view.turn_animation import TurnAnimation
from game.world.looks import painter
from game.world.looks.view import View


class SandView:
    """Keeps what it has drawn, and draws only what differs from that."""

    def __init__(self, window):
        self.window = window
        self.area = pygame.Rect(0, 0, 1, 1)
        self.view = self.turn = None
        self.heatmap = self.blocks = None  # what lies over the sand, part of the picture of it
        self.whole = None  # the view of the whole lattice
        self._marks, self._overlay = (), None  # as last drawn
        self._covered = ()  # the rects that the overlay covers
        self._bare = True  # nothing has been drawn yet

    def fit(self, shape, area, margin, theme, walls, substances):
        """Show a lattice of `shape` in `area` of the window, with a margin in pixels.

        walls: what they are made of. substances: what the cells of each lattice can hold, for a Painter.
        """
        self._theme = theme
        self.area = pygame.Rect(area)
        self._inner = self.area.inflate(-2 * margin, -2 * margin)
        self.view = self.whole = View.fit(shape, *self._inner)
        self._painter = painter.Painter(self.view, theme.colours, walls, self.window.map_rgb, substances=substances[0])
        self.refresh()

    @property
    def panes(self):
        """The parts of the window that show a lattice."""
        return (self.area,)

    @property
    def can_wait(self):
        """Whether what was drawn last may stand for another frame."""
        return not self._bare and self.turn is None

    def show(self, view):
        """Show the lattice through another view."""
        self.view = view
        self._painter.look_through(view)
        self.refresh()

    def lay_over(self, overlays, words):
        """Lay the one of {name: HeatmapOverlay} over the sand, or nothing; there is no title for `words`."""
        self.heatmap = next(iter(overlays.values()), None)

    def refresh(self):
        """Draw everything next time."""
        self.window.surface.fill(self._theme.colours.ground, self.area)
        self._painter.forget()
        self._marks, self._covered, self._bare = (), (), True

    def start_turn(self, now_s, quarters):
        """Let the picture go round by so many quarters, from now on."""
        view, old = self.view, []
        shape = view.shape if quarters == 2 else view.shape[::-1]
        growth = View.fit(shape, *self._inner).cell / view.cell
        self.window.paint(lambda pixels: old.append(_cut(pixels, view).copy()))
        self.turn = TurnAnimation(old[0], now_s, quarters, growth)

    def end_turn(self):
        """Show the world again as it is."""
        self.turn = None
        self.refresh()

    def differs(self, world, marks):
        """Return whether sand or marks look different from what was drawn last."""
        return self._bare or marks != self._marks or self._painter.differs(world)

    def draw(self, world, marks, overlay, now_s, streams=None, under=()):
        """Bring the view up to date and return the rects of the window that changed.

        marks: a tuple of `Mark`. overlay: a function that draws over the sand on a surface and returns the rects that
        it covers, or None. streams: the MotionSamples to draw falling sand by, or None. under: rects to be drawn
        anew in any case.
        """
        if self.turn:
            frame, ground = tuple(self.area), self.window.surface.map_rgb(self._theme.colours.ground)
            self.window.paint(lambda pixels: self.turn.draw(pixels, ground, frame, now_s))
            self._lay_over(overlay)
            return [self.area]
        if self._overlay and not overlay:
            self.refresh()
        if overlay is self._overlay and not under and not self.differs(world, marks):
            return []
        # soft edges laid over themselves would harden from frame to frame: what lay under the overlay comes first
        old = [each.rect for each in self._marks if each not in marks] + [*self._covered, *under]
        old = [rect.clip(self.area) for rect in old]
        spans = self._draw_sand(world, old, streams)
        new = [each.rect.clip(self.area) for each in marks if each not in self._marks]
        self._draw_marks(marks)
        self._lay_over(overlay)
        bare, self._bare = self._bare, False
        if bare:
            return [self.area]
        rects = [pygame.Rect(self.area.left, top, self.area.width, bottom - top) for top, bottom in spans]
        return rects + old + new + list(self._covered)

    def _draw_sand(self, world, damaged, streams):
        """Draw the sand that has changed, and what lies in the damaged rects; return the spans of rows drawn."""
        for rect in damaged:
            self.window.surface.fill(self._theme.colours.ground, rect)
        damage = [(rect.top, rect.bottom) for rect in damaged]
        drawn = []
        self.window.paint(lambda pixels: drawn.extend(self._painter.draw(world, pixels, damage, streams)))
        if self.heatmap and drawn:
            self.window.paint(lambda pixels: self.heatmap.draw(pixels, self.view, drawn, self.window.map_rgb))
        if self.blocks:
            self._draw_blocks(drawn)
        return drawn

    def _draw_blocks(self, spans):
        for top, bottom in spans:
            self.window.surface.set_clip(self.area.left, top, self.area.width, bottom - top)
            self.blocks.draw(self.window.surface, self._theme, self.view)
        self.window.surface.set_clip(None)

    def _lay_over(self, overlay):
        covered = overlay(self.window.surface) if overlay else ()
        self._covered = [rect.clip(self.area) for rect in covered]
        self._overlay = overlay

    def _draw_marks(self, marks):
        self._marks, surface = marks, self.window.surface
        surface.set_clip(self.area)
        for each in marks:
            each.draw(surface, self._theme)
        surface.set_clip(None)


def _cut(pixels, view):
    left, top, right, bottom = view.seen
    return pixels[top:bottom, left:right]
