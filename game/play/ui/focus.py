"""Which control has the pointer and which the keyboard, and which of a frame's events each of them gets.

A person aims at what was drawn last, so events are aimed by the slots of the last frame.
Places are in the column's own pixels: from the upper left of the panel's content, however far it is scrolled.
"""

import math

import pygame

from game.play.ui.input import ENTER, ControlEvent
from game.play.ui.scroll import Scroll
from game.play.ui.text_line import types
from game.play.ui.tooltips import Rest

DOUBLE_S = 0.4  # two presses within this time and DOUBLE_PX are a double press
DOUBLE_PX = 6
BAR = "\0scroll bar"  # what is held while the scroll bar is dragged: no control's name

_LEFT_BUTTON = 1
_WHEEL_BUTTONS = (4, 5)  # MOUSEWHEEL tells the same
ALT_GR = pygame.KMOD_RALT | pygame.KMOD_MODE
_OTHER_MODIFIERS = pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META


class Focus:
    """Keeps pointer, focus and scroll between frames; hands each control its events."""

    def __init__(self):
        self.name = None  # of the control with the keyboard
        self.by_keyboard = False  # it got there by Tab: show the ring
        self.held = None  # the control the mouse button went down on, until it goes up
        self.hover = None
        self.slots = {}
        self.events = {}
        self.popup = None
        self.reveal = False  # the focused control is to be scrolled into view
        self.scroll = Scroll()
        self.bar_width = self.notch = 1
        self._view = pygame.Rect(0, 0, 0, 0)
        self._pointer = None
        self._pointing = True  # the mouse was used later than Tab
        self._ours, self._theirs = set(), set()  # mouse buttons that went down inside and outside of the panel
        self._grip = (None, False)  # part and again of the press being held
        self._last_press = (None, (0, 0), -math.inf)
        self._rest, self._busy = Rest(), False  # busy: did something to a control this frame

    def begin(self, view, events, now_s, pointer):
        """Give the events to their controls and return those that are not the panel's."""
        self._view, self._now_s, self._busy, self.events = view, now_s, False, {}
        self.scroll.view = view.height
        if pointer is not None:
            self._pointer = pointer
        rest = [event for event in events if not self._handle(event)]
        over = None if self._theirs or self.popup else self._control_under(self._pointer)
        self.hover = self.held or over
        rests_on = self.hover if self._pointing else self.name if self.by_keyboard else None
        self._rest.on(rests_on, now_s, self._busy)
        return rest

    def settle(self, slots, content_height):
        """Take this frame's layout, and let go of what is no longer there.

        Where the control in use has moved in the column, the column moves against it: it stays under the pointer.
        """
        known = self.name in slots and self.name in self.slots
        moved = slots[self.name].ring.top - self.slots[self.name].ring.top if known else 0
        self.slots = slots
        self.scroll.content = content_height
        self.scroll.to(self.scroll.offset + moved)
        if self.name not in slots:
            self.name, self.by_keyboard = None, False
        if self.held not in slots and self.held != BAR:
            self.held = None
        if self.popup and self.popup.name != self.name:
            self.popup = None
        if self.reveal and self.name:
            ring = slots[self.name].ring
            self.scroll.reveal(ring.top - self.notch // 4, ring.bottom + self.notch // 4)
        self.reveal = False

    def take(self, top):
        """Give the keyboard to the first control that begins at `top` of the column or below."""
        below = [name for name, slot in self.slots.items() if slot.live and slot.rect.top >= top]
        if below:
            self.name, self.by_keyboard, self._pointing = below[0], True, False

    def leave(self):
        """Give the keyboard back."""
        self._drop()

    def let_go(self):
        """Forget the buttons held: nobody may hear them come up."""
        self.held = None
        self._ours.clear()
        self._theirs.clear()

    def owns(self, pos):
        """Say whether the pointer at `pos` in the window is the panel's: over it, or dragging something of it."""
        return bool(self._ours) or (not self._theirs and self._view.collidepoint(pos))

    @property
    def tipped(self):
        """The control whose tip is to show now, or None."""
        return None if self.popup else self._rest.name

    @property
    def aim(self):
        """What controls are told of the person, but for events."""
        return self.hover, self.held, self.popup, self.hover and self.pointed_part(self.hover)

    def pointed_part(self, name):
        """Return the number of the part of a control that the pointer is over, or None where that tells nothing."""
        if self._pointer is None or not self._pointing or name not in self.slots or name != self.hover:
            return None
        place = self.place(self._pointer)
        return next((i for i, part in enumerate(self.slots[name].parts) if part.collidepoint(place)), None)

    def place(self, pos):
        """Return a place in the window in the column's own pixels."""
        return pos[0] - self._view.x, pos[1] - self._view.y + self.scroll.offset

    # --- events ---

    def _handle(self, event):
        handle = {
            pygame.MOUSEBUTTONDOWN: self._button_down,
            pygame.MOUSEBUTTONUP: self._button_up,
            pygame.MOUSEMOTION: self._motion,
            pygame.MOUSEWHEEL: self._wheel,
            pygame.KEYDOWN: self._key,
            pygame.WINDOWLEAVE: self._leave,
            pygame.WINDOWFOCUSLOST: self._lose,
        }.get(event.type)
        return bool(handle and handle(event))

    def _button_down(self, event):
        inside = self._view.collidepoint(event.pos)
        if event.button in _WHEEL_BUTTONS:
            return inside
        self._pointer = event.pos
        if self._theirs or not (inside or self._ours):
            self._theirs.add(event.button)
            self._drop()
            return False
        self._ours.add(event.button)
        if event.button == _LEFT_BUTTON:
            self._press(event.pos)
        return True

    def _press(self, pos):
        self._pointing = self._busy = True
        if self._press_bar(pos):
            return
        popup, place = self.popup, self.place(pos)
        if popup and popup.rect.collidepoint(place):
            self.held = popup.name
            self._tell(popup.name, ControlEvent("drag", place))
            return
        self._drop()
        if popup:  # a press beside an open list only closes it
            return
        under = self._control_under(pos)
        if under and self.slots[under].live:
            self.held = self.name = under
            part = next((i for i, each in enumerate(self.slots[self.held].parts) if each.collidepoint(place)), None)
            self._grip = part, self._is_second_press((self.held, part), pos)
            self._tell(self.held, ControlEvent("press", place, *self._grip))

    def _is_second_press(self, aim, pos):
        last_aim, last_pos, last_s = self._last_press
        second = aim == last_aim and self._now_s - last_s <= DOUBLE_S and math.dist(pos, last_pos) <= DOUBLE_PX
        self._last_press = (None, pos, -math.inf) if second else (aim, pos, self._now_s)
        return second

    def _press_bar(self, pos):
        if not self.scroll.thumb or pos[0] < self._view.right - self.bar_width:
            return False
        self.held, self.popup = BAR, None
        self.scroll.grab(pos[1] - self._view.y)
        return True

    def _motion(self, event):
        self._pointer, self._pointing = event.pos, True
        if self.held == BAR:
            self.scroll.drag(event.pos[1] - self._view.y)
        elif self.held:
            self._tell(self.held, ControlEvent("drag", self.place(event.pos), *self._grip))
        elif self.popup and self.popup.rect.collidepoint(self.place(event.pos)):
            self._tell(self.popup.name, ControlEvent("drag", self.place(event.pos)))
        return self.owns(event.pos)

    def _button_up(self, event):
        if event.button not in self._ours:
            self._theirs.discard(event.button)
            return False
        self._ours.discard(event.button)
        if event.button == _LEFT_BUTTON:
            if self.held and self.held != BAR:
                self._tell(self.held, ControlEvent("release", self.place(event.pos), *self._grip))
            self.held = None
        return True

    def _wheel(self, event):
        if self._pointer is None or not self.owns(self._pointer):
            return False
        notches = getattr(event, "precise_y", event.y)
        if self.popup and self.popup.rect.collidepoint(self.place(self._pointer)):
            self._tell(self.popup.name, ControlEvent("wheel", notches=notches))
        else:
            self.popup = None
            self.scroll.to(self.scroll.offset - notches * self.notch)
        return True

    def _key(self, event):
        if event.mod & _OTHER_MODIFIERS and not self._types_by_alt_gr(event):
            return False
        if event.key == pygame.K_TAB:
            return self._walk(-1 if event.mod & pygame.KMOD_SHIFT else 1)
        if self.name not in self.slots:
            return False
        key = ENTER if event.key == pygame.K_KP_ENTER else event.key
        text = getattr(event, "unicode", "")
        if key == pygame.K_ESCAPE:
            return self._escape()
        if self._acts_on_focused(key, text):
            self._busy = self.reveal = True
            self._tell(self.name, ControlEvent("key", key=key, shift=bool(event.mod & pygame.KMOD_SHIFT), text=text))
        elif key in (pygame.K_PAGEUP, pygame.K_PAGEDOWN) and self.scroll.limit:
            page = self._view.height - self.notch
            self.scroll.to(self.scroll.offset + (page if key == pygame.K_PAGEDOWN else -page))
        else:
            return False
        return True

    def _acts_on_focused(self, key, text):
        if self.popup:
            return (text.isprintable() and text != "") or key in self.popup.keys
        slot = self.slots[self.name]
        if slot.typed and types(text):
            return True
        return key in slot.keys and (key != pygame.K_SPACE or self.by_keyboard)

    def _types_by_alt_gr(self, event):
        """Return whether a key types a letter into a field by AltGr, for which Windows holds Ctrl down as well."""
        slot = self.slots.get(self.name)
        return bool(slot and slot.typed and event.mod & ALT_GR and types(getattr(event, "unicode", "")))

    def _escape(self):
        """Close the open list, else leave a control that Tab led to; one that was clicked keeps no key from others."""
        was = self.popup or self.by_keyboard
        if self.popup:
            self.popup = None
        else:
            self._drop()
        return bool(was)

    def _walk(self, way):
        """Move the keyboard to the next (1) or the previous (-1) control, round the ends."""
        names = list(self.slots)
        here = names.index(self.name) if self.name in names else (-1 if way > 0 else 0)
        round_trip = (names[(here + way * i) % len(names)] for i in range(1, len(names) + 1))
        self.name = next((name for name in round_trip if self.slots[name].live), None)
        if self.name is None:
            return False
        self.by_keyboard = True
        self.popup, self._pointing, self.reveal = None, False, True
        return True

    def _leave(self, _event):
        self._pointer = None

    def _lose(self, _event):
        self.let_go()

    # --- helpers ---

    def _tell(self, name, event):
        self.events.setdefault(name, []).append(event)

    def _drop(self):
        self.name, self.by_keyboard, self.popup = None, False, None

    def _control_under(self, pos):
        if pos is None or not self._view.collidepoint(pos):
            return None
        place = self.place(pos)
        return next((name for name, slot in self.slots.items() if slot.rect.collidepoint(place)), None)
