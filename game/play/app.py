"""The app: makes the parts of one window, and plays a frame with them."""

import time

import pygame

from game.play.controls.brush import Brush
from game.play.controls.camera import Camera
from game.play.controls.commands import Commands, FileCommands, SandCommands, TimeCommands, ViewCommands
from game.play.controls.event_router import EventRouter
from game.play.controls.fast_forward import FastForward
from game.play.controls.held_keys import HeldKeys
from game.play.controls.keyboard_cursor import KeyboardCursor
from game.play.controls.pointer import Pointer
from game.play.controls.rewind import Rewind
from game.play.controls.time_bar import TimeBar
from game.play.forecast.forecasting import Forecasting
from game.play.frame_step import FrameStep
from game.play.pages.gallery import Gallery
from game.play.pages.help import Help
from game.play.panel.panel import Panel
from game.play.plots.plots import Plots
from game.play.storage.crash_recovery import CrashRecovery
from game.play.storage.files import Files
from game.play.storage.journals import Journals
from game.play.storage.open_sessions import Sessions
from game.play.storage.photo_import import PhotoImport
from game.play.storage.recorder import Recorder
from game.play.storage.settings_saver import SettingsSaver
from game.play.timer.chime import Chime
from game.play.timer.glow import Glow
from game.play.timer.run_out_planner import RunOutPlanner
from game.play.timer.timer import Timer
from game.play.ui.widgets import Ui
from game.play.view.block_overlay import BlockOverlay
from game.play.view.dialog import Dialog
from game.play.view.display import Display
from game.play.view.frame_stats import FrameStats, FrameTime, own_ns
from game.play.view.hints import Hints
from game.play.view.notices import Notices
from game.play.view.renderer import Frame, Renderer
from game.play.view.stats_card import StatsCard
from game.play.view.status_line import StatusLine
from game.play.window.audio import Audio
from game.play.window.background import Background
from game.play.window.hiss import Hiss
from game.world.files.settings import Settings
from game.world.sand.rule import Rule
from game.world.sessions.action import SetRule
from game.world.sessions.session import Session


