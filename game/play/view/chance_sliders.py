"""Sliders of what can be turned in a rule: each is a chance beside a picture of what it decides."""

from dataclasses import replace

import numpy as np

from game.play.view.swatches import striped, swatches_of

ENDS, RARE_ENDS = ("never", "always"), ("never", "often")  # of a chance
RARE = 0.05  # below it a chance has a slider of its own length, or no hand could set it
SPAN = 20  # the length of that, in usual values


def spelled(chance):
    """Return a chance in short and plain figures."""
    return np.format_float_positional(chance, precision=3, fractional=False, trim="-")


class ChanceSliders:
    """The sliders of one panel or page; a drag of one is one act."""

    def __init__(self, sessions, changes):
        self._sessions, self._changes = sessions, changes
        self.turning = False  # a slider is being dragged, and what it sets is one act
        self._turned = False  # … in this frame

    def begin(self):
        """Begin a frame."""
        self._turned = False

    def note_turn(self):
        """Note that something was turned in this frame."""
        self._turned = True

    def end(self, ui):
        """End a frame, in which all of `ui` was laid out."""
        self.turning = ui.focus.held is not None and (self.turning or self._turned)

    def show(self, ui, dial, words=None, picture=None):
        """Show the slider of a Dial, and do what it was told; words and picture: in place of the dial's own."""
        rule, usual = self._sessions.now.rule, self._sessions.now.scene.rule
        knob, value = dial.knob, self._changes.value(dial.knob.name)
        same = usual.definition.source == rule.definition.source
        default = usual.number(knob.name) if same else knob.default
        before, after = striped(picture or dial.picture, swatches_of(ui.theme.colours, rule.definition.materials))
        tip = f"How likely it is in a block where it can happen: {dial.event}."
        words = words or dial.label
        name = knob.name if "." in knob.name else words
        if 0 < default < RARE and value <= SPAN * default:
            knob = replace(knob, high=SPAN * default, ends=RARE_ENDS)
        knob = replace(knob, ends=knob.ends or ENDS)
        turned = ui.slider_with_picture(
            words, knob, value, before, after, default=default, tip=tip, name=name, spell=spelled
        )
        if turned != value:
            self._changes.turn(knob.name, turned, join=self.turning)
            self.note_turn()
