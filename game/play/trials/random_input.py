"""A hand that does anything at all: random input for the soak, the same for the same seed."""

import random

import pygame

from game.play.controls.keymap import CTRL, KEYS, SHIFT
from game.world.files.paths import asset

MOVES = (
    *(pygame.K_TAB, pygame.K_RETURN, pygame.K_SPACE, pygame.K_ESCAPE, pygame.K_HOME, pygame.K_END, pygame.K_DELETE),
    *(pygame.K_LEFT, pygame.K_RIGHT, pygame.K_UP, pygame.K_DOWN, pygame.K_PAGEUP, pygame.K_PAGEDOWN),
    *(pygame.K_BACKSPACE, pygame.K_LCTRL, pygame.K_LSHIFT),
)
MODS = 0, 0, 0, SHIFT, pygame.KMOD_LCTRL, pygame.KMOD_LCTRL | SHIFT
SIZES = (640, 480), (800, 600), (1000, 700), (1280, 720), (701, 533)
LONGEST_STROKE = 40  # frames
DOINGS = {
    "press": 30,
    "release": 30,
    "begin": 20,
    "wheel": 6,
    "point": 8,
    "finger": 4,
    "resize": 1,
    "leave": 1,
    "drop": 1,
}


class Hand:
    """Makes the events of one frame after the other."""

    def __init__(self, seed):
        self._chance = random.Random(seed)
        self._down = []  # keys that are held
        self._left = 0  # frames for which the button is still held
        self._button = 1
        self._fingers = set()
        self.pointer = 0, 0

    def events(self, size, busy):
        """Return the events of a frame in a window of `size`; busy: the share of frames in which something is done."""
        chance = self._chance
        if self._left:
            return self._go_on(size)
        if chance.random() > busy:
            return []
        doing = chance.choices(list(DOINGS), DOINGS.values())[0]
        return getattr(self, f"_{doing}")(size)

    def _press(self, _size):
        chance = self._chance
        if chance.random() < 0.6:
            key = chance.choice([key for key in KEYS if key.codes])
            code, mod = chance.choice(key.codes), pygame.KMOD_LCTRL * bool(key.mods & CTRL) | key.mods & SHIFT
        else:
            code, mod = chance.choice(MOVES), chance.choice(MODS)
        self._down.append(code)
        text = chr(code) if 32 <= code < 127 and not mod & pygame.KMOD_CTRL else ""
        return [pygame.event.Event(pygame.KEYDOWN, key=code, mod=mod, unicode=text)]

    def _release(self, _size):
        keys, self._down = self._down, []
        return [pygame.event.Event(pygame.KEYUP, key=key, mod=0) for key in keys]

    def _begin(self, size):
        self._move(size)
        self._left, self._button = self._chance.randrange(LONGEST_STROKE), self._chance.choice((1, 1, 1, 2, 3))
        return [self._mouse(pygame.MOUSEBUTTONDOWN, button=self._button)]

    def _go_on(self, size):
        self._left -= 1
        if self._left <= 0:
            return [self._mouse(pygame.MOUSEBUTTONUP, button=self._button)]
        if self._chance.random() < 0.3:
            return []
        self._move(size, near=60)
        return [self._mouse(pygame.MOUSEMOTION, rel=(0, 0), buttons=(1, 0, 0))]

    def _point(self, size):
        self._move(size)
        return [self._mouse(pygame.MOUSEMOTION, rel=(0, 0), buttons=(0, 0, 0))]

    def _wheel(self, size):
        self._move(size, near=200)
        return [pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=self._chance.choice((-3, -1, 1, 3)), flipped=False)]

    def _finger(self, _size):
        number, chance = self._chance.randrange(3), self._chance
        where = {"finger_id": number, "touch_id": 1, "x": chance.random(), "y": chance.random(), "dx": 0.0, "dy": 0.0}
        if number not in self._fingers:
            self._fingers.add(number)
            return [pygame.event.Event(pygame.FINGERDOWN, pressure=1.0, **where)]
        if chance.random() < 0.5:
            return [pygame.event.Event(pygame.FINGERMOTION, pressure=1.0, **where)]
        self._fingers.discard(number)
        return [pygame.event.Event(pygame.FINGERUP, pressure=0.0, **where)]

    def _resize(self, _size):
        size = self._chance.choice(SIZES)
        pygame.display.set_mode(size, pygame.RESIZABLE, 32)
        return [pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1])]

    def _leave(self, _size):
        return [pygame.event.Event(pygame.WINDOWLEAVE), pygame.event.Event(pygame.WINDOWFOCUSLOST)]

    def _drop(self, _size):
        kinds = ("scenes", "*.toml"), ("replays", "*.sandglass"), ("pictures", "*.png"), ("font", "*")
        folder, name = self._chance.choice(kinds)
        return [pygame.event.Event(pygame.DROPFILE, file=str(self._chance.choice(sorted(asset(folder).glob(name)))))]

    def _move(self, size, near=None):
        """Put the pointer somewhere, or somewhere near where it is."""
        where = (self._chance.randrange(-5, side + 5) for side in size)
        if near:
            where = (each + self._chance.randrange(-near, near + 1) for each in self.pointer)
        self.pointer = tuple(min(max(each, -5), side + 5) for each, side in zip(where, size, strict=True))

    def _mouse(self, kind, **more):
        return pygame.event.Event(kind, pos=self.pointer, touch=False, **more)
