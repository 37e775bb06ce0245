"""The brush: the tool in hand, and the gesture that it makes. Each gesture is done to the session as it goes on."""

from functools import partial

import pygame

from game.play.controls.gestures import Press, Span, Trail
from game.play.controls.tools.fixture_tool import FixtureTool, fresh
from game.play.controls.tools.ruler import RulerTool
from game.play.controls.tools.selection import MOST_SHOWN, Selection, SelectTool, StampTool
from game.play.ui import theme as look
from game.play.view.overlays.outlines import box_outline, brush_outline, mark
from game.play.view.swatches import swatches_of
from game.world.sand import parameters
from game.world.sand.sand_colours import AMBER, COLOURS, DYES
from game.world.sessions.action import (
    EMPTY_CELLS,
    ERASE,
    SHAPES,
    USUAL_SHAPE,
    Fill,
    Paint,
    Paste,
    SetFixtures,
    box,
    snap,
)

TOOLS = {  # the gesture that each makes
    "brush": Trail,
    "line": Span,
    "rectangle": Span,
    "ellipse": Span,
    "fill": Press,
    "spray": Trail,
    "pick": Press,
    "replace": Trail,
    "tap": FixtureTool,
    "drain": FixtureTool,
    "select": SelectTool,
    "stamp": StampTool,
    "ruler": RulerTool,
}
ONE_CELL = (
    "rectangle",
    "ellipse",
    "fill",
    "pick",
    "select",
    "stamp",
    "ruler",
)  # tools that aim at a cell, however large the brush
NOT_ERASING = ("pick", "tap", "drain", "select", "stamp", "ruler")  # tools in whose place the brush erases
SIZES = (1, 2, 3, 5, 8, 13, 21, 34, 55)  # diameters that the number keys give, in cells
LEFT, RIGHT = 1, 3


class Deed:
    """What a gesture has come to so far."""

    acted = False  # it has changed something


