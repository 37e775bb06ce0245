"""The panel's section of time: how fast it runs, and every way to move in it."""

from game.play.controls.time_commands import HALT
from game.world.sand import parameters

HALT_TIP = "The iteration of this world at which time is to stand still"
RUN_TIP = "Runs to that iteration, or goes back to it, and holds time there"
FAST = "Fast"  # the button that is held


class TimeSection:
    """The speed, and buttons in pairs."""

    def __init__(self, sessions, time_commands, sand_commands, fast_forward):
        self._sessions, self._time, self._sand = sessions, time_commands, sand_commands
        self._fast_forward = fast_forward

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        session = self._sessions.now
        ui.heading("Time")
        tip = "How fast time runs, in iterations per second"
        session.clock.speed = ui.slider(
            "Speed", parameters.SPEED, session.clock.speed, default=session.scene.speed, log=True, tip=tip
        )
        ui.skip(ui.theme.px(2))
        ui.row(2)
        label = "Resume" if session.paused else "Pause"
        if ui.button(label, key="Space", name="Pause", tip="Stops time, or lets it run again"):
            self._time.pause()
        if ui.button("Flip", key="F", tip="Turns the glass over"):
            self._sand.flip()
        ui.row(2)
        if ui.button("Undo", key="Ctrl+Z", tip="Takes back the last action; all is as it would be without it"):
            self._time.undo()
        if ui.button("Redo", key="Ctrl+Y", tip="Brings back what was undone, or the future you left"):
            self._time.redo()
        ui.row(2)
        if ui.button("Restart", key="R", tip="Starts the scene again; friction and speed stay as you set them"):
            self._sand.restart()
        if ui.button("Clear", key="C", tip="Removes all but the walls"):
            self._sand.clear()
        ui.row(2)
        tip = "Turns the lattice by a quarter, so that all falls to another side"
        if ui.button("Turn left", key="Ctrl+F", tip=tip):
            self._sand.turn("3")
        if ui.button("Turn right", key="Shift+F", tip=tip):
            self._sand.turn("1")
        self._lay_out_ahead(ui)

    def _lay_out_ahead(self, ui):
        """Show the ways to run at another speed than the one that is set."""
        ui.row(2)
        if ui.button("Step", key=".", tip="Runs one iteration and pauses"):
            self._time.step()
        ui.button(FAST, key="Right", tip="Hold it to run as fast as this computer can")
        self._fast_forward.hold(ui.focus.held == FAST)
        if ui.button("Run to rest", key="End", tip="Runs until nothing can move any more"):
            self._time.settle()
        if ui.button("Run to next grain", key="Shift+Right", tip="Runs until the next grain passes the neck"):
            self._time.await_flow()
        self._time.halt_at = ui.slider(
            "Stop at t", HALT, self._time.halt_at, log=True, name="Stop at", tip=HALT_TIP, spell="{:,}".format
        )
        if ui.button(f"Run to t = {self._time.halt_at:,}", key="Shift+End", name="Run to t", tip=RUN_TIP):
            self._time.run_to()
