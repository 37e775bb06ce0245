"""The toy: one window's state, and one frame of it."""

import time

from game.play.controls import time_bar
from game.play.controls.brush import Brush
from game.play.controls.camera import Camera
from game.play.controls.commands import Commands
from game.play.controls.event_router import Hearing
from game.play.controls.fast_forward import Ahead
from game.play.controls.keyboard_cursor import Cursor
from game.play.controls.rewind import Rewind
from game.play.forecast.forecasting import Forecasting
from game.play.frame_step import Stepping
from game.play.pages.gallery import Gallery
from game.play.pages.help import Help
from game.play.panel import panel
from game.play.plots.plots import Plots
from game.play.storage.crash_recovery import Recovery
from game.play.storage.files import Files
from game.play.storage.open_sessions import Former
from game.play.storage.photo_import import PhotoCard
from game.play.storage.recorder import Recorder
from game.play.storage.settings_saver import Keeper
from game.play.timer.glow import Glow
from game.play.timer.run_out_planner import Planner
from game.play.timer.timer import Timer
from game.play.ui import theme as look
from game.play.ui.widgets import Ui
from game.play.view import status_line
from game.play.view.block_overlay import Blocks
from game.play.view.comparison_view import Panes
from game.play.view.dialog import Question
from game.play.view.frame_stats import Frame, own_ns
from game.play.view.hints import Hints
from game.play.view.notices import Notices
from game.play.view.renderer import Screen
from game.play.view.sand_view import Stage
from game.play.view.stats_card import Figures
from game.play.window.allocator import give_back_holes
from game.play.window.audio import Mixer
from game.play.window.background import Background
from game.play.window.hiss import Hiss
from game.play.window.layout import MARGIN, Layout
from game.world.files.settings import Settings
from game.world.looks.themes import THEMES
from game.world.sand.rule import Rule
from game.world.scenes.scene import load_scene, scene_title
from game.world.sessions.action import Flip, Load, SetRule, Turn
from game.world.sessions.comparison import Comparison
from game.world.sessions.session import Session


