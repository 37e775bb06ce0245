"""The stats card: what the status line leaves out, while the pointer rests on that line, or until a click on it."""

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.card import box_strokes
from game.play.ui.tooltips import LATER_S
from game.play.view.status_line import counted
from game.world.sessions.session import BUDGET_NS
from game.world.sessions.snapshots import MEGABYTE

AWAY, PAD = 4, 8  # pixels at scale 1 around the card and in it
BUSY = "frames came late: this computer was busy with something else"
FULL = "the sand takes all the time that a frame has"


class StatsCard:
    """The card beside the sand, or below it."""

    def __init__(self, sessions, display, stats):
        self._sessions, self._display, self._stats = sessions, display, stats
        self.kept = False  # open without the pointer
        self._since_s = None  # since when the pointer rests on the line
        self._pointed = False  # for long enough
        self._reading, self.lines = None, ()

    @property
    def shown(self):
        """Whether the card is there."""
        return bool(self.lines)

    def toggle(self):
        """Keep the card open, or close it."""
        self.kept, self._since_s, self._pointed = not self.kept, None, False

    def follow(self, pointer, now_s):
        """Note where the pointer is, in the window."""
        here = pointer is not None and self._display.layout.status_line.collidepoint(pointer)
        if not here:
            self._since_s, self._pointed = None, False
        elif self._since_s is None:
            self._since_s = now_s
        elif now_s - self._since_s >= LATER_S:
            self._pointed = True

    def update(self, now_s):
        """Write the lines anew, if there are new figures or nobody wants any."""
        wanted, reading = self.kept or self._pointed, self._stats.reading
        if wanted and (not self.lines or reading is not self._reading):
            lines, self._reading = tuple(self._write(reading)), reading
        else:
            lines = self.lines if wanted else ()
        self.lines = lines
        self._display.figures_shown = self.shown

    def drawing(self, theme, rect):
        """Return the strokes of the card in `rect`, as high as those of its lines that there is room for."""
        px, high = theme.px, theme.line_height(look.SMALL)
        card = rect.inflate(-2 * px(AWAY), -2 * px(AWAY))
        row = card.inflate(-2 * px(PAD), -2 * px(PAD))
        rows = []
        for line in self.lines:
            more = theme.lines(line, look.SMALL, row.width)
            if (len(rows) + len(more)) * high <= row.height:
                rows += more
        card.height = min(card.height, len(rows) * high + 2 * px(PAD))
        strokes = box_strokes(theme, card, rect)
        for number, text in enumerate(rows):
            place = (row.x, row.y + number * high, row.width, high)
            strokes.append((draw_list.words, place, text, look.SMALL, look.TEXT, 0))
        return strokes

    def _write(self, reading):
        session = self._sessions.now
        if reading:
            work = f"{reading.frame_ms:.1f} of {BUDGET_NS / 1e6:.0f} ms of work each"
            yield f"{reading.frames_per_second:.0f} frames a second, {work}"
            yield _told(reading, session)
            yield _books(self._stats, "Grains" if session.rule.codes.is_sand else "Cells")
        known = f" of {session.reached:,} computed" if session.now < session.reached else ""
        yield f"Iteration {session.now:,}{known}"
        yield f"Memory for the past: {session.past_bytes / MEGABYTE:.1f} of {session.memory_mb:,.0f} MB"


def _books(stats, what):
    """Return the books of the grains, or of the cells, at the latest reading."""
    account, grains = stats.account, sum(stats.grains)
    books = " ".join(f"{sign} {number:,} {word}".strip() for sign, word, number in account.lines)
    return f"{what}: {books}" + ("" if account.agrees(stats.grains) else f", but there are {grains:,}")


def _told(reading, session):
    """Return how fast the sand runs, and why it is not faster."""
    if session.paused:
        return "Paused"
    if reading.done >= reading.due:
        return f"{counted(reading.done, 'iteration')} a second"
    return f"{reading.done:,.0f} of {reading.due:,.0f} iterations a second: {FULL if reading.full else BUSY}"
