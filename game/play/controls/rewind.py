"""The rewind: time that runs backwards while a key is held."""

import pygame

from game.world.sand.clock import Clock

FAST = 5  # how much faster time runs back with Shift


class Rewind:
    """Hears the key and moves a session back, smoothly, at the pace at which it runs forward."""

    def __init__(self):
        self.held = self._fast = False
        self._clock = Clock(1)

    def handle_event(self, event):
        """Take in an event and return whether it was the rewind's."""
        if event.type not in (pygame.KEYDOWN, pygame.KEYUP):
            return False
        if event.key in (pygame.K_LSHIFT, pygame.K_RSHIFT):
            self._fast = event.type == pygame.KEYDOWN
        if event.key != pygame.K_BACKSPACE:
            return False
        if event.type == pygame.KEYDOWN:
            self._fast = bool(event.mod & pygame.KMOD_SHIFT)
        self.held = event.type == pygame.KEYDOWN
        return True

    @property
    def words(self):
        """What the status line says of it, or ""."""
        return "Time runs back" if self.held else ""

    def let_go(self):
        """Let time run forward again."""
        self.held = self._fast = False

    def goal(self, session, elapsed_ns):
        """Return the iteration that `session` is to be at after `elapsed_ns` of running back."""
        self._clock.speed = session.clock.speed * (FAST if self._fast else 1)
        return max(0, session.now - self._clock.due(elapsed_ns))
