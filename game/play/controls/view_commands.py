"""The commands for the view: what the window shows, and how it is left."""

from game.play.ui.input import key_name
from game.world.sessions.comparison import Comparison


class ViewCommands:
    """The keys and buttons of the view and the window."""

    def __init__(
        self,
        sessions,
        display,
        notices,
        brush,
        camera,
        cursor,
        blocks,
        forecasting,
        figures,
        plots,
        differences,
        density,
        stage,
        keys_page,
        hiss,
        panel,
        on_quit,
    ):
        self._sessions, self._display, self._notices = sessions, display, notices
        self._brush, self._camera, self._cursor, self._blocks = brush, camera, cursor, blocks
        self._forecasting, self._figures, self._plots = forecasting, figures, plots
        self._differences, self._density, self._stage = differences, density, stage
        self._help, self._hiss, self._panel, self._on_quit = keys_page, hiss, panel, on_quit

    def show_all(self):
        """Show the whole lattice."""
        self._camera.fit()

    def zoom(self, levels):
        """Show cells larger, or smaller."""
        self._camera.zoom(int(levels))

    def look(self, right, down):
        """Show what lies beside the cells in sight."""
        self._camera.pan(int(right), int(down))

    def toggle_blocks(self):
        """Show what each block can do in the coming iteration, or hide it."""
        self._blocks.toggle()

    def toggle_cursor(self):
        """Let the arrows move a cursor over the cells, or no longer."""
        self._cursor.toggle()

    def toggle_forecast(self):
        """Show where the sand will be, or no longer."""
        self._lay_over(self._forecasting)

    def toggle_differences(self):
        """Mark where the compared worlds differ, or no longer."""
        if len(self._sessions.now.sessions) > 1 or self._differences.shown:
            self._lay_over(self._differences)
        else:
            self._notices.say(f"Only worlds side by side differ: {key_name('Shift+H')} compares.")

    def toggle_density(self):
        """Show where the sand of many runs is now, or no longer."""
        self._lay_over(self._density)

    def _lay_over(self, chosen):
        """Show one of what lies over the sand, or no longer; only one of them lies there."""
        for each in (self._forecasting, self._differences, self._density):
            if each is not chosen and each.shown:
                each.toggle()
        chosen.toggle()

    def toggle_plots(self):
        """Show the plots of what the sand does, or no longer."""
        self._plots.toggle()

    def toggle_panel(self):
        """Hide or show the panel."""
        self._display.panel_shown = not self._display.panel_shown
        self._display.lay_out_anew()

    def turn_tab(self, tabs):
        """Show another section of the panel, and give it the keyboard."""
        if not self._display.panel_shown:
            self.toggle_panel()
        self._panel.turn(int(tabs))

    def toggle_stage(self):
        """Make the window one for a class, or no longer."""
        self._stage.toggle()

    def toggle_sound(self):
        """Let the sand be heard, or not."""
        self._hiss.toggle()

    def toggle_fullscreen(self):
        """Fill the screen, or go back."""
        self._display.window.toggle_fullscreen()
        self._display.lay_out_anew()

    def toggle_help(self):
        """Open or close the page of keys."""
        self._help.toggle()

    def escape(self):
        """Let go of what is being drawn, or close what is open; never quit."""
        for is_open, close in (
            (self._brush.painting, self._brush.let_go),
            (self._help.shown, self.toggle_help),
            (self._brush.selects, self._brush.deselect),
            (self._cursor.on, self.toggle_cursor),
            (self._plots.shown, self.toggle_plots),
            (self._forecasting.shown, self.toggle_forecast),
            (self._differences.shown, self.toggle_differences),
            (self._density.shown, self.toggle_density),
            (self._figures.kept, self._figures.toggle),
            (isinstance(self._sessions.now, Comparison), self._sessions.leave),
            (self._stage.on, self.toggle_stage),
            (self._display.window.fullscreen, self.toggle_fullscreen),
        ):
            if is_open:
                close()
                return
        self._notices.say(f"Nothing is open. {key_name('Ctrl+Q')} quits.")

    def quit(self):
        """Close the window; the next start offers to go on with the session."""
        self._on_quit()
