"""The commands for pieces: what is selected, copied, cut, turned and put down again."""

from game.play.ui.input import key_name

HOW = "Select a piece first: {}, then drag."


class PieceCommands:
    """The keys and buttons of the selection and the stamp in hand."""

    def __init__(self, sessions, notices, brush, stamps):
        self._sessions, self._notices, self._brush, self._stamps = sessions, notices, brush, stamps
        self._selection = brush.selection

    def select(self):
        """Take the tool in hand that selects."""
        self._brush.choose("select")

    def select_all(self):
        """Select the whole lattice."""
        self._brush.choose("select")
        height, width = self._sessions.now.world.shape
        self._selection.box = 0, 0, width, height

    def copy(self):
        """Copy what is selected."""
        if self._has_piece():
            self._slowly("Copying …", self._copy)

    def cut(self):
        """Copy what is selected, and erase it."""
        if self._has_piece():
            self._slowly("Cutting …", self._cut)

    def paste(self):
        """Take what was copied in hand."""
        if self._selection.copied:
            self._brush.choose("stamp")
        else:
            self._notices.say("Nothing is copied yet. " + HOW.format(key_name("Shift+S")))

    def paste_picture(self):
        """Take the picture on the clipboard in hand."""
        self._stamps.take_picture()

    def keep(self):
        """Keep what is selected, or the stamp in hand, among the player's stamps."""
        if self._brush.tool == "stamp" and self._selection.copied:
            self._stamps.keep()
        elif self._has_piece():
            self._selection.copy()
            self._stamps.keep()

    def mirror(self):
        """Exchange left and right, of the stamp in hand or of what is selected."""
        self._change("Mirroring …", 0, True)

    def turn(self):
        """Turn the stamp in hand, or what is selected, by a quarter, clockwise."""
        self._change("Turning …", 1, False)

    def erase(self):
        """Erase what is selected."""
        if self._selection.box:
            self._slowly("Erasing …", lambda: self._sessions.do(self._selection.erasing()))

    def _copy(self):
        self._selection.copy()
        high, wide = self._selection.copied.stamp.shape
        self._notices.say(
            f"Copied {wide}×{high} cells. {key_name('Ctrl+V')} takes them in hand; each click puts them down."
        )

    def _cut(self):
        if self._sessions.ready():
            self._copy()
            self._sessions.do(self._selection.erasing())

    def _change(self, words, quarters, mirrored):
        if self._brush.tool == "stamp" and self._selection.copied:
            self._selection.change_stamp(quarters, mirrored)
        elif self._has_piece():
            self._slowly(words, lambda: self._turn(quarters, mirrored))

    def _turn(self, quarters, mirrored):
        if self._sessions.ready():
            self._sessions.do(self._selection.turning(quarters, mirrored))

    def _has_piece(self):
        if not self._selection.box:
            self._notices.say(HOW.format(key_name("Shift+S")))
        return self._selection.box is not None

    def _slowly(self, words, act):
        left, top, right, bottom = self._selection.box
        self._sessions.slowly(words, lambda: self._selection.box and act(), (right - left) * (bottom - top))
