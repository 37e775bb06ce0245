"""Panes: a stage for each world of a comparison, side by side, of which the leading one is the stage of all tools."""

from dataclasses import replace

import pygame

from game.play.stage import Stage
from game.play.ui import paint
from game.play.ui import theme as look
from game.world.measure import grains_above

TITLE = 26  # height of a title at scale 1
REFRESH_S = 0.25  # the grains left are counted so often


class Panes:
    """Looks like a Stage to the toy; what is shown and done in one pane is shown and done in all."""

    def __init__(self, window, toy, comparison):
        self._window, self._toy, self._comparison = window, toy, comparison
        self._stages = {each: Stage(window) for each in comparison.sessions}
        self._lead = self._stages[comparison.schedule]
        self._shifts = {}  # of each pane from the leading one, in pixels
        self._titles, self._drawn, self._counted_s = {}, {}, None
        self._left = {}  # the grains above the neck in each world
        self._held = None  # the shift of the pane in which a button is held
        self._area = pygame.Rect(0, 0, 1, 1)  # of all panes
        self._overlay, self._covered = None, []  # as last drawn, and the rects that it covers

    # --- as a stage ---

    area = property(lambda self: self._lead.area)
    view = property(lambda self: self._lead.view)
    whole = property(lambda self: self._lead.whole)
    turn = property(lambda self: self._lead.turn)

    @property
    def veil(self):
        """What lies over the leading world."""
        return self._lead.veil

    @veil.setter
    def veil(self, veil):
        self._lead.veil = veil

    @property
    def blocks(self):
        """The blocks over the leading world."""
        return self._lead.blocks

    @blocks.setter
    def blocks(self, blocks):
        self._lead.blocks = blocks

    def fit(self, shape, area, margin, theme, walls):
        """Show lattices of `shape` beside or below one another in `area`, whichever leaves larger cells."""
        self._area, high = pygame.Rect(area), theme.px(TITLE)
        ways = [_split(area, len(self._stages), across, high) for across in (True, False)]
        rects = max(ways, key=lambda rects: min(rects[0].height / shape[0], rects[0].width / shape[1]))
        for (schedule, stage), rect in zip(self._stages.items(), rects, strict=True):
            stage.fit(shape, rect, margin, theme, walls)
            self._titles[schedule] = pygame.Rect(rect.x, rect.y - high, rect.width, high)
        lead = self._lead.area
        self._shifts = {each: (s.area.x - lead.x, s.area.y - lead.y) for each, s in self._stages.items()}
        self._drawn = {}

    def show(self, view):
        """Show the lattices through another view."""
        for schedule, stage in self._stages.items():
            stage.show(_moved(view, *self._shifts[schedule]))

    def refresh(self):
        """Draw everything next time."""
        self._drawn, self._overlay, self._covered = {}, None, []
        for stage in self._stages.values():
            stage.refresh()

    def start_turn(self, now_s, quarters):
        """Let the pictures go round by so many quarters, from now on."""
        for stage in self._stages.values():
            stage.start_turn(now_s, quarters)

    def end_turn(self):
        """Show the worlds again as they are."""
        for stage in self._stages.values():
            stage.end_turn()

    def draw(self, world, marks, overlay, now_s, streams=None):
        """Bring all panes up to date and return the rects of the window that changed; see `Stage.draw`."""
        if self._overlay and not overlay:
            self.refresh()
        panes = [
            (self._stages[schedule], session.world, self._marks_in(schedule, marks))
            for schedule, session in self._comparison.sessions.items()
        ]
        self._count(now_s)
        under = []  # what soft edges lie over comes first, in all panes
        if overlay is not self._overlay or self._new_titles() or any(_differs(*pane) for pane in panes):
            under = self._covered
            self._drawn = {each: t for each, t in self._drawn.items() if self._titles[each].collidelist(under) < 0}
        rects = []
        for stage, world, here in panes:
            rects += stage.draw(
                world, here, None, now_s, under=[rect for rect in under if rect.colliderect(stage.area)]
            )
        rects += self._draw_titles()
        before, self._overlay = self._overlay, overlay
        if overlay and (rects or overlay is not before):
            self._covered = overlay(self._window.surface)
            rects += [*under, *self._covered]
        return rects

    def _marks_in(self, schedule, marks):
        x, y = self._shifts[schedule]
        return tuple(each._replace(points=tuple((a + x, b + y) for a, b in each.points)) for each in marks)

    def own(self, event):
        """Return an event of the pointer over any pane as one over the leading pane."""
        if event.type not in (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
            return event
        if event.type == pygame.MOUSEBUTTONDOWN and self._held is None:
            self._held = self._shift_at(event.pos)
        moved = pygame.event.Event(event.type, {**event.dict, "pos": self.here(event.pos)})
        if event.type == pygame.MOUSEBUTTONUP:
            self._held = None
        return moved

    def let_go(self):
        """Forget in which pane a button is held."""
        self._held = None

    def here(self, pos):
        """Return the place in the leading pane that a place in the window stands for."""
        if pos is None:
            return None
        x, y = self._held or self._shift_at(pos)
        return pos[0] - x, pos[1] - y

    def _shift_at(self, pos):
        inside = (each for each, stage in self._stages.items() if stage.area.collidepoint(pos))
        return self._shifts.get(next(inside, None), (0, 0))

    # --- titles ---

    def titles(self):
        """Return what is written above each world."""
        return {each: (each.capitalize(), f"{self._left.get(each, 0):,} left above") for each in self._stages}

    def _count(self, now_s):
        """Count the grains that are left above, if it is time to."""
        if self._counted_s is None or now_s - self._counted_s >= REFRESH_S:
            self._counted_s, row = now_s, self._toy.plots.measured_row
            sessions = self._comparison.sessions.items()
            self._left = {schedule: grains_above(session.world, row) for schedule, session in sessions}

    def _new_titles(self):
        return {each: title for each, title in self.titles().items() if title != self._drawn.get(each)}

    def _draw_titles(self):
        new = self._new_titles()
        for schedule, (name, left) in new.items():
            rect, theme, surface = self._titles[schedule], self._toy.theme, self._window.surface
            paint.fill(surface, theme, rect, look.SUNKEN)
            words = rect.inflate(-2 * theme.px(10), 0)
            leads = schedule == self._comparison.schedule
            paint.words(surface, theme, words, name, look.HEADING, look.HANDLE if leads else look.TEXT, 0)
            paint.words(surface, theme, words, left, look.SMALL, look.DIM, 1)
        self._drawn |= new
        return [self._titles[each] for each in new]


def _differs(stage, world, marks):
    return stage.turn is not None or stage.differs(world, marks)


def _split(area, number, across, high):
    """Return `number` rects of one size in `area`, with `high` pixels free above each."""
    wide, tall = (area.width // number, area.height) if across else (area.width, area.height // number)
    corners = [(area.x + k * wide, area.y) if across else (area.x, area.y + k * tall) for k in range(number)]
    return [pygame.Rect(x, y + high, wide, max(1, tall - high)) for x, y in corners]


def _moved(view, x, y):
    """Return the view moved by pixels."""
    frame = view.frame and (view.frame[0] + x, view.frame[1] + y, *view.frame[2:])
    return replace(view, left=view.left + x, top=view.top + y, frame=frame)
