"""The density maps: the share of many runs that have sand in each cell now, over each world that is shown."""

from game.play.forecast.legend import scale_card
from game.world.background.density_thread import DensityStart, DensityThread
from game.world.background.forecast_thread import standard_error
from game.world.looks.heatmap_overlay import HeatmapOverlay, density_covers
from game.world.sand.crop import CropBox
from game.world.sessions.action import Load

MOST_CELLS = 2**21  # of a world whose density is followed
TITLE = "Density"


class Density:
    """Follows runs from the start of the scene, or from the last act, to the iteration that is shown."""

    def __init__(self, sessions, display, notices):
        self._sessions, self._display, self._notices = sessions, display, notices
        self.thread = DensityThread()
        self.answer = None  # the DensityMaps that are shown
        self._about = None  # (sessions, the last acts, rules): what the runs are of
        self._starts, self._from = {}, 0  # where they start, and the iteration of the world there
        self._laid = None  # (answer, view) that was laid over the sand

    @property
    def shown(self):
        """Whether they are wanted."""
        return self._display.density_shown

    def toggle(self):
        """Show the maps, or no longer."""
        height, width = self._sessions.now.world.shape
        if not self.shown and height * width > MOST_CELLS:
            self._notices.say(f"Density is followed on lattices of up to {MOST_CELLS:,} cells.")
            return
        if self.shown:
            self.close()
        self._display.density_shown = not self.shown

    def close(self):
        """Take the maps away; return when the thread has ended."""
        self.thread.close()
        self.answer = self._about = self._laid = None
        self._display.sand_view.lay_over({}, {})
        self._display.refresh()

    def update(self, now_s):
        """Wish for the maps of this iteration and show the latest; never wait."""
        session = self._sessions.now
        if not self.shown or not session.arrived:
            return
        if session.world.shape[0] * session.world.shape[1] > MOST_CELLS:
            self.toggle()
            return
        about, now = self._subject(), session.world.iteration
        if about != self._about or now < self._from:
            self._about, self._starts, self._from = about, *_starts(session)
        self.thread.follow(self._about, self._starts, now - self._from)
        self._show(self.thread.answer)

    def _subject(self):
        return tuple(
            (each, each.timeline.history.latest(each.now), each.rule) for each in self._sessions.now.sessions.values()
        )

    def _show(self, answer):
        view = self._display.sand_view
        if answer is None or answer.about is not self._about or self._laid == (answer.now, self._about, view):
            return
        self.answer, self._laid = answer, (answer.now, self._about, view)
        maps = answer.levels.items()
        overlays = {name: HeatmapOverlay(CropBox(0, 0, *each.shape), each, density_covers) for name, each in maps}
        title = f"t = {self._from + answer.now:,}".replace(" ", "\N{NO-BREAK SPACE}")  # not to be cut
        view.lay_over(overlays, dict.fromkeys(overlays, title))
        self._display.refresh()

    def drawing(self, theme, rect):
        """Return the strokes of the card that says what the colours mean."""
        return scale_card(theme, rect, *self._words())

    def _words(self):
        """Return the title of the card, and the lines under its colours."""
        if self.answer is None:
            return TITLE, ("Computing the first runs …",)
        certain, error = self.answer.certain, 100 * standard_error(0.5, self.answer.runs)
        runs = "Nothing is left to chance" if certain else f"{self.answer.runs:,} runs: ± {error:.1f} % at most"
        title = f"{TITLE} at t = {self._from + self.answer.now:,}"
        return title, (runs, f"{self._sessions.now.rule.codes.usual.capitalize()}, from t = {self._from:,} on")


def _starts(session):
    """Return ({name: DensityStart}, the iteration): the start of the scene, where nothing was done since."""
    latest = session.timeline.history.latest(session.now)
    fresh = latest.before is None or isinstance(latest.action, Load)
    starts = {}
    for name, each in session.sessions.items():
        world = each.scene.world(each.seed) if fresh else each.world.copy()
        starts[name] = DensityStart(world, each.rule, each.rule.codes.usual)
    return starts, next(iter(starts.values())).world.iteration
