"""Hints: a few lines at the right moment of the first minutes, each shown once and then never again.

A hint that the player did not need, having done already what it says, counts as seen.
"""

from typing import NamedTuple

from game.world.sessions.action import Draw, Fill, Flip, Paint, SetRule

APART_S = 15.0  # from one hint to the next
STILL_S = 1.5  # sand that has not moved for so long has come to rest


class Hint(NamedTuple):
    """A name, as the settings remember it, the earliest moment (seconds after the start), and what is said."""

    name: str
    after_s: float
    words: str
    of_sand: bool | None = None  # only under the rule of sand, only under others, or under any


HINTS = (
    Hint("paint", 8.0, "Press and drag to paint. The right button erases."),
    Hint("flip", 0.0, "All is at rest. F turns it over."),
    Hint("p", 40.0, "Drag p in the panel: with a lower p, the sand is rougher and its piles are steeper.", True),
    Hint("material", 20.0, "Press the chosen material in the panel again: it shows what it does with others.", False),
)


class Hints:
    """Looks for the moment of those hints that are still to be shown."""

    def __init__(self, settings, sessions, display, notices, material_page):
        self._material_page = material_page
        self._settings, self._sessions, self._display, self._notices = settings, sessions, display, notices
        self._start_s = self._still_since_s = self._last_s = None
        self._before = None, None  # the timeline and its line at the last look

    def update(self, now_s):
        """Show a hint, if it is the moment for one."""
        left = [hint for hint in HINTS if hint.name not in self._settings["hints_seen"]]
        if not left:
            return
        if self._start_s is None:
            self._start_s = now_s
        self._watch(now_s)
        done = self._done()
        for hint in left:
            if hint.name == done:
                self._remember(hint)
        for hint in left:
            if hint.name != done and self._is_moment(hint, now_s):
                self._notices.say(hint.words, holds=self._is_of_use)
                self._last_s = now_s
                self._remember(hint)
                return

    def _watch(self, now_s):
        """Note since when the sand has been at rest."""
        if not self._sessions.now.settled:
            self._still_since_s = None
        elif self._still_since_s is None:
            self._still_since_s = now_s

    def _done(self):
        """Return the name of the hint that an act since the last look made needless, or the page that is open, or None.

        What was done already in a session that has just been opened, such as a replay, is not the player's doing.
        """
        timeline = self._sessions.now.timeline
        before, self._before = self._before, (timeline, timeline.history.line)
        if self._material_page.shown:
            return "material"
        if before[0] is not timeline or before[1] is timeline.history.line:
            return None
        match timeline.history.line.action:
            case Flip():
                return "flip"
            case SetRule():
                return "p"
            case Paint() | Draw() | Fill():
                return "paint"
        return None

    def _is_moment(self, hint, now_s):
        if not self._is_of_use() or self._notices.line or self._sessions.can_leave:
            return False
        if now_s - self._start_s < hint.after_s or hint.of_sand not in (None, self._sessions.now.rule.codes.is_sand):
            return False
        if self._last_s is not None and now_s - self._last_s < APART_S:
            return False
        rests = self._still_since_s is not None and now_s - self._still_since_s > STILL_S
        return hint.name != "flip" or (rests and self._sessions.now.world.grains > 0)

    def _is_of_use(self):
        """Return whether the window is the one that hints are about."""
        return not self._display.page and not self._display.on_stage

    def _remember(self, hint):
        self._settings["hints_seen"] = (*self._settings["hints_seen"], hint.name)
