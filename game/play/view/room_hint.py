"""The hint at room: says which key makes some, where worlds side by side or plots leave cells smaller than a pixel."""

SMALL = 1.0  # pixels to a cell
WORDS = "The sand has little room: P hides the panel, and F5 all small print."


class RoomHint:
    """Says so once each time that it becomes so, as soon as nothing else is to be read."""

    def __init__(self, sessions, display, notices):
        self._sessions, self._display, self._notices = sessions, display, notices
        self._told = False

    def update(self, now_s):
        """Say it, if it is so and was not said."""
        if not self._is_cramped:
            self._told = False
        elif not self._told and not self._notices.line:
            self._told = True
            self._notices.say(WORDS, holds=lambda: self._is_cramped)

    @property
    def _is_cramped(self):
        display = self._display
        takes_room = len(self._sessions.now.sessions) > 1 or display.layout.plots is not None
        return takes_room and display.panel_shown and display.sand_view.whole.cell < SMALL
