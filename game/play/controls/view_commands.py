"""The commands for the view: what the window shows, and how it is left."""

import time

from game.world.sessions.comparison import Comparison

TWICE_S = 3.0  # within which Esc has to come again to quit; as long as the notice of it is read


class ViewCommands:
    """The keys and buttons of the view and the window."""

    def __init__(
        self, sessions, display, notices, brush, camera, cursor, blocks, forecasting, plots, keys_page, hiss, on_quit
    ):
        self._sessions, self._display, self._notices = sessions, display, notices
        self._brush, self._camera, self._cursor, self._blocks = brush, camera, cursor, blocks
        self._forecasting, self._plots, self._help, self._hiss = forecasting, plots, keys_page, hiss
        self._on_quit = on_quit
        self._warned_s = -TWICE_S  # when the player was told how to quit

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
        self._forecasting.toggle()

    def toggle_plots(self):
        """Show the plots of what the sand does, or no longer."""
        self._plots.toggle()

    def toggle_panel(self):
        """Hide or show the panel."""
        self._display.panel_shown = not self._display.panel_shown
        self._display.lay_out_anew()

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
        """Let go of what is being drawn, or close what is open; with nothing open quit, if Esc comes twice."""
        for is_open, close in (
            (self._brush.painting, self._brush.let_go),
            (self._help.shown, self.toggle_help),
            (self._cursor.on, self.toggle_cursor),
            (self._plots.shown, self.toggle_plots),
            (self._forecasting.shown, self.toggle_forecast),
            (isinstance(self._sessions.now, Comparison), self._sessions.leave),
            (self._display.window.fullscreen, self.toggle_fullscreen),
        ):
            if is_open:
                close()
                return
        if time.monotonic() - self._warned_s <= TWICE_S:
            self._on_quit()
            return
        self._warned_s = time.monotonic()
        self._notices.say("Press Esc again to quit.", holds=lambda: time.monotonic() - self._warned_s <= TWICE_S)
