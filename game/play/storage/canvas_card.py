"""The canvas card: asks how large an empty canvas is to be, or how large this one is to become."""

from dataclasses import replace
from functools import partial

from game.play.ui.card import Card
from game.play.ui.text_line import TextLine
from game.play.window.layout import MARGIN
from game.world.rules.definition import load_definition
from game.world.rules.rule import Rule
from game.world.sand import parameters
from game.world.scenes.canvas import canvas
from game.world.sessions.action import ANCHORS, Resize

FIELDS = {side.capitalize(): replace(parameters.SIDE, name=side) for side in ("width", "height")}
KINDS = "A new one", "This one"
WHAT_TIP = "An empty canvas in place of this one, or another size for this one, with what is on it"

KEEP_TIP = "What stays where it is; what the new size has no room for is cut off"


class CanvasCard(Card):
    """The card of a new canvas, or of another size for the one that is played, while one of them is open."""

    width = 380

    def __init__(self, sessions, display, files, rule_files, notices):
        super().__init__(display)
        self._sessions, self._notices = sessions, notices
        self._files, self._rule_files = files, rule_files
        self._resizes = False  # it is about the canvas that is played
        self._lines = {}  # the TextLine of each field
        self._error = ""  # what is wrong with them, in one line
        self._cell = parameters.CELL.default  # pixels, where the canvas is to fill the window
        self._rule = ""  # its label
        self._walls, self._anchor = False, "middle"

    def ask_new(self):
        """Ask what a new canvas is to be like."""
        self._rule = self._rule_files.label
        self._ask(False)

    def ask_size(self):
        """Ask how large the canvas that is played is to become."""
        self._ask(True)

    def _ask(self, resizes):
        height, width = self._sessions.now.world.shape
        self._resizes, self._error = resizes, ""
        self._cell = min(max(round(self._display.sand_view.view.cell), 1), parameters.CELL.high)
        self._fill(width, height)
        self._open(next(iter(FIELDS)))

    def _fill(self, *sides):
        self._lines = {field: TextLine(str(side)) for field, side in zip(FIELDS, sides, strict=True)}

    def handle_events(self, events, now_s, mouse_pos):
        """Take what is chosen, and the answer; return the events that are not the card's."""
        rest = self._lay_out(events, now_s, mouse_pos)
        ui = self.ui
        self._resizes = ui.segmented("Canvas", KINDS, int(self._resizes), tip=WHAT_TIP) == 1
        self._show_size(ui)
        if self._resizes:
            names = list(ANCHORS)
            kept = ui.choice("Keep", [name.capitalize() for name in names], names.index(self._anchor), tip=KEEP_TIP)
            self._anchor = names[kept]
        else:
            labels = [*self._rule_files.labels]
            self._rule = labels[ui.choice("Rule", labels, labels.index(self._rule), tip="How what you paint will move")]
        if self._error:
            ui.text(self._error)
        done, rest = self._answer_row("Resize" if self._resizes else "Create", rest)
        if done:
            self._answer()
        elif done is not None:
            self._close()
        return rest

    def _show_size(self, ui):
        ui.row(2)
        for field, line in self._lines.items():
            typed = ui.text_field(field, line, tip="In cells")
            self._error = self._error if typed.text == line.text else ""
            self._lines = {**self._lines, field: typed}
        tip = "Pixels across a cell, for a canvas that fills the window"
        self._cell = round(ui.slider("Cell size", parameters.CELL, self._cell, log=True, tip=tip))
        ui.row(1 if self._resizes else 2)
        if ui.button("Fill the window", tip="Makes it as large as the window has room for such cells"):
            margin, room = 2 * self._display.theme.px(MARGIN), self._display.layout.sand
            self._fill(*(max(1, (side - margin) // self._cell) for side in room.size))
            self._error = ""
        if not self._resizes:
            self._walls = ui.toggle("Walls around", self._walls, tip="Along all four sides; outside is wall anyway")

    def _answer(self):
        try:
            sides = [knob.parse(self._lines[field].text) for field, knob in FIELDS.items()]
        except ValueError as error:
            self._error = str(error)
            self._display.refresh()
            return
        self._close()
        if self._resizes:
            self._resize(*sides)
        else:
            self._create(*sides)

    def _create(self, width, height):
        label, name = self._rule, self._rule_files.labels[self._rule]
        played = self._sessions.now.rule if label == self._rule_files.label else None
        self._files.open_made(partial(_made, width, height, played, name, self._walls), f"a canvas of {width}×{height}")

    def _resize(self, width, height):
        act = Resize(width, height, self._anchor)
        most = max(width * height, self._sessions.now.world.layout.height * self._sessions.now.world.layout.width)
        self._sessions.slowly("Resizing the canvas …", partial(self._do, act), most)

    def _do(self, act):
        before = self._sessions.now.account.erased
        if self._sessions.do(act):
            cut = self._sessions.now.account.erased - before
            lost = f" {cut:,} grains were cut off." if cut else ""
            self._notices.say(f"The canvas has {act.width}×{act.height} cells now.{lost} Ctrl+Z takes you back.")


def _made(width, height, played, name, walls):
    """Return the Scene of a canvas under the rule that is played, or under another one, by its name or path."""
    return canvas(width, height, played or Rule(definition=load_definition(name)), walls)