class Brush:
    """What the pointer paints with, and the gesture that it is making."""

    def __init__(self, sessions):
        self._sessions = sessions
        self.tool = "brush"
        self._chosen = "sand"  # a material, or ERASE
        self.colour = AMBER  # of sand: one of DYES
        self.diameter = parameters.BRUSH.default
        self.shape = USUAL_SHAPE
        self.over_walls = False
        self.every = parameters.EVERY.default  # iterations from one grain of a new tap to the next
        self.edge_only = False  # rectangles and ellipses are drawn as their outline, as thick as the brush
        self._gesture = self._button = None
        self.deed = Deed()  # of the gesture
        self.selection = Selection(sessions)
        self._erasing = False  # the gesture erases whatever the material
        self._at = None  # where the gesture has come to, and whether it goes straight
        self._before_pick = "brush"
        self.ruled = None  # two places (column, row): where the ruler lies
        self._sprays = 0

    @property
    def painting(self):
        """Whether a gesture is being made."""
        return self._gesture is not None

    @property
    def by_mouse(self):
        """Whether it is the mouse that makes the gesture."""
        return self._button is not None

    @property
    def materials(self):
        """The names of what can be painted in the world that is played, the eraser last."""
        codes = self._sessions.now.world.codes
        return (*codes.told_of(codes.filled | {codes.wall}), ERASE)

    def swatches(self, colours):
        """Return the colours of what can be painted in a theme's Colours, without the eraser."""
        rule = self._sessions.now.rule
        swatches = swatches_of(colours, rule.definition.materials)
        return tuple(swatches[rule.codes.told.index(name)] for name in self.materials[:-1])

    @property
    def material(self):
        """What the brush paints: what was chosen, or the first of the materials if the world has not that one."""
        return self._chosen if self._chosen in self.materials else self.materials[0]

    @material.setter
    def material(self, name):
        self._chosen = name

    @property
    def has_colours(self):
        """Whether the sand of the world that is played can have colours."""
        return self._sessions.now.world.codes.is_sand

    @property
    def ink(self):
        """The material that the gesture leaves."""
        return ERASE if self._erasing else self.material

    @property
    def dye(self):
        """The colour of what the gesture leaves."""
        return self.colour if self.ink == "sand" and self.has_colours else AMBER

    def dip(self, colour):
        """Paint with sand of a colour from now on."""
        self.colour, self.material = colour, "sand"

    def next_colour(self, steps):
        """Take the colour so many swatches further on, or the material where sand has no colours."""
        if not self.has_colours:
            names = self.materials
            self.material = names[(names.index(self.material) + steps) % len(names)]
            return
        self.dip(DYES[(DYES.index(self.colour) + steps) % len(DYES)])

    def choose(self, tool):
        """Take a tool in hand; what was selected is so no longer."""
        self.let_go()
        self.selection.box = None
        if tool == "pick" and self.tool != "pick":
            self._before_pick = self.tool
        self.tool = tool

    @property
    def selects(self):
        """Whether something is selected, or a stamp is in hand."""
        return self.selection.box is not None or self.tool == "stamp"

    def deselect(self):
        """Select nothing, and put the stamp down."""
        self.choose("select")

    def take(self, material, colour):
        """Paint with a material from now on, with the tool that was in hand before the picking.

        colour: the number of the colour of what was picked, if that is sand.
        """
        if material == "sand" and self.has_colours:
            self.colour = COLOURS[colour]
        self.material = ERASE if material == EMPTY_CELLS else material
        self.tool = self._before_pick

    def next_shape(self):
        """Take the next shape of brush."""
        shapes = list(SHAPES)
        self.shape = shapes[(shapes.index(self.shape) + 1) % len(shapes)]

    def next_spray(self):
        """Return a number that no spray has had."""
        self._sprays += 1
        return self._sprays

    def resize(self, steps):
        """Grow or shrink the brush by about a tenth, and by one cell at least, for each step."""
        change = max(1, self.diameter // 10) * steps
        self.diameter = int(min(max(self.diameter + change, parameters.BRUSH.low), parameters.BRUSH.high))

    # --- gestures ---

    def handle_event(self, event, view):
        """Let the mouse make gestures on the lattice that `view` shows."""
        shift = bool(pygame.key.get_mods() & pygame.KMOD_SHIFT)
        if event.type == pygame.MOUSEBUTTONDOWN and event.button in (LEFT, RIGHT) and not self.painting:
            self._button = event.button
            self.press(view.place(*event.pos), event.button == RIGHT, shift)
        elif event.type == pygame.MOUSEMOTION and self._button:
            self.move(view.place(*event.pos), shift)
        elif event.type == pygame.MOUSEBUTTONUP and event.button == self._button:
            self.release(view.place(*event.pos), shift)

    def press(self, place, erase=False, straight=False):
        """Begin the tool's gesture; `erase`: with nothing. A brush that goes `straight` draws a line."""
        tool = "brush" if erase and self.tool in NOT_ERASING else self.tool
        gesture = Span if straight and tool == "brush" else TOOLS[tool]
        self._erasing, self.deed = erase, Deed()
        self._gesture = gesture(self, place, self._sessions.now.world)
        self.move(place)

    def move(self, place, straight=False):
        """Go on with the gesture at another place; `straight`: a line in steps of 45 degrees, sides alike."""
        self._at = place, straight and self.tool != "brush"
        self._do(self._gesture.go(*self._at))

    def hold(self):
        """Let a frame pass: a brush that rests goes on painting."""
        if self.painting:
            self._do(self._gesture.go(*self._at))

    def release(self, place, straight=False):
        """End the gesture at a place."""
        self._do(self._gesture.end(place, straight and self.tool != "brush"))
        self.let_go()

    def let_go(self):
        """End the gesture with what it has done so far."""
        self._gesture = self._button = None
        self._erasing, self.deed = False, Deed()

    def marks(self, place, view):
        """Return the Marks that show what the tool reaches from a place, or what the gesture will draw."""
        if not self.painting and self.tool == "select" and self.selection.box:
            return self.lasting_marks(view)
        outlines = self._gesture.outlines() if self.painting and self._gesture.outlines else None
        return tuple(mark(outline, view) for outline in outlines or [self._aim(place)])

    def piece_at(self, place):
        """Return what is carried, or the stamp in hand over a place, as (Stamp, box in the lattice), if it is shown."""
        if isinstance(self._gesture, SelectTool):
            return self._gesture.carried
        copied = self.selection.copied
        if self.tool != "stamp" or not copied or copied.stamp.cells.size > MOST_SHOWN:
            return None
        return copied.stamp, self.selection.landing(place)

    def lasting_marks(self, view):
        """Return the Marks that show what is selected, wherever the pointer is."""
        selected = not self.painting and self.selection.box
        return (mark(box_outline(*selected), view, look.RING),) if selected else ()

    def _aim(self, place):
        if TOOLS[self.tool] is FixtureTool:
            return box_outline(*fresh(self, place).box)
        if self.tool == "stamp" and self.selection.copied:
            return box_outline(*self.selection.landing(place))
        if self.tool in ONE_CELL:
            return box_outline(*box(place, place))
        return brush_outline(self.shape, self.diameter, snap(place, self.diameter))

    def _do(self, acts):
        """Let acts of the gesture happen; undo takes all of them back together."""
        world = self._sessions.now.world
        for act in acts:
            self._sessions.slowly("Painting …", partial(self._act, act, self.deed), _reach(act, world))

    def _act(self, act, deed):
        deed.acted = self._sessions.do(act, join=deed.acted) or deed.acted


def _reach(act, world):
    """Return how many cells an act goes over at most."""
    height, width = world.shape
    if isinstance(act, Fill):
        return height * width
    if isinstance(act, SetFixtures):
        return 0
    if isinstance(act, Paste):
        return act.stamp.cells.size
    left, top, right, bottom = box(act.start, act.end)
    beyond = act.diameter if isinstance(act, Paint) else 0
    across = min(right + beyond, width) - max(left - beyond, 0)
    down = min(bottom + beyond, height) - max(top - beyond, 0)
    return max(across, 0) * max(down, 0)
