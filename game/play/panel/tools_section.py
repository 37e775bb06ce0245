"""The panel's section of tools: what the pointer does to the sand, and with what."""

from game.world.sand import parameters
from game.world.sand.sand_colours import COLOURS, DYES
from game.world.sessions.action import SHAPES

TIPS = {  # what each tool does that changes the sand
    "brush": "Paints where the pointer goes, and keeps pouring where it rests  (D)",
    "line": "Draws a straight line, as thick as the brush; with Shift in steps of 45°  (N)",
    "rectangle": "Draws a rectangle from corner to corner; with Shift a square  (U)",
    "ellipse": "Draws an ellipse from corner to corner; with Shift a circle  (O)",
    "fill": "Fills all that is joined to the cell under the pointer and like it  (V)",
    "spray": "Scatters single cells, denser the longer it rests  (A)",
    "pick": "Picks what is under the pointer, to paint with it  (I)",
    "replace": "Paints over only what is like the cell it started on  (Y)",
    "tap": "Places a tap, as wide as the brush, that pours what is chosen for ever; "
    "drag a tap or a drain to move it  (J)",
    "drain": "Places a drain, as wide as the brush, that swallows what reaches it  (Z)",
    "select": "Selects a rectangle; dragged inside, it goes along with all that is in it  (Shift+S)",
    "stamp": "Puts down what was copied, as often as you click  (Ctrl+V)",
}
SHORT = {"rectangle": "Box"}  # so that four buttons fit a row


class ToolsSection:
    """The tools and the brush; what is seldom changed of it can be folded away."""

    def __init__(self, brush, material_page, commands, show_stamps):
        """`commands`: those for pieces. `show_stamps()` opens the page of stamps."""
        self._brush, self._page, self._commands, self._show_stamps = brush, material_page, commands, show_stamps
        self._open = False

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        brush = self._brush
        ui.heading("Tools")
        _show_tools(ui, brush)
        if brush.tool in ("select", "stamp"):
            self._show_piece(ui)
        self._show_materials(ui)
        if brush.has_colours:
            _show_colours(ui, brush)
        tip = "Width of the brush, in cells  (1-9)"
        brush.diameter = ui.slider("Size", parameters.BRUSH, brush.diameter, log=True, tip=tip)
        _show_special(ui, brush)
        self._open = ui.fold(
            "Shape of the brush", self._open, tip="Round, square or diamond, and whether it replaces walls"
        )
        if self._open:
            _show_shape(ui, brush)

    def _show_piece(self, ui):
        """Show what can be done with what is selected, or with the stamp in hand."""
        selection, commands, stamps = self._brush.selection, self._commands, self._brush.tool == "stamp"
        there = selection.copied is not None if stamps else selection.box is not None
        if not stamps:
            ui.row(3)
            if ui.button("Copy", key="Ctrl+C", tip="Copies what is selected", enabled=there):
                commands.copy()
            if ui.button("Cut", key="Ctrl+X", tip="Copies what is selected, and erases it", enabled=there):
                commands.cut()
            if ui.button("Erase", key="Del", tip="Erases what is selected", enabled=there):
                commands.erase()
        ui.row(2)
        if ui.button("Keep", key="Ctrl+K", tip="Keeps it as a stamp, with a name, in a folder of yours", enabled=there):
            commands.keep()
        if ui.button("Stamps", key="F3", tip="Shows the stamps that you have kept, to take one in hand"):
            self._show_stamps()
        if stamps and ui.button(
            "Paste a picture", key="Ctrl+Shift+V", tip="Takes the picture on the clipboard in hand"
        ):
            commands.paste_picture()
        ui.row(2)
        if ui.button("Mirror", key="Shift+X", tip="Exchanges left and right", enabled=there):
            commands.mirror()
        if ui.button("Turn", key="Shift+E", tip="Turns it by a quarter, clockwise", enabled=there):
            commands.turn()
        if stamps:
            selection.air = ui.toggle("Stamp its air too", selection.air, tip="Empties what lies below empty cells")

    def _show_materials(self, ui):
        """Show what can be painted; the material in hand, pressed again, shows what it does."""
        brush = self._brush
        names, tip = brush.materials, "What the left button paints; the right one erases  (S, W, X)"
        labels, index = [name.capitalize() for name in names], names.index(brush.material)
        if brush.has_colours:
            chosen = ui.segmented("Paint", labels, index, tip=tip)
        else:
            tips = [f"Paints {name}; pressed again, it shows what {name} does with others  (,)" for name in names[:-1]]
            tips.append("Paints with nothing  (X)")
            again = self._page.toggle if index < len(names) - 1 else None
            colours = (*brush.swatches(ui.theme.colours), None)
            chosen = ui.grid("Paint", labels, index, 4, tips, colours, again)
        if chosen != index:
            brush.material = names[chosen]


def _show_tools(ui, brush):
    tools = tuple(TIPS)
    labels = [SHORT.get(tool, tool.capitalize()) for tool in tools]
    now = tools.index(brush.tool) if brush.tool in tools else -1
    chosen = ui.grid("Tool", labels, now, 4, [TIPS[tool] for tool in tools])
    if chosen != now:
        brush.choose(tools[chosen])


def _show_colours(ui, brush):
    """Show a swatch for each colour of sand, and one for the rainbow."""
    plain = [ui.theme.colours.swatch(number) for number in range(len(COLOURS))]
    fields = [*((colour,) for colour in plain), tuple(plain)]
    tips = [*(f"Sand in {name}; it also recolours the sand it is painted over  (,)" for name in COLOURS)]
    tips.append("Sand in all colours, which change as time passes  (,)")
    chosen = DYES[ui.swatches("Colour", fields, DYES.index(brush.colour), tips)]
    if chosen != brush.colour:
        brush.dip(chosen)


def _show_special(ui, brush):
    """Show what only the tool in hand has."""
    if brush.tool in ("rectangle", "ellipse"):
        tip = "Draws only the outline, as thick as the brush  (Shift+U, Shift+O)"
        brush.edge_only = ui.toggle("Outline only", brush.edge_only, tip=tip)
    if brush.tool == "tap":
        tip = "Iterations from one pour to the next, in each cell of a new tap"
        brush.every = round(ui.slider("Pours every", parameters.EVERY, brush.every, log=True, tip=tip))


def _show_shape(ui, brush):
    shapes = tuple(SHAPES)
    labels = [shape.capitalize() for shape in shapes]
    tip = "Shape of the brush  (Shift+D)"
    brush.shape = shapes[ui.segmented("Shape", labels, shapes.index(brush.shape), tip=tip)]
    tip = "Lets what you paint replace walls; otherwise walls stay"
    brush.over_walls = ui.toggle("Paint over walls", brush.over_walls, tip=tip)
