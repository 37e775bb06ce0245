"""The dialog: a question over the sand, which goes on meanwhile; it can be answered, or left alone."""

from typing import NamedTuple

import pygame

from game.play.ui.card import Card

WIDTH = 420  # pixels at scale 1
TOP = 16
NO_MODS = pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META


class Answer(NamedTuple):
    """One way to answer."""

    label: str
    act: object  # a function without arguments, or None to do nothing
    key: int
    key_label: str
    tip: str = ""


class Dialog:
    """The question that is open, if any."""

    def __init__(self, display):
        self._display = display
        self._card = None
        self._title = self._text = ""
        self._answers = ()

    @property
    def shown(self):
        """Whether a question is open."""
        return self._card is not None

    @property
    def ui(self):
        """The controls."""
        return self._card.ui

    def let_go(self):
        """Let go of the button that is held."""
        if self.shown:
            self.ui.let_go()

    def ask(self, title, text, answers):
        """Open a question in place of the one before."""
        self._title, self._text, self._answers = title, text, answers
        self._card = Card(self._display.theme, WIDTH)
        self._display.refresh()

    def handle_events(self, events, now_s, mouse_pos):
        """Take the answer, if one is among the events, and return the events that are not the question's."""
        rest = self._card.lay_out(self._display, self._display.theme.px(TOP), events, now_s, mouse_pos)
        ui, chosen = self.ui, None
        ui.heading(self._title)
        ui.text(self._text)
        ui.row(len(self._answers))
        for answer in self._answers:
            if ui.button(answer.label, key=answer.key_label, tip=answer.tip):
                chosen = answer
        others = [event for event in rest if not (chosen is None and self._by_key(event))]
        by_key = next((self._by_key(event) for event in rest if self._by_key(event)), None)
        if chosen or by_key:
            self._close(chosen or by_key)
        return others

    def draw(self, surface, theme, area):
        """Draw the question; return the rects that it covers."""
        return self._card.draw(surface, theme)

    def _by_key(self, event):
        if event.type != pygame.KEYDOWN or event.mod & NO_MODS:
            return None
        return next((answer for answer in self._answers if answer.key == event.key), None)

    def _close(self, answer):
        self._card = None
        self._display.refresh()
        if answer.act:
            answer.act()
