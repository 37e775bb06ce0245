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
from game.play.storage.crash_recovery import CrashRecovery
from game.play.storage.files import Files
from game.play.storage.journals import Journals
from game.play.storage.open_sessions import Sessions
from game.play.storage.photo_import import PhotoImport
from game.play.storage.recorder import Recorder
from game.play.storage.settings_saver import SettingsSaver
from game.play.timer.glow import Glow
from game.play.timer.run_out_planner import Planner
from game.play.timer.timer import Timer
from game.play.ui.widgets import Ui
from game.play.view import status_line
from game.play.view.block_overlay import Blocks
from game.play.view.dialog import Question
from game.play.view.display import Display
from game.play.view.frame_stats import Frame, own_ns
from game.play.view.hints import Hints
from game.play.view.notices import Notices
from game.play.view.renderer import Screen
from game.play.view.stats_card import Figures
from game.play.window.audio import Audio
from game.play.window.background import Background
from game.play.window.hiss import Hiss
from game.world.files.settings import Settings
from game.world.sand.rule import Rule
from game.world.sessions.action import Flip, SetRule, Turn
from game.world.sessions.session import Session


class Toy:
    """Everything the window holds. `frame` is called once for each frame; keys call methods of `commands`."""

    def __init__(self, window, scene, seed=0, p=None, settings=None):
        self.window = window
        self.settings = settings or Settings()
        self.display = Display(window, self.settings, lambda: self.plots.measured_row)
        self.figures = Figures(self)
        self.notices = Notices(lambda: self.figures.height)
        self.journals = Journals(self.notices.say)
        self.sessions = Sessions(Session(scene, seed), self.journals, self.notices, self._switch)
        self.brush = Brush()
        self.commands = Commands(self)
        self.panel = panel.Panel(Ui(self.display.theme))
        self.hud = status_line.Hud()
        self.running = True
        self.undo_goes_back = False  # undo goes to the moment of the act it takes back
        self._now_s = 0.0  # when this frame is
        self._heard = None, True  # the page that was open in the last frame, and whether the panel was shown
        self._gather_helpers()
        if p is not None:
            self.sessions.do(SetRule(Rule.with_p(p, scene.rule.schedule)))

    def _gather_helpers(self):
        self.figures = Figures(self)
        self.notices = Notices(lambda: self.figures.height)
        self.background = Background(lambda error: self.notices.say(error, trouble=True))
        self.audio = Audio(self.background)
        self.rewind, self.camera, self.blocks = Rewind(), Camera(self), Blocks(self)
        self.time_bar = time_bar.TimeBar()
        self.photo_import = PhotoImport(self.sessions, self.display)
        self.files = Files(self.sessions, self.journals, self.photo_import, self.background, self.notices)
        self.gallery = Gallery(self)
        self.help = Help(self)
        self.display.pages = self.help, self.gallery
        self.cursor = Cursor(self)
        self.question = Question(self)
        self.recorder = Recorder(self.sessions, self.display, self.background, self.notices)
        self.crash_recovery = CrashRecovery(self.sessions, self.journals, self.question, self.background, self.notices)
        self.settings_saver = SettingsSaver(
            self.settings, self.sessions, self.brush, self.window, self.background, self.notices
        )
        # the last one lies on top
        self.overlays = [self.camera.badge, self.figures, self.question, self.photo_import, self.notices]
        self.hearing, self.stepping, self.screen = Hearing(self), Stepping(self), Screen(self)
        # what looks at each frame once it is shown, by `update(now_s)`
        self.watchers = [self.recorder, self.settings_saver, self.camera.badge, self.figures]
        self._gather_instruments()

    def _gather_instruments(self):
        self.hiss = Hiss(self.sessions, self.settings, self.audio, self.background, self.notices)
        self.watchers += [self.hiss, Hints(self)]
        self.forecasting = Forecasting(self.sessions, self.display, self.hearing)
        self.plots = Plots(self)
        self.overlays.insert(0, self.forecasting)
        self.watchers += [self.forecasting, self.plots]
        self.planner, self.glow, self.timer = Planner(self), Glow(self), Timer(self)
        self.ahead = Ahead(self)
        self.hearing.first.append(self.ahead)
        self.overlays.insert(0, self.glow)
        self.watchers += [self.ahead, self.timer, self.glow]

    # --- what the parts ask of it ---

    def paint(self, acts):
        """Let the acts of the brush's gesture happen, and have it know whether any changed something."""
        for act, join in acts:
            if self.sessions.do(act, join):
                self.brush.acted = self.brush.painting

    def let_go(self):
        """Let go of all that a key or a button holds: nobody may hear it come up."""
        cards = [card.ui for card in (self.question, self.photo_import) if card.shown]
        holders = self.brush, self.time_bar, self.camera, self.rewind, self.ahead, self.display.stage, self.panel.ui
        for each in (*holders, *cards):
            each.let_go()

    def turn_over(self, quarters=2):
        """Turn the lattice by quarters, clockwise, and let its old picture turn, unless motion is to be reduced.

        Return whether it turned: not while it does so already.
        """
        if self.display.stage.turn or not self.sessions.ready():
            return False
        self.brush.let_go()
        if not self.settings["reduced_motion"] and not self.display.page:
            self.display.stage.start_turn(self._now_s, quarters)
        self.camera.turn_over(quarters)
        self.sessions.do(Flip() if quarters == 2 else Turn(quarters))
        return True

    def close(self):
        """End every session's journal and wait for what is being written."""
        self.recorder.stop()
        self.forecasting.close()
        self.sessions.close()
        self.settings_saver.close()
        self.background.finish()
        self.audio.close()

    def _switch(self):
        """Show another session, or another scene: what else is heard in this frame finds it laid out."""
        self.brush.let_go()
        self.display.lay_out_anew()
        self._fit()

    # --- one frame ---

    def frame(self, events, elapsed_ns, now_s, mouse_pos=None):
        """Hear events, run the iterations due after `elapsed_ns`, draw what changed; return whether anything did."""
        start, worked = time.perf_counter_ns(), own_ns()
        self._now_s = now_s
        self.sessions.begin_frame()
        self._fit()
        self.background.update()
        self.window.find_pointer()
        left = self.cursor.handle_events(self._left_by_overlays(events, now_s, mouse_pos))
        for event in self._lay_out_panel(left, now_s, mouse_pos):
            self.hearing.handle_event(event)
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
            each.update(now_s)
        work_ns = time.perf_counter_ns() - start
        self.stepping.note(work_ns)
        session = self.sessions.now
        frame = Frame(work_ns, own_ns() - worked, self.stepping.moving_ns, session.due, session.done)
        self.hud.count(frame, session, now_s)
        return bool(changed)

    def _left_by_overlays(self, events, now_s, mouse_pos):
        """Return the events that nothing which lies over the sand has taken; what a page hides hears none."""
        page = self.display.page
        if page:
            events = page.handle_events(events, now_s, mouse_pos)
        for each in self.overlays[::-1]:
            if each.shown and page:
                each.handle_events([], now_s, None)
            elif each.shown:
                events = each.handle_events(events, now_s, mouse_pos)
        return events

    def _lay_out_panel(self, events, now_s, mouse_pos):
        if not self.display.panel_shown or self.display.page:
            return events
        return self.panel.lay_out(self.display.layout.panel, events, now_s, mouse_pos, self)

    def _let_go_of_hidden(self):
        """Let go of what is held when a page opens or the panel goes, since what comes up is no longer heard."""
        if self._heard != (self.display.page, self.display.panel_shown):
            self._heard = self.display.page, self.display.panel_shown
            self.let_go()

    def _tell(self, now_s):
        """Show what there is to say: trouble with the journal, and lines that come and go."""
        if self.sessions.now.trouble:
            self.notices.say(f"{self.sessions.now.trouble}; the sand goes on, unrecorded", trouble=True)
            self.sessions.now.trouble = None
        if self.notices.pass_time(now_s):
            self.display.refresh()

    def _fit(self):
        """Lay everything out, after the window or the lattice changed its size or what it looks like."""
        stage, view = self.display.stage, self.display.stage.view
        if self.display.fit(self.sessions.now):
            self.camera.keep(view if stage is self.display.stage else None)
            self.time_bar.place(self.display.layout.bar, self.display.theme)
            self.screen.forget()
