"""Crash recovery: offers to resume the last session, whether it was cut off or its window was closed."""

from datetime import datetime
from functools import partial

import pygame

from game.play.view.dialog import Answer
from game.world.background.rule_warmup import make_recording_ready
from game.world.sessions import journal
from game.world.sessions.journal import Journal
from game.world.sessions.session import SEEK_NS, Session


class CrashRecovery:
    """Keeps journals from the start of the window, and offers to resume the session that was left last."""

    def __init__(self, sessions, journals, question, background, notices):
        self._sessions, self._journals, self._question = sessions, journals, question
        self._background, self._notices = background, notices

    def start(self):
        """Keep journals from now on, and look for one to go on with."""
        session = self._sessions.now
        self._journals.keep()
        self._journals.begin(session, session.timeline.history.story())
        self._background.do(_left_over, self._offer)

    def _offer(self, found):
        if found is None:
            return
        path, text = found
        answers = (
            Answer("Resume", partial(self._resume, path), pygame.K_RETURN, "Enter"),
            Answer("Later", None, pygame.K_ESCAPE, "Esc"),
            Answer("Discard", partial(self._discard, path), pygame.K_DELETE, "Del"),
        )
        self._question.ask("Resume your last session?", text, answers)

    def _resume(self, path):
        self._background.do(partial(_resumed, path), self._take)

    def _take(self, found):
        height, width = found[1].scene.shape
        self._sessions.slowly("Opening your last session …", partial(self._open, *found), height * width)

    def _open(self, kept, recording):
        """Open the session of a Journal and its Recording, paused where it was left."""
        session = Session.retold(recording)
        session.journal, session.paused = kept, True
        self._sessions.open(session)
        session.seek(recording.end, SEEK_NS)
        self._notices.say(recording.problem or "Your session is back, paused. Space resumes it.")

    def _discard(self, path):
        self._background.do(partial(journal.finish, path), writes=True)


def _resumed(path):
    """Return the Journal to go on with and its Recording, once all rules in it are compiled."""
    kept, recording = Journal.resume(path)
    make_recording_ready(recording)
    return kept, recording


def _left_over():
    """Return (path, what to say) of the journal to go on with, or None."""
    path = journal.left_over()
    if path is None:
        return None
    when = f"{datetime.fromtimestamp(path.stat().st_mtime):%d %B, %H:%M},"
    if not path.name.endswith(journal.STOPPED):
        return path, f"All that you did until {when} is kept."
    acts = journal.acts_in(path)
    return (
        path,
        f"Your session of {when} went on when its journal could not. Acts that it holds: {acts:,}; nothing later.",
    )
