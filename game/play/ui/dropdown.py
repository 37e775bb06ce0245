"""The drop-down choice: a box that shows the chosen option, and the list that opens over what follows."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.controls import GAP, INSET, PUSH_KEYS, ROW, body
from game.play.ui.input import ENTER
from game.play.ui.scroll import thumb

LIST_ROW = 26
MOVE_KEYS = {pygame.K_UP: -1, pygame.K_DOWN: 1, pygame.K_PAGEUP: -8, pygame.K_PAGEDOWN: 8}
OPEN_KEYS = PUSH_KEYS | {pygame.K_UP, pygame.K_DOWN}


class Popup:
    """The open list of one choice: where it is, which rows show, and which is lit."""

    keys = frozenset(MOVE_KEYS) | {pygame.K_HOME, pygame.K_END, ENTER}

    def __init__(self, name, chosen):
        self.name = name
        self.chosen = self.lit = chosen
        self.first = 0  # the uppermost row that shows
        self.rect = pygame.Rect(0, 0, 0, 0)  # empty until it has been laid out
        self.box = self.rect
        self.options = ()
        self.row_height = 1

    @property
    def shown(self):
        """How many rows there is room for."""
        return self.rect.height // self.row_height

    def row_at(self, pos):
        """Return the index of the option at a place, or None."""
        index = self.first + (pos[1] - self.rect.y) // self.row_height
        return index if self.rect.collidepoint(pos) and index < len(self.options) else None

    def light(self, index):
        """Light an option, and scroll it into the list's view."""
        self.lit = min(max(index, 0), len(self.options) - 1)
        self.first = min(max(self.first, self.lit - self.shown + 1), self.lit)

    def turn(self, rows):
        """Scroll the list by a number of rows."""
        self.first = min(max(self.first + rows, 0), max(0, len(self.options) - self.shown))

    def lay_out(self, theme, view):
        """Take room below the box, or above it where there is more; `view` is what shows of the column."""
        margin, self.row_height = theme.px(4), theme.px(LIST_ROW)
        below, above = view.bottom - self.box.bottom - 2 * margin, self.box.top - view.top - 2 * margin
        wanted = len(self.options) * self.row_height
        goes_down = below >= min(wanted, 4 * self.row_height) or below >= above
        rows = max(1, min(wanted, below if goes_down else above) // self.row_height)
        height = rows * self.row_height
        top = self.box.bottom + margin if goes_down else self.box.top - margin - height
        was_empty = not self.rect.height
        self.rect = pygame.Rect(self.box.x, top, self.box.width, height)
        if was_empty:
            self.first = self.lit - rows // 2
        self.turn(0)

    def strokes(self, theme):
        """Return the drawing of the list."""
        px = theme.px
        edge = self.rect.inflate(2 * px(1), 2 * px(1))
        yield draw_list.box, edge, look.EDGE, px(4)
        yield draw_list.box, self.rect, look.RAISED, px(4)
        for row in range(self.shown):
            index = self.first + row
            place = pygame.Rect(self.rect.x, self.rect.y + row * self.row_height, self.rect.width, self.row_height)
            if index == self.lit:
                yield draw_list.box, place, look.ACCENT, px(4)
            colour = look.SUNKEN if index == self.lit else look.BRIGHT_ACCENT if index == self.chosen else look.TEXT
            yield draw_list.words, place.inflate(-2 * px(INSET), 0), self.options[index], look.BODY, colour, 0
        track = pygame.Rect(self.rect.right - px(5), self.rect.y, px(3), self.rect.height)
        yield from thumb(theme, track, self.first, self.shown, len(self.options), look.FAINT)


def choice(ui, label, options, index, tip="", name=None):
    """Show one option out of many, with a list to choose from; return the index of the chosen one."""
    px, label_width = ui.theme.px, max(ui.label_width, min(ui.theme.width(f"{label}  ", look.BODY), ui.width // 2))
    rect = ui.place(px(ROW), px(GAP))
    box = pygame.Rect(rect.x + label_width, rect.y, rect.width - label_width, rect.height)
    me = ui.claim(name or label, rect, ring=box, keys=OPEN_KEYS, tip=tip)
    for event in me.events:
        index = _handle(ui.focus, me.name, event, options, index)
    popup = ui.focus.popup
    if popup and popup.name == me.name:
        popup.box, popup.options = rect, options
    body(ui, box, me)
    inner = box.inflate(-2 * px(INSET), 0)
    size = px(10)
    chevron = pygame.Rect(inner.right - size, rect.centery - size // 2, size, size)
    ui.stroke(draw_list.polygon, chevron, draw_list.CHEVRON_DOWN, look.TEXT if me.hover else look.DIM)
    words = pygame.Rect(inner.x, inner.y, chevron.x - px(4) - inner.x, inner.height)
    aside = pygame.Rect(rect.x, rect.y, label_width, rect.height)
    ui.stroke(draw_list.words, aside, label, look.BODY, look.TEXT, 0)
    ui.stroke(draw_list.words, words, options[index], look.BODY, look.TEXT, 0)
    return index


def _handle(focus, name, event, options, index):
    """Open, move in, or close the list; return the index chosen after the event."""
    popup = focus.popup if focus.popup and focus.popup.name == name else None
    if popup is None:
        if event.kind == "press" or event.kind == "key":
            focus.popup = Popup(name, index)
            focus.popup.options = options
        return index
    chosen = None
    if event.kind == "key":
        chosen = _key(popup, event)
    elif event.kind == "wheel":
        popup.turn(-round(event.notches) or (-1 if event.notches > 0 else 1))
    elif popup.row_at(event.pos) is not None:
        popup.lit = popup.row_at(event.pos)
        chosen = popup.lit if event.kind == "release" else None
    if chosen is None:
        return index
    focus.popup = None
    return chosen


def _key(popup, event):
    """Move the light; return the option it is on if the key takes it."""
    if event.key == ENTER or event.key == pygame.K_SPACE:
        return popup.lit
    if event.key in MOVE_KEYS:
        popup.light(popup.lit + MOVE_KEYS[event.key])
    elif event.key in (pygame.K_HOME, pygame.K_END):
        popup.light(0 if event.key == pygame.K_HOME else len(popup.options) - 1)
    elif event.text:
        popup.light(_next_with(popup.options, event.text, popup.lit))
    return None


def _next_with(options, letter, lit):
    """Return the next option after `lit` that begins with the letter, round the end; `lit` if there is none."""
    order = [(lit + 1 + i) % len(options) for i in range(len(options))]
    return next((i for i in order if options[i].casefold().startswith(letter.casefold())), lit)
