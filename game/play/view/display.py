"""The display: how the window is laid out, what its theme is, and the view of the sand in it."""

from typing import Protocol

import pygame

from game.play.ui import theme as look
from game.play.view.comparison_view import ComparisonView
from game.play.view.sand_view import SandView
from game.play.view.turn_animation import TurnAnimation
from game.play.window.layout import MARGIN, WindowLayout, fitting_scale, room_of
from game.world.looks.themes import THEMES, substances_of
from game.world.looks.view import View
from game.world.sessions.comparison import Comparison

STAGE_ROWS = 500  # pixels at scale 1 from top to bottom of the stage: so large is everything there


class LatticeView(Protocol):
    """The view of one lattice, or of several that are shown in the same way: a SandView or a ComparisonView."""

    area: pygame.Rect  # of the pane that leads
    panes: tuple  # the parts of the window, Rects, that show a lattice
    view: View  # through which that pane shows its lattice
    whole: View  # … and all of it
    turn: TurnAnimation | None
    heatmap: object  # the HeatmapOverlay over the leading lattice, or None
    blocks: object  # the BlockOverlay over it, or None

    def fit(self, shape, area, margin, theme, walls, substances):
        """Show lattices of `shape` in `area` of the window; substances: those of each of them."""

    def show(self, view):
        """Show the lattices through another view."""

    def lay_over(self, overlays, words):
        """Lay {name: HeatmapOverlay} over the lattices and write {name: words} in their titles; else nothing."""

    def refresh(self):
        """Draw everything next time."""

    def start_turn(self, now_s, quarters):
        """Let the pictures go round by so many quarters."""

    def end_turn(self):
        """Show the worlds again as they are."""

    def draw(self, world, marks, overlay, now_s, streams=None):
        """Bring the window up to date and return the rects that changed."""


class Display:
    """Keeps theme, layout and view of the sand; all three are replaced while the window is open."""

    def __init__(self, window, settings, measured_row, board_height):
        """`measured_row()` returns the row above which a comparison counts the grains that are left.

        `board_height()` returns the pixels that large letters take below the sand.
        """
        self.window, self._settings, self._measured_row = window, settings, measured_row
        self._board_height = board_height
        self.theme = look.theme_of(settings["ui_scale"], self.colours)
        self.layout = None
        self.sand_view: LatticeView = SandView(window)
        self.panel_shown = True
        self.on_stage = False  # everything is large, and small print is away
        self.plots_shown = self.legend_shown = self.density_shown = self.figures_shown = False
        self.pages = ()  # what lies over everything else in the window while it is open
        self.now_s = 0.0  # when this frame is
        self.stale = False  # the view of the sand has to be drawn anew
        self._session = None  # whose worlds the view shows
        self._shape, self._worlds = (1, 1), 1  # of its lattices, and how many there are
        self._looks = None  # what everything was laid out for

    @property
    def colours(self):
        """The colours of the theme that is set."""
        return THEMES[self._settings["theme"]]

    @property
    def page(self):
        """The page that is open, or None."""
        return next((each for each in self.pages if each.shown), None)

    @property
    def in_sight(self):
        """Whether sand and panel are seen, if only behind a page."""
        return not (self.page and self.page.fills_window)

    @property
    def room(self):
        """The (width, height) in pixels of the part of the window that a lattice can fill."""
        return room_of(self.layout, self.theme)

    def refresh(self):
        """Have the view of the sand drawn anew: what lies over it looks different."""
        self.stale = True

    def lay_out_anew(self):
        """Have everything laid out and drawn anew."""
        self._looks = None

    def fit(self, session):
        """Lay everything out for a session's worlds, if anything about that has changed; return whether it had."""
        shape, walls = session.world.shape, session.scene.made_of
        substances = [substances_of(each.rule.definition.materials) for each in session.sessions.values()]
        settings = self.window.size, self.colours, self._settings["ui_scale"], self.on_stage, self._board_height()
        looks = session, shape, walls, substances, self._cards, settings
        if looks == self._looks:
            return False
        self._looks, self._shape, self._worlds = looks, shape, len(session.sessions)
        self._renew_theme()
        self.layout = self._lay_out(self.panel_shown)
        self.window.covered = self.page is not None and self.in_sight
        self.window.surface.fill(self.colours.ground)
        if session is not self._session:
            self._session = session
            self.sand_view = self._sand_view_of(session)
        self.sand_view.fit(shape, self.layout.sand, self.theme.px(MARGIN), self.theme, walls, substances)
        return True

    @property
    def hidden_panel_makes_room(self):
        """Whether the plots have room as soon as the panel is hidden."""
        return self.panel_shown and self._lay_out(panel_shown=False).plots is not None

    @property
    def _cards(self):
        """The names of the cards beside the sand."""
        shown = {"legend": self.legend_shown, "density": self.density_shown, "figures": self.figures_shown}
        return tuple(name for name, is_shown in shown.items() if is_shown)

    def _lay_out(self, panel_shown):
        return WindowLayout(
            *(self.theme, self.window.size, panel_shown, self._shape, self.plots_shown, self._cards),
            *(self._board_height(), self.on_stage, self._worlds),
        )

    def _sand_view_of(self, session):
        if isinstance(session, Comparison):
            return ComparisonView(self.window, session, self._measured_row)
        return SandView(self.window)

    def _renew_theme(self):
        """Keep the colours and the UI scale that were asked for, as far as the window leaves room for it."""
        scale = self._settings["ui_scale"]
        if self.on_stage:
            scale = max(scale, self.window.size[1] / STAGE_ROWS)
        wanted = fitting_scale(scale, self.window.size), self.colours
        if wanted != (self.theme.scale, self.theme.colours):
            self.theme = look.theme_of(*wanted)
