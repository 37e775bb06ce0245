"""Input: what a person can do to a control, and where a control takes it."""

import sys
from typing import NamedTuple

import pygame

ENTER = pygame.K_RETURN  # the keypad's Enter counts as this one


def key_name(label):
    """Return a shortcut as the keys of this machine are called: Cmd instead of Ctrl on a Mac."""
    return label.replace("Ctrl", "Cmd") if sys.platform == "darwin" else label


class Slot(NamedTuple):
    """Where a control lies and which input it takes."""

    rect: pygame.Rect
    ring: pygame.Rect  # of the focus ring
    parts: tuple = ()  # rects inside it that act differently: a slider's track, a choice's segments
    keys: frozenset = frozenset()
    tip: str = ""
    live: bool = True
    typed: bool = False  # it takes all that is typed


class ControlEvent(NamedTuple):
    """One thing that a person did to a control."""

    kind: str  # press, drag, release, key or wheel
    pos: tuple = (0, 0)
    part: int | None = None  # the part under the press that this press, drag or release belongs to
    again: bool = False  # that press was the second of a double press
    key: int = 0
    shift: bool = False
    text: str = ""
    notches: float = 0.0  # of the wheel, up is positive
