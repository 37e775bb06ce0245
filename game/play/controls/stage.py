"""The stage: a window for a class, without panel and small print, with what the player chose in large letters."""

from datetime import datetime

import pygame

from game.play.timer.timer import RUNNING
from game.play.ui import draw_list, large_words
from game.play.ui import theme as look
from game.play.window.large_pointer import show_large, show_usual

ITERATION, P, PARTITION, CLOCK = LINES = "iteration", "p", "partition", "clock"
# Of the window's height, what the end of the stage, the large letters and those of a running timer take.
LEAST_HEIGHT, HEIGHT, TIMER_HEIGHT = 0.05, 0.16, 0.24
CLOCK_SHARE = 0.38  # of their width, at most, for the clock
PAD = 0.12  # of their height, around them
GAP = "     "
END = "End the stage"  # where no line was chosen
HINT = "F5, Esc or a click here ends the stage. P shows the panel: View says which lines stand here."


class Stage:
    """Which lines stand below the sand, and what they say."""

    def __init__(self, sessions, display, settings, timer, notices):
        self._sessions, self._display, self._settings = sessions, display, settings
        self._timer, self._notices = timer, notices
        self._panel_shown = True  # before the stage

    @property
    def on(self):
        """Whether the window is one for a class."""
        return self._display.on_stage

    def toggle(self):
        """Put panel and small print away, or bring them back."""
        display = self._display
        if self.on:
            display.on_stage, display.panel_shown = False, self._panel_shown
            show_usual()
        else:
            self._panel_shown, display.panel_shown, display.on_stage = display.panel_shown, False, True
            show_large(self._settings["ui_scale"])
            self._notices.say(HINT, holds=lambda: self.on)
        display.lay_out_anew()

    @property
    def height(self):
        """The height in pixels of what stands below the sand; a timer in full screen has its clock there."""
        share = HEIGHT if self._settings["stage_lines"] or self._notices.line else LEAST_HEIGHT
        if self._tells_timer:
            share = TIMER_HEIGHT
        return round(share * self._display.window.size[1]) if self.on or self._has_clock else 0

    @property
    def _has_clock(self):
        return self._display.window.fullscreen and self._timer.state == RUNNING

    @property
    def _tells_timer(self):
        chosen = CLOCK in self._settings["stage_lines"] if self.on else self._has_clock
        return chosen and self._timer.state == RUNNING

    def drawing(self, theme, rect):
        """Return the strokes of the large letters."""
        strokes = [(draw_list.fill, tuple(rect), look.SUNKEN)]
        room = pygame.Rect(rect).inflate(-2 * round(PAD * rect.height), -2 * round(PAD * rect.height))
        clock = self._clock()
        if clock:
            wide = round(CLOCK_SHARE * room.width) if self.on else room.width
            size = large_words.fitting_size(theme, [clock], (wide, room.height))
            align = 1 if self.on else 0.5
            strokes.append((large_words.large_words, tuple(room), clock, size, look.BRIGHT_HANDLE, align))
            room.width -= large_words.width(theme, clock, size) + 2 * (room.x - rect.x)
        if self.on and self._notices.line:
            return strokes + _notice(theme, room, *self._notices.line)
        lines = self._lines() or [END] * (not clock)
        return strokes + (_in_rows(theme, room, lines) if self.on and lines else [])

    def _lines(self):
        """Return what is said of the world, as far as the player chose it."""
        session, chosen = self._sessions.now, self._settings["stage_lines"]
        number = len(session.rule.offsets)
        lines = {ITERATION: f"iteration {session.world.iteration:,}"}
        if session.rule.leans and len(session.sessions) == 1:
            lines[P] = f"p = {session.rule.p:.4g}"
        lines[PARTITION] = f"partition {session.world.iteration % number + 1} of {number}"
        return [text for name, text in lines.items() if name in chosen]

    def _clock(self):
        """Return what the clock says: what is left of the timer, or else the time of day."""
        if self._tells_timer:
            return self._timer.clock_words
        return f"{datetime.now():%H:%M}" if self.on and CLOCK in self._settings["stage_lines"] else ""


def _in_rows(theme, room, lines):
    """Return the strokes of lines in so few rows that they are as large as can be."""
    ways = []
    for rows in range(1, len(lines) + 1):
        count = -(-len(lines) // rows)
        written = [GAP.join(lines[first : first + count]) for first in range(0, len(lines), count)]
        ways.append((large_words.fitting_size(theme, written, room.size), written))
    size, written = max(ways, key=lambda way: way[0])
    high = room.height / len(written)
    return [
        (
            large_words.large_words,
            (room.x, round(room.y + number * high), room.width, round(high)),
            *(line, size, look.TEXT, 0),
        )
        for number, line in enumerate(written)
    ]


def _notice(theme, room, text, trouble):
    """Return the strokes of a notice, in as large letters as it has room for in three rows."""
    for size in range(room.height // 3, look.SMALL, -1):
        rows = theme.lines(text, size, room.width)
        if len(rows) * theme.line_height(size) <= room.height:
            break
    high, colour = theme.line_height(size), look.BRIGHT_ACCENT if trouble else look.TEXT
    return [
        (draw_list.words, (room.x, room.y + number * high, room.width, high), row, size, colour, 0)
        for number, row in enumerate(rows)
    ]
