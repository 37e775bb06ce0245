"""A player at the window: hands that press keys and buttons, under the dummy video driver."""

from contextlib import contextmanager
from functools import cache
from unittest import mock

import pygame

from game.play.app import App
from game.play.ui import draw_list
from game.play.window.window import Window
from game.world.scenes import scene as scenes

FRAME_NS = 16_666_667
load_scene = cache(scenes.load_scene)  # nobody changes a scene
MADE = []  # the players of the test that runs
WAIT_MS = 20  # at most, from frame to frame, for what the background does


def words_of(drawn):
    """Return [(rect, text, size)] of the words in what was drawn."""
    return [(rect, *how[:2]) for stroke, rect, *how in drawn if stroke is draw_list.words]


class Player:
    """Hands that press keys and buttons, and a clock that ticks as told."""

    def __init__(self, scene="blank", size=(900, 700), settings=None):
        self.app = App(Window(size), load_scene(scene, (120, 90) if scene == "blank" else None), settings=settings)
        self.now_s, self.pointer = 100.0, None
        MADE.append(self)
        self.wait(0)

    @property
    def parts(self):
        return self.app.parts

    @property
    def session(self):
        return self.parts.sessions.now

    @property
    def world(self):
        return self.parts.sessions.now.world

    def frame(self, *events, elapsed_ns=FRAME_NS):
        self.now_s += elapsed_ns / 1e9
        return self.app.frame(list(events), elapsed_ns, self.now_s, self.pointer)

    def wait(self, frames):
        for _ in range(frames + 1):
            self.frame()

    def hold_time(self):
        self.session.paused = True

    def key(self, code, text="", mod=0):
        self.press(code, text, mod)
        self.release(code, mod)

    def press(self, code, text="", mod=0):
        self.frame(pygame.event.Event(pygame.KEYDOWN, key=code, unicode=text, mod=mod))

    def release(self, code, mod=0):
        self.frame(pygame.event.Event(pygame.KEYUP, key=code, mod=mod))

    def resize(self, size):
        pygame.display.set_mode(size, pygame.RESIZABLE, 32)
        self.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))

    def drop(self, path):
        self.frame(pygame.event.Event(pygame.DROPFILE, file=str(path)))
        self.settle()

    def settle(self):
        """Play frames in which no time passes until the background has nothing left to do."""
        self.frame(elapsed_ns=0)
        while self.parts.background.busy:
            pygame.event.wait(WAIT_MS)  # work that is done posts an event
            pygame.event.clear()
            self.frame(elapsed_ns=0)

    def button(self, kind, pos, button=1):
        self.pointer = pos
        self.frame(pygame.event.Event(kind, pos=pos, button=button))

    def move(self, pos):
        self.pointer = pos
        self.frame(pygame.event.Event(pygame.MOUSEMOTION, pos=pos, rel=(0, 0), buttons=(1, 0, 0)))

    def drag(self, *places, button=1):
        self.button(pygame.MOUSEBUTTONDOWN, places[0], button)
        for pos in places[1:]:
            self.move(pos)
        self.button(pygame.MOUSEBUTTONUP, places[-1], button)

    def click(self, pos):
        self.drag(pos)

    def pixel(self, column, row):
        """Return the pixel in the middle of a cell."""
        x, y = self.parts.display.sand_view.view.pixel(column + 0.5, row + 0.5)
        return int(x), int(y)

    def unfold(self, name):
        """Open a fold of the panel."""
        self.click(self.parts_of(name)[0].center)

    @contextmanager
    def reading(self):
        """Yield a list of what is drawn meanwhile, scrolled into view or not: (what draws, rect in the window, …)."""
        found, draw = [], draw_list.draw

        def noted(surface, theme, strokes, shift=(0, 0)):
            strokes = list(strokes)
            found.extend((stroke, pygame.Rect(rect).move(shift), *how) for stroke, rect, *how in strokes)
            draw(surface, theme, strokes, shift)

        with mock.patch.object(draw_list, "draw", noted):
            yield found

    def drawn(self):
        """Draw everything anew; return what is drawn, as `reading` does."""
        with self.reading() as found:
            self.frame(pygame.event.Event(pygame.WINDOWEXPOSED), elapsed_ns=0)
        return found

    def written(self):
        """Draw everything anew; return [(rect in the window, text, size)] of all words."""
        return words_of(self.drawn())

    def words(self):
        """Return all that is written, as one text."""
        return " ".join(text for _, text, _ in self.written())

    def control(self, name, share=0.5):
        """Scroll to a control and return the place at `share` of the way along its moving part."""
        part = self.parts_of(name)[0]
        return int(part.left + share * part.width), part.centery

    def parts_of(self, name):
        """Scroll to a control and return the rects of its parts, or its own."""
        ui = self.parts.panel.ui
        ring = ui.focus.slots[name].ring
        ui.focus.scroll.reveal(ring.top, ring.bottom)
        self.frame(elapsed_ns=0)
        return ui.parts(name) or [ui.rects[name]]
