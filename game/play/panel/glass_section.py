"""The glass's part of the panel: an hourglass changed under one's eyes, with how long it will run."""

from dataclasses import replace

from game.world.sand.duration import spell
from game.world.sand.parameters import SIDE
from game.world.scenes.hourglass import CURVE, FILL, NECK, THICKNESS
from game.world.scenes.hourglass_maker import HEIGHT, glass_within, resized
from game.world.scenes.hourglass_spec import SMALLEST
from game.world.sessions.action import Reshape

SLIDERS = (
    (NECK, "Neck", True),
    (CURVE, "Curve", False),
    (THICKNESS, "Wall", True),
    (FILL, "Fill", False),
)
UNKNOWN = "…"


class GlassFold:
    """The rows, which can be folded away."""

    def __init__(self):
        self.open = False
        self._turning = False  # a slider is being dragged, and what it does is one act
        self._refills = False  # the glass of this drag has been filled anew

    def lay_out(self, ui, toy):
        """Show the rows and obey what was done to them."""
        self.open = ui.fold("Glass", self.open, tip="Makes an hourglass of any shape, and pours the sand into it")
        if not self.open:
            return
        glass = toy.sessions.now.scene.glass
        if glass is None:
            ui.text("This scene is not one glass. Here it can be made into one, with its sand in it.", dim=True)
            if ui.button("Make a glass"):
                self._reshape(toy, self._made_of(toy.sessions.now.world.shape))
            return
        changed = self._slid(ui, glass)
        held = ui.focus.held is not None
        if changed != glass:
            self._reshape(toy, changed, changed.fill != glass.fill, join=self._turning)
        self._turning = held and (self._turning or changed != glass)
        if ui.button("Fill it anew", tip="Takes all sand out and fills the upper bulb"):
            self._reshape(toy, glass, refill=True)
        ui.text(running_time(toy), dim=True)

    def _slid(self, ui, glass):
        """Return the glass as the sliders have it."""
        size = ui.slider("Size", HEIGHT, glass.height, default=HEIGHT.default, log=True, name="Glass size")
        if size != glass.height:
            glass = resized(glass, size)
        for each, label, log in SLIDERS:
            value = getattr(glass, each.name)
            turned = ui.slider(label, each, value, log=log)
            if turned != value:
                glass = replace(glass, **{each.name: turned})
        return glass

    def _made_of(self, shape):
        """Return a glass on a lattice as large as a slider can make it."""
        height, width = shape
        part = min(max(HEIGHT.low / height, 1.0), HEIGHT.high / height)
        return glass_within(min(max(round(part * width), SMALLEST), SIDE.high), round(part * height))

    def _reshape(self, toy, glass, refill=False, join=False):
        """Put a glass in place; one whose bulb cannot hold the sand is filled anew, for nothing would flow in it.

        So are those that follow in the same drag: most of the sand is gone.
        """
        grains = toy.sessions.now.world.grains
        self._refills = refill or (join and self._refills)
        if not self._refills and grains > glass.inside().sum() // 2:
            self._refills = True
            words = f"A bulb of this glass does not hold {grains:,} grains: it was filled anew."
            toy.notices.say(words, holds=lambda: toy.sessions.now.scene.glass == glass)
        toy.sessions.do(Reshape(glass, self._refills), join)


def running_time(toy):
    """Return how long the glass runs, in words."""
    ending, session = toy.planner.ask() or toy.planner.newest, toy.sessions.now
    if ending is None:
        return UNKNOWN
    if ending.endless:
        return "Runs for longer than can be foreseen."
    left = ending.at - session.now
    if left <= 0 and not ending.has_neck:
        return "All sand is at rest, and there is no neck."
    if left <= 0:
        return "The sand above the neck is stuck." if ending.left else "No sand is above the neck."
    return f"Runs for {spell(left / session.clock.speed)} more at {session.clock.speed:,.0f} iterations a second."
