"""A panel with one control of every kind, and a hand that sends it events."""

import pygame

from game.play.ui.sliders import HANDLE
from game.play.ui.theme import Theme
from game.play.ui.widgets import Ui
from game.world.rules.rule import PROBABILITIES
from game.world.sand import parameters

PICTURE = ((("accent",), ("accent", "stone")),), (((), ("sunken",)),)
SCENES = ["Hourglass", "Avalanche", "Rain", "Funnel", *(f"Scene {i}" for i in range(30))]
WIDTH = 300
PARAGRAPH = "One paragraph of several words that has to be wrapped to fit the narrow column."


class Panel:
    """A panel at the left of a window, the values it shows, and a clock."""

    def __init__(self, scale=1.0, height=900, width=WIDTH):
        self.ui = Ui(Theme(scale))
        self.rect = pygame.Rect(0, 0, round(width * scale), height)
        self.surface = pygame.Surface((self.rect.width + 500, height))
        self.now_s = 0.0
        self.pressed = []  # names of the buttons, in the order of their presses
        self.p, self.bias, self.speed, self.brush, self.fall_pair = 0.6, 0.0, 240, 6, 1.0
        self.scene, self.tool, self.over, self.folded_out, self.undo = 0, 0, False, True, False
        self.names, self.paragraph = ("Save", "Load", "Help"), PARAGRAPH
        self.frame()

    def frame(self, *events, wait_s=0.0, mouse_pos=None):
        """Run one frame and return the events that the panel left over."""
        self.now_s += wait_s
        ui = self.ui
        rest = ui.begin(self.rect, list(events), self.now_s, mouse_pos)
        ui.heading("Scene")
        self.scene = ui.choice("Scene", SCENES, self.scene, tip="What to play with")
        ui.row(2)
        self._button("Flip", key="F", tip="Turn the glass over")
        self._button("Undo", enabled=self.undo)
        self.p = ui.slider("p", parameters.P, self.p, marks=(0.25, 0.5, 0.75, 1.0))
        self.bias = ui.slider("Lean", parameters.BIAS, self.bias)
        self.speed = ui.slider("Speed", parameters.SPEED, self.speed, log=True)
        self.brush = ui.slider("Brush", parameters.BRUSH, self.brush, default=10)
        self.tool = ui.segmented("Tool", ("Sand", "Wall", "Erase"), self.tool)
        self.over = ui.toggle("Over walls", self.over)
        self.folded_out = ui.fold("More", self.folded_out)
        if self.folded_out:
            self.fall_pair = ui.slider_with_picture("Pair", PROBABILITIES[2], self.fall_pair, *PICTURE)
            ui.text(self.paragraph, dim=True)
        ui.row(3)
        for name in self.names:
            self._button(name)
        ui.end(self.surface)
        return rest

    def _button(self, name, **how):
        if self.ui.button(name, **how):
            self.pressed.append(name)

    def spot(self, name, fraction=0.5):
        """Return the place in the window where a slider's handle stands at `fraction` of its track."""
        zone = self.ui.parts(name)[0]
        radius = self.ui.theme.px(HANDLE)
        return round(zone.x + radius + fraction * (zone.width - 2 * radius)), zone.centery

    def click(self, pos):
        """Press and release the mouse in a frame of its own."""
        return self.frame(down(pos), up(pos))

    def type(self, *keys):
        """Press keys, each in a frame of its own, and return the events left over."""
        return [event for each in keys for event in self.frame(key(each))]

    def tab_to(self, name):
        """Walk to a control with Tab."""
        for _ in range(len(self.ui.rects)):
            self.type(pygame.K_TAB)
            if self.ui.focus.name == name:
                return
        raise AssertionError(f"Tab never came to {name}")


def down(pos, button=1):
    return pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=pos, button=button)


def up(pos, button=1):
    return pygame.event.Event(pygame.MOUSEBUTTONUP, pos=pos, button=button)


def move(pos):
    return pygame.event.Event(pygame.MOUSEMOTION, pos=pos, rel=(0, 0), buttons=(0, 0, 0))


def wheel(notches):
    return pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=notches, precise_y=float(notches), flipped=False)


def key(code, mod=0, text=""):
    return pygame.event.Event(pygame.KEYDOWN, key=code, mod=mod, unicode=text)
