"""The panel: what can be chosen and turned, top to bottom; first what a newcomer reaches for, last what is set once."""

from game.play.panel import show_section, window_section
from game.play.panel.friction_section import Friction
from game.play.panel.glass_section import GlassFold
from game.play.panel.recording_section import PastFold
from game.play.panel.timer_section import TimerFold
from game.play.panel.tools_section import Toolbox
from game.world.sand import parameters
from game.world.scenes.scene import scene_names

FAST = "Fast"  # the button that is held


class Panel:
    """The column of controls, and the few values that only it remembers."""

    def __init__(self, ui):
        self.ui = ui
        self.toolbox, self.friction = Toolbox(), Friction()
        self.timer, self.glass, self.past = TimerFold(), GlassFold(), PastFold()
        self._scenes = scene_names()

    def lay_out(self, rect, events, now_s, mouse_pos, toy):
        """Show the controls, obey what was done to them, and return the events that the panel leaves to others."""
        self.ui.theme = toy.display.theme
        rest = self.ui.begin(rect, events, now_s, mouse_pos)
        self._scene(toy)
        self.toolbox.lay_out(self.ui, toy)
        self.friction.lay_out(self.ui, toy)
        self._time(toy)
        for fold in (self.timer, self.glass, self.past):
            fold.lay_out(self.ui, toy)
        show_section.show(self.ui, toy)
        self._window(toy)
        return rest

    def _scene(self, toy):
        ui, scene, commands = self.ui, toy.sessions.now.scene, toy.commands
        names = self._scenes if scene.name in self._scenes else (*self._scenes, scene.name)
        titles = [toy.sessions.title_of(name) for name in names]
        now = names.index(scene.name)
        chosen = ui.choice("Scene", titles, now, tip="Puts the sand and walls of another scene in place of these")
        if chosen != now:
            toy.sessions.load(names[chosen])
        if scene.notice:
            ui.text(scene.notice, dim=True)
        ui.row(3)
        if ui.button("Gallery", key="F2", tip="All scenes at once, running, with a sentence on each"):
            commands.files.show_scenes()
        if ui.button("Save", key="Ctrl+S", tip="Saves sand, walls and settings as one picture"):
            commands.files.save()
        if ui.button("Open", key="Ctrl+O", tip="Shows the saved scenes; the one opened replaces this sand"):
            commands.files.open_scenes()

    def _time(self, toy):
        ui, session, commands = self.ui, toy.sessions.now, toy.commands
        ui.heading("Time")
        tip = "How fast the sand runs, in iterations per second"
        session.clock.speed = ui.slider(
            "Speed", parameters.SPEED, session.clock.speed, default=session.scene.speed, log=True, tip=tip
        )
        ui.row(2)
        label = "Go on" if session.paused else "Pause"
        if ui.button(label, key="Space", name="Pause", tip="Holds the sand where it is, and lets it go on"):
            commands.time.pause()
        if ui.button("Flip", key="F", tip="Turns the glass over"):
            commands.sand.flip()
        ui.row(2)
        tip = "Turns the table by a quarter, and the sand falls to another side"
        if ui.button("Turn left", key="Ctrl+F", tip=tip):
            commands.sand.turn("3")
        if ui.button("Turn right", key="Shift+F", tip=tip):
            commands.sand.turn("1")
        ui.row(2)
        if ui.button("Undo", key="Ctrl+Z", tip="Takes back the last act; the sand is as it would have been without"):
            commands.time.undo()
        if ui.button("Redo", key="Ctrl+Y", tip="Brings back what was undone, or the future that was left"):
            commands.time.redo()
        ui.row(2)
        if ui.button("Restart", key="R", tip="Starts the scene again; friction and speed stay as they are set"):
            commands.sand.restart()
        if ui.button("Clear", key="C", tip="Takes all sand away and leaves the walls"):
            commands.sand.clear()
        self._ahead(toy)

    def _ahead(self, toy):
        """Show the ways to go on other than at the speed that is set."""
        ui, commands = self.ui, toy.commands
        ui.row(2)
        if ui.button("Step", key=".", tip="Lets the sand move by one iteration"):
            commands.time.step()
        ui.button(FAST, key="Right", tip="Hold it: time goes as fast as the frames can hold")
        toy.fast_forward.hold(ui.focus.held == FAST)
        ui.row(2)
        if ui.button("Settle", key="End", tip="Runs until nothing can move any more"):
            commands.time.settle()
        if ui.button("Flow", key="Shift+Right", tip="Runs until a grain next passes the neck"):
            commands.time.await_flow()

    def _window(self, toy):
        ui = self.ui
        ui.heading("Window")
        toy.hiss.show(ui)
        ui.row(2)
        if ui.button("Full screen", key="F11", tip="Fills the screen, or goes back to the window"):
            toy.commands.view.toggle_fullscreen()
        if ui.button("Keys", key="F1", tip="Every key on one page"):
            toy.commands.view.toggle_help()
        window_section.show(ui, toy.settings)
