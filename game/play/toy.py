"""The toy: one window's state, what each command does to it, and one frame of it."""

import time
from functools import cache

import pygame

from game.play import hud, keys, overlay, panel
from game.play.stage import Stage
from game.play.tools import Brush
from game.play.ui import paint
from game.play.ui import theme as look
from game.play.ui.widgets import Ui
from game.world import knob, picture
from game.world.action import Clear, Flip, Load, SetRule
from game.world.rule import Rule
from game.world.scene import load_scene, scene_title
from game.world.session import BUDGET_NS, Session

LEAST_STEPPING_NS = 2_000_000  # left to the sand even where the rest of a frame has spent the budget
MARGIN = 8  # pixels at scale 1 around the sand
FASTER = 2**0.5  # what one press of + does to the speed


class Toy:
    """Everything the window holds. `frame` is called once for each frame; commands are methods named in `keys`."""

    def __init__(self, window, scene, seed=0, p=None, ui_scale=knob.UI_SCALE.default):
        self.window = window
        self.stage = Stage(window)
        self.session = Session(scene, seed)
        if p is not None:
            self.do(SetRule(Rule.with_p(p, scene.rule.schedule)))
        self.ui_scale = ui_scale
        self.theme = look.Theme(ui_scale)
        self.brush = Brush()
        self.panel = panel.Panel(Ui(self.theme))
        self.hud = hud.Hud(self.theme)
        self.running = True
        self.help_open = False
        self.panel_shown = True
        self._size = self._cell_size = None
        self._hud_drawn = None
        self._pointer = None
        self._other_ns = 0  # what the last frame spent on anything but stepping

    # --- commands ---

    def do(self, action):
        """Let a player's act happen."""
        self.session.do(action)

    def pause(self):
        """Hold time, or let it go on."""
        self.session.paused = not self.session.paused

    def step(self):
        """Run one iteration and hold time."""
        self.session.paused = True
        self.session.step()

    def flip(self):
        """Turn the glass over: at once in the lattice, and in half a second on the screen."""
        if self.stage.turn:
            return
        self.brush.let_go()
        self.stage.start_turn(time.perf_counter())
        self.do(Flip())

    def restart(self):
        """Start the scene again."""
        self.do(Load(self.session.scene, self.session.seed))

    def load(self, name):
        """Put the scene of that name in place of this one."""
        self.do(Load(load_scene(name), self.session.seed))
        self._size = None

    def clear(self):
        """Take all sand away."""
        self.do(Clear())

    def faster(self):
        """Speed time up by half."""
        self._change_speed(FASTER)

    def slower(self):
        """Slow time down by a third."""
        self._change_speed(1 / FASTER)

    def take_sand(self):
        """Paint sand from now on."""
        self.brush.material = "sand"

    def take_wall(self):
        """Paint walls from now on."""
        self.brush.material = "wall"

    def take_eraser(self):
        """Erase from now on."""
        self.brush.material = "erase"

    def smaller_brush(self):
        """Shrink the brush."""
        self.brush.resize(-1)

    def larger_brush(self):
        """Grow the brush."""
        self.brush.resize(1)

    def toggle_panel(self):
        """Hide or show the panel."""
        self.panel_shown = not self.panel_shown
        self._size = None

    def toggle_fullscreen(self):
        """Fill the screen, or go back."""
        self.window.toggle_fullscreen()
        self._size = None

    def toggle_help(self):
        """Open or close the page of keys."""
        self.help_open = not self.help_open

    def escape(self):
        """Close what is open; with nothing open, quit."""
        if self.help_open:
            self.toggle_help()
        elif self.window.fullscreen:
            self.toggle_fullscreen()
        else:
            self.running = False

    # --- one frame ---

    def frame(self, events, elapsed_ns, now_s, mouse_pos=None):
        """Hear events, run the iterations due after `elapsed_ns`, draw what changed; return whether anything did."""
        start = time.perf_counter_ns()
        self._fit()
        rest = self._lay_out_panel(events, now_s, mouse_pos)
        for event in rest:
            self._hear(event)
        for stroke in self.brush.pour():
            self.do(stroke)
        self._follow(mouse_pos)
        stepping_ns = self._step(elapsed_ns, now_s)
        self._fit()
        changed = self._draw(now_s)
        self.window.show(changed)
        work_ns = time.perf_counter_ns() - start
        self._other_ns = work_ns - stepping_ns
        self.hud.count(work_ns, self.session.due, self.session.done, self._grains, now_s)
        return bool(changed)

    def _lay_out_panel(self, events, now_s, mouse_pos):
        if not self.panel_shown:
            return events
        return self.panel.lay_out(self._panel_area, events, now_s, mouse_pos, self)

    def _hear(self, event):
        if event.type == pygame.QUIT:
            self.running = False
        elif event.type == pygame.KEYDOWN:
            command = keys.command(event)
            if command:
                getattr(self, command)()
        elif event.type == pygame.MOUSEWHEEL:
            self.brush.resize(event.y)
        elif event.type == pygame.WINDOWFOCUSLOST:
            self.brush.let_go()
        elif event.type in (pygame.WINDOWEXPOSED, pygame.WINDOWSIZECHANGED):
            self._size = None
        elif self.help_open and event.type == pygame.MOUSEBUTTONDOWN:
            self.toggle_help()
        elif self.brush.painting or (event.type == pygame.MOUSEBUTTONDOWN and self.sand_area.collidepoint(event.pos)):
            for stroke in self.brush.hear(event, self.stage.view):
                self.do(stroke)

    def _follow(self, mouse_pos):
        """Let the brush's outline follow the pointer."""
        over_sand = mouse_pos is not None and self.sand_area.collidepoint(mouse_pos)
        self._pointer = mouse_pos if over_sand or self.brush.painting else None

    def _step(self, elapsed_ns, now_s):
        """Run what is due and return how long that took; while the glass turns, time stands still."""
        if self.stage.turn:
            if not self.stage.turn.over(now_s):
                return 0
            self.stage.end_turn()
        start = time.perf_counter_ns()
        self.session.frame(elapsed_ns, max(BUDGET_NS - self._other_ns, LEAST_STEPPING_NS))
        return time.perf_counter_ns() - start

    def _change_speed(self, factor):
        clock = self.session.clock
        clock.speed = min(max(clock.speed * factor, knob.SPEED.low), knob.SPEED.high)

    def _grains(self):
        return self.session.world.grains

    # --- drawing ---

    def _fit(self):
        """Work out where everything lies, after the window or the lattice changed its size."""
        shape, size = self.session.world.shape, self.window.size
        if (size, shape) == self._size:
            return
        self._size = size, shape
        self._scale()
        self._panel_area = panel.area(self.theme, size)
        wide = size[0] - (self._panel_area.width if self.panel_shown else 0)
        bar = self.theme.px(hud.HEIGHT)
        self.sand_area = pygame.Rect(0, 0, wide, size[1] - bar)
        self._hud_area = pygame.Rect(0, size[1] - bar, wide, bar)
        self.window.surface.fill(picture.GROUND)
        self.stage.fit(shape, self.sand_area, self.theme.px(MARGIN))
        self._hud_drawn = None
        self.panel.ui.invalidate()

    def _scale(self):
        """Keep the UI scale that was asked for, as far as the window leaves room for it."""
        scale = panel.fitting_scale(self.ui_scale, self.window.size[0])
        if scale != self.theme.scale:
            self.theme = self.panel.ui.theme = self.hud.theme = look.Theme(scale)

    def _draw(self, now_s):
        """Draw the parts of the window that differ from what is on it; return their rects."""
        surface = self.window.surface
        rects = self.stage.draw(self.session.world, self._outline(), self._overlay(), now_s)
        drawing = self.hud.drawing(self._hud_area, self.session.paused)
        if drawing != self._hud_drawn:
            paint.draw(surface, self.theme, drawing)
            self._hud_drawn = drawing
            rects.append(self._hud_area)
        if self.panel_shown and self.panel.ui.end(surface):
            rects.append(self._panel_area)
        return rects

    def _overlay(self):
        """Return what draws over the sand now, or None."""
        return self._draw_help if self.help_open else None

    def _draw_help(self, surface):
        overlay.draw_help(surface, self.theme, self.sand_area)

    def _outline(self):
        """Return the brush's outline (x, y, radius) in pixels where the pointer is over the sand, or None."""
        if self._pointer is None or self.stage.turn:
            return None
        return self.brush.outline(self.stage.view.place(*self._pointer), self.stage.view)

    @cache  # noqa: B019 - there is one toy, and scene files do not change under it
    def title_of(self, name):
        """Return the title of a shipped scene, or of the one that is open."""
        scene = self.session.scene
        return scene.title if name == scene.name else scene_title(name)
