"""The journals: every session of the window is recorded in a file as it goes, so that a crash loses nothing."""

from contextlib import suppress

from game.world.files.atomic import FileError
from game.world.sessions.history import WAIT, Entry
from game.world.sessions.journal import Journal
from game.world.sessions.session_format import LARGEST_FILE

AGAIN_S = 5.0  # from one try to begin a lost journal anew to the next


class Journals:
    """Begins and ends the journals of sessions; `say(text, trouble)` tells of trouble with them."""

    def __init__(self, say):
        self._say = say
        self._kept = False
        self._lost = None  # the session whose journal has stopped
        self._next_s = 0.0  # the earliest time to begin a lost journal anew

    def keep(self):
        """Keep a journal of every session that begins from now on."""
        self._kept = True

    def begin(self, session, entries):
        """Open a journal for a session in which `entries` have been done."""
        if not self._kept:
            return
        try:
            session.journal = _begun(session, entries)
            session.journal.acted = False
        except FileError as error:
            session.trouble = str(error)

    def update(self, session, now_s):
        """Say that a session's journal cannot be gone on with, and begin it anew once there is room again."""
        if session.trouble:
            self._say(f"{session.trouble}; the sand goes on, unrecorded", trouble=True)
            session.trouble, self._next_s = None, now_s + AGAIN_S
            self._lost = None if _is_full(session.lost_journal) else session
        if session is not self._lost or not session.arrived or now_s < self._next_s:
            return
        self._next_s = now_s + AGAIN_S
        lost = session.lost_journal
        with suppress(FileError):
            session.journal = _begun(session, session.timeline.history.story())
            session.lost_journal = self._lost = None
            if lost:
                lost.unlink(missing_ok=True)
            self._say("The journal is kept again.")

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


def _is_full(path):
    """Return whether a lost journal is too large to be told again."""
    return path is not None and path.exists() and path.stat().st_size > LARGEST_FILE // 2


def _begun(session, entries):
    """Return a new journal of all that was done in a session; raise FileError, and leave nothing, if it fails."""
    journal = Journal.begin(*session.timeline.start)
    try:
        for entry in entries:
            journal.note(entry)
        journal.note(Entry(session.now, WAIT))
    except FileError:
        with suppress(OSError):
            journal.path.unlink()
        raise
    return journal
