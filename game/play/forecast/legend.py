"""The legend: what the colours of a forecast mean, for when it is, and how sure."""

import pygame

from game.core.draw.cells import AIR
from game.core.draw.heatmap import ALWAYS
from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.card import draw_box
from game.world.looks.heatmap_colours import over

WIDTH = 226  # pixels at scale 1, with everything in it
PAD = 10
AWAY = 12  # from the corner of the sand
BAR = 9
REFRESH_S = 0.2  # numbers that follow the sand are written anew so often, so that they can be read
UNKNOWN = "Forecast", "Computing the first runs …"


class Legend:
    """The card of a Forecasting, in the upper left corner of the stage, as far as there is room."""

    def __init__(self, toy, forecasting):
        self._toy, self._forecasting = toy, forecasting
        self._lines = UNKNOWN
        self._written_s = None
        self._about = None  # the answer that the lines tell of, and whether it is stale

    def changed(self, now_s):
        """Write the lines anew if it is time; return whether they say something else."""
        about = self._forecasting.answer, self._forecasting.stale
        if about == self._about and self._written_s is not None and now_s - self._written_s < REFRESH_S:
            return False
        before, self._lines = self._lines, self._write()
        self._about, self._written_s = about, now_s
        return self._lines != before

    @property
    def lines(self):
        """What the card says: the title, and line by line what stands under the bar."""
        return self._lines

    def draw(self, surface, theme, area):
        """Draw the card, where there is room for it; return the rects that it covers."""
        px, line = theme.px, theme.line_height(look.SMALL)
        stage, away, wide = self._toy.display.stage.area, px(AWAY), px(WIDTH)
        rect = pygame.Rect(min(stage.x + away, area.right - away - wide), stage.y + away, wide, 0)
        title, *lines = self._lines if 2 * rect.width <= area.width else self._lines[:2]
        rect.height = 2 * px(PAD) + px(24) + px(BAR) + line + px(4) + line * len(lines)
        if rect.x < area.x + away or 2 * rect.height > area.height:
            return []
        covered = draw_box(surface, theme, rect.inflate(-2 * px(5), -2 * px(5)))
        stale, row = self._forecasting.stale, rect.inflate(-2 * px(PAD), -2 * px(PAD))
        row.height = px(20)
        draw_list.words(surface, theme, row, title, look.HEADING, look.HANDLE, 0)
        if stale:
            draw_list.words(surface, theme, row, "stale", look.BODY, look.BRIGHT_ACCENT, 1)
        row.y, row.height = row.y + px(24), px(BAR)
        _draw_bar(surface, theme, row, stale)
        row.y, row.height = row.bottom, line
        for share, align in (("never", 0), ("50 %", 0.5), ("always", 1)):
            draw_list.words(surface, theme, row, share, look.SMALL, look.FAINT, align)
        row.y += line + px(4)
        for text in lines:
            draw_list.words(surface, theme, row, text, look.SMALL, look.DIM, 0)
            row.y += line
        return covered

    def _title(self):
        answer, session = self._forecasting.answer, self._toy.sessions.now
        goal = session.now - session.world.iteration + answer.request.start + answer.request.ahead
        return f"Sand at iteration {goal:,}"

    def _write(self):
        answer, shape = self._forecasting.answer, self._toy.sessions.now.world.shape
        if answer is None:
            return UNKNOWN
        ago = self._toy.sessions.now.world.iteration - answer.request.start
        when = f"{_iterations(answer.request.ahead)} ahead", f"Computed {f'{_iterations(ago)} ago' if ago else 'now'}"
        lines = [self._title(), _said_of_runs(answer), *when, self._here()]
        part, exact = answer.request.crop.box, answer.request.about[0].exact
        if (part.height, part.width) != shape:
            cells = f"{part.width:,}×{part.height:,} cells"
            lines += [f"Of the {cells} in sight"] if exact else [f"Only the middle {cells},", "as if walled in"]
        return tuple(line for line in lines if line)

    def _here(self):
        """Return what the forecast says of the cell under the pointer."""
        pointer = self._toy.hearing.pointer
        if pointer is None:
            return ""
        column, row = self._toy.display.stage.view.place(*pointer)
        found = self._forecasting.share_at(int(row), int(column))
        return "" if found is None else f"Here {100 * found[0]:.1f} ± {100 * found[1]:.1f} %"


def _said_of_runs(answer):
    if answer.certain:
        return "Nothing is left to chance"
    return f"{answer.runs:,} runs: ± {100 * answer.error:.1f} % at most"


def _iterations(number):
    return f"{number:,} iteration{'' if number == 1 else 's'}"


def _draw_bar(surface, theme, rect, stale):
    """Draw the scale as it looks over air, as it does in the picture."""
    colours = over(theme.colours.air[AIR].dark, stale)
    for x in range(rect.width):
        colour = colours[x * ALWAYS // max(1, rect.width - 1)].tolist()
        surface.fill(colour, (rect.x + x, rect.y, 1, rect.height))
