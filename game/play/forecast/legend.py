"""The legend: what the colours of a forecast mean, which iteration it is for, and how accurate it is."""

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.card import box_strokes
from game.world.background.forecast_thread import standard_error
from game.world.looks.heatmap_colours import scale_over_air

AWAY, PAD = 4, 8  # pixels at scale 1 around the card and in it
TITLE, BAR, GAP = 22, 9, 4  # heights in pixels at scale 1
REFRESH_S = 0.2  # numbers that follow the sand are written anew so often, so that they can be read
UNKNOWN = "Forecast", "Computing the first runs …"


class Legend:
    """A card beside the sand, or below it."""

    def __init__(self, sessions, display, pointer):
        """`pointer.place` is where the pointer is over the sand, in pixels, or None."""
        self._sessions, self._display, self._pointer = sessions, display, pointer
        self.lines = UNKNOWN  # the title, and the lines under the bar
        self._written_s = None
        self._about = None, False  # the Forecast that the lines tell of, and whether it is stale

    def update(self, answer, stale, now_s):
        """Write the lines anew for a Forecast or None, if it is time."""
        if (answer, stale) == self._about and self._written_s is not None and now_s - self._written_s < REFRESH_S:
            return
        self.lines = self._write(answer)
        self._about, self._written_s = (answer, stale), now_s

    def drawing(self, theme, rect):
        """Return the strokes of the card in `rect`, as high as its lines, of which there are those with room."""
        title, *lines = self.lines
        return scale_card(theme, rect, title, lines, stale=self._about[1])

    def _write(self, answer):
        if answer is None:
            return UNKNOWN
        session, request = self._sessions.now, answer.request
        ago = session.world.iteration - request.crop.iteration
        lines = [
            f"{request.of.capitalize()} at iteration {session.now - ago + request.ahead:,}",
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
        column, row = self._display.sand_view.view.place(*self._pointer.place)
        box = answer.request.crop.box
        x, y = int(column) - box.left, int(row) - box.top
        if not (0 <= y < box.height and 0 <= x < box.width):
            return ""
        share = int(answer.counts[y, x]) / answer.runs
        error = 0.0 if answer.certain else standard_error(share, answer.runs)
        return f"Here {100 * share:.1f} ± {100 * error:.1f} %"


def scale_card(theme, rect, title, lines, stale=False):
    """Return the strokes of a card in `rect` with the colours from never to always and what is to be said of them.

    It is as high as those of the lines that there is room for.
    """
    px, line = theme.px, theme.line_height(look.SMALL)
    card = rect.inflate(-2 * px(AWAY), -2 * px(AWAY))
    head = 2 * px(PAD) + px(TITLE) + px(BAR) + line + px(GAP)
    lines = [row for text in lines for row in theme.lines(text, look.SMALL, card.width - 2 * px(PAD))]
    lines = lines[: max(0, (card.height - head) // line)]
    card.height = min(card.height, head + len(lines) * line)
    row = card.inflate(-2 * px(PAD), -2 * px(PAD))
    row.height = px(TITLE)
    strokes = box_strokes(theme, card, rect)
    size = look.HEADING if theme.width(title, look.HEADING) <= row.width else look.SMALL
    strokes.append((draw_list.words, tuple(row), title, size, look.HANDLE, 0))
    if stale:
        strokes.append((draw_list.words, tuple(row), "stale", look.BODY, look.BRIGHT_ACCENT, 1))
    row.y, row.height = row.bottom, px(BAR)
    strokes.append((draw_scale, tuple(row), stale))
    row.y, row.height = row.bottom, line
    for share, align in (("never", 0), ("50 %", 0.5), ("always", 1)):
        strokes.append((draw_list.words, tuple(row), share, look.SMALL, look.FAINT, align))
    row.y += line + px(GAP)
    for text in lines:
        strokes.append((draw_list.words, tuple(row), text, look.SMALL, look.DIM, 0))
        row.y += line
    return strokes


def _accuracy(answer):
    if answer.certain:
        return "Nothing is left to chance"
    return f"{answer.runs:,} runs: ± {100 * answer.error:.1f} % at most"


def _iterations(number):
    return f"{number:,} iteration{'' if number == 1 else 's'}"


def draw_scale(surface, theme, rect, stale):
    """Draw the colours from never to always as they look over air, from left to right."""
    colours, (left, top, width, height) = scale_over_air(theme.colours, stale).tolist(), rect
    for x in range(width):
        surface.fill(colours[x * (len(colours) - 1) // max(1, width - 1)], (left + x, top, 1, height))
