"""The cursor: a pointer that the keyboard moves over the cells, to do all that the mouse does on the sand."""

import pygame

from game.play.ui import theme as look
from game.play.ui.input import ENTER
from game.play.view.overlays.outlines import box_outline, mark

WAYS = {pygame.K_LEFT: (-1, 0), pygame.K_RIGHT: (1, 0), pygame.K_UP: (0, -1), pygame.K_DOWN: (0, 1)}
FAR = 10  # cells that an arrow goes with Shift
PRESS, ERASE = ENTER, pygame.K_DELETE  # what stands for the left and the right button


class KeyboardCursor:
    """Hears the arrows, Enter and Delete while it is on, unless Tab has led to a control of the panel."""

    def __init__(self, sessions, brush, focus):
        """`focus`: that of the panel's controls."""
        self._sessions, self._brush, self._focus = sessions, brush, focus
        self.on = False
        self._cell = None  # (column, row)
        self._pressed = None  # the key that is held as a button

    @property
    def place(self):
        """Where it is, (column, row) in cells: the middle of a cell."""
        return self._cell[0] + 0.5, self._cell[1] + 0.5

    def marks(self, view):
        """Return the Marks of its cell and of the tool there."""
        column, row = self._cell
        box = box_outline(column, row, column + 1, row + 1)
        return (*self._brush.marks(self.place, view), mark(box, view, look.RING))

    def toggle(self):
        """Show it, where it was last or else in the middle of the lattice, or put it away."""
        self.on = not self.on
        self._let_go()
        self._focus.leave()
        height, width = self._sessions.now.world.shape
        self._cell = self._cell or (width // 2, height // 2)

    def handle_events(self, events):
        """Take the events that are the cursor's and return the others."""
        if not self.on:
            return events
        height, width = self._sessions.now.world.shape
        self._cell = min(self._cell[0], width - 1), min(self._cell[1], height - 1)
        if self._pressed and not self._brush.painting:  # something else has let go of the brush
            self._pressed = None
        return [event for event in events if not self._hear(event)]

    def _hear(self, event):
        if event.type not in (pygame.KEYDOWN, pygame.KEYUP):
            return False
        key = ENTER if event.key == pygame.K_KP_ENTER else event.key
        if event.type == pygame.KEYUP:
            if key != self._pressed:
                return False
            self._brush.release(self.place)
            self._pressed = None
            return True
        if self._focus.by_keyboard or event.mod & (pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META):
            return False
        if key in WAYS:
            self._move(WAYS[key], FAR if event.mod & pygame.KMOD_SHIFT else 1)
            return True
        if key in (PRESS, ERASE):
            self._press(key)
            return True
        return False

    def _move(self, way, cells):
        height, width = self._sessions.now.world.shape
        column, row = (here + cells * step for here, step in zip(self._cell, way, strict=True))
        self._cell = min(max(column, 0), width - 1), min(max(row, 0), height - 1)
        if self._pressed:
            self._brush.move(self.place)

    def _press(self, key):
        if self._pressed is None and not self._brush.painting:
            self._pressed = key
            self._brush.press(self.place, erase=key == ERASE)

    def _let_go(self):
        if self._pressed:
            self._brush.let_go()
        self._pressed = None
