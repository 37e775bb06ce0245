"""The name card: asks for a name over the sand, which goes on meanwhile."""

from game.play.ui.card import Card
from game.play.ui.text_line import TextLine

FIELD = "Name"


class NameCard(Card):
    """The question for a name, if one is open."""

    def __init__(self, display):
        super().__init__(display)
        self._title = self._line = self._then = None

    def ask(self, title, name, then):
        """Ask for a name, and offer one; then(name) is called with what is taken."""
        self._title, self._line, self._then = title, TextLine(name), then
        self._open(FIELD)

    def handle_events(self, events, now_s, mouse_pos):
        """Take what is typed, and the answer; return the events that are not the card's."""
        rest = self._lay_out(events, now_s, mouse_pos)
        ui = self.ui
        ui.heading(self._title)
        self._line = ui.text_field(FIELD, self._line)
        taken, rest = self._answer_row("Save", rest)
        if taken is not None:
            self._close()
        if taken:
            self._then(self._line.text.strip())
        return rest
