"""The parts of one window, each made with exactly what it uses."""

import pygame

from game.play.controls.camera import Camera
from game.play.controls.commands import Commands, FileCommands, SandCommands, TimeCommands, ViewCommands
from game.play.controls.comparing import Comparing
from game.play.controls.event_router import EventRouter
from game.play.controls.fast_forward import FastForward
from game.play.controls.held_keys import HeldKeys
from game.play.controls.keyboard_cursor import KeyboardCursor
from game.play.controls.piece_commands import PieceCommands
from game.play.controls.pointer import Pointer
from game.play.controls.rewind import Rewind
from game.play.controls.stage import Stage
from game.play.controls.time_bar import TimeBar
from game.play.controls.tools.brush import Brush
from game.play.controls.tools.ruler import Ruler
from game.play.controls.tools.stamp_preview import StampPreview
from game.play.controls.view_buttons import ViewButtons
from game.play.forecast.density import Density
from game.play.forecast.forecasting import Forecasting
from game.play.frame_step import FrameStep
from game.play.pages.gallery import GalleryPage
from game.play.pages.help import HelpPage
from game.play.pages.material_page import MaterialPage
from game.play.panel.compare_section import CompareSection
from game.play.panel.glass_section import GlassSection
from game.play.panel.panel import Panel
from game.play.panel.recording_section import RecordingSection
from game.play.panel.rules_section import RulesSection
from game.play.panel.scene_section import SceneSection
from game.play.panel.show_section import ShowSection
from game.play.panel.time_section import TimeSection
from game.play.panel.timer_section import TimerSection
from game.play.panel.tools_section import ToolsSection
from game.play.panel.window_section import WindowSection
from game.play.plots.plots import Plots
from game.play.storage.canvas_card import CanvasCard
from game.play.storage.comparison_files import ComparisonFiles
from game.play.storage.crash_recovery import CrashRecovery
from game.play.storage.files import Files
from game.play.storage.journals import Journals
from game.play.storage.name_card import NameCard
from game.play.storage.open_sessions import Sessions
from game.play.storage.photo_import import PhotoImport
from game.play.storage.recorder import Recorder
from game.play.storage.rule_change import RuleChange
from game.play.storage.rule_files import RuleFiles
from game.play.storage.settings_saver import SettingsSaver
from game.play.storage.stamps import Stamps
from game.play.storage.window_glass import WindowGlass
from game.play.timer.chime import Chime
from game.play.timer.glow import Glow
from game.play.timer.run_out_planner import RunOutPlanner
from game.play.timer.timer import RUNNING, Timer
from game.play.ui.widgets import Ui
from game.play.view.dialog import Dialog
from game.play.view.differences import Differences
from game.play.view.display import Display
from game.play.view.frame_stats import FrameStats
from game.play.view.hints import Hints
from game.play.view.notices import Notices
from game.play.view.overlays.block_card import BlockCard
from game.play.view.overlays.block_overlay import BlockOverlay
from game.play.view.overlays.minimap import Minimap
from game.play.view.overlays.stats_card import StatsCard
from game.play.view.renderer import Renderer
from game.play.view.room_hint import RoomHint
from game.play.view.status_line import StatusLine
from game.play.window.audio import Audio
from game.play.window.background import Background
from game.play.window.hiss import Hiss
from game.world.scenes.fine_glass import fine_glass
from game.world.sessions.session import Session


