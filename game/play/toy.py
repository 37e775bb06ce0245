"""The toy: one window's state, and one frame of it."""

import time
from functools import cache

import pygame

from game.play import hud, keys, overlay, panel, timebar
from game.play.background import Background
from game.play.commands import Commands
from game.play.files import Files
from game.play.gallery import Gallery
from game.play.notice import Notices
from game.play.photo import PhotoCard
from game.play.question import Question
from game.play.recorder import Recorder
from game.play.recovery import Recovery
from game.play.rewind import Rewind
from game.play.stage import Stage
from game.play.tools import Brush
from game.play.ui import paint
from game.play.ui import theme as look
from game.play.ui.widgets import Ui
from game.world import knob, picture
from game.world.action import Flip, Load, SetRule
from game.world.rule import Rule
from game.world.scene import load_scene, scene_title
from game.world.session import BUDGET_NS, Session

LEAST_STEPPING_NS = 2_000_000  # left to the sand even where the rest of a frame has spent the budget
LONG_WAY_S = 0.3  # a way to another moment that takes longer is shown
MARGIN = 8  # pixels at scale 1 around the sand


class Toy:
    """Everything the window holds. `frame` is called once for each frame; keys call methods of `commands`."""

    SEEK_NS = 30_000_000  # a frame may take this long on the way to another moment: more than two snapshots are apart

    def __init__(self, window, scene, seed=0, p=None, ui_scale=knob.UI_SCALE.default):
        self.window = window
        self.stage = Stage(window)
        self.session = Session(scene, seed)
        self._former = []  # the sessions that others were opened over
        self.ui_scale = ui_scale
        self.theme = look.Theme(ui_scale)
        self.brush = Brush()
        self.commands = Commands(self)
        self.panel = panel.Panel(Ui(self.theme))
        self.hud = hud.Hud(self.theme)
        self.running = True
        self.help_open = False
        self.panel_shown = True
        self.undo_goes_back = False  # undo goes to the moment of the act it takes back
        self._size = None
        self._stale = False  # the stage has to be drawn anew
        self._way_since_s = None  # since when another moment is being computed
        self._hud_drawn = self._bar_drawn = None
        self._pointer = None
        self._down = set()  # the keys that are held
        self._other_ns = 0  # what the last frame spent on anything but stepping
        self._gather_helpers()
        if p is not None:
            self.do(SetRule(Rule.with_p(p, scene.rule.schedule)))

    def _gather_helpers(self):
        self.notices = Notices()
        self.background = Background(lambda error: self.notices.say(error, trouble=True))
        self.rewind = Rewind()
        self.time_bar = timebar.TimeBar(self.theme)
        self.files, self.gallery = Files(self), Gallery(self)
        self.photo, self.question = PhotoCard(self), Question(self)
        self.recorder, self.recovery = Recorder(self), Recovery(self)
        self._lay_over = self._draw_over  # one object, which the stage knows again
        self.overlays = [self.question, self.gallery, self.photo, self.notices]  # the last one lies on top

    # --- what the parts ask of it ---

    def do(self, action, join=False):
        """Let a player's act happen; `join`: undo takes it back together with the act before."""
        if self.is_there():
            self.session.do(action, join)

    def is_there(self):
        """Return whether the session is at the moment it should be at; wait a little for that, or say so."""
        there = self.session.timeline.catch_up(self.SEEK_NS)
        if not there:
            self.notices.say("The sand is still being computed.")
        return there

    def refresh(self):
        """Have the stage drawn anew: what lies over the sand looks different."""
        self._stale = True

    def lay_out_anew(self):
        """Have everything laid out and drawn anew."""
        self._size = None

    def turn_over(self):
        """Flip the lattice and let its old picture turn."""
        if self.stage.turn:
            return
        self.brush.let_go()
        self.stage.start_turn(time.perf_counter())
        self.do(Flip())

    def load(self, name):
        """Put the shipped scene of that name in place of this one."""
        self.open_scene(load_scene(name), self.session.seed)

    def open_scene(self, scene, seed):
        """Put a scene in place of this one; it is an act, and can be taken back."""
        self.do(Load(scene, seed))
        self.lay_out_anew()

    def open_session(self, session):
        """Play another session, and keep this one behind it if anything was done in it."""
        if self.session.timeline.history.line.before is not None or self._former:
            self._former.append(self.session)
        else:
            self.recovery.close(self.session)
        self._take(session)

    def leave_session(self):
        """Go back to the session that this one was opened over; return whether there is one."""
        if self._former:
            self.recovery.close(self.session)
            self._take(self._former.pop())
            return True
        return False

    @property
    def can_leave_session(self):
        """Whether this session was opened over another."""
        return bool(self._former)

    def close(self):
        """End every session's journal and wait for what is being written."""
        self.recorder.stop()
        for session in (*self._former, self.session):
            self.recovery.close(session)
        self.background.finish()

    def _take(self, session):
        session.timeline.memory_mb = self.session.timeline.memory_mb
        self.brush.let_go()
        self.stage.turn, self.session = None, session
        self.lay_out_anew()

    # --- one frame ---

    def frame(self, events, elapsed_ns, now_s, mouse_pos=None):
        """Hear events, run the iterations due after `elapsed_ns`, draw what changed; return whether anything did."""
        start = time.perf_counter_ns()
        self._fit()
        self.background.hear()
        for event in self._lay_out_panel(self._left_by_overlays(events, now_s, mouse_pos), now_s, mouse_pos):
            self._hear(event)
        for stroke in self.brush.pour():
            self.do(stroke, join=True)
        self._follow(mouse_pos)
        stepping_ns = self._step(elapsed_ns, now_s)
        self._tell(now_s)
        self._fit()
        changed = self._draw(now_s)
        self.window.show(changed)
        self.recorder.look(now_s)
        work_ns = time.perf_counter_ns() - start
        self._other_ns = work_ns - stepping_ns
        self.hud.count(work_ns, self.session, now_s)
        return bool(changed)

    def _left_by_overlays(self, events, now_s, mouse_pos):
        """Return the events that nothing which lies over the sand has taken."""
        for each in self.overlays[::-1]:
            if each.shown:
                events = each.listen(events, now_s, mouse_pos)
        return events

    def _lay_out_panel(self, events, now_s, mouse_pos):
        if not self.panel_shown:
            return events
        return self.panel.lay_out(self._panel_area, events, now_s, mouse_pos, self)

    def _hear(self, event):
        if event.type == pygame.QUIT:
            self.running = False
        elif self.rewind.hear(event):
            self.brush.let_go()
        elif event.type == pygame.KEYDOWN:
            command = keys.command(event)
            if command and (event.key not in self._down or command in keys.REPEATING):
                getattr(self.commands, command)()
            self._down.add(event.key)
        elif event.type == pygame.KEYUP:
            self._down.discard(event.key)
        elif event.type == pygame.MOUSEWHEEL:
            self.brush.resize(event.y)
        elif event.type == pygame.WINDOWFOCUSLOST:
            self.brush.let_go()
            self.time_bar.hear(event)
            self._down.clear()
        elif event.type in (pygame.WINDOWEXPOSED, pygame.WINDOWSIZECHANGED):
            self.lay_out_anew()
        elif event.type == pygame.DROPFILE:
            self.files.open(event.file)
        elif self.help_open and event.type == pygame.MOUSEBUTTONDOWN:
            self.commands.toggle_help()
        else:
            self._hear_pointer(event)

    def _hear_pointer(self, event):
        """Give an event of the pointer to the brush or the time bar, whichever it is over or held by."""
        on_sand = event.type == pygame.MOUSEBUTTONDOWN and self.sand_area.collidepoint(event.pos)
        going_on = self.brush.painting
        if not going_on and self.time_bar.hear(event):
            self.brush.let_go()
        elif going_on or on_sand:
            for number, stroke in enumerate(self.brush.hear(event, self.stage.view)):
                self.do(stroke, join=going_on or number > 0)

    def _follow(self, mouse_pos):
        """Let the brush's outline follow the pointer."""
        over_sand = mouse_pos is not None and self.sand_area.collidepoint(mouse_pos)
        self._pointer = mouse_pos if over_sand or self.brush.painting else None

    def _step(self, elapsed_ns, now_s):
        """Run what is due and return how long that took; while the glass turns, time stands still."""
        start = time.perf_counter_ns()
        self.session.timeline.rewinding = self.rewind.held
        if self.time_bar.held or self.rewind.held:
            if self.stage.turn:
                self.stage.end_turn()
            self._go_to_another_moment(elapsed_ns)
            return time.perf_counter_ns() - start
        if self.stage.turn:
            if not self.stage.turn.over(now_s):
                return 0
            self.stage.end_turn()
        self.session.frame(elapsed_ns, max(BUDGET_NS - self._other_ns, LEAST_STEPPING_NS))
        return time.perf_counter_ns() - start

    def _go_to_another_moment(self, elapsed_ns):
        """Follow the time bar's handle or the rewind."""
        session, timeline = self.session, self.session.timeline
        session.due = session.done = 0
        if self.time_bar.held:
            goal = self.time_bar.goal(session)
        else:  # where the last frame did not get, this one goes first
            goal = self.rewind.goal(session, elapsed_ns) if timeline.goal is None else timeline.goal
        if goal == timeline.goal:
            timeline.catch_up(self.SEEK_NS)
        elif goal != session.now:
            session.seek(goal, self.SEEK_NS)

    def _half_way(self, now_s):
        """Return whether the moment that is computed is one on the way, passed too quickly to be worth a look."""
        if self.session.timeline.goal is None:
            self._way_since_s = None
            return False
        if self._way_since_s is None:
            self._way_since_s = now_s
        return now_s - self._way_since_s < LONG_WAY_S

    def _tell(self, now_s):
        """Show what there is to say: trouble with the journal, and lines that come and go."""
        if self.session.trouble:
            self.notices.say(f"{self.session.trouble}; the sand goes on, unrecorded", trouble=True)
            self.session.trouble = None
        if self.notices.pass_time(now_s):
            self.refresh()

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
        bar, line = self.theme.px(timebar.HEIGHT), self.theme.px(hud.HEIGHT)
        self.sand_area = pygame.Rect(0, 0, wide, size[1] - bar - line)
        self.time_bar.area = pygame.Rect(0, self.sand_area.bottom, wide, bar)
        self._hud_area = pygame.Rect(0, size[1] - line, wide, line)
        self.window.surface.fill(picture.GROUND)
        self.stage.fit(shape, self.sand_area, self.theme.px(MARGIN))
        self._hud_drawn = self._bar_drawn = None
        self.panel.ui.invalidate()

    def _scale(self):
        """Keep the UI scale that was asked for, as far as the window leaves room for it."""
        scale = panel.fitting_scale(self.ui_scale, self.window.size[0])
        if scale != self.theme.scale:
            self.theme = self.panel.ui.theme = self.hud.theme = self.time_bar.theme = look.Theme(scale)

    def _draw(self, now_s):
        """Draw the parts of the window that differ from what is on it; return their rects."""
        surface = self.window.surface
        if self._stale:
            self.stage.refresh()
        rects = []
        if self._stale or not self._half_way(now_s):
            rects = self.stage.draw(self.session.world, self._outline(), self._overlay(), now_s)
        self._stale = False
        bar = self.time_bar.drawing(self.session)
        if bar != self._bar_drawn:
            paint.draw(surface, self.theme, bar)
            self._bar_drawn = bar
            rects.append(self.time_bar.area)
        drawing = self.hud.drawing(self._hud_area, self.session, self._said())
        if drawing != self._hud_drawn:
            paint.draw(surface, self.theme, drawing)
            self._hud_drawn = drawing
            rects.append(self._hud_area)
        if self.panel_shown and self.panel.ui.end(surface):
            rects.append(self._panel_area)
        return rects

    def _said(self):
        """Return what the HUD is to say first, or ""."""
        timeline = self.session.timeline
        if self._way_since_s is not None and timeline.goal:
            return f"Computing the sand: {100 * timeline.moment.now // timeline.goal} %"
        return self.recorder.said or ("Time runs back" if self.rewind.held else "")

    def _overlay(self):
        """Return what draws over the sand now, or None."""
        return self._lay_over if self.help_open or any(each.shown for each in self.overlays) else None

    def _draw_over(self, surface):
        if self.help_open:
            overlay.draw_help(surface, self.theme, self.sand_area)
        for each in self.overlays:
            if each.shown:
                each.draw(surface, self.theme, self.sand_area)

    def _outline(self):
        """Return the brush's outline (x, y, radius) in pixels where the pointer is over the sand, or None."""
        if self._pointer is None or self.stage.turn or self.help_open or self.gallery.shown or self.photo.shown:
            return None
        return self.brush.outline(self.stage.view.place(*self._pointer), self.stage.view)

    @cache  # noqa: B019 - there is one toy, and scene files do not change under it
    def title_of(self, name):
        """Return the title of a shipped scene, or of the one that is open."""
        scene = self.session.scene
        return scene.title if name == scene.name else scene_title(name)
