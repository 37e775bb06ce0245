"""Notices: one line at a time in the status line that says what happened and goes away."""

LEAST_S = 4.0
S_PER_LETTER = 0.06  # a longer line takes longer to read
SHORTEST_S = 2.0  # while another line waits
MOST_WAITING = 3


class Notices:
    """Lines waiting to be shown, one at a time; what is said twice stays longer."""

    def __init__(self, subject):
        """`subject()` returns what is told of: a line goes when that is another one, unless it tells of trouble."""
        self._subject = subject
        self._lines = []  # (text, whether it tells of trouble, a function that says whether it holds), the first shown
        self._since_s = None
        self._now_s = 0.0

    def say(self, text, trouble=False, holds=lambda: True):
        """Show a line as long as it holds: at once, unless one that tells of trouble is still to be read."""
        about = self._subject()
        line = str(text), trouble, lambda: holds() and (trouble or self._subject() == about)
        if self._lines and self._lines[0][1] and self._lines[0][:2] != line[:2]:
            self._lines = [*self._lines[:MOST_WAITING], line]
        else:
            self._lines, self._since_s = [line], None

    @property
    def text(self):
        """The line that is shown, or None."""
        return self._lines[0][0] if self._lines else None

    @property
    def line(self):
        """(the line that is shown, whether it tells of trouble), or None."""
        return self._lines[0][:2] if self._lines else None

    def pass_time(self, now_s):
        """Let the line age."""
        self._now_s = now_s
        if self._lines and self._since_s is None:
            self._since_s = now_s
        elif self._lines and (self._age() > self._stay() or not self._lines[0][2]()):
            self._lines, self._since_s = self._lines[1:], None

    def _age(self):
        return 0.0 if self._since_s is None else self._now_s - self._since_s

    def _stay(self):
        if len(self._lines) > 1:
            return SHORTEST_S
        return LEAST_S + S_PER_LETTER * len(self._lines[0][0])
