"""The panel: an immediate-mode column of controls, a pure function of the events and values it is given.

    rest = ui.begin(rect, events, now_s, mouse_pos)   # the events that are not the panel's
    p = ui.slider("p", knob.P, p)                     # every control returns its value
    ui.end(surface)                                   # draws, if anything looks different

Controls only leave strokes, a value; end() compares them with the last frame's and draws when they differ.
A control that is given what it was given in the last frame, in the same place, leaves the same strokes again.
All of it, lists and tips too, stays inside the rect, so a frame that is not drawn is still right on the screen.
"""

import functools
import itertools
from typing import NamedTuple

import pygame

from game.play.ui import choice_grids, controls, draw_list, dropdown, sliders, text_field, tooltips
from game.play.ui import theme as look
from game.play.ui.focus import BAR as HELD_BAR
from game.play.ui.focus import Focus
from game.play.ui.input import Slot

PAD = 14  # from the rect's edge to the controls
BLEED = 4  # a control without a body reaches this far beyond its words
LABELS = 0.27, 66  # of the width goes to the labels, but at least so many pixels at scale 1
BAR = 4  # width of the scroll bar
SHORTEST_THUMB = 24
NOTCH = 56  # scrolled by one notch of the wheel


class WidgetState(NamedTuple):
    """What a control learns when it claims its place: its own name, what was done to it, and how it should look."""

    name: str
    events: list  # of ControlEvents
    hover: bool
    held: bool


class _Kept(NamedTuple):
    """What a control was given in the last frame, what it returned, and all that it left."""

    given: tuple
    value: object
    slots: dict
    strokes: list
    state: tuple  # of the column below it


def _kept(control):
    """Return a control as a method of Ui that runs only where it is given something else than in the last frame."""

    @functools.wraps(control)
    def method(ui, *arguments, **how):
        return ui.kept(control, arguments, how)

    return method


class Ui:
    """A panel and what it remembers from frame to frame: focus, scroll and what was drawn."""

    heading = _kept(controls.heading)
    text = _kept(controls.text)
    button = _kept(controls.button)
    toggle = _kept(controls.toggle)
    fold = _kept(controls.fold)
    segmented = _kept(controls.segmented)
    grid = _kept(choice_grids.grid)
    swatches = _kept(choice_grids.swatches)
    text_field = text_field.text_field  # not kept: who has the keyboard is no argument of it
    slider = _kept(sliders.slider)
    slider_with_picture = _kept(sliders.slider_with_picture)
    choice = _kept(dropdown.choice)

    def __init__(self, theme):
        self.theme = theme
        self.focus = Focus()
        self.dirty = True  # the last end() drew something new
        self._drawn = None
        self._rect = pygame.Rect(0, 0, 0, 0)
        self._cells = ()  # (left, width) of the controls still to come in this row
        self._before, self._now = (), []  # what the last frame's controls left, and this one's, in their order

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
        self._cells = ()
        self._slots, self._strokes = {}, []
        self._before, self._now = self._now, []
        self._shared = self.theme, self._rect.width, self.focus.aim
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

    # --- what the controls ask ---

    def kept(self, control, arguments, how):
        """Return the value of a control: left as in the last frame where it is given the same, and no event."""
        given = (
            *(control, arguments, [*map(type, arguments)], how),  # of which 1 and 1.0 are equal
            *(self._shared, self._state, [*self._slots]),
        )
        number, told = len(self._now), bool(self.focus.events)
        last = self._before[number] if number < len(self._before) else None
        if last is None or told or given != last.given:
            slots, strokes = len(self._slots), len(self._strokes)
            value = control(self, *arguments, **how)
            left = dict(itertools.islice(self._slots.items(), slots, None)), self._strokes[strokes:], self._state
            self._now.append(None if told else _Kept(given, value, *left))
            return value
        self._slots |= last.slots
        self._strokes += last.strokes
        self._y, self._row_bottom, self._cells = last.state
        self._now.append(last)
        return last.value

    @property
    def width(self):
        """The width in pixels of the next control."""
        return self._cells[0][1] if self._cells else self._rect.width - 2 * self.theme.px(PAD)

    @property
    def label_width(self):
        """The width in pixels of the next control's label, where it stands before the control."""
        return max(round(self.width * LABELS[0]), self.theme.px(LABELS[1]))

    def has_room_for(self, label, columns):
        """Return whether buttons of `columns` in a row have room for a label, each."""
        return controls.fits(self, label, (self.width + 2 * self.theme.px(BLEED)) // columns - 2 * self.theme.px(BLEED))

    def row(self, columns):
        """Let the next `columns` controls share a row."""
        self._flush()
        gap = 2 * self.theme.px(BLEED)
        lefts = [round(i * (self.width + gap) / columns) for i in range(columns + 1)]
        self._cells = tuple((left, right - gap - left) for left, right in itertools.pairwise(lefts))
        self._row_bottom = self._y

    def place(self, height, gap):
        """Return the next free rect of the column, with `gap` free pixels below."""
        (left, width), self._cells = (self._cells[0], self._cells[1:]) if self._cells else ((0, self.width), ())
        rect = pygame.Rect(self.theme.px(PAD) + left, self._y, width, height)
        self._row_bottom = max(self._row_bottom, rect.bottom + gap)
        if not self._cells:
            self._y = self._row_bottom
        return rect

    @property
    def bottom(self):
        """Where the column ends so far."""
        return self._row_bottom if self._cells else self._y

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

    def claim(self, name, rect, ring=None, parts=(), keys=frozenset(), tip="", live=True, typed=False):
        """Take a rect for a control and return the claim. `ring`: what the focus ring goes around, if not the rect."""
        while name in self._slots:
            name += "'"
        body = rect if ring is None else ring
        bodiless = rect.x < self.theme.px(PAD)
        ring = body if bodiless else body.inflate(2 * self.theme.px(2), 2 * self.theme.px(2))
        self._slots[name] = Slot(rect, ring, parts, keys if live else frozenset(), tip, live, typed)
        focus = self.focus
        return WidgetState(name, focus.events.get(name, []) if live else [], focus.hover == name, focus.held == name)

    def stroke(self, *stroke):
        """Add (paint function, rect, ...) to the drawing."""
        self._strokes.append(stroke)

    @property
    def _state(self):
        """Where the next control will stand."""
        return self._y, self._row_bottom, self._cells

    # --- drawing ---

    def _flush(self):
        """End a row whose cells were not all taken."""
        if self._cells:
            self._cells, self._y = (), self._row_bottom

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
