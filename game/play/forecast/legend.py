"""The legend: what the colours of a forecast mean, which iteration it is for, and how accurate it is."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.card import draw_box
from game.world.background.forecast_thread import standard_error
from game.world.looks.heatmap_colours import scale_over_air

WIDTH = 226  # pixels at scale 1, with everything in it
PAD = 10
AWAY = 12  # from the corner of the sand
BAR = 9
REFRESH_S = 0.2  # numbers that follow the sand are written anew so often, so that they can be read
UNKNOWN = "Forecast", "Computing the first runs …"


class Legend:
    """A card in the upper left corner of the sand, where there is room for it."""

    def __init__(self, sessions, display, pointer):
        """`pointer.place` is where the pointer is over the sand, in pixels, or None."""
        self._sessions, self._display, self._pointer = sessions, display, pointer
        self.lines = UNKNOWN  # the title, and the lines under the bar
        self._written_s = None
        self._about = None, False  # the Forecast that the lines tell of, and whether it is stale

    def update(self, answer, stale, now_s):
        """Write the lines anew for a Forecast or None, if it is time; return whether they have changed."""
        if (answer, stale) == self._about and self._written_s is not None and now_s - self._written_s < REFRESH_S:
            return False
        before, self.lines = self.lines, self._write(answer)
        self._about, self._written_s = (answer, stale), now_s
        return self.lines != before

    def draw(self, surface, theme, area):
        """Draw the card, where there is room for it; return the rects that it covers."""
        px, line = theme.px, theme.line_height(look.SMALL)
        sand, away, wide = self._display.stage.area, px(AWAY), px(WIDTH)
        rect = pygame.Rect(min(sand.x + away, area.right - away - wide), sand.y + away, wide, 0)
        title, *lines = self.lines if 2 * rect.width <= area.width else self.lines[:2]
        rect.height = 2 * px(PAD) + px(24) + px(BAR) + line + px(4) + line * len(lines)
        if rect.x < area.x + away or 2 * rect.height > area.height:
            return []
        covered = draw_box(surface, theme, rect.inflate(-2 * px(5), -2 * px(5)))
        (_, stale), row = self._about, rect.inflate(-2 * px(PAD), -2 * px(PAD))
        row.height = px(20)
        draw_list.words(surface, theme, row, title, look.HEADING, look.HANDLE, 0)
        if stale:
            draw_list.words(surface, theme, row, "stale", look.BODY, look.BRIGHT_ACCENT, 1)
        row.y, row.height = row.y + px(24), px(BAR)
        draw_scale(surface, theme, row, stale)
        row.y, row.height = row.bottom, line
        for share, align in (("never", 0), ("50 %", 0.5), ("always", 1)):
            draw_list.words(surface, theme, row, share, look.SMALL, look.FAINT, align)
        row.y += line + px(4)
        for text in lines:
            draw_list.words(surface, theme, row, text, look.SMALL, look.DIM, 0)
            row.y += line
        return covered

    def _write(self, answer):
        if answer is None:
            return UNKNOWN
        session, request = self._sessions.now, answer.request
        ago = session.world.iteration - request.start
        lines = [
            f"Sand at iteration {session.now - ago + request.ahead:,}",
            _accuracy(answer),
            f"{_iterations(request.ahead)} ahead",
            f"Computed {_iterations(ago)} ago" if ago else "Computed now",
            self._under_pointer(answer),
        ]
        box, exact = request.crop.box, request.about[0].exact
        if (box.height, box.width) != session.world.shape:
            cells = f"{box.width:,}×{box.height:,} cells"
            lines += [f"Of the {cells} in sight"] if exact else [f"Only the middle {cells},", "as if walled in"]
        return tuple(line for line in lines if line)

    def _under_pointer(self, answer):
        """Return what the forecast says of the cell under the pointer, or ""."""
        if self._pointer.place is None:
            return ""
        column, row = self._display.stage.view.place(*self._pointer.place)
        box = answer.request.crop.box
        x, y = int(column) - box.left, int(row) - box.top
        if not (0 <= y < box.height and 0 <= x < box.width):
            return ""
        share = int(answer.counts[y, x]) / answer.runs
        error = 0.0 if answer.certain else standard_error(share, answer.runs)
        return f"Here {100 * share:.1f} ± {100 * error:.1f} %"


def _accuracy(answer):
    if answer.certain:
        return "Nothing is left to chance"
    return f"{answer.runs:,} runs: ± {100 * answer.error:.1f} % at most"


def _iterations(number):
    return f"{number:,} iteration{'' if number == 1 else 's'}"


def draw_scale(surface, theme, rect, stale):
    """Draw the colours from never to always as they look over air, from left to right."""
    colours = scale_over_air(theme.colours, stale).tolist()
    for x in range(rect.width):
        surface.fill(colours[x * (len(colours) - 1) // max(1, rect.width - 1)], (rect.x + x, rect.y, 1, rect.height))