class Parts:
    """Everything that the window shows, hears and keeps; no part knows this class."""

    def __init__(self, window, scene, seed, settings, on_switch):
        """`on_switch()` is called after another session, or another scene, has taken the place of the one shown."""
        self.window, self.settings = window, settings
        self.running = True  # the player has not quit
        self._make_holders(scene, seed, on_switch)
        self._make_parts()
        self._make_controls()

    def _make_holders(self, scene, seed, on_switch):
        """Make what the parts share."""
        self.display = Display(self.window, self.settings, lambda: self.plots.measured_row, lambda: self.stage.height)
        self.notices = Notices(lambda: (self.sessions.now, self.sessions.now.scene))
        self.background = Background(lambda error: self.notices.say(error, trouble=True))
        self.journals = Journals(self.notices.say)
        self.sessions = Sessions(
            Session(scene, seed),
            self.journals,
            self.notices,
            on_switch,
            lambda each: fine_glass(each, self.display.room),
        )
        self.frame_stats, self.audio = FrameStats(), Audio(self.background)
        self.brush, self.pointer, self.keys = Brush(self.sessions), Pointer(self.display), HeldKeys(self.sessions)

    def _make_parts(self):
        """Make what is shown, stored and heard."""
        self.status_line = StatusLine(self.frame_stats)
        self.stats_card = StatsCard(self.sessions, self.display, self.frame_stats)
        self.block_overlay = BlockOverlay(self.sessions, self.display, self.notices)
        self.ruler = Ruler(self.brush, self.display)
        self.block_card = BlockCard(self.block_overlay, self.display, self.pointer)
        self.forecasting = Forecasting(self.sessions, self.display, self.pointer)
        self.density = Density(self.sessions, self.display, self.notices)
        self.differences = Differences(self.sessions, self.display)
        self.plots = Plots(self.sessions, self.display, self.frame_stats, self.background, self.notices)
        self.minimap = Minimap(self.sessions, self.display)
        self.dialog = Dialog(self.display)
        self.photo_import = PhotoImport(self.sessions, self.display)
        self.rule_change = RuleChange(self.sessions, self.background, self.notices)
        self.rule_files = RuleFiles(self.sessions, self.rule_change, self.background, self.notices)
        self.name_card = NameCard(self.display)
        self.files = Files(
            *(self.sessions, self.journals, self.photo_import, self.rule_files, self.name_card),
            *(self.background, self.notices),
        )
        self.stamps = Stamps(self.brush, self.photo_import, self.name_card, self.background, self.notices)
        self.canvas_card = CanvasCard(self.sessions, self.display, self.files, self.rule_files, self.notices)
        self.recorder = Recorder(self.sessions, self.display, self.settings, self.background, self.notices)
        self.comparison_files = ComparisonFiles(self.sessions, self.display, self.plots, self.background, self.notices)
        self.crash_recovery = CrashRecovery(self.sessions, self.journals, self.dialog, self.background, self.notices)
        self.settings_saver = SettingsSaver(
            self.settings, self.sessions, self.brush, self.window, self.background, self.notices
        )
        self.gallery = GalleryPage(self.display, self.sessions, self.files, self.stamps, self.background, self.notices)
        self.help = HelpPage(self.display)
        self.material_page = MaterialPage(self.display, self.sessions, self.rule_change, self.brush)
        self.display.pages = self.help, self.gallery, self.material_page
        self.hiss = Hiss(self.sessions, self.settings, self.audio, self.background, self.notices)
        self.planner = RunOutPlanner(self.sessions, self.background)
        self.glow = Glow(self.display, self.settings)
        chime = Chime(self.settings, self.audio, self.background)
        self.timer = Timer(self.sessions, self.planner, self.notices, self.window.set_title, self.glow, chime)
        self.stage = Stage(self.sessions, self.display, self.settings, self.timer, self.notices)
        self.panel = Panel(Ui(self.display.theme), self.display)
        self.window_glass = WindowGlass(
            self.sessions,
            self.display,
            self.journals,
            self.brush,
            self.notices,
            lambda: self.timer.state == RUNNING or self.recorder.going_on,
        )

    def _make_controls(self):
        """Make what keys and pointer work, and tell in which order all parts hear and are seen."""
        sessions, display, notices, brush = self.sessions, self.display, self.notices, self.brush
        self.rewind, self.time_bar = Rewind(), TimeBar()
        self.stamp_preview = StampPreview(sessions, display)
        self.camera = Camera(sessions, display, self.pointer, brush, self.minimap, lambda: self.commands.time.pause())
        self.view_buttons = ViewButtons(self.pointer, lambda command: self.commands.give(command))
        self.cursor = KeyboardCursor(sessions, brush, self.panel.ui.focus)
        self.fast_forward = FastForward(sessions, self.background, notices, self.keys)
        self.comparing = Comparing(
            *(sessions, self.journals, self.rule_files, self.background, notices, lambda: self.timer.own_speed)
        )
        self.commands = Commands(
            TimeCommands(sessions, notices, self.keys, self.fast_forward, self.timer),
            SandCommands(sessions, self.comparing, self.settings, display, notices, brush, self.camera, self.timer),
            ViewCommands(
                *(sessions, display, notices, brush, self.camera, self.cursor, self.block_overlay),
                *(self.forecasting, self.stats_card, self.plots, self.differences, self.density, self.stage),
                *(self.help, self.hiss, self.panel, self.quit),
            ),
            FileCommands(
                *(sessions, self.files, self.gallery, self.recorder, self.plots, self.comparison_files),
                self.canvas_card,
            ),
            PieceCommands(sessions, notices, brush, self.stamps),
        )
        self.panel.hold(self._sections())
        first = self.view_buttons, self.rewind, self.camera, self.fast_forward
        on_window = {
            pygame.QUIT: lambda event: self.quit(),
            pygame.WINDOWFOCUSLOST: lambda event: self.let_go(),
            pygame.WINDOWEXPOSED: lambda event: display.lay_out_anew(),
            pygame.WINDOWSIZECHANGED: lambda event: display.lay_out_anew(),
            pygame.DROPFILE: lambda event: self.files.open(event.file),
        }
        self.event_router = EventRouter(
            *(display, self.pointer, self.keys, self.commands, brush, self.time_bar, self.stats_card, self.stage),
            *(first, on_window),
        )
        pacers = self.fast_forward, self.timer
        self.frame_step = FrameStep(sessions, display, self.settings, self.time_bar, self.rewind, pacers)
        self.renderer = Renderer(display)
        self.cards = self.name_card, self.canvas_card, self.photo_import, self.dialog  # the first lies on top
        self.overlays = [self.glow, self.block_card, self.ruler, self.minimap, *self.cards[::-1]]
        hints = Hints(self.settings, sessions, display, notices, self.material_page)
        room_hint = RoomHint(sessions, display, notices)
        self.watchers = [self.recorder, self.settings_saver, self.camera.badge, self.stats_card, self.hiss]
        self.watchers += [hints, room_hint]
        self.watchers += [self.forecasting, self.density, self.plots, self.fast_forward, self.timer, self.glow]
        self.watchers += [self.rule_change, self.rule_files, self.block_card, self.ruler, self.window_glass]

    def _sections(self):
        """Return the sections of the panel by the names of its tabs, from top to bottom."""
        sessions, commands = self.sessions, self.commands
        return {
            "Scene": [SceneSection(sessions, commands.files)],
            "Tools": [ToolsSection(self.brush, self.material_page, commands.piece, commands.files.open_stamps)],
            "Rule": [RulesSection(sessions, self.rule_change, self.rule_files, self.brush)],
            "Time": [TimeSection(sessions, commands.time, commands.sand, self.fast_forward)],
            "More": [
                TimerSection(self.timer, sessions, self.settings, commands.time),
                GlassSection(sessions, self.planner, self.notices),
                RecordingSection(sessions, self.recorder, self.files, self.settings, commands.time),
            ],
            "Measure": [
                ShowSection(sessions, self.brush, self.forecasting, self.plots, self.stats_card, commands.view),
                CompareSection(self.comparing, self.rule_files, self.differences, self.density, commands),
            ],
            "View": [WindowSection(self.settings, self.hiss, self.stage, commands.view)],
        }

    def let_go(self):
        """Let go of all that a key or a button holds: nobody may hear it come up."""
        holders = self.brush, self.pointer, self.time_bar, self.camera, self.rewind, self.fast_forward, self.panel.ui
        for each in (*holders, *self.cards):
            each.let_go()

    @property
    def at_rest(self):
        """Whether nothing goes on: no sand moves, nothing is held, and nothing is shown that comes and goes."""
        session = self.sessions.now
        goes_on = (
            not (session.arrived and (session.paused or session.settled)),
            self.keys.any_down or self.brush.painting or self.time_bar.held,
            self.timer.state == RUNNING or self.fast_forward.words,
            self.recorder.said or self.forecasting.thread.working,
            self.density.shown and self.density.thread.working,
            self.display.sand_view.turn or self.gallery.shown,
            self.glow.shown or self.camera.badge.shown,
        )
        return not any(goes_on)

    def quit(self):
        """Play no further frame."""
        self.running = False

    def close(self):
        """End every session's journal and wait for what is being written."""
        self.recorder.stop()
        self.sessions.close()
        self.settings_saver.close()
        self.background.finish()
        self.planner.close()
        self.forecasting.close()
        self.density.close()
        self.audio.close()
