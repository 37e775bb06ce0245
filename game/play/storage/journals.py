"""The journals: every session of the window is recorded in a file as it goes, so that a crash loses nothing."""

from game.world.files.atomic import FileError
from game.world.sessions.journal import Journal


class Journals:
    """Begins and ends the journals of sessions; `say(text, trouble)` tells of trouble with them."""

    def __init__(self, say):
        self._say = say
        self._kept = False

    def keep(self):
        """Keep a journal of every session that begins from now on."""
        self._kept = True

    def begin(self, session, entries):
        """Open a journal for a session in which `entries` have been done."""
        if not self._kept:
            return
        try:
            session.journal = Journal.begin(*session.timeline.start)
            for entry in entries:
                session.journal.note(entry)
            session.journal.acted = False
        except FileError as error:
            session.journal, session.trouble = None, str(error)

    def close(self, session):
        """End a session's journal."""
        self._end(session, lambda journal: journal.close(session.now, _digest(session)))

    def leave(self, session):
        """End a session's journal so that the next start offers to go on, if the player has done anything in it."""
        if session.journal and not session.journal.acted:
            self._end(session, lambda journal: journal.close(session.now, ""))
        elif session.timeline.goal is None:
            self._end(session, lambda journal: journal.leave(session.now, session.world.digest()))
        else:
            self._end(session, Journal.abandon)

    def _end(self, session, end):
        if session.journal is None:
            return
        try:
            end(session.journal)
        except FileError as error:
            self._say(error, trouble=True)
        session.journal = None


def _digest(session):
    """Return the digest of a session's world, or "" while another moment is being computed."""
    return "" if session.timeline.goal is not None else session.world.digest()
