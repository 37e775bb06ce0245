"""The panel: an immediate-mode column of controls, a pure function of the events and values it is given.

    rest = ui.begin(rect, events, now_s, mouse_pos)   # the events that are not the panel's
    p = ui.slider("p", knob.P, p)                     # every control returns its value
    ui.end(surface)                                   # draws, if anything looks different

Controls only leave strokes, a value; end() compares them with the last frame's and draws when they differ.
All of it, lists and tips too, stays inside the rect, so a frame that is not drawn is still right on the screen.
"""

import itertools
from typing import NamedTuple

import pygame

from game.play.ui import choice_grids, controls, draw_list, dropdown, sliders, tooltips
from game.play.ui import theme as look
from game.play.ui.focus import BAR as HELD_BAR
from game.play.ui.focus import Focus
from game.play.ui.input import Slot

PAD = 14  # from the rect's edge to the controls
BLEED = 4  # a control without a body reaches this far beyond its words
LABEL_SHARE = 0.36  # of the width goes to the labels
BAR = 4  # width of the scroll bar
SHORTEST_THUMB = 24
NOTCH = 56  # scrolled by one notch of the wheel


class WidgetState(NamedTuple):
    """What a control learns when it claims its place: its own name, what was done to it, and how it should look."""

    name: str
    events: list  # of ControlEvents
    hover: bool
    held: bool


