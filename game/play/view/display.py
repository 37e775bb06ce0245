"""The display: how the window is laid out, what its theme is, and the view of the sand in it."""

from game.play.ui import theme as look
from game.play.view.comparison_view import Panes
from game.play.view.sand_view import Stage
from game.play.window.layout import MARGIN, Layout, fitting_scale
from game.world.looks.themes import THEMES
from game.world.sessions.comparison import Comparison


class Display:
    """Keeps theme, layout and view of the sand; all three are replaced while the window is open."""

    def __init__(self, window, settings, measured_row):
        """`measured_row()` returns the row above which a comparison counts the grains that are left."""
        self.window, self._settings, self._measured_row = window, settings, measured_row
        self.theme = look.Theme(settings["ui_scale"], self.colours)
        self.layout = None
        self.stage = Stage(window)
        self.panel_shown = True
        self.plots_shown = False
        self.pages = ()  # what takes the place of everything else in the window while it is open
        self.stale = False  # the view of the sand has to be drawn anew
        self._session = None  # whose worlds the view shows
        self._looks = None  # what everything was laid out for

    @property
    def colours(self):
        """The colours of the theme that is set."""
        return THEMES[self._settings["theme"]]

    @property
    def page(self):
        """The page that is open, or None."""
        return next((each for each in self.pages if each.shown), None)

    def refresh(self):
        """Have the view of the sand drawn anew: what lies over it looks different."""
        self.stale = True

    def lay_out_anew(self):
        """Have everything laid out and drawn anew."""
        self._looks = None

    def fit(self, session):
        """Lay everything out for a session's worlds, if anything about that has changed; return whether it had."""
        shape, walls = session.world.shape, session.scene.made_of
        looks = session, self.window.size, shape, walls, self.colours, self._settings["ui_scale"]
        if looks == self._looks:
            return False
        self._looks = looks
        self._renew_theme()
        self.layout = Layout(self.theme, self.window.size, self.panel_shown, shape if self.plots_shown else None)
        self.window.surface.fill(self.colours.ground)
        if session is not self._session:
            self._session = session
            self.stage = self._stage_of(session)
        self.stage.fit(shape, self.layout.sand, self.theme.px(MARGIN), self.theme, walls)
        return True

    def _stage_of(self, session):
        if isinstance(session, Comparison):
            return Panes(self.window, session, self._measured_row)
        return Stage(self.window)

    def _renew_theme(self):
        """Keep the colours and the UI scale that were asked for, as far as the window leaves room for it."""
        wanted = fitting_scale(self._settings["ui_scale"], self.window.size), self.colours
        if wanted != (self.theme.scale, self.theme.colours):
            self.theme = look.theme_of(*wanted)
