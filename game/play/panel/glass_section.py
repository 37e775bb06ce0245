"""The panel's section of the glass: an hourglass changed under one's eyes, with how long it will run."""

from dataclasses import replace
from functools import partial

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
POURED = "powder", "liquid"  # what a glass can be filled with
UNKNOWN = "…"


class GlassSection:
    """The rows, which can be folded away; a drag of a slider is one act."""

    def __init__(self, sessions, planner, notices):
        self._sessions, self._planner, self._notices = sessions, planner, notices
        self._open = False
        self._turning = False  # a slider is being dragged, and what it does is one act
        self._refills = False  # the glass of this drag has been filled anew

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        self._open = ui.fold("Glass", self._open, tip="Makes an hourglass of any shape, with what is in it")
        if not self._open:
            return
        glass = self._sessions.now.scene.glass
        if glass is None:
            ui.text("This scene is not a glass. You can turn it into one; what is here stays in it.", dim=True)
            if ui.button("Make a glass"):
                self._put(_glass_on(self._sessions.now.world.shape))
            return
        changed = self._slid(ui, glass)
        held = ui.focus.held is not None
        if changed != glass:
            self._put(changed, _poured(changed) != _poured(glass), join=self._turning)
        self._turning = held and (self._turning or changed != glass)
        if ui.button("Refill", tip="Empties the glass and fills the upper bulb"):
            self._put(glass, refill=True)
        run_out = self._planner.ask() or self._planner.newest
        ui.text(running_time(self._sessions.now, run_out), dim=True)

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
        return self._filled(ui, glass)

    def _filled(self, ui, glass):
        """Return the glass with what the player chooses to fill it with, where there is more than sand."""
        rule = self._sessions.now.rule
        names = [each.name for each in rule.definition.materials if each.kind in POURED and each.form_of is None]
        if rule.codes.is_sand or not names:
            return glass
        now = next((name for name in (glass.material, rule.codes.usual) if name in names), names[0])
        chosen = names[ui.choice("Filled with", [name.capitalize() for name in names], names.index(now))]
        return glass if chosen == now else replace(glass, material=chosen)

    def _put(self, glass, refill=False, join=False):
        height, width = self._sessions.now.world.shape
        act = partial(self._reshape, glass, refill, join)
        self._sessions.slowly("Making the glass …", act, max(height * width, glass.height * glass.width))

    def _reshape(self, glass, refill, join):
        """Put a glass in place; one whose bulb cannot hold the sand is filled anew, for nothing would flow in it.

        So are those that follow in the same drag: most of the sand is gone.
        """
        sessions = self._sessions
        grains = sessions.now.world.grains
        self._refills, words = refill or (join and self._refills), ""
        if not self._refills and grains > glass.inside().sum() // 2:
            self._refills = True
            words = f"This glass is too small for {grains:,} grains: it was filled anew."
        sessions.do(Reshape(glass, self._refills), join)
        if words:
            self._notices.say(words)


def _poured(glass):
    return glass.fill, glass.material


def _glass_on(shape):
    """Return a glass on a lattice of a shape, as large as a slider can make it."""
    height, width = shape
    part = min(max(HEIGHT.low / height, 1.0), HEIGHT.high / height)
    return glass_within(min(max(round(part * width), SMALLEST), SIDE.high), round(part * height))


def running_time(session, run_out):
    """Return how long a session's glass runs, in words; run_out: None while that is not known."""
    if run_out is None:
        return UNKNOWN
    if run_out.endless:
        return "Runs for longer than can be computed."
    left = run_out.at - session.now
    if left <= 0 and not run_out.has_neck:
        return "All is at rest, and nothing is above a neck."
    if left <= 0:
        return "What is above the neck is stuck." if run_out.left else "Nothing is above the neck."
    return f"Runs for {spell(left / session.clock.speed)} more at {session.clock.speed:,.0f} iterations a second."