class Ui:
    """A panel and what it remembers from frame to frame: focus, scroll and what was drawn."""

    heading = controls.heading
    text = controls.text
    button = controls.button
    toggle = controls.toggle
    fold = controls.fold
    segmented = controls.segmented
    grid = choice_grids.grid
    swatches = choice_grids.swatches
    slider = sliders.slider
    slider_with_picture = sliders.slider_with_picture
    choice = dropdown.choice

    def __init__(self, theme):
        self.theme = theme
        self.focus = Focus()
        self.dirty = True  # the last end() drew something new
        self._drawn = None
        self._rect = pygame.Rect(0, 0, 0, 0)
        self._cells = []  # (left, width) of the controls still to come in this row

    def begin(self, rect, events, now_s=0.0, mouse_pos=None):
        """Start a frame in `rect` of the window; return the events that the panel leaves to others.

        now_s: any clock that only rises. mouse_pos: None while the pointer is outside of the window.
        """
        px = self.theme.px
        self._rect = pygame.Rect(rect)
        self.focus.bar_width, self.focus.notch = px(PAD) - px(BLEED), px(NOTCH)
        self.focus.scroll.shortest = px(SHORTEST_THUMB)
        rest = self.focus.begin(self._rect, events, now_s, mouse_pos)
        self._y = self._row_bottom = px(PAD)
        self._cells = []
        self._slots, self._strokes = {}, []
        return rest

    def end(self, surface):
        """Finish the frame: draw the panel if it differs from what was drawn last; return whether it did."""
        self._flush()
        if self.focus.by_keyboard and self.focus.name in self._slots:
            ring = self._slots[self.focus.name].ring
            self.stroke(draw_list.ring, ring, look.RING, self.theme.px(5), max(1, int(1.5 * self.theme.scale)))
        self.focus.settle(self._slots, self._y + self.theme.px(PAD))
        drawing = self._strokes + list(self._overlay())
        now = (
            self._rect,
            self.theme.scale,
            self.theme.colours.name,
            surface.get_size(),
            self.focus.scroll.offset,
            drawing,
        )
        self.dirty = now != self._drawn
        if self.dirty:
            self._draw(surface, drawing)
            self._drawn = now
        return self.dirty

    def invalidate(self):
        """Draw at the next end() in any case: the surface lost what was on it."""
        self._drawn = None

    # --- what the window asks ---

    @property
    def rects(self):
        """The rect in the window of every control of the last frame, by name, scrolled out of view or not."""
        return {name: self._in_window(slot.rect) for name, slot in self.focus.slots.items()}

    def parts(self, name):
        """Return the rects in the window of a control's parts: track, segments, or rows of its open list."""
        popup = self.focus.popup
        if popup and popup.name == name:
            row = pygame.Rect(popup.rect.topleft, (popup.rect.width, popup.row_height))
            return [self._in_window(row.move(0, i * popup.row_height)) for i in range(popup.shown)]
        return [self._in_window(part) for part in self.focus.slots[name].parts]

    def let_go(self):
        """Let go of the control that a button holds: nobody may hear it come up."""
        self.focus.let_go()

    def wants_mouse(self, pos):
        """Say whether the pointer at `pos` belongs to the panel, so that it paints no sand there."""
        return self.focus.owns(pos)

    @property
    def wants_keys(self):
        """Whether a control of the panel has the keyboard."""
        return self.focus.name is not None

    # --- what the controls ask ---

    @property
    def width(self):
        """The width in pixels of the next control."""
        return self._cells[0][1] if self._cells else self._rect.width - 2 * self.theme.px(PAD)

    @property
    def label_width(self):
        """The width in pixels of the next control's label, where it stands before the control."""
        return round(self.width * LABEL_SHARE)

    def row(self, columns):
        """Let the next `columns` controls share a row."""
        self._flush()
        gap = 2 * self.theme.px(BLEED)
        lefts = [round(i * (self.width + gap) / columns) for i in range(columns + 1)]
        self._cells = [(left, right - gap - left) for left, right in itertools.pairwise(lefts)]
        self._row_bottom = self._y

    def place(self, height, gap):
        """Return the next free rect of the column, with `gap` free pixels below."""
        left, width = self._cells.pop(0) if self._cells else (0, self.width)
        rect = pygame.Rect(self.theme.px(PAD) + left, self._y, width, height)
        self._row_bottom = max(self._row_bottom, rect.bottom + gap)
        if not self._cells:
            self._y = self._row_bottom
        return rect

    @property
    def begun(self):
        """Whether a control stands in the column already."""
        return bool(self._strokes)

    def skip(self, height):
        """Leave free pixels."""
        self._flush()
        self._y += height

    def bleed(self, rect):
        """Return the rect of a control without a body: a little wider than its words."""
        return rect.inflate(2 * self.theme.px(BLEED), 0)

    def claim(self, name, rect, ring=None, parts=(), keys=frozenset(), tip="", live=True):
        """Take a rect for a control and return the claim. `ring`: what the focus ring goes around, if not the rect."""
        while name in self._slots:
            name += "'"
        body = rect if ring is None else ring
        bodiless = rect.x < self.theme.px(PAD)
        ring = body if bodiless else body.inflate(2 * self.theme.px(2), 2 * self.theme.px(2))
        self._slots[name] = Slot(rect, ring, parts, keys if live else frozenset(), tip, live)
        focus = self.focus
        return WidgetState(name, focus.events.get(name, []) if live else [], focus.hover == name, focus.held == name)

    def stroke(self, *stroke):
        """Add (paint function, rect, ...) to the drawing."""
        self._strokes.append(stroke)

    # --- drawing ---

    def _flush(self):
        """End a row whose cells were not all taken."""
        if self._cells:
            self._cells, self._y = [], self._row_bottom

    def _in_window(self, rect):
        return rect.move(self._rect.x, self._rect.y - self.focus.scroll.offset)

    def _view(self):
        """What shows of the column, in the column's pixels."""
        return pygame.Rect((0, self.focus.scroll.offset), self._rect.size)

    def _overlay(self):
        """Yield the strokes that lie over the controls: scroll bar, open list, tip."""
        px, view, thumb = self.theme.px, self._view(), self.focus.scroll.thumb
        if thumb:
            bar = pygame.Rect(view.right - px(BAR) - px(3), view.y + thumb[0], px(BAR), thumb[1])
            yield draw_list.box, bar, look.DIM if self.focus.held == HELD_BAR else look.EDGE, px(2)
        if self.focus.popup:
            self.focus.popup.lay_out(self.theme, view)
            yield from self.focus.popup.strokes(self.theme)
        tipped = self._slots.get(self.focus.tipped)
        if tipped and tipped.tip:
            yield from tooltips.strokes(self.theme, tipped, view)

    def _draw(self, surface, drawing):
        clip = surface.get_clip()
        surface.set_clip(self._rect.clip(clip))
        surface.fill(self.theme.rgb(look.GROUND), self._rect)
        draw_list.draw(surface, self.theme, drawing, (self._rect.x, self._rect.y - self.focus.scroll.offset))
        surface.set_clip(clip)
