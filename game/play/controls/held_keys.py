"""The keys that are held."""

import pygame


class HeldKeys:
    """Notes which keys are down, and the session that each went down in."""

    def __init__(self, sessions):
        self._sessions = sessions
        self.repeats = False  # the key that gives a command just now has been held for a while
        self._down = {}  # key: session

    def note(self, event):
        """Take in an event, also one that something else has taken."""
        if event.type == pygame.KEYDOWN:
            self._down.setdefault(event.key, self._sessions.now)
        elif event.type == pygame.KEYUP:
            self._down.pop(event.key, None)
        elif event.type == pygame.WINDOWFOCUSLOST:
            self._down.clear()

    def has_down(self, key):
        """Return whether a key is held since an earlier frame, or for a command."""
        return key in self._down

    @property
    def any_down(self):
        """Whether any key is held."""
        return bool(self._down)

    def went_down_here(self, key):
        """Return whether a key that is held went down in the session that is played."""
        return self._down[key] is self._sessions.now
