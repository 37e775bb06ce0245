"""The recovery: every session has a journal, and one that ended without a word can be gone on with."""

from datetime import datetime
from functools import partial

import pygame

from game.play.view.dialog import Answer
from game.world.sessions import journal
from game.world.sessions.journal import Journal
from game.world.sessions.session import SEEK_NS, Session


class Recovery:
    """Keeps the journals of the window's sessions, and offers what a crash left."""

    def __init__(self, toy):
        self._toy = toy

    def start(self):
        """Keep journals from now on, and look for one that a crash left."""
        toy = self._toy
        toy.journals.keep()
        toy.journals.begin(toy.sessions.now, toy.sessions.now.timeline.history.story())
        toy.background.do(lambda: next(journal.unfinished(), None), self._offer)

    def _offer(self, path):
        if path is None:
            return
        when = datetime.fromtimestamp(path.stat().st_mtime)
        text = f"A session of {when:%d %B, %H:%M}, was cut off. Nothing of it is lost: it can go on where it was."
        answers = (
            Answer("Go on", partial(self._go_on, path), pygame.K_RETURN, "Enter"),
            Answer("Later", None, pygame.K_ESCAPE, "Esc"),
            Answer("Let it go", partial(self._let_go, path), pygame.K_DELETE, "Del"),
        )
        self._toy.question.ask("Go on where you were?", text, answers)

    def _go_on(self, path):
        self._toy.background.do(partial(Journal.resume, path), self._take_up)

    def _take_up(self, found):
        toy = self._toy
        session = Session.retold(found[1])
        session.journal = found[0]
        session.paused = True
        toy.sessions.open(session)
        session.seek(found[1].end, SEEK_NS)
        toy.notices.say(found[1].problem or "Here you were. Space lets time go on.")

    def _let_go(self, path):
        self._toy.background.do(partial(journal.finish, path))