class Toy:
    """Everything the window holds. `frame` is called once for each frame; keys call methods of `commands`."""

    SEEK_NS = 30_000_000  # a frame may take this long on the way to another moment: more than two snapshots are apart

    def __init__(self, window, scene, seed=0, p=None, settings=None):
        self.window = window
        self.settings = settings or Settings()
        self.stage = Stage(window)
        self.session = Session(scene, seed)
        self.theme = look.Theme(self.settings["ui_scale"], self.colours)
        self.brush = Brush()
        self.commands = Commands(self)
        self.panel = panel.Panel(Ui(self.theme))
        self.hud = status_line.Hud(self.theme)
        self.running = True
        self.panel_shown = True
        self.undo_goes_back = False  # undo goes to the moment of the act it takes back
        self._now_s = 0.0  # when this frame is
        self._has_waited = False  # in this frame, for the moment that the session should be at
        self._heard = None, True  # the page that was open in the last frame, and whether the panel was shown
        self._size = None  # of the window and the lattice, as laid out, and what they look like
        self._gather_helpers()
        if p is not None:
            self.do(SetRule(Rule.with_p(p, scene.rule.schedule)))

    def _gather_helpers(self):
        self.figures = Figures(self)
        self.notices = Notices(lambda: self.figures.height)
        self.background = Background(lambda error: self.notices.say(error, trouble=True))
        self.mixer = Mixer(self.background)
        self.rewind, self.camera, self.blocks = Rewind(), Camera(self), Blocks(self)
        self.time_bar = time_bar.TimeBar(self.theme)
        self.files, self.gallery = Files(self), Gallery(self)
        self.help = Help(self)
        self.pages = [self.help, self.gallery]  # what takes the place of everything else in the window while it is open
        self.cursor = Cursor(self)
        self.photo, self.question = PhotoCard(self), Question(self)
        self.recorder, self.recovery, self.keeper = Recorder(self), Recovery(self), Keeper(self)
        self.former = Former(self.recovery)
        # the last one lies on top
        self.overlays = [self.camera.badge, self.figures, self.question, self.photo, self.notices]
        self.hearing, self.stepping, self.screen = Hearing(self), Stepping(self), Screen(self)
        # what looks at each frame once it is shown, by `look(now_s)`
        self.watchers = [self.recorder, self.keeper, self.camera.badge, self.figures]
        self._gather_instruments()

    def _gather_instruments(self):
        self.hiss = Hiss(self)
        self.watchers += [self.hiss, Hints(self)]
        self.forecasting = Forecasting(self)
        self.plots = Plots(self)
        self.overlays.insert(0, self.forecasting)
        self.watchers += [self.forecasting, self.plots]
        self.planner, self.glow, self.timer = Planner(self), Glow(self), Timer(self)
        self.ahead = Ahead(self)
        self.hearing.first.append(self.ahead)
        self.overlays.insert(0, self.glow)
        self.watchers += [self.ahead, self.timer, self.glow]

    # --- what the parts ask of it ---

    def do(self, action, join=False):
        """Let a player's act happen; return whether it changed anything.

        join: undo takes it back together with the act before.
        """
        return self.is_there() and self.session.do(action, join)

    def paint(self, acts):
        """Let the acts of the brush's gesture happen, and have it know whether any changed something."""
        for act, join in acts:
            if self.do(act, join):
                self.brush.acted = self.brush.painting

    @property
    def colours(self):
        """The colours of the theme that is set."""
        return THEMES[self.settings["theme"]]

    def is_there(self):
        """Return whether the session is where it should be; wait for that a little, once a frame, or say so."""
        if not self.session.arrived and not self._has_waited:
            self._has_waited = True
            self.session.catch_up(self.SEEK_NS)
        if self.session.arrived:
            return True
        self.notices.say("The sand is still being computed.")
        return False

    @property
    def page(self):
        """The page that is open, or None."""
        return next((each for each in self.pages if each.shown), None)

    def refresh(self):
        """Have the stage drawn anew: what lies over the sand looks different."""
        self.screen.stale = True

    def lay_out_anew(self):
        """Have everything laid out and drawn anew."""
        self._size = None

    def let_go(self):
        """Let go of all that a key or a button holds: nobody may hear it come up."""
        cards = [card.ui for card in (self.question, self.photo) if card.shown]
        holders = self.brush, self.time_bar, self.camera, self.rewind, self.ahead, self.stage, self.panel.ui
        for each in (*holders, *cards):
            each.let_go()

    def turn_over(self, quarters=2):
        """Turn the lattice by quarters, clockwise, and let its old picture turn, unless motion is to be reduced.

        Return whether it turned: not while it does so already.
        """
        if self.stage.turn or not self.is_there():
            return False
        self.brush.let_go()
        if not self.settings["reduced_motion"] and not self.page:
            self.stage.start_turn(self._now_s, quarters)
        self.camera.turn_over(quarters)
        self.do(Flip() if quarters == 2 else Turn(quarters))
        return True

    def load(self, name):
        """Put the shipped scene of that name in place of this one."""
        self.open_scene(load_scene(name), self.session.seed)

    def open_scene(self, scene, seed):
        """Put a scene in place of this one; return whether that was done. It is an act, and can be taken back."""
        if not self.do(Load(scene, seed)):
            return False
        self.lay_out_anew()
        give_back_holes()
        return True

    def open_session(self, session, keep=False):
        """Play another session, and keep this one behind it if it is asked for or anything was done in it."""
        before = self.session
        self._take(session)
        if keep or before.timeline.history.line.before is not None or self.former:
            self.former.push(before)
        else:
            self.former.end(before)
        give_back_holes()

    def leave_session(self):
        """Go back to the session that this one was opened over; return whether there is one."""
        if not self.former:
            return False
        self.former.end(self.session)
        self._take(self.former.pop())
        give_back_holes()
        return True

    @property
    def can_leave_session(self):
        """Whether this session was opened over another."""
        return bool(self.former)

    def close(self):
        """End every session's journal and wait for what is being written."""
        self.recorder.stop()
        self.forecasting.close()
        self.former.close()
        self.recovery.close(self.session)
        self.keeper.close()
        self.background.finish()
        self.mixer.close()

    def _take(self, session):
        session.limit_memory(self.session.memory_mb)
        self.brush.let_go()
        self.stage, self.session = self._stage_of(session), session
        self.lay_out_anew()
        self._fit()  # what else is heard in this frame finds the stage laid out

    def _stage_of(self, session):
        return Panes(self.window, self, session) if isinstance(session, Comparison) else Stage(self.window)

    # --- one frame ---

    def frame(self, events, elapsed_ns, now_s, mouse_pos=None):
        """Hear events, run the iterations due after `elapsed_ns`, draw what changed; return whether anything did."""
        start, worked = time.perf_counter_ns(), own_ns()
        self._now_s, self._has_waited = now_s, False
        self._fit()
        self.background.hear()
        self.window.find_pointer()
        left = self.cursor.listen(self._left_by_overlays(events, now_s, mouse_pos))
        for event in self._lay_out_panel(left, now_s, mouse_pos):
            self.hearing.hear(event)
        for event in events:
            self.hearing.note(event)
        self._let_go_of_hidden()
        self.paint(self.brush.hold())
        self.hearing.follow(mouse_pos)
        self.figures.follow(mouse_pos, now_s)
        self.stepping.step(elapsed_ns, now_s)
        self._tell(now_s)
        self._fit()
        changed = self.screen.draw(now_s)
        self.window.show(changed)
        for each in self.watchers:
            each.look(now_s)
        work_ns = time.perf_counter_ns() - start
        self.stepping.note(work_ns)
        frame = Frame(work_ns, own_ns() - worked, self.stepping.moving_ns, self.session.due, self.session.done)
        self.hud.count(frame, self.session, now_s)
        return bool(changed)

    def _left_by_overlays(self, events, now_s, mouse_pos):
        """Return the events that nothing which lies over the sand has taken; what a page hides hears none."""
        page = self.page
        if page:
            events = page.listen(events, now_s, mouse_pos)
        for each in self.overlays[::-1]:
            if each.shown and page:
                each.listen([], now_s, None)
            elif each.shown:
                events = each.listen(events, now_s, mouse_pos)
        return events

    def _lay_out_panel(self, events, now_s, mouse_pos):
        if not self.panel_shown or self.page:
            return events
        return self.panel.lay_out(self.layout.panel, events, now_s, mouse_pos, self)

    def _let_go_of_hidden(self):
        """Let go of what is held when a page opens or the panel goes, since what comes up is no longer heard."""
        if self._heard != (self.page, self.panel_shown):
            self._heard = self.page, self.panel_shown
            self.let_go()

    def _tell(self, now_s):
        """Show what there is to say: trouble with the journal, and lines that come and go."""
        if self.session.trouble:
            self.notices.say(f"{self.session.trouble}; the sand goes on, unrecorded", trouble=True)
            self.session.trouble = None
        if self.notices.pass_time(now_s):
            self.refresh()

    def _fit(self):
        """Lay everything out, after the window or the lattice changed its size or what it looks like."""
        shape, size, walls = self.session.world.shape, self.window.size, self.session.scene.made_of
        looks = size, shape, walls, self.colours, self.settings["ui_scale"]
        if looks == self._size:
            return
        self._size = looks
        self._renew_theme()
        self.layout = Layout(self.theme, size, self.panel_shown, shape if self.plots.shown else None)
        self.time_bar.area = self.layout.bar
        self.window.surface.fill(self.colours.ground)
        before = self.stage.view
        self.stage.fit(shape, self.layout.sand, self.theme.px(MARGIN), self.theme, walls)
        self.camera.keep(before)
        self.screen.forget()

    def _renew_theme(self):
        """Keep the colours and the UI scale that were asked for, as far as the window leaves room for it."""
        wanted = panel.fitting_scale(self.settings["ui_scale"], self.window.size), self.colours
        if wanted != (self.theme.scale, self.theme.colours):
            self.theme = self.panel.ui.theme = self.hud.theme = self.time_bar.theme = look.theme_of(*wanted)

    def title_of(self, name):
        """Return the title of a shipped scene, or of the one that is open."""
        scene = self.session.scene
        return scene.title if name == scene.name else scene_title(name)
