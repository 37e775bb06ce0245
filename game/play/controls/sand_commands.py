"""The commands for the sand: what turns, tilts or replaces it, and what the brush paints."""

import math

from game.play.controls.tools.brush import SIZES
from game.world.sessions.action import Clear, Flip, Load, SetRule, Turn

TILT = 0.1  # of bias, by one press of a key


class SandCommands:
    """The keys and buttons of the sand and the tools."""

    def __init__(self, sessions, comparing, settings, display, notices, brush, camera, timer):
        self._sessions, self._comparing, self._settings = sessions, comparing, settings
        self._display, self._notices = display, notices
        self._brush, self._camera, self._timer = brush, camera, timer

    # --- the world ---

    def flip(self):
        """Turn the glass over: at once in the lattice, and in half a second on the screen."""
        self._sessions.slowly("Turning the glass over …", self._flip)

    def turn(self, quarters):
        """Turn the table by quarters, clockwise."""
        self._sessions.slowly("Turning the table …", lambda: self._turn_over(int(quarters)))

    def tilt(self, way):
        """Tilt the table a step to the left (-1) or to the right (1)."""
        rule = self._sessions.now.rule
        if not rule.leans:
            self._notices.say("Only a table of sand tilts: this rule has no left and right.")
            return
        if rule.p == 0.0:
            self._notices.say("At p = 0 no grain topples, whichever way the table tilts.")
            return
        bias = _next_bias(rule.bias, int(way))
        self._sessions.do(SetRule(rule.leaning(bias)))
        side = "left" if bias < 0 else "right"
        self._notices.say(f"The table tilts to the {side}: bias {bias:+.2g}" if bias else "The table is level: bias 0")

    def restart(self):
        """Start the scene again, with the friction and at the speed that are set."""
        self._sessions.slowly("Starting again …", self._restart)

    def clear(self):
        """Take all sand away."""
        self._sessions.slowly("Clearing …", lambda: self._sessions.do(Clear()))

    def compare(self):
        """Show this world in variants side by side, from now on; again, go back to it as it was."""
        self._sessions.slowly("Getting the worlds ready …", self._comparing.toggle)

    # --- the brush ---

    def material(self, name):
        """Paint with sand, with walls, or with nothing from now on."""
        self._brush.material = name

    def tool(self, name):
        """Choose a tool; rectangles and ellipses are filled."""
        self._brush.choose(name)
        self._brush.edge_only = False

    def edge(self, name):
        """Choose a tool that draws outlines only."""
        self._brush.choose(name)
        self._brush.edge_only = True

    def size(self, number):
        """Give the brush the size that belongs to a number key."""
        self._brush.diameter = SIZES[int(number) - 1]

    def next_colour(self, steps):
        """Paint with sand of the colour so many swatches further on."""
        self._brush.next_colour(int(steps))

    def next_shape(self):
        """Give the brush its next shape."""
        self._brush.next_shape()

    def smaller_brush(self):
        """Shrink the brush."""
        self._brush.resize(-1)

    def larger_brush(self):
        """Grow the brush."""
        self._brush.resize(1)

    def _flip(self):
        if self._turn_over(2):
            self._timer.turned()

    def _restart(self):
        sessions, rule, speed = self._sessions, self._sessions.now.rule, self._timer.own_speed
        if sessions.do(Load(sessions.now.scene, sessions.now.seed)):
            sessions.do(SetRule(rule), join=True)
            sessions.now.clock.speed = speed
        if sessions.now.paused:
            self._notices.say("The scene is at its start, and time stands still: Space lets it go on.")

    def _turn_over(self, quarters):
        """Turn the lattice by quarters, and let its old picture turn, unless motion is to be reduced.

        Return whether it turned: not while it does so already.
        """
        view = self._display.sand_view
        if view.turn or not self._sessions.ready():
            return False
        self._brush.let_go()
        if not self._settings["reduced_motion"] and not self._display.page:
            view.start_turn(self._display.now_s, quarters)
        self._camera.turn_over(quarters)
        self._sessions.do(Flip() if quarters == 2 else Turn(quarters))
        return True


def _next_bias(bias, way):
    """Return the next multiple of TILT, in [-1, 1], to the left (-1) or to the right (1)."""
    steps = round(bias / TILT, 6)
    steps = math.floor(steps) + 1 if way > 0 else math.ceil(steps) - 1
    return min(max(steps * TILT, -1.0), 1.0)
