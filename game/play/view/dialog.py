"""The dialog: a question over the sand, which goes on meanwhile; it can be answered, or left alone."""

from typing import NamedTuple

import pygame

from game.play.ui.card import Card

NO_MODS = pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META


class Answer(NamedTuple):
    """One way to answer."""

    label: str
    act: object  # a function without arguments, or None to do nothing
    key: int
    key_label: str
    tip: str = ""


class Dialog(Card):
    """The question that is open, if any."""

    width = 420

    def __init__(self, display):
        super().__init__(display)
        self._title = self._text = ""
        self._answers = ()

    def ask(self, title, text, answers):
        """Open a question in place of the one before."""
        self._title, self._text, self._answers = title, text, answers
        self._open()

    def handle_events(self, events, now_s, mouse_pos):
        """Take the answer, if one is among the events, and return the events that are not the question's."""
        rest = self._lay_out(events, now_s, mouse_pos)
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
            self._take(chosen or by_key)
        return others

    def _by_key(self, event):
        if event.type != pygame.KEYDOWN or event.mod & NO_MODS:
            return None
        return next((answer for answer in self._answers if answer.key == event.key), None)

    def _take(self, answer):
        self._close()
        if answer.act:
            answer.act()
