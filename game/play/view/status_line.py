"""The status line: says calmly under the sand how fast it runs and how many grains there are, and what happened."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look

GAP = "    "
KEY = "F1  all keys"
BESIDE = 12  # pixels at scale 1 between the words and those at the right
NEAR = 0.05  # a speed that differs less from the one that is set is shown as that: the line keeps still


class StatusLine:
    """Says what matters of the FrameStats; the StatsCard tells the rest."""

    def __init__(self, stats):
        self._stats = stats
        self._written = None  # the Reading that the words are of
        self._material = ""  # … and the material
        self._pace = self._grains = ""
        self._alarm = False  # something is to be noticed

    def update(self, session, material):
        """Write the words anew, if they are of another reading or material.

        material: the one to tell of, where there are several.
        """
        reading, grains, account = self._stats.reading, self._stats.grains, self._stats.account
        if reading is self._written and (reading is None or material == self._material):
            return
        self._written, self._material, balanced = reading, material, account.agrees(grains)
        self._pace, self._grains = _pace(reading, session), _told(grains, account, session.rule.codes, material)
        self._alarm = (reading.full and not session.paused) or not balanced

    def drawing(self, theme, rect, session, said="", aside="", notice=None, badge=""):
        """Return the strokes of the line in `rect`: a value that changes only when the line does.

        said: goes first, and is to be noticed. aside: goes first where nothing is said. notice: (text, whether it
        tells of trouble) or None; it has the upper row, or both if it is long. badge: words at the right, or "".
        """
        px = theme.px
        words = pygame.Rect(rect).inflate(-2 * px(12), 0)
        if not notice:
            strokes = [(draw_list.fill, tuple(rect), look.SUNKEN)]
            return strokes + self._words(theme, words, session, said, aside, badge)
        rows, size = _rows(theme, notice[0], words.width)
        upper, lower = pygame.Rect(words), pygame.Rect(words)
        upper.height = words.height // 2
        lower.y, lower.height = upper.bottom, words.height - upper.height
        colour = look.BRIGHT_ACCENT if notice[1] else look.TEXT
        strokes = [(draw_list.fill, tuple(rect), look.RAISED)]
        strokes += [
            (draw_list.words, tuple(each), row, size, colour, 0)
            for each, row in zip((upper, lower), rows, strict=False)
        ]
        return strokes + (self._words(theme, lower, session, said, aside, badge) if len(rows) == 1 else [])

    def _words(self, theme, words, session, said, aside, badge):
        """Return the strokes of what the line says when nothing has happened."""
        px, badge_strokes = theme.px, []
        if badge:
            badge_strokes = [(draw_list.words, tuple(words), badge, look.SMALL, look.TEXT, 1)]
            words = pygame.Rect(words)
            words.width = max(0, words.width - theme.width(badge, look.SMALL) - px(BESIDE))
        first = [said or aside] if said or aside else []
        if session.now < session.reached:
            first.append(f"Iteration {session.now:,} of {session.reached:,}")
        text = self._fitting(theme, first, "Paused" if session.paused else self._pace, words.width)
        colour = look.ACCENT if said or self._alarm else look.DIM
        line = [*badge_strokes, (draw_list.words, tuple(words), text, look.SMALL, colour, 0)]
        if not badge and theme.width(text, look.SMALL) + px(24) + theme.width(KEY, look.SMALL) <= words.width:
            line.append((draw_list.words, tuple(words), KEY, look.SMALL, look.FAINT, 1))
        return line

    def _fitting(self, theme, first, pace, room):
        """Return as much of the line as there is room for."""
        if self._written is None:
            return GAP.join(first)
        short = pace.partition(":")[0]
        lines = [GAP.join(each) for each in ([*first, pace, self._grains], [*first, pace], first or [short]) if each]
        return next((line for line in lines if theme.width(line, look.SMALL) <= room), lines[-1])


def _rows(theme, text, room):
    """Return (text in one row or two, their size); of a text that is still too long the middle is left out."""
    if theme.width(text, look.BODY) <= room:
        return [text], look.BODY
    rows, kept = theme.lines(text, look.SMALL, room), len(text)
    while len(rows) > 2 and kept > 4:
        kept -= 4
        rows = theme.lines(f"{text[: kept // 2]}…{text[-(kept // 2) :]}", look.SMALL, room)
    return rows[:2], look.SMALL


def _pace(reading, session):
    """Return how fast the sand runs, in words."""
    if session.settled:
        return "The sand is at rest" if session.rule.codes.is_sand else "All is at rest"
    if reading.full:
        return f"{reading.done:,.0f} of {reading.due:,.0f} iterations a second: all this computer can do"
    speed = session.clock.speed
    near = abs(reading.done - speed) <= max(NEAR * speed, 1 / reading.seconds)
    return counted(speed if near else reading.done, "iteration") + " a second"


def _told(now, account, codes, material):
    """Return how much there is, and what is wrong where the account, by kind like it, tells of something else."""
    if codes.is_sand:
        said = counted(sum(now), "grain")
    elif material in codes.told and (own := sum(now[code] for code in codes.codes_of(material))):
        said = f"{counted(own, 'cell')} of {material}"
    else:
        said = f"{counted(sum(now), 'cell')} of all materials"
    if account.agrees(now):
        return said
    wrong = (
        f"but {account.expected:,} in the account"
        if sum(now) != account.expected
        else f"of wrong {'colours' if codes.is_sand else 'materials'}"
    )
    return f"{said}, {wrong}"


def counted(number, what):
    """Return '1 grain', '2,000 grains', '1.5 iterations'."""
    digits = f"{number:,.0f}" if number >= 10 or number == round(number) else f"{number:.2g}"
    return f"{digits} {what}{'' if digits == '1' else 's'}"
