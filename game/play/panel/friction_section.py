"""The friction: the panel's section of how sand moves, from p to all seven probabilities."""

from dataclasses import replace

from game.world.sand import parameters
from game.world.sand.rule import SCHEDULES, Rule
from game.world.sessions.action import SetRule

PAPER_P = (0.25, 0.5, 0.75, 1.0)  # the four values of the paper

BLOCKS = {  # what each probability decides: corners a b c d before and after
    "topple_left": (".o.#", "..o#"),
    "topple_right": ("o.#.", "..#o"),
    "fall_pair": ("oo..", "..oo"),
    "fall_low_left": ("o..#", "..o#"),
    "fall_low_right": (".o#.", "..#o"),
    "fall_full_left": ("o#.#", ".#o#"),
    "fall_full_right": ("#o#.", "#.#o"),
}
SCHEDULE_TIP = (
    "The order in which partitions into blocks take turns. Margolus: two partitions, piles grow one side first. "
    "Paper: four, grains alternate sides. Balanced: the same four reordered, grains fall evenly and twice as fast."
)
LEAN_TIP = "To which side grains topple rather, and the order in which blocks take turns"
SEVEN_TIP = "How likely sand moves, for each thing that can happen in a block of 2×2 cells"


class Friction:
    """The rows, and what only they remember."""

    def __init__(self):
        self.all_seven = False  # whether the fold with all probabilities is open
        self.lean_open = False  # whether that of bias and schedule is
        self._turning = False  # a slider is being dragged, and what it sets is one act
        self._rule = None  # the rule that _p and _bias stand for
        self._p = self._bias = 0.0

    def lay_out(self, ui, toy):
        """Show the rows and obey what was done to them."""
        rule, usual = toy.sessions.now.rule, toy.sessions.now.scene.rule
        if rule is not self._rule:
            self._rule, self._p, self._bias = rule, rule.p, rule.bias
        ui.heading("Friction")
        tip = "How readily grains topple. Less is more friction: tall, thin piles."
        p, bias, schedule = (
            ui.slider("p", parameters.P, self._p, default=usual.p, marks=PAPER_P, tip=tip),
            self._bias,
            None,
        )
        self.lean_open = ui.fold("Bias and schedule", self.lean_open, tip=LEAN_TIP)
        if self.lean_open:
            bias, schedule = self._lean(ui, rule, usual)
        changed = self._changed(rule, p, bias, schedule or rule.schedule)
        changed = self._seven(ui, changed, usual)
        held = ui.focus.held is not None
        if changed is not rule:
            toy.sessions.do(SetRule(changed), join=self._turning)
        self._turning = held and (self._turning or changed is not rule)

    def _lean(self, ui, rule, usual):
        """Show bias and schedule; return them as they are to be."""
        tip = "Leans the toppling: below 0 to the left, above 0 to the right."
        bias = ui.slider("Bias", parameters.BIAS, self._bias, default=usual.bias, marks=(0.0,), tip=tip)
        names = list(SCHEDULES)
        now = names.index(rule.schedule)
        return bias, names[ui.choice("Schedule", [name.capitalize() for name in names], now, tip=SCHEDULE_TIP)]

    def _changed(self, rule, p, bias, schedule):
        """Return the rule with what was set, or itself."""
        changed = rule
        if (p, bias) != (self._p, self._bias):
            topples = Rule.with_p(p, bias=bias)
            changed = replace(rule, topple_left=topples.topple_left, topple_right=topples.topple_right)
            self._p, self._bias, self._rule = p, bias, changed
        if schedule != rule.schedule:
            changed = self._rule = replace(changed, schedule=schedule)
        return changed

    def _seven(self, ui, rule, usual):
        self.all_seven = ui.fold("All seven probabilities", self.all_seven, tip=SEVEN_TIP)
        if not self.all_seven:
            return rule
        for each in parameters.PROBABILITIES:
            before, after = BLOCKS[each.name]
            words = each.name.replace("_", " ").capitalize()
            value = getattr(rule, each.name)
            tip = f"How often {each.meaning}."
            turned = ui.slider_with_picture(
                words, each, value, before, after, default=getattr(usual, each.name), tip=tip
            )
            if turned != value:
                rule = replace(rule, **{each.name: turned})
        return rule
