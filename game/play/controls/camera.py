"""The camera: which part of the lattice is in sight. It is no part of the world, and not recorded."""

import math

import pygame

from game.play.controls.keymap import CTRL
from game.play.view.overlays.zoom_badge import ZoomBadge
from game.world.looks.view import LEVELS, View, level
from game.world.sessions.session import SEEK_NS

LEFT, MIDDLE = 1, 2
CTRL_KEYS = pygame.K_LCTRL, pygame.K_RCTRL, pygame.K_LMETA, pygame.K_RMETA
FEWEST_CELLS = 6  # across the shorter side of the sand view, at the largest zoom, but for
LARGEST_CELL = 64  # pixels: no sand view is too small for this
PAN = 1 / 8  # of the sand view, by one press of a key
MISTAKE_S = 0.7  # a finger that has painted for less than this meant to be one of two


class Camera:
    """Hears wheel, drags and fingers, obeys the keys, and keeps what is in the middle when the window changes."""

    def __init__(self, sessions, display, pointer, brush, minimap, on_tap):
        """`on_tap()` is called when Space was pressed and has dragged nothing."""
        self._sessions, self._display, self._pointer = sessions, display, pointer
        self._brush, self._minimap, self._on_tap = brush, minimap, on_tap
        self._on_map = False  # a press on the minimap is held
        self.badge = ZoomBadge(display)
        self._drag = None  # where the pointer was that drags the lattice along, and the button that does
        self._ctrl = False  # a Ctrl key is held
        self._space = None  # while Space is held: whether it has dragged
        self._fingers = {}  # where they are, by number
        self._pinch = None  # while two fingers are down: cell, place and distance at the start
        self._since_s = 0.0  # when the first finger came down
        self._swallows = False  # what the mouse does is what is left of a pinch

    # --- what the keys ask of it ---

    def zoom(self, steps):
        """Go `steps` levels closer, or away, about the pointer or the middle of the sand view."""
        view = self._sand_view.view
        x, y = self._pointer.place or self._sand_view.area.center
        self._show(level(view.cell, steps), view.place(x, y), x, y)

    def zoom_to(self, cell):
        """Show cells `cell` pixels wide, with what is in the middle of the sand view where it is."""
        x, y = self._sand_view.area.center
        self._show(cell, self._sand_view.view.place(x, y), x, y)

    def fit(self):
        """Show the whole lattice."""
        self._sand_view.show(self._sand_view.whole)
        self.badge.show()

    def pan(self, right, down):
        """Move on over the lattice by parts of the sand view."""
        area = self._sand_view.area
        self._shift(-right * PAN * area.width, -down * PAN * area.height)

    # --- what the toy tells it ---

    def keep(self, before):
        """After a new layout, show what the view `before` showed, if that was not the whole."""
        sand_view = self._sand_view
        if before is None or before.frame is None or before.shape != sand_view.whole.shape:
            return
        x, y, width, height = before.frame
        place = before.place(x + width / 2 - 0.5, y + height / 2 - 0.5)
        area = sand_view.area
        self._show(before.cell, place, area.x + area.width / 2 - 0.5, area.y + area.height / 2 - 0.5)

    def turn_over(self, quarters=2):
        """Follow the sand in sight as the lattice is turned over; a quarter turn shows all of it."""
        view, area = self._sand_view.view, self._sand_view.area
        if view.frame is None:
            return
        if quarters != 2:
            self.fit()
            return
        x, y = area.x + area.width / 2 - 0.5, area.y + area.height / 2 - 0.5
        column, row = view.place(x, y)
        self._show(view.cell, (view.shape[1] - column, view.shape[0] - row), x, y)

    def let_go(self):
        """Forget what is held: nobody may hear it come up."""
        self._drag = self._space = self._pinch = None
        self._on_map = False
        self._fingers.clear()
        self._swallows = self._ctrl = False

    def handle_event(self, event):
        """Take in an event and return whether it was the camera's."""
        hears = {
            pygame.MOUSEWHEEL: self._wheel,
            pygame.MOUSEBUTTONDOWN: self._press,
            pygame.MOUSEMOTION: self._motion,
            pygame.MOUSEBUTTONUP: self._release,
            pygame.KEYDOWN: self._key_down,
            pygame.KEYUP: self._key_up,
            pygame.FINGERDOWN: self._finger_down,
            pygame.FINGERMOTION: self._finger_motion,
            pygame.FINGERUP: self._finger_up,
        }.get(event.type)
        return bool(hears and hears(event))

    @property
    def busy(self):
        """Whether the pointer is on the map, or drags or pinches the lattice, so that no brush is to be seen."""
        on_map = self._on_map or (self._pointer.place is not None and self._minimap.is_at(self._pointer.place))
        return self._drag is not None or self._pinch is not None or self._space is not None or on_map

    # --- events ---

    def _wheel(self, event):
        if not (self._ctrl or pygame.key.get_mods() & CTRL):
            return False
        self.zoom(event.y)
        return True

    def _press(self, event):
        if self._swallows and getattr(event, "touch", False):
            return True
        if self._minimap.is_at(event.pos) and not self._drag and not self._brush.painting:
            self._on_map = event.button == LEFT
            self._follow_map(event.pos)
            return True
        drags = event.button == MIDDLE or (event.button == LEFT and self._space is not None)
        if self._drag or not drags or not self._sand_view.area.collidepoint(event.pos):
            return False
        self._drag = event.pos, event.button
        return True

    def _motion(self, event):
        if self._swallows and getattr(event, "touch", False):
            return True
        if self._on_map:
            self._follow_map(event.pos)
            return True
        if not self._drag:
            return False
        (x, y), button = self._drag
        self._drag = event.pos, button
        if self._space is not None:
            self._space = True
        self._shift(event.pos[0] - x, event.pos[1] - y)
        return True

    def _release(self, event):
        if self._swallows and getattr(event, "touch", False):
            return True
        if self._on_map and event.button == LEFT:
            self._on_map = False
            return True
        if not self._drag or event.button != self._drag[1]:
            return False
        self._drag = None
        return True

    def _key_down(self, event):
        self._ctrl |= event.key in CTRL_KEYS
        if event.key != pygame.K_SPACE or event.mod & (CTRL | pygame.KMOD_ALT) or self._brush.painting:
            return False
        self._space = bool(self._space)
        return True

    def _key_up(self, event):
        self._ctrl &= event.key not in CTRL_KEYS
        if event.key != pygame.K_SPACE or self._space is None:
            return False
        dragged, self._space = self._space, None
        if not dragged and not self._drag:
            self._on_tap()
        return True

    # --- fingers ---

    def _finger_down(self, event):
        self._fingers[event.finger_id] = self._pixel_of(event)
        if len(self._fingers) == 1:
            self._since_s = self._display.now_s
        elif len(self._fingers) == 2 and self._sand_view.area.collidepoint(self._middle):
            self._take_back_stroke()
            self._swallows = True
            self._start_pinch()
        return self._swallows

    def _finger_motion(self, event):
        if event.finger_id in self._fingers:
            self._fingers[event.finger_id] = self._pixel_of(event)
        if self._pinch and len(self._fingers) == 2:
            cell, place, span = self._pinch
            self._show(cell * self._span / span, place, *self._middle)
        return self._swallows

    def _finger_up(self, event):
        self._fingers.pop(event.finger_id, None)
        swallowed = self._swallows
        if self._pinch and len(self._fingers) == 1:
            self._end_pinch()
        if len(self._fingers) == 2:
            self._start_pinch()
        self._swallows = self._swallows and bool(self._fingers)
        return swallowed

    def _start_pinch(self):
        view = self._sand_view.view
        self._pinch = view.cell, view.place(*self._middle), self._span

    def _end_pinch(self):
        """Let cells that are wider than a pixel be whole pixels wide again."""
        self._pinch = None
        view, (x, y) = self._sand_view.view, self._sand_view.area.center
        if view.frame and view.cell > 1:
            self._show(round(view.cell), view.place(x, y), x, y)

    def _take_back_stroke(self):
        """End the stroke that the first of two fingers began, and undo it if it came down only just before."""
        stroke = self._brush.deed
        self._brush.let_go()
        if self._display.now_s - self._since_s < MISTAKE_S:
            self._sessions.slowly("Undoing …", lambda: stroke.acted and self._sessions.now.undo(budget_ns=SEEK_NS))

    def _pixel_of(self, event):
        width, height = self._display.window.size
        return event.x * width, event.y * height

    @property
    def _middle(self):
        (x0, y0), (x1, y1) = list(self._fingers.values())[:2]
        return (x0 + x1) / 2, (y0 + y1) / 2

    @property
    def _span(self):
        one, other = list(self._fingers.values())[:2]
        return max(1.0, math.dist(one, other))

    # --- the view ---

    @property
    def _sand_view(self):
        return self._display.sand_view

    def _follow_map(self, pos):
        """Show what the minimap shows at a place, while it is held there."""
        if self._on_map:
            self._show(self._sand_view.view.cell, self._minimap.place(pos), *self._sand_view.area.center)

    def _shift(self, right, down):
        """Drag the lattice by pixels."""
        view, area = self._sand_view.view, self._sand_view.area
        if view.frame is not None:
            x, y = area.center
            self._show(view.cell, view.place(x, y), x + right, y + down)

    def _show(self, cell, place, x, y):
        """Show a place at pixel (x, y), with `cell` pixels to a cell, as far as the limits allow."""
        sand_view = self._sand_view
        self.badge.show()
        most = max(LARGEST_CELL, min(sand_view.area.size) / FEWEST_CELLS)
        cell = min(cell, max(each for each in LEVELS if each <= most))
        if cell <= sand_view.whole.cell:
            view = sand_view.whole
        else:
            view = View.near(sand_view.whole.shape, tuple(sand_view.area), cell, place, x, y)
        if view != sand_view.view:
            sand_view.show(view)
