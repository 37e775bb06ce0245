"""The toolbox: the panel's section of what the pointer does to the sand, and with what."""

from game.play.controls.brush import MATERIALS, TOOLS
from game.play.panel import dyes
from game.world.sand import parameters
from game.world.sessions.action import SHAPES

TIPS = {  # what each tool does
    "brush": "Paints where the pointer goes, and goes on pouring where it rests  (D)",
    "line": "Draws a straight line, as thick as the brush, from press to release; Shift: in steps of 45°  (N)",
    "rectangle": "Draws a rectangle from corner to corner; Shift: a square  (U)",
    "ellipse": "Draws an ellipse from corner to corner; Shift: a circle  (O)",
    "fill": "Fills what is joined to the cell under the pointer and is like it  (V)",
    "spray": "Strews single grains, denser the longer it rests  (A)",
    "pick": "Takes what is under the pointer to paint with  (I)",
    "replace": "Paints over only what is like the cell it began on  (Y)",
    "tap": "Places a tap, as wide as the brush, that pours sand of the chosen colour and never runs dry; "
    "a tap or a drain that is there is moved  (J)",
    "drain": "Places a drain, as wide as the brush, that swallows the sand that comes to it  (Z)",
}
SHORT = {"rectangle": "Box"}  # so that four buttons fit a row


class Toolbox:
    """The section, and whether what is seldom changed of the brush is folded away."""

    def __init__(self):
        self.open = False

    def lay_out(self, ui, toy):
        """Show the section, and obey what was done in it."""
        brush = toy.brush
        ui.heading("Tools")
        _show_tools(ui, brush)
        labels = [name.capitalize() for name in MATERIALS]
        tip = "What the left button paints with; the right one erases  (S, W, X)"
        brush.material = MATERIALS[ui.segmented("Paint", labels, MATERIALS.index(brush.material), tip=tip)]
        dyes.show(ui, toy)
        tip = "Width of the brush, in cells  (1-9)"
        brush.diameter = ui.slider("Size", parameters.BRUSH, brush.diameter, log=True, tip=tip)
        _show_special(ui, brush)
        self.open = ui.fold("Shape of the brush", self.open, tip="Its outline, and whether it paints sand over walls")
        if self.open:
            _show_shape(ui, brush)


def _show_tools(ui, brush):
    tools = tuple(TOOLS)
    labels = [SHORT.get(tool, tool.capitalize()) for tool in tools]
    chosen = tools[ui.grid("Tool", labels, tools.index(brush.tool), 4, [TIPS[tool] for tool in tools])]
    if chosen != brush.tool:
        brush.choose(chosen)


def _show_special(ui, brush):
    """Show what only the tool in hand has."""
    if brush.tool in ("rectangle", "ellipse"):
        tip = "Draws only the edge, as thick as the brush, and leaves what is inside as it is  (Shift+U, Shift+O)"
        brush.edge_only = ui.toggle("Outline only", brush.edge_only, tip=tip)
    if brush.tool == "tap":
        tip = "Iterations from one grain to the next, in each cell of a new tap"
        brush.every = round(ui.slider("Pours every", parameters.EVERY, brush.every, log=True, tip=tip))


def _show_shape(ui, brush):
    shapes = tuple(SHAPES)
    labels = [shape.capitalize() for shape in shapes]
    tip = "Shape of the brush  (Shift+D)"
    brush.shape = shapes[ui.segmented("Shape", labels, shapes.index(brush.shape), tip=tip)]
    tip = "Lets sand replace walls; without it they stay"
    brush.over_walls = ui.toggle("Paint sand over walls", brush.over_walls, tip=tip)
