"""The former sessions: those that others were opened over. They wait with little memory to be gone back to."""

from game.world.sand import parameters

MOST = 4  # sessions that wait; when there are more, the middle ones are forgotten


class Former:
    """A stack of sessions, the player's own at the bottom."""

    def __init__(self, recovery):
        self._recovery = recovery
        self._waiting = []

    def __len__(self):
        return len(self._waiting)

    def __iter__(self):
        return iter(self._waiting)

    def push(self, session):
        """Let a session wait, its past to be computed anew if need be; of many forget one, never the player's own."""
        session.limit_memory(parameters.MEMORY.low)
        self._waiting.append(session)
        if len(self._waiting) > MOST:
            self.end(self._waiting.pop(1))

    def pop(self):
        """Return the session that was played last."""
        return self._waiting.pop()

    def end(self, session):
        """End a session that nobody returns to."""
        self._recovery.close(session)
        session.drop_past()

    def close(self):
        """End the journals of those that wait."""
        for session in self._waiting:
            self._recovery.close(session)
