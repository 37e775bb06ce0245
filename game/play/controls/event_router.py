"""Hearing: where an event goes that neither the panel nor anything laid over the sand has taken."""

import pygame

from game.play.controls import keymap
from game.play.controls.time_bar import LEFT


class Hearing:
    """Gives events to the keys' commands, the brush and the time bar, and knows where the pointer is."""

    def __init__(self, toy):
        self._toy = toy
        # what hears before the keys do: `handle_event(event)` says whether the event was its own
        self.first = [toy.rewind, toy.camera]
        self.pointer = None  # (x, y) in pixels, while it is over the sand or paints
        self.repeats = False  # the key that gives a command just now has been held for a while
        self._down = {}  # the keys that are held, and the session that each went down in

    def handle_event(self, event):
        """Let the part that an event is meant for act on it."""
        toy, event = self._toy, self._toy.display.stage.own(event)
        if event.type != pygame.KEYDOWN:
            self.note(event)
        if event.type == pygame.QUIT:
            toy.running = False
        elif any(each.handle_event(event) for each in self.first):
            toy.brush.let_go()
        elif event.type == pygame.KEYDOWN:
            self._hear_key(event)
        elif event.type == pygame.MOUSEWHEEL:
            toy.brush.resize(event.y)
        elif event.type == pygame.WINDOWFOCUSLOST:
            toy.let_go()
        elif event.type in (pygame.WINDOWEXPOSED, pygame.WINDOWSIZECHANGED):
            toy.display.lay_out_anew()
        elif event.type == pygame.DROPFILE:
            toy.files.open(event.file)
        else:
            self._hear_pointer(event)

    def _hear_key(self, event):
        """Give a key's command, and while it is held some again, but not in another session than it went down in."""
        toy, command = self._toy, keymap.command(event)
        self.repeats = event.key in self._down
        began_here = self._down.setdefault(event.key, toy.sessions.now) is toy.sessions.now
        if command and (not self.repeats or (began_here and command in keymap.REPEATING)):
            name, *words = command.split()
            getattr(toy.commands, name)(*words)
        self.repeats = False

    def note(self, event):
        """Note which keys are held, those that something else has taken among them."""
        if event.type == pygame.KEYDOWN:
            self._down.setdefault(event.key, self._toy.sessions.now)
        elif event.type == pygame.KEYUP:
            self._down.pop(event.key, None)
        elif event.type == pygame.WINDOWFOCUSLOST:
            self._down.clear()

    def has_down(self, key):
        """Return whether a key is held since an earlier frame, or for a command."""
        return key in self._down

    @property
    def place(self):
        """Where the pointer is, in pixels, while it is over the sand or paints, or None."""
        return self.pointer

    def follow(self, mouse_pos):
        """Note where the pointer is in this frame."""
        over_sand = mouse_pos is not None and self._toy.display.layout.sand.collidepoint(mouse_pos)
        self.pointer = self._toy.display.stage.here(mouse_pos) if over_sand or self._toy.brush.painting else None

    def _hear_pointer(self, event):
        """Give an event of the pointer to the brush or the time bar, whichever it is over or held by."""
        toy = self._toy
        on_sand = event.type == pygame.MOUSEBUTTONDOWN and toy.display.layout.sand.collidepoint(event.pos)
        going_on = toy.brush.painting
        if not going_on and toy.time_bar.handle_event(event):
            toy.brush.let_go()
        elif not going_on and _is_press(event) and toy.display.layout.hud.collidepoint(event.pos):
            toy.figures.toggle()
        elif going_on or on_sand:
            toy.paint(toy.brush.handle_event(event, toy.display.stage.view, toy.sessions.now.world))


def _is_press(event):
    return event.type == pygame.MOUSEBUTTONDOWN and event.button == LEFT
