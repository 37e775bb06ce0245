"""The name card: asks for a name over the sand, which goes on meanwhile."""

import pygame

from game.play.ui.card import Card
from game.play.ui.text_line import TextLine

WIDTH = 360  # pixels at scale 1
TOP = 16
FIELD = "Name"
ANSWERS = {pygame.K_RETURN: True, pygame.K_KP_ENTER: True, pygame.K_ESCAPE: False}  # whether the name is taken


class NameCard:
    """The question for a name, if one is open."""

    def __init__(self, display):
        self._display = display
        self._card = self._title = self._line = self._then = None

    @property
    def shown(self):
        """Whether a name is being asked for."""
        return self._card is not None

    @property
    def ui(self):
        """The controls."""
        return self._card.ui

    def let_go(self):
        """Let go of the button that is held."""
        if self.shown:
            self.ui.let_go()

    def ask(self, title, name, then):
        """Ask for a name, and offer one; then(name) is called with what is taken."""
        self._title, self._line, self._then = title, TextLine(name), then
        self._card = Card(self._display.theme, WIDTH)
        self._card.ui.focus.name = FIELD
        self._display.refresh()

    def handle_events(self, events, now_s, mouse_pos):
        """Take what is typed, and the answer; return the events that are not the card's."""
        rest = self._card.lay_out(self._display, self._display.theme.px(TOP), events, now_s, mouse_pos)
        ui = self.ui
        ui.heading(self._title)
        self._line = ui.text_field(FIELD, self._line)
        ui.row(2)
        taken, cancelled = ui.button("Save", key="Enter"), ui.button("Cancel", key="Esc")
        keys = [event.key for event in rest if event.type == pygame.KEYDOWN and event.key in ANSWERS]
        if taken or cancelled or keys:
            self._answer(taken or (not cancelled and ANSWERS[keys[0]]))
        return [event for event in rest if not (event.type == pygame.KEYDOWN and event.key in ANSWERS)]

    def draw(self, surface, theme, area):
        """Draw the card; return the rects that it covers."""
        return self._card.draw(surface, theme)

    def _answer(self, taken):
        name, then, self._card = self._line.text.strip(), self._then, None
        self._display.refresh()
        if taken:
            then(name)
