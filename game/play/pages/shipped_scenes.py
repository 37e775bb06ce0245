"""The shelf of shipped scenes: each runs as a small world while in view, within a part of the frame's time."""

import time
from functools import partial

import numpy as np
import pygame

from game.world.looks import painter
from game.world.looks.themes import substances_of
from game.world.looks.view import View
from game.world.sand.advance import advance
from game.world.scenes.scene import load_scene, scene_names, scene_title

BUDGET_NS = 4_000_000  # of a frame, for all small worlds together; those that are left out come first in the next
LARGEST_SIDE = 640  # cells: a larger scene runs on a coarser lattice
LIFE_S = 60.0  # then a small world starts again
LONGEST_STEP_S = 0.1  # of a small world's time, however long it was not looked at


class ShippedScenes:
    """The shipped scenes; their small worlds are made beside the frames when the shelf is first opened."""

    title = "Scenes"
    waiting = "…"
    empty = ""
    lets_go = False
    can_take_back = False

    def __init__(self, sessions, display, background, is_open):
        """is_open(): whether anyone may look at them; else no more of them are made."""
        self._sessions, self._display, self._background, self._is_open = sessions, display, background, is_open
        self._names = ()
        self._titles = {}
        self._lives = {}  # name: Life
        self._making = False
        self._next = 0  # whose turn it is, among those in view

    def __len__(self):
        return len(self._names)

    @property
    def first(self):
        """The number of the scene to begin with: the one that is played."""
        name = self._sessions.now.scene.name
        return self._names.index(name) if name in self._names else 0

    def begin(self):
        """Have the small worlds made, those that are not there yet or have other colours."""
        if not self._names:
            self._names = scene_names()
            self._titles = {name: scene_title(name) for name in self._names}
        colours = self._display.colours
        if any(life.colours is not colours for life in self._lives.values()):
            self._lives = {}
        self._make_next()

    def name(self, number):
        """Return the title of a scene."""
        return self._titles[self._names[number]]

    def about(self, number):
        """Return the sentence on a scene."""
        life = self._lives.get(self._names[number])
        return life.scene.notice if life else ""

    def picture(self, number):
        """Return the picture of a scene as it is now, or None."""
        life = self._lives.get(self._names[number])
        return life and life.sprite

    def open(self, number):
        """Play a scene."""
        self._sessions.load(self._names[number])

    def run(self, now_s, rooms):
        """Let small worlds run, given {number: (width, height) of its room}; return the numbers whose picture moved."""
        start = time.perf_counter_ns()
        waiting = [number for number in rooms if self._names[number] in self._lives]
        waiting = waiting[self._next % max(1, len(waiting)) :] + waiting[: self._next % max(1, len(waiting))]
        moved = []
        for number in waiting:
            if self._lives[self._names[number]].run(now_s, rooms[number]):
                moved.append(number)
            self._next += 1
            if time.perf_counter_ns() - start > BUDGET_NS:
                break
        return moved

    def _make_next(self):
        """Make the next small world beside the frames: that of the scene that is played, then those around it."""
        missing = [number for number, name in enumerate(self._names) if name not in self._lives]
        name = self._names[min(missing, key=lambda number: abs(number - self.first))] if missing else None
        if missing and self._is_open() and not self._making:
            self._making = True
            self._background.do(partial(Life, name, self._display.colours), partial(self._take, name), self._give_up)

    def _take(self, name, life):
        self._making, self._lives[name] = False, life
        self._make_next()

    def _give_up(self):
        self._making = False


class Life:
    """A small world, its picture a pixel to a cell, and that picture in the size of its room."""

    def __init__(self, name, colours):
        self.colours = colours
        scene = load_scene(name)
        coarser = max(scene.shape) / LARGEST_SIDE
        if coarser > 1:
            height, width = scene.shape
            scene = load_scene(name, (round(width / coarser), round(height / coarser)))
        self.scene, self.sprite = scene, None
        self._start()
        height, width = scene.shape
        self._pixels = np.zeros((height, width), np.uint32)
        self._painter = painter.Painter(
            View.fit(scene.shape, 0, 0, width, height),
            colours,
            scene.made_of,
            rgbx,
            substances=substances_of(scene.rule.definition.materials),
        )
        self._surface = pygame.image.frombuffer(self._pixels, (width, height), "RGBX")
        advance(self._world, scene.rule, 1)  # compiles what is not compiled yet, here and not in a frame
        self._painter.draw(self._world, self._pixels)

    def run(self, now_s, room):
        """Let the time since the last call pass; return whether the picture, fitted into `room`, looks different."""
        since_s = 0.0 if self._now_s is None else min(now_s - self._now_s, LONGEST_STEP_S)
        self._now_s, self._age_s = now_s, self._age_s + since_s
        if self._age_s > LIFE_S:
            self._start()
        self._due += since_s * self.scene.speed
        advance(self._world, self.scene.rule, int(self._due))
        self._due -= int(self._due)
        changed = self._painter.draw(self._world, self._pixels)
        size = fitting(self._surface.get_size(), room)
        if not changed and self.sprite and self.sprite.get_size() == size:
            return False
        self.sprite = pygame.transform.smoothscale(self._surface, size)
        return True

    def _start(self):
        self._world = self.scene.world(1)
        self._now_s, self._age_s, self._due = None, 0.0, 0.0


def rgbx(red, green, blue):
    """Return the pixel value whose bytes are red, green, blue and one more; one function, so that paints are kept."""
    return red | green << 8 | blue << 16


def fitting(size, room):
    """Return the size as large as `room` allows."""
    scale = min(room[0] / size[0], room[1] / size[1])
    return max(1, round(size[0] * scale)), max(1, round(size[1] * scale))
