"""The event router: where an event goes that neither the panel nor anything over the sand has taken."""

import pygame

from game.play.controls import keymap
from game.play.controls.time_bar import LEFT


class EventRouter:
    """Gives events to the commands, the brush, the time bar and the status line."""

    def __init__(self, display, pointer, keys, commands, brush, time_bar, stats_card, stage, first, on_window):
        """`first`: what hears before the keys do. `on_window`: {type of an event of the window: what to do with it}."""
        self._display, self._pointer, self._keys, self._commands = display, pointer, keys, commands
        self._brush, self._time_bar, self._stats_card, self._stage = brush, time_bar, stats_card, stage
        self._first, self._on_window = first, on_window

    def handle_event(self, event):
        """Let the part that an event is meant for act on it."""
        event = self._pointer.mapped(event)
        if event.type != pygame.KEYDOWN:
            self._keys.note(event)
        if event.type == pygame.QUIT:
            self._on_window[event.type](event)
        elif any(each.handle_event(event) for each in self._first):
            self._brush.let_go()
        elif event.type == pygame.KEYDOWN:
            self._hear_key(event)
        elif event.type == pygame.MOUSEWHEEL:
            self._brush.resize(event.y)
        elif event.type in self._on_window:
            self._on_window[event.type](event)
        else:
            self._hear_pointer(event)

    def _hear_key(self, event):
        """Give a key's command, and while it is held some again, but not in another session than it went down in."""
        keys, command = self._keys, keymap.command(event)
        keys.repeats = keys.has_down(event.key)
        keys.note(event)
        if command and (not keys.repeats or (keys.went_down_here(event.key) and command in keymap.REPEATING)):
            self._commands.give(command)
        keys.repeats = False

    def _hear_pointer(self, event):
        """Give an event of the pointer to the brush or the time bar, whichever it is over or held by."""
        brush, layout, pressed = self._brush, self._display.layout, event.type == pygame.MOUSEBUTTONDOWN
        if brush.painting:
            brush.handle_event(event, self._display.sand_view.view)
        elif self._time_bar.handle_event(event):
            brush.let_go()
        elif pressed and event.button == LEFT and layout.status_line.collidepoint(event.pos):
            self._stats_card.toggle()
        elif pressed and event.button == LEFT and self._stage.on and layout.board.collidepoint(event.pos):
            self._stage.toggle()
        elif pressed and layout.sand.collidepoint(event.pos):
            brush.handle_event(event, self._display.sand_view.view)