class Toy:
    """The window and its parts, none of which knows the app. `frame` is called once for each frame."""

    def __init__(self, window, scene, seed=0, p=None, settings=None):
        self.window, self.settings = window, settings or Settings()
        self.running = True
        self._hears = None, True, window.fullscreen  # page, panel and screen of the last frame
        self._make_holders(scene, seed)
        self._make_parts()
        self._make_controls()
        if p is not None:
            self.sessions.do(SetRule(Rule.with_p(p, scene.rule.schedule)))

    def _make_holders(self, scene, seed):
        """Make what the parts share."""
        self.display = Display(self.window, self.settings, lambda: self.plots.measured_row)
        self.notices = Notices(lambda: self.figures.height)
        self.background = Background(lambda error: self.notices.say(error, trouble=True))
        self.journals = Journals(self.notices.say)
        self.sessions = Sessions(Session(scene, seed), self.journals, self.notices, self._switch)
        self.frame_stats, self.audio = FrameStats(), Audio(self.background)
        self.brush, self.pointer, self.keys = Brush(self.sessions), Pointer(self.display), HeldKeys(self.sessions)

    def _make_parts(self):
        """Make what is shown, stored and heard."""
        self.hud = StatusLine(self.frame_stats)
        self.figures = StatsCard(self.sessions, self.display, self.frame_stats)
        self.blocks = BlockOverlay(self.sessions, self.display, self.notices)
        self.forecasting = Forecasting(self.sessions, self.display, self.pointer)
        self.plots = Plots(self)
        self.question = Dialog(self.display)
        self.photo_import = PhotoImport(self.sessions, self.display)
        self.files = Files(self.sessions, self.journals, self.photo_import, self.background, self.notices)
        self.recorder = Recorder(self.sessions, self.display, self.background, self.notices)
        self.crash_recovery = CrashRecovery(self.sessions, self.journals, self.question, self.background, self.notices)
        self.settings_saver = SettingsSaver(
            self.settings, self.sessions, self.brush, self.window, self.background, self.notices
        )
        self.gallery = Gallery(self)
        self.help = Help(self)
        self.display.pages = self.help, self.gallery
        self.hiss = Hiss(self.sessions, self.settings, self.audio, self.background, self.notices)
        self.planner = RunOutPlanner(self.sessions, self.background)
        self.glow = Glow(self.display, self.settings)
        chime = Chime(self.settings, self.audio, self.background)
        self.timer = Timer(self.sessions, self.planner, self.notices, self.window.set_title, self.glow, chime)
        self.panel = Panel(Ui(self.display.theme))

    def _make_controls(self):
        """Make what keys and pointer work, and tell in which order all parts hear and are seen."""
        sessions, display, notices, brush = self.sessions, self.display, self.notices, self.brush
        self.rewind, self.time_bar = Rewind(), TimeBar()
        self.camera = Camera(sessions, display, self.pointer, brush, lambda: self.commands.time.pause())
        self.cursor = KeyboardCursor(sessions, brush, self.panel.ui.focus)
        self.ahead = FastForward(sessions, self.background, notices, self.keys)
        self.commands = Commands(
            TimeCommands(sessions, notices, self.keys, self.ahead, self.timer, self.panel.timer.unfold),
            SandCommands(sessions, self.journals, self.settings, display, notices, brush, self.camera, self.timer),
            ViewCommands(
                *(sessions, display, notices, brush, self.camera, self.cursor, self.blocks),
                *(self.forecasting, self.plots, self.help, self.hiss, self.quit),
            ),
            FileCommands(sessions, self.files, self.gallery, self.recorder, self.plots),
        )
        first = self.rewind, self.camera, self.ahead
        on_window = {
            pygame.QUIT: lambda event: self.quit(),
            pygame.WINDOWFOCUSLOST: lambda event: self.let_go(),
            pygame.WINDOWEXPOSED: lambda event: display.lay_out_anew(),
            pygame.WINDOWSIZECHANGED: lambda event: display.lay_out_anew(),
            pygame.DROPFILE: lambda event: self.files.open(event.file),
        }
        self.event_router = EventRouter(
            display, self.pointer, self.keys, self.commands, brush, self.time_bar, self.figures, first, on_window
        )
        pacers = self.ahead, self.timer
        self.frame_step = FrameStep(sessions, display, self.settings, self.time_bar, self.rewind, pacers)
        self.renderer = Renderer(display)
        badge, self.cards = self.camera.badge, (self.photo_import, self.question)  # the first card lies on top
        self.overlays = [self.glow, self.forecasting, badge, self.figures, *self.cards[::-1], self.notices]
        hints = Hints(self.settings, sessions, display, notices)
        self.watchers = [self.recorder, self.settings_saver, badge, self.figures, self.hiss, hints]
        self.watchers += [self.forecasting, self.plots, self.ahead, self.timer, self.glow]

    # --- one frame ---

    def frame(self, events, elapsed_ns, now_s, mouse_pos=None):
        """Hear events, run the iterations due after `elapsed_ns`, draw what changed; return whether anything did."""
        start, worked = time.perf_counter_ns(), own_ns()
        self.display.now_s = now_s
        self.sessions.begin_frame()
        self._fit()
        self.background.update()
        self.window.find_pointer()
        self._hear(events, now_s, mouse_pos)
        self.frame_step.step(elapsed_ns, now_s)
        self._tell(now_s)
        self._fit()
        changed = self.renderer.draw(self._frame(now_s))
        self.window.show(changed)
        for each in self.watchers:
            each.update(now_s)
        self._note(time.perf_counter_ns() - start, own_ns() - worked, now_s)
        return bool(changed)

    def _hear(self, events, now_s, mouse_pos):
        """Give events to what lies on top first, then to the cursor, the panel, the keys and the sand."""
        left = self.cursor.handle_events(self._left_by_cards(events, now_s, mouse_pos))
        if self.display.panel_shown and not self.display.page:
            left = self.panel.lay_out(self.display.layout.panel, left, now_s, mouse_pos, self)
        for event in left:
            self.event_router.handle_event(event)
        for event in events:
            self.keys.note(event)
        self._let_go_of_hidden()
        self.brush.hold()
        self.pointer.follow(mouse_pos, self.brush.painting)
        self.figures.follow(mouse_pos, now_s)

    def _left_by_cards(self, events, now_s, mouse_pos):
        """Return the events that neither a page nor a card over the sand has taken; what a page hides hears none."""
        page = self.display.page
        if page:
            events = page.handle_events(events, now_s, mouse_pos)
        for card in self.cards:
            if card.shown and page:
                card.handle_events([], now_s, None)
            elif card.shown:
                events = card.handle_events(events, now_s, mouse_pos)
        return events

    def _let_go_of_hidden(self):
        """Let go of what is held when what hears it has changed, since what comes up is no longer heard."""
        hears = self.display.page, self.display.panel_shown, self.window.fullscreen
        if hears != self._hears:
            self._hears = hears
            self.let_go()

    def _tell(self, now_s):
        """Show what there is to say: trouble with the journal, and lines that come and go."""
        session = self.sessions.now
        if session.trouble:
            self.notices.say(f"{session.trouble}; the sand goes on, unrecorded", trouble=True)
            session.trouble = None
        if self.notices.pass_time(now_s):
            self.display.refresh()

    def _frame(self, now_s):
        """Return the Frame to be shown."""
        session, display = self.sessions.now, self.display
        if not display.page:
            self.blocks.prepare()
        said = self.frame_step.words or self.recorder.said or self.rewind.words or self.ahead.words
        line = self.hud.drawing(display.theme, display.layout.hud, session, said, self.timer.words)
        return Frame(
            now_s,
            display.page,
            session,
            self.frame_step.passing(now_s),
            self._marks(display.stage.view),
            tuple(each for each in self.overlays if each.shown),
            self.time_bar.drawing(session),
            line,
            self.plots,
            self.panel.ui if display.panel_shown else None,
        )

    def _marks(self, view):
        """Return the marks of the tool at the cursor or at the pointer."""
        if self.camera.busy or self.photo_import.shown:
            return ()
        if self.cursor.on and not self.brush.by_mouse:
            return self.cursor.marks(view)
        return self.brush.marks(view.place(*self.pointer.place), view) if self.pointer.place else ()

    def _note(self, work_ns, own_work_ns, now_s):
        """Note what the frame took."""
        self.frame_step.note(work_ns)
        session = self.sessions.now
        frame = FrameTime(work_ns, own_work_ns, self.frame_step.moving_ns, session.due, session.done)
        self.frame_stats.count(frame, session, now_s)
        self.hud.update(session)

    def _fit(self):
        """Lay everything out, after the window or the lattice changed its size or what it looks like."""
        display, before, view = self.display, self.display.stage, self.display.stage.view
        if not display.fit(self.sessions.now):
            return
        self.camera.keep(view if display.stage is before else None)
        self.time_bar.place(display.layout.bar, display.theme)
        self.renderer.forget()
        self.plots.forget()
        self.panel.ui.invalidate()
        if display.page:
            display.page.forget()

    def _switch(self):
        """Show another session, or another scene: what else is heard in this frame finds it laid out."""
        self.brush.let_go()
        self.pointer.let_go()
        self.display.lay_out_anew()
        self._fit()

    # --- the end ---

    def let_go(self):
        """Let go of all that a key or a button holds: nobody may hear it come up."""
        holders = self.brush, self.pointer, self.time_bar, self.camera, self.rewind, self.ahead, self.panel.ui
        for each in (*holders, *self.cards):
            each.let_go()

    def quit(self):
        """Play no further frame."""
        self.running = False

    def close(self):
        """End every session's journal and wait for what is being written."""
        self.recorder.stop()
        self.planner.close()
        self.forecasting.close()
        self.sessions.close()
        self.settings_saver.close()
        self.background.finish()
        self.audio.close()
