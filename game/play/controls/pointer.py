"""The pointer: where the mouse is, in the window and in the view of the sand."""

import pygame

BUTTON_AND_MOTION = pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP


class Pointer:
    """Takes a place in any pane for the same place in the leading one; while a button is held, the pane stays."""

    def __init__(self, display):
        self._display = display
        self.in_window = None  # (x, y) in pixels, or None while the mouse is elsewhere
        self.place = None  # (x, y) in pixels in the leading pane, while it is over the sand or paints
        self._held = None  # from the leading pane to the one in which a button is held, in pixels

    def follow(self, mouse_pos, painting):
        """Note where the mouse is in this frame."""
        self.in_window = mouse_pos
        over_sand = mouse_pos is not None and self._display.layout.sand.collidepoint(mouse_pos)
        self.place = self._in_lead(mouse_pos) if mouse_pos is not None and (over_sand or painting) else None

    def mapped(self, event):
        """Return an event of the mouse as one in the leading pane, any other as it is."""
        if event.type not in BUTTON_AND_MOTION:
            return event
        if event.type == pygame.MOUSEBUTTONDOWN and self._held is None:
            self._held = self._shift_at(event.pos)
        event = pygame.event.Event(event.type, {**event.dict, "pos": self._in_lead(event.pos)})
        if event.type == pygame.MOUSEBUTTONUP:
            self._held = None
        return event

    def let_go(self):
        """Forget in which pane a button is held."""
        self._held = None

    def _in_lead(self, pos):
        x, y = self._shift_at(pos) if self._held is None else self._held
        return pos[0] - x, pos[1] - y

    def _shift_at(self, pos):
        """Return the way from the leading pane to the one at `pos`, in pixels."""
        view = self._display.sand_view
        pane = next((pane for pane in view.panes if pane.collidepoint(pos)), view.area)
        return pane.x - view.area.x, pane.y - view.area.y
