"""The wait between two frames: until the next is due, or where nothing goes on until something happens."""

import time

import pygame

from game.world.sessions.session import FRAMES_PER_SECOND

CALM_FRAMES = 30  # with nothing going on, after which events are waited for: half a second for tips and fades to come
CALM_MS = 250  # the longest wait for an event; less takes more of a battery, more lets what tells the time jerk
HIDDEN_MS = 50  # the same while nobody sees the window and sand moves in it: a timer still ends on time
LOOK_MS = 20  # from one look for an event to the next: pygame's own wait looks each millisecond, at 3 % of a core;
# while nobody sees the window, HIDDEN_MS


class FrameWait:
    """Waits as long as what goes on in a window allows."""

    def __init__(self):
        self._clock = pygame.time.Clock()
        self._calm = 0  # frames in a row with nothing going on

    def events(self, at_rest, hidden):
        """Wait for the next frame and return the events until then.

        at_rest: nothing goes on, so that only an event can change what is seen. hidden: nobody sees it.
        """
        if hidden:
            wait_for_event(CALM_MS if at_rest else HIDDEN_MS, HIDDEN_MS)
            self._clock.tick()
        elif at_rest and self._calm >= CALM_FRAMES:
            wait_for_event(CALM_MS, LOOK_MS)
            self._clock.tick()
        else:
            self._clock.tick(FRAMES_PER_SECOND)
        events = pygame.event.get()
        self._calm = 0 if events or not at_rest else self._calm + 1
        return events


def wait_for_event(longest_ms, look_ms):
    """Return when there is an event, or after that time; look for one every so many milliseconds."""
    until_s = time.monotonic() + longest_ms / 1e3
    while not pygame.event.peek() and time.monotonic() < until_s:
        time.sleep(look_ms / 1e3)
